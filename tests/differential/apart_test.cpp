// How far two zones are apart: generated code against exact geometry, around every such distance.
#include <gtest/gtest.h>

#include "tests/differential/engines.h"

namespace rtac::differential {
namespace {

// On the grid and between its steps; known from both sides alone, of curves and offsets.
constexpr const char* pairs[] = {
    "pad, hut",
    "hut, pad",
    "pad, rectangle (2 m, 2 m) to (3 m, 3 m)",
    "pad, rectangle (3 m, 3 m) to (4 m, 4 m)",
    "pad, polygon [(2.0004 m, 0.5 m), (4 m, 0 m), (4 m, 1 m)]",
    "pad, polygon [(2.9999 m, 3 m), (4 m, 3 m), (3 m, 4.0001 m)]",
    "pad, pond",
    // what surely lies in them is 3 m apart, what contains them a little less
    "rectangle (5 m, 0 m) to (6 m, 1 m) | circle (5.085372 m, 2.303883 m) radius 0.1 m, pad",
    "pond, circle (8 m, 4 m) radius 50 cm",
    "grow(pad, 1 m), hut",
    "shrink(hut, 10 cm), complement(grow(hut, 1 m))",
    "pad | hut, hut - pad",
    "room, loft",
    "loft, box (2 m, 2 m, 8 m) to (3 m, 3 m, 9 m)",
    "prism (pond) from 0 m to 1 m, loft",
    "grow(room, 0.5 m), loft",
};

std::string spec() {
  std::string text =
      "spec s;\nperiod 1 s;\n"
      "zone pad = rectangle (0 m, 0 m) to (2 m, 2 m);\n"
      "zone hut = rectangle (5 m, 6 m) to (7 m, 8 m);\n"
      "zone pond = circle (6 m, 0 m) radius 1 m;\n"
      "zone room = box (0 m, 0 m, 0 m) to (2 m, 2 m, 0.1004 m);\n"
      "zone loft = prism (hut) from 12 m to 15 m;\n"
      "input x : real [m] in 0 .. 20 m;\n";
  int count = 0;
  for (const char* pair : pairs) {
    const std::string k = std::to_string(count++);
    text += "monitor a" + k + " { \"R1: a\" always distance(" + pair + ") >= x; }\n";
    text += "monitor b" + k + " { \"R2: b\" always distance(" + pair + ") < x; }\n";
  }
  return text;
}

driver::Observed observed(const Rational& metres, std::int64_t now_us) {
  return {
      {interp::Reading::Kind::number, *interp::Decimal::parse(to_decimal(metres))}, now_us, true};
}

// The least and the most that each of them may be, as the reference has it.
std::vector<driver::MarginEnds> known(driver::Engine& engine) {
  std::vector<driver::Judgement> found;
  engine.step(0, {observed(0, 0)}, found);
  std::vector<driver::MarginEnds> ends;
  for (std::size_t k = 0; k < std::size(pairs); ++k) ends.push_back(engine.margin(2 * k));
  return ends;
}

// At x both are judged: what generated code says, the reference says too, and it says something
// where x is more than 2 mm off.
class Judges {
 public:
  Judges(driver::Engine& reference, driver::Engine& kernel)
      : reference_(reference), kernel_(kernel) {}

  void judge(std::size_t pair, const Rational& x, bool is_near) {
    now_us_ += 1'000'000;
    reference_.step(now_us_, {observed(x, now_us_)}, exact_);
    kernel_.step(now_us_, {observed(x, now_us_)}, found_);
    for (const std::size_t m : {2 * pair, 2 * pair + 1}) {
      SCOPED_TRACE(std::string(pairs[pair]) + " at " + to_decimal(x));
      const bool is_open = found_[m].verdict == interp::Verdict::unknown;
      if (is_near && is_open) continue;
      EXPECT_EQ(found_[m].verdict, exact_[m].verdict);
      if (is_near) ++decided_nearby_;
    }
  }
  [[nodiscard]] std::size_t decided_nearby() const { return decided_nearby_; }

 private:
  driver::Engine &reference_, &kernel_;
  std::int64_t now_us_ = 0;
  std::vector<driver::Judgement> exact_, found_;
  std::size_t decided_nearby_ = 0;
};

TEST(ZonesApart, GeneratedCodeKnowsThemWithinAStepOfTheGrid) {
  const auto checked = check(spec(), Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const auto reference = driver::make_interpreter(*checked->compilation.spec);
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  const driver::LoadedKernel kernel = load(code, {}, Speed::of_building);
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const std::vector<driver::MarginEnds> all = known(*reference);
  Judges judges(*reference, *kernel.engine);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Rational lo = all[k].lo.value(), hi = all[k].hi.value();
    EXPECT_LE(hi - lo, Rational(3, 100)) << pairs[k];
    for (const int um : {-20'000, -2000, -1000, -999, -1, 0, 1, 999, 1000, 2000, 20'000}) {
      for (const Rational& end : {lo, hi}) {
        const Rational near = (end + Rational(um, 1'000'000)) * 1'000'000;
        const Rational x(mpz_class(near.get_num() / near.get_den()), 1'000'000);
        if (x < 0) continue;
        judges.judge(k, x, x >= lo - Rational(2, 1000) && x <= hi + Rational(2, 1000));
      }
    }
  }
  EXPECT_GT(judges.decided_nearby(), 150U);
}

}  // namespace
}  // namespace rtac::differential
