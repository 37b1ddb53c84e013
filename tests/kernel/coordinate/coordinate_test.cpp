// Who drives under `coordinate` (language rule 12.1): what the choice promises of anything that may
// be found, and the golden case `coordinated`, tick by tick.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "coordinate_probe.h"
#include "spec_kernel.h"

namespace {

constexpr int max = probe_monitors_max;

// ---- anything that may be found

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
  bool one_in(int n) { return below(n) == 0; }

 private:
  std::mt19937 engine_;
};

// Its own property each recovery keeps; of the others in `kept_of_8` cases of 8.
probe_choice any(Random& random, int kept_of_8) {
  probe_choice c{};
  c.count = 2 + random.below(max - 1);
  c.driving = random.below(c.count + 1) - 1;
  for (int i = 0; i < c.count; ++i) {
    c.engaged[i] = random.one_in(2);
    for (int j = 0; j < c.count; ++j) {
      c.proved[i * c.count + j] = i == j ? 2 : random.below(8) < kept_of_8;
      c.ahead[i * c.count + j] = random.below(9) - 4;
    }
  }
  // an idle monitor has been judged under the motion of who drives
  if (c.driving >= 0) {
    for (int j = 0; j < c.count; ++j) {
      if (c.engaged[j] == 0) c.ahead[c.driving * c.count + j] = random.below(4);
    }
  }
  return c;
}
bool keeps(const probe_choice& c, int i, int j) {
  return probe_keeps_now(&c, i, j) != 0;
}
bool proved(const probe_choice& c, int i, int j) {
  return c.proved[i * c.count + j] != 0;
}
// Among monitor j and those above it: does a way along pairs that are not proved lead from j round
// in a circle?
bool in_conflict(const probe_choice& c, int j) {
  std::vector<bool> led(static_cast<std::size_t>(j) + 1, false);
  const auto leads = [&](int from, int to) { return from != to && !proved(c, from, to); };
  led[static_cast<std::size_t>(j)] = true;
  for (int round = 0; round <= j; ++round) {
    for (int a = 0; a <= j; ++a) {
      for (int b = 0; b <= j; ++b) {
        if (led[static_cast<std::size_t>(a)] && leads(a, b))
          led[static_cast<std::size_t>(b)] = true;
      }
    }
  }
  // those that are led to, without whoever keeps all of the others that are left
  for (int round = 0; round <= j; ++round) {
    for (int a = 0; a <= j; ++a) {
      bool out = false;
      for (int b = 0; b <= j; ++b) out = out || (led[static_cast<std::size_t>(b)] && leads(a, b));
      if (!out) led[static_cast<std::size_t>(a)] = false;
    }
  }
  for (const bool left : led) {
    if (left) return true;
  }
  return false;
}

TEST(Rule12_1, TheLongestPrefixDrives) {
  Random random(1);
  int lower = 0, stayed = 0;
  for (int n = 0; n < 200'000; ++n) {
    probe_choice c = any(random, 5);
    const int best = probe_coordinate(&c);
    int longest = -1, first = -1;
    for (int i = 0; i < c.count; ++i) {
      if (c.engaged[i] == 0) continue;
      if (first < 0) first = i;
      longest = std::max(longest, probe_kept_prefix(&c, i));
    }
    ASSERT_EQ(best < 0, first < 0);
    if (best < 0) continue;
    ASSERT_TRUE(c.engaged[best]);
    ASSERT_EQ(probe_kept_prefix(&c, best), longest);
    lower += best != first;
    // whoever drives goes on where nobody keeps more
    const bool as_good =
        c.driving >= 0 && c.engaged[c.driving] && probe_kept_prefix(&c, c.driving) == longest;
    if (as_good) ASSERT_EQ(best, c.driving);
    stayed += as_good;
  }
  EXPECT_GT(lower, 10'000);
  EXPECT_GT(stayed, 10'000);
}

// Of several others that are as good, the one with most room where its prefix ends; else the first.
TEST(Rule12_1, OfEqualPrefixesTheOneWithMostRoomDrives) {
  probe_choice c{};
  c.count = 3;
  c.driving = -1;
  c.engaged[0] = c.engaged[1] = c.engaged[2] = 1;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) c.proved[3 * i + j] = i == j ? 2 : 0;
  }
  c.proved[3 * 1 + 0] = c.proved[3 * 2 + 0] = 1;
  c.proved[3 * 2 + 1] = 0;
  // recovery 0 keeps monitor 0 alone, 1 the first two
  EXPECT_EQ(probe_coordinate(&c), 1);
  // now each of 1 and 2 keeps the first two, and neither the fourth
  c.count = 4;
  for (int i = 0; i < 4; ++i) {
    c.engaged[i] = i == 1 || i == 2 || i == 3;
    for (int j = 0; j < 4; ++j) c.proved[4 * i + j] = i == j ? 2 : j < 3;
    c.ahead[4 * i + 3] = -10 * i;
  }
  c.proved[4 * 3 + 2] = 0;  // its own prefix ends sooner
  EXPECT_EQ(probe_coordinate(&c), 1);
  c.ahead[4 * 2 + 3] = 5;
  EXPECT_EQ(probe_coordinate(&c), 2);
  c.ahead[4 * 1 + 3] = 5;
  EXPECT_EQ(probe_coordinate(&c), 1);
  c.driving = 2;
  EXPECT_EQ(probe_coordinate(&c), 2);
}

TEST(Rule12_1, EveryIdleMonitorIsKeptByWhoDrives) {
  Random random(2);
  int engaged = 0;
  for (int n = 0; n < 200'000; ++n) {
    const probe_choice given = any(random, 1 + n % 8);
    probe_choice c = given;
    const int best = probe_coordinate(&c);
    for (int j = 0; j < c.count; ++j) {
      ASSERT_GE(c.engaged[j], given.engaged[j]);
      engaged += c.engaged[j] - given.engaged[j];
      if (best >= 0 && c.engaged[j] == 0) ASSERT_TRUE(keeps(c, best, j));
    }
  }
  EXPECT_GT(engaged, 10'000);
}

// What needs no acknowledgement is kept, whatever is found; and what needs one is broken by some.
TEST(Rule12_1, AMonitorWithoutACircleIsKeptWhoeverDrives) {
  Random random(3);
  int safe = 0, broken = 0;
  for (int n = 0; n < 300'000; ++n) {
    probe_choice c = any(random, 4 + n % 5);
    const int best = probe_coordinate(&c);
    if (best < 0) continue;
    for (int j = 0; j < c.count; ++j) {
      const bool kept = keeps(c, best, j);
      if (in_conflict(c, j)) {
        broken += !kept;
      } else {
        ASSERT_TRUE(kept) << "monitor " << j << " of " << c.count;
        safe += c.engaged[j] && best != j;
      }
    }
  }
  EXPECT_GT(safe, 10'000);
  EXPECT_GT(broken, 1'000);
}

// While the same monitors are engaged, whatever else is found: at most once for each monitor, and
// each time to a longer prefix.
TEST(Rule12_1, ControlPassesOnceForEachMonitorThatIsEngaged) {
  Random random(4);
  int passed = 0;
  for (int n = 0; n < 20'000; ++n) {
    probe_choice c = any(random, 5);
    c.driving = probe_coordinate(&c);
    int switches = 0;
    for (int tick = 0; tick < 30 && c.driving >= 0; ++tick) {
      probe_choice next = c;
      for (int k = 0; k < c.count * c.count; ++k) next.ahead[k] = random.below(9) - 4;
      for (int j = 0; j < c.count; ++j) {
        if (c.engaged[j] == 0) next.ahead[c.driving * c.count + j] = random.below(4);
      }
      const int before = probe_kept_prefix(&next, c.driving);
      const int best = probe_coordinate(&next);
      bool same = true;
      for (int j = 0; j < c.count; ++j) same = same && next.engaged[j] == c.engaged[j];
      if (best != c.driving && same) ASSERT_GT(probe_kept_prefix(&next, best), before);
      if (!same) switches = 0;
      switches += best != c.driving;
      passed += best != c.driving;
      ASSERT_LE(switches, c.count);
      c = next;
      c.driving = best;
    }
  }
  EXPECT_GT(passed, 200);
}

// Out of what is false now its own recovery leads (rule 11), and no other one counts.
TEST(Rule12_1, OutOfAViolationItsOwnRecoveryLeads) {
  Random random(5);
  for (int n = 0; n < 50'000; ++n) {
    probe_choice c = any(random, 7);
    const int j = random.below(c.count);
    c.engaged[j] = c.violated[j] = 1;
    const int best = probe_coordinate(&c);
    ASSERT_GE(best, 0);
    for (int i = 0; i < c.count; ++i) ASSERT_EQ(keeps(c, i, j), i == j);
    // the recovery of the first that is false goes before all that keep no more than what is above
    ASSERT_GE(probe_kept_prefix(&c, best), probe_kept_prefix(&c, j));
  }
}

// ---- the golden case: walls > side > calm; the recoveries of walls and calm may leave the side

enum Monitor { walls, side, calm };

class Scene {
 public:
  Scene() { shared_drive_init(&state_); }
  // The cart at (x, y), in mm, with this velocity, in mm/s.
  const shared_drive_out& tick(std::int64_t x, std::int64_t y, std::int64_t vx = 0,
                               std::int64_t vy = 0) {
    shared_drive_in in{};
    set(in.position, x, y);
    set(in.velocity, vx, vy);
    shared_drive_step(&state_, &in, now_us_, &out_);
    now_us_ += 100'000;
    return out_;
  }
  [[nodiscard]] bool engaged(Monitor m) const { return out_.monitors[m].engaged != 0; }

 private:
  void set(shared_point& p, std::int64_t x, std::int64_t y) const {
    p.x_lo = p.x_hi = x;
    p.y_lo = p.y_hi = y;
    p.stamp_us = now_us_;
    p.valid = 1;
  }
  shared_drive_state state_{};
  shared_drive_out out_{};
  std::int64_t now_us_ = 1'000'000;
};

TEST(Rule12_1, TheAdvancedControllerKeepsThemAll) {
  Scene s;
  const shared_drive_out& out = s.tick(5'000, 10'000);
  EXPECT_EQ(out.mode, 0);
  EXPECT_EQ(out.keeps, SHARED_DRIVE_MONITORS);
}

// In the corner of both, the recovery of the lower one keeps both zones.
TEST(Rule12_1, TheRecoveryThatKeepsBothZonesDrives) {
  Scene s;
  ASSERT_EQ(s.tick(5'000, 10'000).mode, 0);
  const shared_drive_out& out = s.tick(9'600, 400, 500, -500);
  EXPECT_TRUE(s.engaged(walls));
  EXPECT_TRUE(s.engaged(side));
  EXPECT_EQ(out.mode, side + 1);
  EXPECT_EQ(out.keeps, 3);
}

// The side fails while the recovery of the walls, which rank higher, drives: it takes over, and
// keeps driving although ahead of the other one the side holds again.
TEST(Rule12_1, WhatIsNotKeptTakesOverAndIsNotHandedBack) {
  Scene s;
  ASSERT_EQ(s.tick(5'000, 10'000).mode, 0);
  ASSERT_EQ(s.tick(5'000, 900, 0, -500).mode, walls + 1);
  EXPECT_EQ(s.tick(5'000, 600).keeps, 3);
  ASSERT_EQ(s.tick(8'000, 600).mode, walls + 1);
  ASSERT_EQ(s.tick(9'750, 600).mode, side + 1);
  for (int n = 0; n < 5; ++n) {
    const shared_drive_out& out = s.tick(9'440, 600);
    EXPECT_TRUE(s.engaged(walls));
    ASSERT_EQ(out.mode, side + 1);
    EXPECT_EQ(out.monitors[side].ahead, SHARED_VERDICT_TRUE);
  }
}

// When the side lets go, the walls, still engaged, get their own recovery back.
TEST(Rule12_1, WhenItLetsGoTheOtherOneGoesOn) {
  Scene s;
  ASSERT_EQ(s.tick(5'000, 10'000).mode, 0);
  ASSERT_EQ(s.tick(9'600, 900, 500, -500).mode, side + 1);
  int ticks = 0;
  while (s.tick(6'000, 1'000).mode == side + 1 && ++ticks < 100) {
  }
  EXPECT_TRUE(s.engaged(walls));
  EXPECT_FALSE(s.engaged(side));
  EXPECT_EQ(s.tick(6'000, 1'000).mode, walls + 1);
}

// The side holds ahead of who drives, who is slow, and not ahead of the fast recovery that is to
// follow: so it engages before that one may drive.
TEST(Rule12_1, AFasterRecoveryIsLookedAheadBeforeItDrives) {
  Scene s;
  ASSERT_EQ(s.tick(5'000, 10'000).mode, 0);
  ASSERT_EQ(s.tick(5'000, 10'000, 1'700, 0).mode, calm + 1);
  s.tick(5'000, 10'000);
  // creeping, at rest, near both boundaries
  const shared_drive_out& out = s.tick(9'450, 560);
  EXPECT_TRUE(s.engaged(walls));
  EXPECT_EQ(out.monitors[side].ahead, SHARED_VERDICT_TRUE);
  EXPECT_TRUE(s.engaged(side));
  EXPECT_EQ(out.mode, side + 1);
}
// Farther from the side it holds ahead of the fast one, too.
TEST(Rule12_1, AFasterRecoveryDrivesWhereThereIsRoomForIt) {
  Scene s;
  ASSERT_EQ(s.tick(5'000, 10'000).mode, 0);
  ASSERT_EQ(s.tick(5'000, 10'000, 1'700, 0).mode, calm + 1);
  s.tick(5'000, 10'000);
  const shared_drive_out& out = s.tick(8'900, 560);
  EXPECT_TRUE(s.engaged(walls));
  EXPECT_FALSE(s.engaged(side));
  EXPECT_NE(out.mode, side + 1);
}

// Unknown is not kept: without samples every monitor engages, and who keeps all of them drives.
TEST(Rule12_1, UnknownIsNotKept) {
  Scene s;
  ASSERT_EQ(s.tick(5'000, 10'000).mode, 0);
  shared_drive_state state{};
  shared_drive_out out{};
  shared_drive_in in{};
  shared_drive_init(&state);
  shared_drive_step(&state, &in, 1'000'000, &out);
  for (const auto& m : out.monitors) EXPECT_TRUE(m.engaged);
  EXPECT_EQ(out.mode, side + 1);
}

}  // namespace
