// The generated wrapper takes doubles: whatever they are, what it finds is so on their exact
// values. The golden case `plain_types`, compiled as it is kept, against the reference.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string>

#include "doubles.h"
#include "tests/differential/engines.h"

namespace rtac::differential {
namespace {

using doubles::Monitors;
using Kind = interp::Reading::Kind;

constexpr std::int64_t period_us = 20'000;

// The exact value of a double: the smallest end with the 1074th decimal.
driver::Observed observed(double value, std::int64_t now_us) {
  if (!std::isfinite(value)) return {{Kind::unknown, {}}, now_us, true};
  std::array<char, 1400> digits{};
  std::snprintf(digits.data(), digits.size(), "%.1074f", value);
  std::string text = digits.data();
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  const std::optional<interp::Decimal> exact = interp::Decimal::parse(text);
  EXPECT_TRUE(exact) << text;
  return {{Kind::number, exact.value_or(interp::Decimal())}, now_us, true};
}

// Doubles at, beside and between steps, and such as no sensor should give.
class Doubles {
 public:
  explicit Doubles(unsigned seed) : random_(seed) {}
  // `limits`: of the input and of what properties compare it with.
  double next(const std::vector<double>& limits, double step) {
    const double limit = limits[below(limits.size())];
    switch (below(12)) {
      case 0:
        return odd();
      case 1:
      case 2:
        return limit;
      case 3:
      case 4:
        return std::nextafter(limit, below(2) == 0 ? -1e9 : 1e9);
      case 5:
        return limit + (below(2) == 0 ? step : -step) / 2;
      case 6:
        return limit + (below(2) == 0 ? step : -step);
      case 7: {
        const double on_grid = std::round(between(limits) / step) * step;
        return std::nextafter(on_grid, below(2) == 0 ? -1e9 : 1e9);
      }
      default:
        return between(limits);
    }
  }
  std::size_t below(std::size_t count) { return random_() % count; }

 private:
  double between(const std::vector<double>& limits) {
    return std::uniform_real_distribution<double>(limits.front(), limits.back())(random_);
  }
  double odd() {
    using Limits = std::numeric_limits<double>;
    const double all[] = {1e308,
                          Limits::max(),
                          Limits::infinity(),
                          Limits::quiet_NaN(),
                          Limits::min(),
                          Limits::denorm_min(),
                          0.0,
                          1e15,
                          1e12,
                          9.3e18};
    return std::copysign(all[below(std::size(all))], below(2) == 0 ? -1.0 : 1.0);
  }
  std::mt19937 random_;
};

// One tick of everything: x, y, z, share, n.
using Sensed = std::array<double, 5>;
Sensed sensed(Doubles& any) {
  return {any.next({-2, -0.7, -0.3, 0.3, 0.7, 2}, 1e-3), any.next({-3, -0.3, 0.9, 3}, 0.03),
          any.next({-1, 0.299, 0.3, 0.301, 1}, 1e-3), any.next({0, 0.01, 0.29, 1}, 1e-6),
          any.below(4) == 0 ? any.next({-5, 3, 4, 100}, 1) : static_cast<double>(any.below(6))};
}
void give(Monitors& monitors, const Sensed& s, std::int64_t now_us) {
  monitors.x(Length(s[0]), now_us).y(Length(s[1]), now_us).z(Length(s[2]), now_us);
  monitors.share(Charge(s[3]), now_us).n(s[4], now_us);
}
std::vector<driver::Observed> given(const Sensed& s, std::int64_t now_us) {
  std::vector<driver::Observed> all;
  for (const double value : s) all.push_back(observed(value, now_us));
  return all;
}

interp::Verdict verdict_of(Verdict found) {
  if (found == Verdict::is_unknown) return interp::Verdict::unknown;
  return found == Verdict::is_true ? interp::Verdict::yes : interp::Verdict::no;
}

class WrapperOfDoubles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ostringstream text;
    text << std::ifstream(RTAC_DOUBLES).rdbuf();
    checked_ = check(text.str(), Until::checked);
    ASSERT_EQ(checked_->problem, "");
    reference_ = driver::make_interpreter(*checked_->compilation.spec);
  }
  std::unique_ptr<Checked> checked_;
  std::unique_ptr<driver::Engine> reference_;
};

// All but a product compare an input with a step of its grid: exactly (rule 13.1).
TEST_F(WrapperOfDoubles, FindsWhatIsSoOnTheirExactValues) {
  Doubles any(7);
  Monitors whole, alone;
  std::vector<driver::Judgement> exact;
  std::array<std::array<int, 3>, Monitors::count> seen{};
  int open = 0;
  for (std::int64_t tick = 0; tick < 5000; ++tick) {
    const std::int64_t now_us = tick * period_us;
    const Sensed s = sensed(any);
    give(whole, s, now_us);
    give(alone, s, now_us);
    const auto& findings = whole.step(now_us);
    const auto& verdicts = alone.verdicts(now_us);
    reference_->step(now_us, given(s, now_us), exact);
    for (std::size_t m = 0; m < Monitors::count; ++m) {
      const std::string what = std::string(Monitors::info()[m].name) + " at tick " +
                               std::to_string(tick) + ": " + ::testing::PrintToString(s);
      const interp::Verdict found = verdict_of(findings[m].verdict);
      ASSERT_EQ(verdict_of(verdicts[m]), found) << what;
      ++seen[m][static_cast<std::size_t>(found)];
      if (m == Monitors::wide_index && found == interp::Verdict::unknown) {
        open += exact[m].verdict != found ? 1 : 0;
        continue;
      }
      ASSERT_EQ(exact[m].verdict, found) << what;
    }
  }
  for (std::size_t m = 0; m < Monitors::count; ++m) {
    if (m == Monitors::fresh_index) continue;  // never older
    for (const int times : seen[m]) EXPECT_GT(times, 10) << Monitors::info()[m].name;
  }
  EXPECT_LT(open, 100);  // within the rounding of a product
}

}  // namespace
}  // namespace rtac::differential
