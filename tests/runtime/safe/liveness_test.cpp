// theory, P2b: against an adversary that drives at the walls, control comes back within the time
// that the compiler derives and `rtac explain` prints.
#include <gtest/gtest.h>

#include <sstream>

#include "compiler/analysis/liveness.h"
#include "compiler/driver/compile.h"
#include "tests/runtime/safe/robots.h"
#include "yard_loiter_system.h"
#include "yard_retreat_system.h"
#include "yard_route_system.h"
#include "yard_sequence_system.h"

namespace {

using rtac::TimeUs;

constexpr TimeUs second = 1'000'000;

RTAC_TEST_YARD(yard_retreat);
RTAC_TEST_YARD(yard_route);
RTAC_TEST_YARD(yard_loiter);
RTAC_TEST_YARD(yard_sequence);

// Of the decision of this kind of robot.
std::optional<double> derived_s(const std::string& yard, std::size_t decision) {
  rtac::driver::Options options;
  options.spec = RTAC_YARDS "/" + yard + ".rta";
  std::ostringstream out;
  rtac::driver::Compilation c;
  rtac::driver::compile(options, out, c);
  if (!c.module) return std::nullopt;
  const rtac::ir::Decision& d = c.module->decisions[decision];
  const auto seconds = rtac::analysis::return_seconds((*c.spec)[c.spec->decisions[decision].kind],
                                                      *c.module, d, d.monitors[0].recovery);
  return seconds ? std::optional<double>{seconds->get_d()} : std::nullopt;
}

template <class Robot>
TimeUs longest_us() {
  using Output = typename Robot::Output;
  TimeUs longest = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    rtac::sim::PushAtNearest<Output> push(Robot::limits(), &Robot::zone());
    rtac::sim::BangBang<Output> bang(Robot::limits(), seed, 50'000, 1'500'000);
    for (rtac::Controller<Output>* adversary : {static_cast<rtac::Controller<Output>*>(&push),
                                                static_cast<rtac::Controller<Output>*>(&bang)}) {
      rtac::sim::RobotSetup robot;
      robot.start = {1.0 + 0.5 * double(seed % 4), 1.0 + 0.4 * double(seed % 5)};
      robot.heading_rad = double(seed);
      const auto shares =
          Robot::run(robot, seed, 180 * second, *adversary, [](TimeUs, const auto&) {});
      EXPECT_GE(shares.engagements(), 1);
      longest = std::max(longest, shares.longest_us());
    }
  }
  return longest;
}

template <class Drone, class Cart>
void expect_within(const std::string& yard) {
  const TimeUs measured[] = {longest_us<Drone>(), longest_us<Cart>()};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto bound_s = derived_s(yard, i);
    ASSERT_TRUE(bound_s.has_value()) << yard << " " << i;
    const double measured_s = double(measured[i]) * 1e-6;
    EXPECT_LE(measured_s, *bound_s) << yard << " " << i;
    // a bound, not just any number; on its way to a site a robot may get control back early
    EXPECT_GE(measured_s, *bound_s / 200) << yard << " " << i;
  }
}

TEST(Liveness, ARetreatGivesControlBackInTime) {
  expect_within<yard_retreat_drone, yard_retreat_cart>("yard_retreat");
}
TEST(Liveness, ALoiteringRobotGivesControlBackInTime) {
  expect_within<yard_loiter_drone, yard_loiter_cart>("yard_loiter");
}
TEST(Liveness, ARouteGivesControlBackInTime) {
  expect_within<yard_route_drone, yard_route_cart>("yard_route");
}
TEST(Liveness, ASequenceGivesControlBackInTime) {
  expect_within<yard_sequence_drone, yard_sequence_cart>("yard_sequence");
}
TEST(Liveness, NothingIsPromisedForWhoStands) {
  EXPECT_EQ(derived_s("yard_brake", 0), std::nullopt);
}

}  // namespace
