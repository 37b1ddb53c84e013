// A hostile world keeps to what is declared: errors, ages, stamps in order. Only faults go further.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "rtac/sim/attacker.h"
#include "rtac/sim/hostile.h"
#include "scene.h"

namespace rtac::sim {
namespace {

using testing::drone_limits;
using testing::ms;
using testing::robot_at;
using testing::Room;

class Hostile : public ::testing::Test {
 protected:
  Hostile() {
    limits.hears_age_us = 150 * ms;
    surroundings.zones = {room.view()};
    surroundings.radius_m = limits.radius_m;
    Property inside;
    inside.op = PropertyOp::inside;
    properties.push_back(inside);
  }
  // Two drones chase the walls for ten seconds; `each` sees every observation.
  template <class Each>
  void fly(const Hostility& hostility, Tape& tape, const Each& each) {
    World<Acceleration> world({robot_at(limits, {1, 1}), robot_at(limits, {3.4, 1})},
                              testing::quiet());
    Arena arena(surroundings, properties, limits, 2);
    arena.watch(world.truths());
    std::map<TimeUs, std::vector<TruthState>> history;
    HostileFleet<Acceleration> fleet(world, arena, hostility, tape,
                                     [&](TimeUs now) { history[now] = world.truths(); });
    Chase<Acceleration> attack(arena, 0, Aim::fence, hostility.seed);
    Observation seen[2];
    for (TimeUs t = 0; t < 10'000 * ms; t += 50 * ms) {
      ASSERT_TRUE(fleet.wait_until(t));
      for (int i = 0; i < 2; ++i) {
        seen[i].self = i;
        seen[i].robots = 2;
        fleet.robot(i).sense(seen[i]);
        seen[i].now_us = fleet.now_us();
        each(seen[i], history);
        fleet.robot(i).actuate(attack.command(seen[i]));
        fleet.robot(i).announce({});
      }
    }
  }
  template <class T>
  static bool late(const Sample<T>& sample, TimeUs now, TimeUs age) {
    return sample.stamp_us == never_us || now - sample.stamp_us > age || sample.stamp_us > now;
  }

  Room room;
  RobotLimits limits = drone_limits();
  Surroundings surroundings;
  std::vector<Property> properties;
};

TEST_F(Hostile, MeasurementsAreAsDeclared) {
  for (const Noise noise :
       {Noise::none, Noise::uniform, Noise::extreme, Noise::aimed, Noise::lasting}) {
    for (const Ages ages : {Ages::fresh, Ages::oldest, Ages::unequal, Ages::wandering}) {
      Tape tape;
      TimeUs last_us[2] = {never_us, never_us};
      fly({7, Aim::fence, noise, ages, 0, 0}, tape, [&](const Observation& o, auto& history) {
        ASSERT_FALSE(late(o.position, o.now_us, limits.position_age_us));
        ASSERT_FALSE(late(o.velocity, o.now_us, limits.velocity_age_us));
        const auto self = static_cast<std::size_t>(o.self);
        const TruthState& p = history.at(o.position.stamp_us)[self];
        const TruthState& v = history.at(o.velocity.stamp_us)[self];
        ASSERT_LE(length(o.position.value - p.position), limits.position_error_m + 1e-12);
        ASSERT_LE(length(o.velocity.value - v.velocity), limits.velocity_error_mps + 1e-12);
        ASSERT_GE(o.position.stamp_us, last_us[self]);
        last_us[self] = o.position.stamp_us;
      });
    }
  }
}

TEST_F(Hostile, MessagesAreAsOldAsDeclaredAndInOrder) {
  for (const Ages ages : {Ages::fresh, Ages::oldest, Ages::unequal, Ages::wandering}) {
    Tape tape;
    TimeUs last_us[2] = {never_us, never_us};
    TimeUs oldest_us = 0;
    fly({3, Aim::fence, Noise::aimed, ages, 0, 0}, tape, [&](const Observation& o, auto& history) {
      if (o.now_us < 200 * ms) return;
      const auto other = static_cast<std::size_t>(1 - o.self);
      const Announcement& heard = o.others[other];
      ASSERT_FALSE(late(heard.position, o.now_us, limits.hears_age_us));
      ASSERT_FALSE(late(heard.velocity, o.now_us, limits.hears_age_us));
      const TruthState& p = history.at(heard.position.stamp_us)[other];
      ASSERT_LE(length(heard.position.value - p.position), limits.position_error_m + 1e-12);
      ASSERT_GE(heard.position.stamp_us, last_us[other]);
      last_us[other] = heard.position.stamp_us;
      oldest_us = std::max(oldest_us, o.now_us - heard.position.stamp_us);
    });
    EXPECT_EQ(oldest_us >= 100 * ms, ages != Ages::fresh);
  }
}

// However short a message may be heard for: never older than the robot measures it, a period later,
// and such that the others hear it at their next tick, which may come late.
TEST_F(Hostile, WhatIsToldIsAsOldAsSensesDeclareAndCanStillBeHeard) {
  const TimeUs period_us = 50 * ms, jitter_us = 5 * ms;
  struct Case {
    TimeUs hears_us, apart_us;  // declared, and the most that is told of
  };
  for (const Case each : {Case{400 * ms, 100 * ms},  // the sense of 50 ms, and a period
                          Case{150 * ms, 75 * ms},   // half of it
                          Case{80 * ms, 25 * ms},    // a period and its jitter less
                          Case{55 * ms, 0}}) {
    limits.hears_age_us = each.hears_us;
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      Tape tape;
      TimeUs apart_us = 0;
      Hostility hostility{seed, Aim::fence, Noise::aimed, Ages::unequal, 0, jitter_us};
      hostility.period_us = period_us;
      fly(hostility, tape, [&](const Observation& o, auto&) {
        if (o.now_us < 600 * ms) return;
        const Announcement& heard = o.others[static_cast<std::size_t>(1 - o.self)];
        ASSERT_FALSE(late(heard.position, o.now_us, limits.hears_age_us)) << each.hears_us;
        ASSERT_FALSE(late(heard.velocity, o.now_us, limits.hears_age_us)) << each.hears_us;
        apart_us = std::max(apart_us, std::abs(heard.position.stamp_us - heard.velocity.stamp_us));
      });
      EXPECT_LE(apart_us, each.apart_us) << each.hears_us;
      EXPECT_GE(apart_us, each.apart_us - 2 * ms) << each.hears_us;  // a step of the world
    }
  }
}

// Unless it is aimed, noise helps as often as it harms.
TEST_F(Hostile, AimedNoiseHidesTheDanger) {
  int runs_aimed = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Tape tape;
    double hidden_m = 0;
    int count = 0;
    fly({seed, Aim::fence, Noise::aimed, Ages::fresh, 0, 0}, tape,
        [&](const Observation& o, auto& history) {
          const TruthState& t = history.at(o.now_us)[static_cast<std::size_t>(o.self)];
          hidden_m += signed_clearance(room.view(), o.position.value) -
                      signed_clearance(room.view(), t.position);
          ++count;
        });
    if (hidden_m / count > 0.9 * limits.position_error_m) ++runs_aimed;
  }
  EXPECT_GE(runs_aimed, 5);
}

// The same error from the first sample to the last one, another one for another robot.
TEST_F(Hostile, LastingErrorsNeitherTurnNorFade) {
  std::vector<Vec2> off[2];
  Tape tape;
  fly({5, Aim::fence, Noise::lasting, Ages::oldest, 0, 0}, tape,
      [&](const Observation& o, auto& history) {
        const auto self = static_cast<std::size_t>(o.self);
        const TruthState& p = history.at(o.position.stamp_us)[self];
        off[self].push_back(o.position.value - p.position);
      });
  for (const auto& each : off) {
    ASSERT_GT(each.size(), 100u);
    EXPECT_NEAR(length(each.front()), limits.position_error_m, 1e-9);
    for (const Vec2& other : each) EXPECT_LT(length(other - each.front()), 1e-9);
  }
  EXPECT_GT(length(off[0].front() - off[1].front()), 1e-3);
}

TEST_F(Hostile, FaultsLoseAndBreakSamples) {
  Tape tape;
  bool lost = false, broken = false;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    fly({seed, Aim::fence, Noise::aimed, Ages::oldest, 500 * ms, 0}, tape,
        [&](const Observation& o, auto&) {
          lost = lost || late(o.position, o.now_us, limits.position_age_us);
          broken = broken || std::isnan(o.velocity.value.x);
        });
  }
  EXPECT_TRUE(lost);
  EXPECT_TRUE(broken);
}

TEST_F(Hostile, TicksAreLateByTheJitterAtMost) {
  Tape tape;
  TimeUs latest_us = 0;
  fly({1, Aim::fence, Noise::none, Ages::fresh, 0, 5 * ms}, tape,
      [&](const Observation& o, auto&) { latest_us = std::max(latest_us, o.now_us % (50 * ms)); });
  EXPECT_GT(latest_us, 3 * ms);
  EXPECT_LE(latest_us, 5 * ms);
}

// What is played comes from the tape, whatever the seed.
TEST_F(Hostile, ATapeIsPlayedToTheLastBit) {
  Tape first = Tape::recorder();
  std::vector<double> measured;
  const auto note = [&](const Observation& o, auto&) { measured.push_back(o.position.value.x); };
  fly({1, Aim::fence, Noise::uniform, Ages::wandering, 0, 2 * ms}, first, note);
  const std::vector<double> recorded = measured;
  measured.clear();
  // The commands are not on this tape: the same ones by the same seed.
  Tape second = Tape::player(first.written());
  fly({1, Aim::fence, Noise::none, Ages::fresh, 0, 0}, second, note);
  EXPECT_EQ(measured, recorded);
  EXPECT_EQ(second.written(), first.written());
  EXPECT_EQ(second.failed_line(), -1);
}

TEST(Tape, TakesAWholeLineOfWhomItIsAskedFor) {
  std::vector<std::int64_t> whole{0};
  std::vector<double> real{7};
  for (const char* line : {"sense 5 0x1p0", "sense -1 0x1p0", "sense 0", "sense 0 0x1p0 0x1p0"}) {
    Tape tape = Tape::player({"decide 0", line});
    EXPECT_FALSE(tape.read("sense", whole, real, 1)) << line;
    EXPECT_EQ(tape.failed_line(), 1) << line;
    EXPECT_EQ(whole[0], 0);
    EXPECT_EQ(real[0], 7);
  }
  Tape tape = Tape::player({"decide 0", "sense 0 0x1p0"});
  EXPECT_TRUE(tape.read("sense", whole, real, 1));
  EXPECT_EQ(real[0], 1);
}

TEST(Tape, FailsWhereItEnds) {
  Tape tape = Tape::player({"wait 5", "sense 0 x"});
  std::vector<std::int64_t> whole{0};
  std::vector<double> none, real{0};
  EXPECT_TRUE(tape.read("wait", whole, none, 0));
  EXPECT_EQ(whole[0], 5);
  EXPECT_FALSE(tape.read("sense", whole, real, 0));
  EXPECT_EQ(tape.failed_line(), 1);
  EXPECT_FALSE(tape.read("wait", whole, none, 0));
}

// Whatever the time: full effort, towards the wall that is nearest. An attack in phases also runs
// up, slides along and creeps.
TEST_F(Hostile, WhoOnlyPushesNeverDoesAnythingElse) {
  for (const Manner manner : {Manner::only_pushes, Manner::in_phases}) {
    std::vector<TruthState> truths(1);
    truths[0].position = {0.4, 1.5};
    Arena arena(surroundings, properties, limits, 1);
    arena.watch(truths);
    Chase<Acceleration> attack(arena, 0, Aim::fence, 5, manner);
    int other = 0;
    for (TimeUs t = 0; t < 60'000 * ms; t += 50 * ms) {
      Observation seen;
      seen.now_us = t;
      const Vec2 a = attack.command(seen).value_mps2;
      if (std::abs(a.x + limits.accel_mps2) > 0.01 || std::abs(a.y) > 0.2) ++other;
    }
    EXPECT_EQ(other > 0, manner == Manner::in_phases) << other;
  }
}

}  // namespace
}  // namespace rtac::sim
