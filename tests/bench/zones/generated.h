// A zone as its users get it: compiled from a file of zones by the program `rtac`, its kernel by
// the C compiler, loaded into this process.
#pragma once

#include <memory>
#include <string>

#include "tests/bench/zones/contender.h"
#include "tests/bench/zones/cost.h"

namespace rtac::bench {

struct Generated {
  Cost rtac, c_compiler;
  double table_bytes = 0;  // of the kernel
  // One of each question, in the order of `Question`; the places are given later.
  std::function<Contender(Question, const std::vector<GridPlace>&)> contender;
};

// The monitor asks for this clearance, so that distances are told to this horizon at least.
constexpr std::int32_t needed_clearance_mm = 5'000;

// nullptr: `problem` says why.
std::unique_ptr<Generated> generate(const Outline& outline, std::string& problem);

}  // namespace rtac::bench
