// The command line of rtac. stdout carries data, stderr messages.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace rtac::driver {

// Documented exit codes.
inline constexpr int exit_clean = 0;
inline constexpr int exit_spec_errors = 1;
inline constexpr int exit_usage = 2;
inline constexpr int exit_violation = 3;
inline constexpr int exit_inconclusive = 4;
inline constexpr int exit_internal = 70;

// `arguments` without the name of the program.
int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

}  // namespace rtac::driver
