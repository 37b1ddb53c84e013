// The program `rtac-sim`. Data goes to standard output; what it refuses is a line on standard
// error, with a tab before what would work, and another one before the number of a diagnostic where
// the exit code does not say it.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace rtac::simulate {

// As `rtac` documents them.
inline constexpr int exit_clean = 0, exit_usage = 2, exit_violation = 3, exit_inconclusive = 4;
inline constexpr int cannot_read = 9002, cannot_write = 9003;

// `--kernel FILE --manifest FILE [--scenario FILE] [--seed N] [--runs N] [--jobs N]
// [--adversary NAME] [--trace FILE] [--replay FILE] [--predicted NAME=PERCENT,...] [--shares yes]`
// `--predicted`: of decisions, the share of the places where control comes back; `--shares`: a line
// for each decision on how much of the time its advanced controller had, and nothing else.
int run_program(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

}  // namespace rtac::simulate
