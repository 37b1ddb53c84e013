// Legs and paths: generated code against exact geometry, and exact geometry against many places
// along them. On the grid and off it, with holes, along walls, through corners.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/differential/batch.h"

namespace rtac::differential {
namespace {

using driver::Observed;
using interp::Reading;
using interp::Waypoint;

const char* const spec =
    "spec s;\nperiod 1 s;\n"
    "zone yard = polygon [(0 m, 0 m), (10 m, 0 m), (10 m, 4 m), (6 m, 4 m), (6 m, 6 m), "
    "(10 m, 6 m), (10 m, 10 m), (0 m, 10 m)] hole [(2 m, 2 m), (4 m, 2 m), (4 m, 4 m), "
    "(2 m, 4 m)];\n"
    "zone pond = circle (5 m, 5 m) radius 2 m;\n"
    "zone kiss = rectangle (0 m, 0 m) to (10 m, 4 m) | polygon [(5 m, 4 m), (8 m, 8 m), (2 m, 8 "
    "m)];\n"
    "zone lane = grow(rectangle (1 m, 1 m) to (9 m, 1.5 m), 30 cm);\n"
    "input plan : path[6] max_age 3 s;\ninput other : path[3] max_age inf;\n"
    "input p : point in -20 .. 20 m;\ninput q : point in -20 .. 20 m error 2 cm;\n"
    "input r : point in -20 .. 20 m resolution 0.7 mm;\n"
    "monitor a { \"R1\" always plan inside yard; }\n"
    "monitor b { \"R2\" always plan inside complement(pond); }\n"
    "monitor c { \"R3\" always clearance(plan, yard) >= 10 cm; }\n"
    "monitor d { \"R4\" always distance(plan, pond) >= 20 cm; }\n"
    "monitor e { \"R5\" always leg(q, plan) inside yard; }\n"
    "monitor f { \"R6\" always path(p, r, plan) inside yard; }\n"
    "monitor g { \"R7\" always leg(p, r) inside lane; }\n"
    "monitor h { \"R8\" always distance(leg(p, q), lane) >= 1 m; }\n"
    "monitor i { \"R9\" always distance(plan, other) >= 50 cm; }\n"
    "monitor j { \"R10\" always distance(path(p, q, r), plan) >= 50 cm; }\n"
    "monitor k { \"R11\" always distance(leg(p, plan), r) <= 1 m; }\n"
    "monitor l { \"R12\" always clearance(leg(p, r), yard) >= -1 m; }\n"
    "monitor m { \"R13\" always once[0 s, 2 s] leg(p, r) inside complement(yard); }\n"
    "monitor n { \"R14\" always min[0 s, 2 s](clearance(leg(p, r), yard)) >= 0 m; }\n"
    "monitor x { \"R16\" always plan inside kiss; }\n"
    "monitor o { \"R15\" always clearance(plan, complement(pond)) >= 0 m or distance(plan, q) < 1 "
    "m; "
    "}\n";

// What arrives at each tick.
class Ticks {
 public:
  explicit Ticks(unsigned seed) : random_(seed) {}
  std::vector<Observed> next(std::int64_t now_us) {
    std::vector<Observed> inputs;
    put_path(6, now_us, inputs);
    put_path(3, now_us, inputs);
    for (int k = 0; k < 3; ++k) put_point(now_us, inputs);
    return inputs;
  }

 private:
  double any(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool one_of(unsigned n) { return random_() % n == 0; }
  // On corners and walls, near them, on whole metres, or anywhere.
  std::pair<double, double> place() {
    static constexpr double walls[] = {0, 1, 1.5, 2, 3, 4, 5, 6, 7, 9, 10};
    const auto coordinate = [&] {
      if (one_of(3)) return any(-2, 12);
      const double off = one_of(2) ? 0 : one_of(2) ? 0.001 : any(-0.02, 0.02);
      return walls[random_() % 11] + off;
    };
    const double x = coordinate();
    return {x, coordinate()};
  }
  Reading path(std::size_t most) {
    Reading reading;
    const std::size_t count = random_() % (most + 2);
    if (count > most || one_of(20)) {  // too many of them, or not finite
      reading.kind = Reading::Kind::unknown;
      return reading;
    }
    std::vector<Waypoint> points;
    for (std::size_t k = 0; k < count; ++k) {
      const auto [x, y] = place();
      points.push_back({std::lround(x * 1000), std::lround(y * 1000)});
    }
    if (one_of(30) && count > 0) points[0].x_mm = (std::int64_t{1} << 29) + 1;
    reading.kind = Reading::Kind::number;
    reading.number = interp::Decimal(1);
    reading.path = std::make_shared<const std::vector<Waypoint>>(std::move(points));
    return reading;
  }
  void put_path(std::size_t most, std::int64_t now_us, std::vector<Observed>& to) {
    const bool is_new = one_of(2);
    to.push_back({path(most), now_us, is_new});
    const auto next = static_cast<std::int64_t>(random_() % (most + 2)) - (one_of(20) ? 2 : 0);
    to.push_back({{Reading::Kind::number, interp::Decimal(next)}, now_us, is_new});
  }
  void put_point(std::int64_t now_us, std::vector<Observed>& to) {
    const auto [x, y] = place();
    for (const double metres : {x, y}) {
      const std::string text = to_decimal(Rational(std::lround(metres * 1e4), 10000UL));
      const bool known = !one_of(60);
      to.push_back(
          {{known ? Reading::Kind::number : Reading::Kind::unknown, *interp::Decimal::parse(text)},
           now_us,
           true});
    }
  }
  std::mt19937 random_;
};

// What the reference finds, once for all kernels.
class Reference {
 public:
  Reference() : checked_(check(spec, Until::kernel)) {
    if (checked_->problem.empty()) code_ = driver::kernel_code(checked_->compilation);
  }
  [[nodiscard]] const std::string& problem() const { return checked_->problem; }
  [[nodiscard]] const driver::KernelCode& code() const { return code_; }
  // The first finding of a kernel that is not conservative, or not tight; "": there is none.
  std::string difference(driver::Engine& kernel) {
    std::vector<driver::Judgement> found;
    std::int64_t tick = 0;
    for (const Step& step : steps()) {
      kernel.step(tick * 1000000, step.inputs, found);
      for (std::size_t k = 0; k < found.size(); ++k) {
        const char* const fault =
            this->fault(k, step.exact[k].verdict, step.margins[k], found[k], kernel.margin(k));
        if (*fault == 0) continue;
        return "monitor " + std::to_string(k) + " at tick " + std::to_string(tick) + " is " +
               fault + ": exact " + step.exact[k].margin + ", found " + found[k].margin;
      }
      ++tick;
    }
    return "";
  }
  // The same of verdicts alone.
  std::string difference(driver::Engine& kernel, driver::Engine& alone) {
    std::vector<driver::Judgement> found, verdicts;
    std::int64_t tick = 0;
    for (const Step& step : steps()) {
      kernel.step(tick * 1000000, step.inputs, found);
      alone.step(tick * 1000000, step.inputs, verdicts);
      for (std::size_t k = 0; k < found.size(); ++k) {
        if (found[k].verdict != verdicts[k].verdict) {
          return "monitor " + std::to_string(k) + " at tick " + std::to_string(tick);
        }
      }
      ++tick;
    }
    return "";
  }
  [[nodiscard]] std::size_t count(std::size_t monitor, interp::Verdict verdict) {
    std::size_t count = 0;
    for (const Step& step : steps()) count += step.exact[monitor].verdict == verdict ? 1 : 0;
    return count;
  }
  [[nodiscard]] std::size_t monitors() { return steps().front().exact.size(); }

 private:
  struct Step {
    std::vector<Observed> inputs;
    std::vector<driver::Judgement> exact;
    std::vector<driver::MarginEnds> margins;
  };
  // Takes long; who asks for the code alone does not wait for it.
  const std::vector<Step>& steps() {
    if (!steps_.empty()) return steps_;
    const auto engine = driver::make_interpreter(*checked_->compilation.spec);
    Ticks ticks(1);
    for (std::int64_t tick = 0; tick < 1200; ++tick) {
      Step& step = steps_.emplace_back();
      step.inputs = ticks.next(tick * 1000000);
      engine->step(tick * 1000000, step.inputs, step.exact);
      for (std::size_t k = 0; k < step.exact.size(); ++k) step.margins.push_back(engine->margin(k));
    }
    return steps_;
  }
  static const char* fault(std::size_t monitor, interp::Verdict exact, const driver::MarginEnds& e,
                           const driver::Judgement& found, const driver::MarginEnds& f) {
    const bool is_unknown = found.verdict == interp::Verdict::unknown;
    if (!is_unknown && found.verdict != exact) return "wrong";
    if (e.lo < f.lo || f.hi < e.hi) return "too sure";
    constexpr std::size_t below_0 = 11;  // `l` asks for a clearance below 0; behind it is the past
    if (exact == interp::Verdict::unknown || monitor > below_0) return "";
    const bool is_open = !e.lo.is_finite() && !e.hi.is_finite();
    if (is_open) return is_unknown ? "needlessly unknown" : "";
    if (!e.lo.is_finite() || !e.hi.is_finite()) return "";
    // What touches a boundary may cross it, for all that bounds can tell.
    const bool holds = exact == interp::Verdict::yes;
    const Rational off = holds ? e.lo.value() : Rational(-e.hi.value());
    const Rational beyond = off - (monitor == below_0 && holds ? 1 : 0);
    if (beyond <= Rational(12, 1000)) return "";
    if (is_unknown) return "needlessly unknown";
    if (!holds) return "";
    const bool is_tight =
        f.lo.is_finite() && Rational(e.lo.value() - f.lo.value()) <= Rational(10, 1000);
    return is_tight ? "" : "too low";
  }

  std::unique_ptr<Checked> checked_;
  driver::KernelCode code_;
  std::vector<Step> steps_;
};
Reference& reference() {
  static Reference made;
  return made;
}

TEST(Trails, AreJudgedConservativelyAndTightly) {
  ASSERT_EQ(reference().problem(), "");
  const driver::LoadedKernel kernel = load(reference().code());
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  EXPECT_EQ(reference().difference(*kernel.engine), "");
  const driver::LoadedKernel alone = load_verdicts(reference().code());
  ASSERT_NE(alone.engine, nullptr) << alone.problem;
  kernel.engine->restart();
  EXPECT_EQ(reference().difference(*kernel.engine, *alone.engine), "");
  for (std::size_t k = 0; k < reference().monitors(); ++k) {
    SCOPED_TRACE("monitor " + std::to_string(k));
    EXPECT_GT(reference().count(k, interp::Verdict::yes), 5U);
    EXPECT_GT(reference().count(k, interp::Verdict::no), 20U);
  }
}

// 0.35 mm deep through a corner of the hole, and as far beside it.
TEST(Trails, WhatCrossesABoundaryIsNotInsideHoweverLittle) {
  ASSERT_EQ(reference().problem(), "");
  const auto judged = [&](std::int64_t sum_mm, const Edit& edit) {
    const driver::LoadedKernel kernel = load(reference().code(), edit, Speed::of_building);
    Reading plan;
    plan.kind = Reading::Kind::number;
    plan.path = std::make_shared<const std::vector<Waypoint>>(
        std::vector<Waypoint>{{3000, sum_mm - 3000}, {sum_mm - 3000, 3000}});
    std::vector<Observed> inputs(10);
    inputs[0] = {plan, 0, true};
    inputs[1] = {{Reading::Kind::number, interp::Decimal(0)}, 0, true};
    std::vector<driver::Judgement> found;
    kernel.engine->step(0, inputs, found);
    return found[0].verdict;
  };
  EXPECT_EQ(judged(7999, {}), interp::Verdict::no);
  EXPECT_EQ(judged(8010, {}), interp::Verdict::yes);
  EXPECT_EQ(judged(8000, {}), interp::Verdict::unknown);
  const auto without = [](std::string text) {
    const std::string crosses = "m.hi = min_of(m.hi, -1);";
    return text.replace(text.find(crosses), crosses.size(), "");
  };
  EXPECT_EQ(judged(7999, without), interp::Verdict::unknown);
}

// From one part of a zone into another one, where a corner of one touches a wall of the other.
TEST(Trails, WhatLeadsThroughAPlaceWherePartsTouchIsInside) {
  ASSERT_EQ(reference().problem(), "");
  Reading plan;
  plan.kind = Reading::Kind::number;
  plan.path = std::make_shared<const std::vector<Waypoint>>(
      std::vector<Waypoint>{{5000, 2000}, {5000, 6000}});
  std::vector<Observed> inputs(10);
  inputs[0] = {plan, 0, true};
  inputs[1] = {{Reading::Kind::number, interp::Decimal(0)}, 0, true};
  constexpr std::size_t kiss = 14;
  const auto judged = [&](driver::Engine& engine) {
    std::vector<driver::Judgement> found;
    engine.step(0, inputs, found);
    return found[kiss].verdict;
  };
  const auto found = [&](const Edit& edit) {
    return judged(*load(reference().code(), edit, Speed::of_building).engine);
  };
  const auto checked = check(spec, Until::kernel);
  EXPECT_EQ(judged(*driver::make_interpreter(*checked->compilation.spec)), interp::Verdict::yes);
  EXPECT_EQ(found({}), interp::Verdict::unknown);
  const auto without = [](std::string text) {
    const std::string asks = "!vertex_on_leg(z, from, to)";
    return text.replace(text.find(asks), asks.size(), "1");
  };
  EXPECT_EQ(found(without), interp::Verdict::no);
}

// Along a wall all places are as far outside, so that no division of the leg is better than
// another: the worst case. Random legs are known better.
class FarLegs {
 public:
  FarLegs()
      : checked_(check("spec s;\nperiod 1 s;\n"
                       "zone yard = rectangle (0 m, 0 m) to (64 m, 10 m) - rectangle (20 m, 2 m) "
                       "to (44 m, 8 m);\n"
                       "input plan : path[2];\n"
                       "monitor m { \"R1\" always clearance(plan, yard) >= -1 m; }\n",
                       Until::kernel)),
        reference_(driver::make_interpreter(*checked_->compilation.spec)),
        code_(driver::kernel_code(checked_->compilation)) {}

  // How far generated code is below the reference, in parts of the leg: 10 mm are given away
  // anyhow.
  double below(driver::Engine& kernel, const Waypoint& from, const Waypoint& to) {
    Reading plan;
    plan.kind = Reading::Kind::number;
    plan.path = std::make_shared<const std::vector<Waypoint>>(std::vector<Waypoint>{from, to});
    const std::vector<Observed> inputs = {
        {plan, now_us_, true}, {{Reading::Kind::number, interp::Decimal(0)}, now_us_, true}};
    std::vector<driver::Judgement> found;
    reference_->step(now_us_, inputs, found);
    kernel.step(now_us_, inputs, found);
    now_us_ += 1'000'000;
    const double gap =
        Rational(reference_->margin(0).hi.value() - kernel.margin(0).lo.value()).get_d();
    const double length = std::hypot(static_cast<double>(to.x_mm - from.x_mm),
                                     static_cast<double>(to.y_mm - from.y_mm));
    return (gap * 1000 - 10) / length;
  }
  [[nodiscard]] driver::LoadedKernel loaded(const Edit& edit) const {
    return load(code_, edit, Speed::of_building);
  }

 private:
  std::unique_ptr<Checked> checked_;
  std::unique_ptr<driver::Engine> reference_;
  driver::KernelCode code_;
  std::int64_t now_us_ = 0;
};

TEST(Trails, TheFarthestPlaceOutsideIsKnownToASixtyFourthOfALeg) {
  FarLegs legs;
  const driver::LoadedKernel kernel = legs.loaded({});
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const Waypoint from{0, -5000}, to{64'000, -5000};
  EXPECT_LE(legs.below(*kernel.engine, from, to), 1.0 / 64);
  EXPECT_GE(legs.below(*kernel.engine, from, to), 1.0 / 70);
  std::mt19937 random(3);
  const auto place = [&] {
    return Waypoint{static_cast<std::int64_t>(random() % 90'000) - 10'000,
                    static_cast<std::int64_t>(random() % 40'000) - 10'000};
  };
  for (int k = 0; k < 300; ++k) {
    const Waypoint a = place(), b = place();
    // what the reference leaves open itself is a two-hundredth
    ASSERT_LE(legs.below(*kernel.engine, a, b), 1.0 / 64 + 1.0 / 200)
        << a.x_mm << ' ' << a.y_mm << " to " << b.x_mm << ' ' << b.y_mm;
  }
}

struct Mistake {
  const char *name, *text, *instead;
};
// Each is one of the library's text, at every place of it.
const Mistake mistakes[] = {
    {"stretches_fall_by_nothing", "lo_from + lo_to - length * (to - from) / 2048 - 1",
     "lo_from + lo_to"},
    {"the_first_stretch_is_the_lowest", "all[k].least < all[low].least ? k : low", "0"},
    {"legs_are_their_ends", "if (gap >= 1 && (inside_zone(z, a) != 0) != (turned != 0))",
     "if ((inside_zone(z, a) != 0) != (turned != 0))"},
    {"sides_are_not_turned", "(at.inside != 0) != (turned != 0)", "at.inside != 0"},
    {"errors_of_places_are_none", "least.lo - t->room_mm", "least.lo"},
    {"errors_of_places_are_those_of_the_last",
     "max_of(t.room_mm, root_up(dot(half, half)) + (is_cell ? 0 : 2))",
     "root_up(dot(half, half)) + (is_cell ? 0 : 2)"},
    {"within_is_around", "trail_least(greatest ? around : within, &t, greatest)",
     "trail_least(greatest ? within : around, &t, greatest)"},
    {"the_last_leg_is_left_out", "k < places; ++k) {\n    const span leg",
     "k < places - 1; ++k) {\n    const span leg"},
    {"paths_lead_on_from_their_start", "trail_then(trail_of_place(x, y), p, p.next,",
     "trail_then(trail_of_place(x, y), p, 0,"},
    {"the_next_way_point_is_all", "min_of(most, p.count - first)", "(p.count - first)"},
    {"paths_may_have_any_index", "&& next <= count", ""},
    {"empty_paths_lead_somewhere", "return p.count > 0 ? margin_true() : margin_false();",
     "return margin_true();"},
    {"legs_cross_without_meeting", "if (cross_each_other(a, b, c, d)) {\n    return span_of(0, 0);",
     "if (0) {\n    return span_of(0, 0);"},
    {"legs_are_apart_by_their_ends", "gap.hi = gap.lo < SPAN_MAX ? gap.lo + 3 : gap.hi;",
     "gap.lo = SPAN_MAX;"},
};

TEST(Trails, MistakesAreNoticed) {
  ASSERT_EQ(reference().problem(), "");
  for (const Mistake& mistake : mistakes) {
    SCOPED_TRACE(mistake.name);
    bool matches = false;
    const auto edit = [&](const std::string& text) {
      std::string to = text;
      const std::string from = mistake.text;
      for (std::size_t at = to.find(from); at != std::string::npos; at = to.find(from, at + 1)) {
        to.replace(at, from.size(), mistake.instead);
        matches = true;
      }
      return to;
    };
    const driver::LoadedKernel kernel = load(reference().code(), edit, Speed::of_building);
    ASSERT_TRUE(matches) << "the kernel has no such text any more";
    ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
    EXPECT_NE(reference().difference(*kernel.engine), "");
  }
}

}  // namespace
}  // namespace rtac::differential
