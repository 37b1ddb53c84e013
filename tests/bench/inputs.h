// One recorded tick as both sides take it: integers for the kernel, doubles for the hand-written
// step.
#pragma once

#include <array>

#include "robot_delivery_kernel.h"
#include "rtac/types.h"
#include "tests/bench/hand/delivery.h"

namespace rtac::bench {

using KernelIn = robot_delivery_plan_executor_in;
using KernelState = robot_delivery_plan_executor_state;
using KernelOut = robot_delivery_plan_executor_out;

// The same conversion as in the generated class.
void fill(KernelIn& to, const Observation& from, bool holding, bool surrender);

// Points into itself, so it stays where it was filled.
struct HandInput {
  hand_in in{};
  std::array<std::array<hand_vec, max_waypoints>, HAND_ROBOTS + 1> points{};  // own plan last

  HandInput() = default;
  HandInput(const HandInput&) = delete;
  HandInput& operator=(const HandInput&) = delete;
};
void fill(HandInput& to, const Observation& from, bool holding, bool surrender);

// The state of the hand-written step that corresponds to one of the kernel.
hand_state hand_state_of(const KernelState& from);

}  // namespace rtac::bench
