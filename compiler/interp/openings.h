// When a zone is there (rule 7).
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/sema/spec.h"

namespace rtac::interp {

// `now_us`: since 1970-01-01T00:00Z.
bool is_open(const std::vector<sema::Opening>& openings, std::int64_t now_us);

}  // namespace rtac::interp
