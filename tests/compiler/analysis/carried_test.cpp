// The price of a way that a hold is carried along covers what robots in space take to fly it, and
// is the one that the recheck finds.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/travel.h"
#include "compiler/recheck/travel.h"
#include "compiler/support/rational.h"
#include "rtac/safe/space.h"
#include "tests/runtime/core/test_plants.h"

namespace rtac::analysis::test {
namespace {

constexpr std::int64_t period_us = 50'000;
constexpr std::int32_t cell_mm = 100;

Rational micro(double value) {
  Rational r(std::lround(1e6 * value), 1'000'000);
  r.canonicalize();
  return r;
}
sema::Sense sense(double error, TimeUs age_us) {
  return {{micro(error), {}}, {micro(1e-6 * static_cast<double>(age_us)), {}}};
}
sema::RobotKind kind_of(const RobotLimits& l) {
  sema::RobotKind k;
  k.in_space = true;
  k.motion.model = sema::MotionModel::point;
  k.motion.speed = {micro(l.speed_mps), {}};
  k.motion.accel = {micro(l.accel_mps2), {}};
  k.motion.brake = {micro(l.brake_mps2), {}};
  k.motion.disturbance = sema::Quantity{micro(l.disturbance_mps2), {}};
  k.radius = {micro(l.radius_m), {}};
  k.position = sense(l.position_error_m, l.position_age_us);
  k.velocity = sense(l.velocity_error_mps, l.velocity_age_us);
  k.latency = {micro(1e-6 * static_cast<double>(l.latency_us)), {}};
  return k;
}
safe::Setting setting_of(const RobotLimits& limits, double speed_mps) {
  safe::Setting s;
  s.limits = limits, s.limits.in_space = true;
  s.period_us = period_us, s.speed_mps = speed_mps;
  return s;
}

// Flies these legs once.
class Legs final : public safe::Carried {
 public:
  Legs(const safe::Setting& setting, std::vector<Vec3> ends) : Carried(setting), ends_(ends) {}
  using Carried::stray_m;
  [[nodiscard]] bool flown() const { return begun_ && holding(); }

 private:
  void look(TimeUs /*now_us*/, Vec3 /*from*/, safe::Carried::Legs& legs) override {
    for (const Vec3 end : ends_) (void)legs.push(end);
    begun_ = true;
  }
  std::vector<Vec3> ends_;
  bool begun_ = false;
};

// What lasts: errors of what is measured, and a push.
struct Lasting {
  Vec3 place, velocity, push;
};

// Samples as old and commands as late as they may be.
double flown_s(const RobotLimits& limits, double speed_mps, const std::vector<Vec3>& ends,
               const Lasting& lasts) {
  Legs legs(setting_of(limits, speed_mps), ends);
  const std::size_t age = std::size_t(limits.position_age_us / rtac::test::step_us);
  const std::size_t late = std::size_t(limits.latency_us / rtac::test::step_us);
  std::vector<Vec3> places(age + 1), velocities(age + 1), commands(late + 1);
  Vec3 at{}, v{0, 0, 0};
  Observation seen;
  seen.robots = 1;
  Vec3 commanded{};
  for (TimeUs now_us = 0; now_us < 600'000'000; now_us += rtac::test::step_us) {
    if (now_us % period_us == 0) {
      const Vec3 p = places.front() + lasts.place, w = velocities.front() + lasts.velocity;
      seen.now_us = now_us;
      seen.position = {{p.x, p.y}, now_us - limits.position_age_us};
      seen.velocity = {{w.x, w.y}, now_us - limits.velocity_age_us};
      seen.height_m = p.z, seen.climb_mps = w.z;
      if (now_us == 0) legs.engage(seen);
      const Acceleration a = legs.command(seen, Gate::free);
      commanded = {a.value_mps2.x, a.value_mps2.y, a.up_mps2};
      if (legs.flown()) return 1e-6 * static_cast<double>(now_us);
    }
    commands.push_back(commanded), commands.erase(commands.begin());
    const double s = 1e-6 * static_cast<double>(rtac::test::step_us);
    v = v + s * (commands.front() + lasts.push);
    at = at + s * v;
    places.push_back(at), places.erase(places.begin());
    velocities.push_back(v), velocities.erase(velocities.begin());
  }
  return 600;
}

std::vector<Vec3> stairs(int cells) {
  std::vector<Vec3> ends;
  Vec3 at{};
  for (int i = 0; i < cells; ++i) {
    at = at + (i % 2 == 0 ? Vec3{0.1, 0, 0} : Vec3{0, 0.1, 0});
    ends.push_back(at);
  }
  return ends;
}

void expect_priced(const RobotLimits& limits, double speed_mps, const Lasting& lasts) {
  for (const int cells : {1, 6, 24}) {
    const auto price = carried_seconds(kind_of(limits), micro(speed_mps), period_us, cell_mm,
                                       std::int64_t{cells} * cell_mm);
    ASSERT_TRUE(price);
    const std::vector<Vec3> straight{{0.1 * cells, 0, 0}};
    for (const std::vector<Vec3>& way : {stairs(cells), straight}) {
      EXPECT_LE(flown_s(limits, speed_mps, way, lasts), price->get_d())
          << speed_mps << " m/s, " << cells << " cells, " << way.size() << " legs";
    }
  }
}

TEST(CarriedLegs, TakeNoLongerThanPriced) {
  for (const double speed_mps : {0.05, 0.2, 0.4}) {
    expect_priced(rtac::test::drone_limits(), speed_mps, {});
  }
}
TEST(CarriedLegs, TakeNoLongerThanPricedWhateverLasts) {
  RobotLimits limits = rtac::test::drone_limits();
  limits.brake_mps2 = limits.accel_mps2 = 2;
  limits.velocity_error_mps = 0.05, limits.disturbance_mps2 = 0.2;
  const double p = limits.position_error_m, v = 0.05, d = 0.2;
  for (const double way : {-1.0, 1.0}) {
    for (const double speed_mps : {0.05, 0.3}) {
      expect_priced(limits, speed_mps, {{way * p, 0, 0}, {way * v, 0, 0}, {-way * d, 0, 0}});
      expect_priced(limits, speed_mps, {{0, way * p, 0}, {0, 0, way * v}, {0, way * d, 0}});
    }
  }
}
// A leg itself, with nothing on top that is there for looking and braking: that does not hide it.
TEST(CarriedLegs, SettleAsFastAsIsPriced) {
  const RobotLimits limits = rtac::test::drone_limits();
  const double one = flown_s(limits, 0.4, {{1, 0, 0}}, {});
  const double two = flown_s(limits, 0.4, {{1, 0, 0}, {2, 0, 0}}, {});
  const auto leg = carried_leg_seconds(kind_of(limits), micro(0.4), period_us);
  ASSERT_TRUE(leg);
  EXPECT_LE(two - one, 1 / 0.4 + leg->get_d() - 1);  // 1 s: the look
}
// It would not follow as the price says.
TEST(CarriedLegs, OfABrakeThatIsTooWeakHaveNoPrice) {
  RobotLimits limits = rtac::test::drone_limits();
  limits.brake_mps2 = limits.accel_mps2 = 0.1, limits.velocity_error_mps = 0;
  EXPECT_TRUE(carried_seconds(kind_of(limits), micro(0.02), period_us, cell_mm, 1000));
  EXPECT_FALSE(carried_seconds(kind_of(limits), micro(0.8), period_us, cell_mm, 1000));
}

TEST(CarriedLegs, ArePricedTheSameByTheRecheck) {
  for (const double error : {0.0, 0.02, 0.1}) {
    RobotLimits limits = rtac::test::drone_limits();
    limits.position_error_m = error;
    const sema::RobotKind kind = kind_of(limits);
    sema::Decision decision;
    decision.period = sema::Quantity{micro(1e-6 * period_us), {}};
    sema::Controller home;
    home.implementation = sema::Route{sema::SiteId{}, sema::ZoneId{}, {micro(0.3), {}}};
    const Rational cell(1, 10), way(12);
    const auto theirs = recheck::return_seconds(kind, decision, home, cell, way);
    // from where it stands to the centre of a cell; and the dwell
    const auto ours = carried_seconds(kind, micro(0.3), period_us, cell_mm, 12'000 + 400 + 100);
    ASSERT_TRUE(theirs && ours);
    EXPECT_NEAR(theirs->get_d(), ours->get_d() + 3e-6 * period_us, 0.01);
  }
}

// What legs keep off walls for stops is what the runtime takes a stop to explain.
TEST(CarriedLegs, StrayAsFarOnBothSides) {
  for (const double push_mps2 : {0.0, 0.2}) {
    for (const double speed_mps : {0.1, 0.5}) {
      RobotLimits limits = rtac::test::drone_limits();
      limits.disturbance_mps2 = push_mps2;
      const double stray_m = Legs(setting_of(limits, speed_mps), {}).stray_m();
      const ir::Body body = body_of(kind_of(limits), period_us);
      const auto known_mm = static_cast<double>(stray_mm(body, micro(speed_mps), period_us));
      EXPECT_GE(known_mm, 1e3 * stray_m - 1e-6);
      EXPECT_LE(known_mm, 1e3 * stray_m + 2);
    }
  }
}

}  // namespace
}  // namespace rtac::analysis::test
