// Outcome of an operation that can fail at run time. Nothing here throws or ends the process.
#pragma once

#include <cstdint>

namespace rtac {

enum class [[nodiscard]] Status : std::int8_t{
    ok,
    full,          // a bounded container or buffer has no room; nothing was stored
    io_error,      // the operating system refused a file operation
    bad_argument,  // the arguments do not fit together
    stopped        // the platform asked to stop
};

const char* status_text(Status status);

}  // namespace rtac
