// Included before the sources of the compiler that mistakes are seeded in.
#pragma once

#include <cstdlib>
#include <cstring>

namespace rtac::mutation {

// Whether this is the mistake that the environment asks for.
inline bool seeded(const char* name) {
  static const char* const chosen = std::getenv("RTAC_MISTAKE");
  return chosen != nullptr && std::strcmp(chosen, name) == 0;
}

}  // namespace rtac::mutation
