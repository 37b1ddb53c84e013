// The two robots of the yard, with one recovery: what a test is written for once.
#pragma once

#include "tests/runtime/safe/closed_loop.h"

// For a module `yard_X`: yard_X_drone and yard_X_cart, each with Output, limits(), zone(), run().
#define RTAC_TEST_YARD(space)                                                              \
  struct space##_drone {                                                                   \
    using Output = rtac::Acceleration;                                                     \
    static rtac::RobotLimits limits() { return space::Drone_limits(); }                    \
    static const rtac::ZoneView& zone() { return space::yard_zone(); }                     \
    static constexpr double give_back_m = space::DroneSystem::return_clearance_m;          \
    template <class OnStep>                                                                \
    static rtac::test::Shares run(const rtac::sim::RobotSetup& robot, std::uint64_t seed,  \
                                  rtac::TimeUs end_us, rtac::Controller<Output>& advanced, \
                                  const OnStep& on_step) {                                 \
      return rtac::test::run<space::DroneSystem, Output>(                                  \
          limits(), robot, seed, end_us, advanced, on_step,                                \
          [](auto& controller, auto& plans, auto& tasks) {                                 \
            return space::DroneSystem::Controllers{{controller, plans}, tasks};            \
          });                                                                              \
    }                                                                                      \
  };                                                                                       \
  struct space##_cart {                                                                    \
    using Output = rtac::Twist;                                                            \
    static rtac::RobotLimits limits() { return space::Cart_limits(); }                     \
    static const rtac::ZoneView& zone() { return space::yard_zone(); }                     \
    static constexpr double give_back_m = space::CartSystem::return_clearance_m;           \
    template <class OnStep>                                                                \
    static rtac::test::Shares run(const rtac::sim::RobotSetup& robot, std::uint64_t seed,  \
                                  rtac::TimeUs end_us, rtac::Controller<Output>& advanced, \
                                  const OnStep& on_step) {                                 \
      return rtac::test::run<space::CartSystem, Output>(                                   \
          limits(), robot, seed, end_us, advanced, on_step,                                \
          [](auto& controller, auto& plans, auto& tasks) {                                 \
            return space::CartSystem::Controllers{{controller, plans}, tasks};             \
          });                                                                              \
    }                                                                                      \
  }
