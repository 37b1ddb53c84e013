// The step of a large fleet leaves robots out that are far off. What it finds is, in every case and
// to the last digit, what the steps of all pairs find together: these leave nobody out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "closed_of_24_kernel.h"
#include "closed_of_2_kernel.h"
#include "open_of_24_kernel.h"
#include "open_of_2_kernel.h"
#include "space_of_24_kernel.h"
#include "space_of_2_kernel.h"

namespace {

constexpr int robots = 24;
constexpr std::int64_t now_us = 10'000'000, hears_us = 200'000, age_us = 100'000;

// One kernel, by its names.
#define RTAC_STEP(kind, count)                                          \
  struct kind##_##count {                                               \
    using In = kind##_of_##count##_drive_in;                            \
    using Out = kind##_of_##count##_drive_out;                          \
    using State = kind##_of_##count##_drive_state;                      \
    static void init(State& s) { kind##_of_##count##_drive_init(&s); }  \
    static void step(State& s, const In& in, std::int64_t at, Out& o) { \
      kind##_of_##count##_drive_step(&s, &in, at, &o);                  \
    }                                                                   \
  };
RTAC_STEP(open, 2)
RTAC_STEP(open, 24)
RTAC_STEP(closed, 2)
RTAC_STEP(closed, 24)
RTAC_STEP(space, 2)
RTAC_STEP(space, 24)
#undef RTAC_STEP

enum { is_false = OPEN_OF_24_VERDICT_FALSE, is_true = OPEN_OF_24_VERDICT_TRUE };

class Scene {
 public:
  explicit Scene(unsigned seed) : random_(seed) {}
  std::int64_t whole(std::int64_t lo, std::int64_t hi) {
    return std::uniform_int_distribution<std::int64_t>(lo, hi)(random_);
  }
  bool one_in(int n) { return whole(1, n) == 1; }

  template <class Point>
  void point(Point& p, std::int64_t x, std::int64_t y, std::int64_t high, std::int64_t age,
             bool faults) {
    const std::int64_t wide =
        faults && one_in(12) ? whole(2, one_in(2) ? 4'000 : 60'000) : whole(0, 1);
    p.x_lo = x;
    p.x_hi = x + wide;
    p.y_lo = y;
    p.y_hi = y + whole(0, 1);
    if constexpr (requires { p.z_lo; }) {
      p.z_lo = high;
      p.z_hi = high + (faults && one_in(12) ? whole(2, 60'000) : whole(0, 1));
    }
    p.stamp_us = now_us - whole(0, age);
    if (faults && one_in(12)) p.stamp_us = now_us - age - 1;
    if (faults && one_in(40)) p.stamp_us = now_us + 1;
    p.valid = faults && one_in(20) ? 0 : 1;
  }
  // Speeds up to the declared one and its error, or beyond.
  template <class Point>
  void velocity(Point& v, std::int64_t age, bool faults) {
    const std::int64_t most = faults && one_in(8) ? 4000 : 1400;
    point(v, whole(-most, most), whole(-most, most), whole(-most, most), age, faults);
  }
  // `spread`: half of the side of the square that they are in, mm. `faults`: one in how many.
  template <class In>
  void fill(In& in, std::int64_t spread, bool own_faults, int fault_of) {
    std::memset(&in, 0, sizeof in);
    in.self = static_cast<std::int32_t>(whole(0, robots - 1));
    const std::int64_t middle = 100'000;
    const auto place = [&] { return middle + whole(-spread, spread); };
    // in space often one above the other
    const std::int64_t flat = one_in(2) ? spread : 0;
    const auto height = [&] { return flat > 0 ? whole(-flat, flat) : whole(-60'000, 60'000); };
    point(in.position, place(), place(), height(), age_us, own_faults);
    velocity(in.velocity, age_us, own_faults);
    for (auto& o : in.others) {
      const bool faults = fault_of > 0 && one_in(fault_of);
      point(o.position, place(), place(), height(), hears_us, faults);
      if (faults && one_in(10)) o.position.x_hi = o.position.x_lo = 2'000'000'000;
      if constexpr (requires { o.position.z_lo; }) {
        if (faults && one_in(10)) o.position.z_hi = o.position.z_lo = -2'000'000'000;
      }
      velocity(o.velocity, hears_us, faults);
      o.lease_end_us = one_in(4) ? now_us + whole(0, 1'200'000) : INT64_MIN;
      o.goes_first = one_in(2);
      presence(o);
    }
  }
  template <class Other>
  void presence(Other& o) {
    if constexpr (requires { o.present; }) {
      o.presence_us = now_us - whole(0, hears_us + 20'000);
      o.present = one_in(3) ? 0 : 1;
    }
  }

 private:
  std::mt19937 random_;
};

struct Found {
  std::int32_t now = is_true, ahead = is_true, safer = is_true, gate = 0;
  std::int64_t margin = INT64_MAX, now_margin = INT64_MAX, violation_us = INT64_MAX;
  bool operator==(const Found&) const = default;
  friend std::ostream& operator<<(std::ostream& out, const Found& f) {
    return out << f.now << " " << f.ahead << " " << f.safer << " gate " << f.gate << " margins "
               << f.margin << " " << f.now_margin << " violation " << f.violation_us;
  }
};

template <class Kernel>
Found first_step(const typename Kernel::In& in) {
  typename Kernel::State state;
  typename Kernel::Out out;
  Kernel::init(state);
  Kernel::step(state, in, now_us, out);
  const auto& m = out.monitors[0];
  return {m.now, m.ahead, m.safer, out.gate, m.margin, m.now_margin, out.violation_us};
}

std::int32_t both(std::int32_t a, std::int32_t b) {
  if (a == is_false || b == is_false) return is_false;
  return a == is_true ? b : a;
}

// What the pairs find together; nothing is unknown first, then free of the others.
template <class Pair, class Fleet>
Found of_pairs(const typename Fleet::In& in) {
  Found all;
  for (int j = 0; j < robots; ++j) {
    if (j == in.self) continue;
    typename Pair::In two;
    std::memset(&two, 0, sizeof two);
    // whoever goes first is told by goes_first, not by the number
    two.self = 0;
    std::memcpy(&two.position, &in.position, sizeof two.position);
    std::memcpy(&two.velocity, &in.velocity, sizeof two.velocity);
    static_assert(sizeof two.others[1] == sizeof in.others[0]);
    std::memcpy(&two.others[1], &in.others[j], sizeof two.others[1]);
    const Found one = first_step<Pair>(two);
    all.now = both(all.now, one.now);
    all.ahead = both(all.ahead, one.ahead);
    all.safer = both(all.safer, one.safer);
    all.gate = std::max(all.gate, one.gate);
    all.margin = std::min(all.margin, one.margin);
    all.now_margin = std::min(all.now_margin, one.now_margin);
    all.violation_us = std::min(all.violation_us, one.violation_us);
  }
  return all;
}

template <class Pair, class Fleet>
void compare(unsigned seeds) {
  int held = 0, failing = 0;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    Scene scene(seed);
    const std::int64_t spreads_mm[] = {800, 3'000, 8'000, 20'000, 50'000, 95'000};
    typename Fleet::In in;
    scene.fill(in, spreads_mm[seed % 6], scene.one_in(10),
               scene.one_in(2) ? 0 : static_cast<int>(scene.whole(1, 60)));
    const Found fleet = first_step<Fleet>(in);
    const Found pairs = of_pairs<Pair, Fleet>(in);
    ASSERT_EQ(fleet, pairs) << "seed " << seed;
    held += fleet.ahead == is_true;
    failing += fleet.gate != 0;
  }
  EXPECT_GT(held, seeds / 20);
  EXPECT_GT(failing, seeds / 20);
}

TEST(Fleet, FindsWhatAllPairsFind) {
  compare<closed_2, closed_24>(4'000);
}
TEST(Fleet, FindsWhatAllPairsFindOfThoseThatArePresent) {
  compare<open_2, open_24>(4'000);
}

TEST(Fleet, FindsWhatAllPairsFindInSpace) {
  compare<space_2, space_24>(4'000);
}

// Far off and left out, but not forgotten: a stamp that goes backwards is a fault all the same.
TEST(Fleet, NoticesTheFaultsOfThoseFarOff) {
  for (int fault = 0; fault < 4; ++fault) {
    closed_24::In in;
    Scene(1).fill(in, 0, false, 0);
    in.self = 0;
    for (int j = 1; j < robots; ++j) {
      auto& o = in.others[j];
      o.position.x_lo = o.position.x_hi = in.position.x_lo + 5'000 * j;
      o.lease_end_us = now_us + 500'000;
    }
    closed_24::State state;
    closed_24::Out out;
    closed_24::init(state);
    for (auto& o : in.others) o.position.stamp_us = o.velocity.stamp_us = now_us - 1'000;
    in.position.stamp_us = in.velocity.stamp_us = now_us;
    closed_24::step(state, in, now_us, out);
    ASSERT_EQ(out.monitors[0].ahead, is_true);
    auto& far = in.others[robots - 1];
    if (fault == 1) far.position.stamp_us -= 1'000;
    if (fault == 2) far.velocity.stamp_us -= 1'000;
    if (fault == 3) far.lease_end_us -= 1'000;  // a promise cannot be taken back
    in.position.stamp_us = in.velocity.stamp_us = now_us + 50'000;
    closed_24::step(state, in, now_us + 50'000, out);
    EXPECT_EQ(out.monitors[0].ahead == is_true, fault == 0) << fault;
  }
}

// Nobody of the fleet, or a place that is not known: nothing is known of any distance.
TEST(Fleet, KnowsNothingWithoutItsOwnPlace) {
  closed_24::In in;
  Scene(2).fill(in, 20'000, false, 0);
  in.position.valid = 0;
  EXPECT_NE(first_step<closed_24>(in).ahead, is_true);
  EXPECT_NE(first_step<closed_24>(in).now, is_true);
  in.position.valid = 1;
  in.self = robots;
  EXPECT_NE(first_step<closed_24>(in).ahead, is_true);
}

}  // namespace
