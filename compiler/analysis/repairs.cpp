#include "compiler/analysis/repairs.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/timing.h"
#include "compiler/analysis/travel.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::analysis {
namespace {

constexpr std::size_t offered_most = 3;
constexpr std::int64_t grown_most = 1'000'000;  // steps of what helps by growing

// A number of the specification, on a grid on which it is looked for.
struct Number {
  std::string what;  // "a `latency`"
  const char* unit;
  int per_unit;            // steps of the grid in an SI unit
  int shown_per_unit;      // of the unit that it is shown in
  std::int64_t least = 1;  // steps; what is less is refused, or no robot has it
  bool grows = false;      // a larger one helps
  std::function<sema::Quantity*(sema::RobotKind&, sema::Decision&)> of;
};

sema::Quantity* in(std::optional<sema::Quantity>& q) {
  return q ? &*q : nullptr;
}

// Everything that the clearance depends on at which control can be given back, or a way.
std::vector<Number> numbers() {
  using Kind = sema::RobotKind;
  using Of = std::function<sema::Quantity*(Kind&, sema::Decision&)>;
  const auto sensed = [](std::optional<sema::Sense> Kind::*which, bool age) -> Of {
    return [which, age](Kind& k, sema::Decision&) {
      if (!(k.*which)) return static_cast<sema::Quantity*>(nullptr);
      return age ? &(k.*which)->max_age : &(k.*which)->error;
    };
  };
  const auto own = [](sema::Quantity Kind::*which) -> Of {
    return [which](Kind& k, sema::Decision&) { return &(k.*which); };
  };
  const auto motion = [](sema::Quantity sema::Motion::*which) -> Of {
    return [which](Kind& k, sema::Decision&) { return &(k.motion.*which); };
  };
  return {
      {"a `latency`", "ms", 1000, 1000, 1, false, own(&Kind::latency)},
      {"a `max_age` of the position", "ms", 1000, 1000, 1, false, sensed(&Kind::position, true)},
      {"a `max_age` of the velocity", "ms", 1000, 1000, 1, false, sensed(&Kind::velocity, true)},
      {"a `max_age` of the heading", "ms", 1000, 1000, 1, false, sensed(&Kind::heading, true)},
      {"a `period`", "ms", 1000, 1000, 1, false,
       [](Kind&, sema::Decision& d) { return in(d.period); }},
      {"a `jitter`", "ms", 1000, 1000, 1, false,
       [](Kind&, sema::Decision& d) { return in(d.jitter); }},
      {"a `max_age` of the battery", "ms", 1000, 1000, 1, false, sensed(&Kind::battery, true)},
      {"an `error` of the battery", "%", 10'000, 100, 1, false, sensed(&Kind::battery, false)},
      {"an `error` of the position", "m", 1000, 1, 1, false, sensed(&Kind::position, false)},
      {"an `error` of the velocity", "m/s", 1000, 1, 1, false, sensed(&Kind::velocity, false)},
      {"an `error` of the heading", "rad", 1000, 1, 1, false, sensed(&Kind::heading, false)},
      {"a `brake`", "m/s^2", 1000, 1, 1, true, motion(&sema::Motion::brake)},
      // a sampled brake that is very strong takes a long way to turn into a hold
      {"a `brake`", "m/s^2", 1000, 1, 1000, false, motion(&sema::Motion::brake)},
      {"an `accel`", "m/s^2", 1000, 1, 1, false, motion(&sema::Motion::accel)},
      {"a `speed` of the robot", "m/s", 1000, 1, 1, false, motion(&sema::Motion::speed)},
      {"a `turn`", "rad/s", 1000, 1, 1, false,
       [](Kind& k, sema::Decision&) { return in(k.motion.turn); }},
      {"a `turn`", "rad/s", 1000, 1, 1, true,
       [](Kind& k, sema::Decision&) { return in(k.motion.turn); }},
      {"a `turn_accel`", "rad/s^2", 1000, 1, 1, true,
       [](Kind& k, sema::Decision&) { return in(k.motion.turn_accel); }},
      {"a `disturbance`", "m/s^2", 1000, 1, 1, false,
       [](Kind& k, sema::Decision&) { return in(k.motion.disturbance); }},
      {"an `error` of the output", "m/s^2", 1000, 1, 1, false,
       [](Kind& k, sema::Decision&) { return in(k.output_error); }},
      {"a `radius`", "m", 1000, 1, 1, false, own(&Kind::radius)},
  };
}

// Durations of properties are multiples of the period, which cannot be changed alone then.
bool asks_for_the_past(const sema::Spec& spec, const sema::Decision& decision) {
  bool found = false;
  const auto in = [&](const sema::Expr& e) {
    found = found || std::holds_alternative<sema::HeldFor>(e.node) ||
            std::holds_alternative<sema::Previously>(e.node) ||
            std::holds_alternative<sema::Past>(e.node) ||
            std::holds_alternative<sema::Since>(e.node) ||
            std::holds_alternative<sema::WithinOf>(e.node) ||
            std::holds_alternative<sema::Aggregate>(e.node);
  };
  for (const sema::MonitorId id : decision.priority) {
    sema::for_each_expr(*spec[id].always, in);
    if (spec[id].return_when) sema::for_each_expr(*spec[id].return_when, in);
  }
  return found;
}

Trial trial_of(const sema::Spec& spec, const sema::RobotKind& kind, const sema::Decision& decision,
               std::int64_t most_us = INT64_MAX) {
  Trial t;
  t.kind = kind;
  ir::Decision& d = t.decision;
  d.period_us = ceil_to_int(decision.period->value * 1'000'000);
  d.return_extra_us = return_extra_us(spec, decision, d.period_us);
  d.body = body_of(kind, d.period_us, jitter_us(spec, decision, d.period_us, most_us));
  keep_off_walls(spec, decision, kind, d);
  d.pushed_mmps = ceil_to_int(Rational(pushed_speed(kind, d.period_us) * 1000));
  d.motions.push_back(any_control(kind));
  for (const sema::MonitorId id : decision.priority) {
    t.lookahead_us = std::max(t.lookahead_us, lookahead_us(spec, spec[id], d.period_us));
  }
  t.lookahead_us = std::min(t.lookahead_us, most_us);
  return t;
}

class Search {
 public:
  Search(const sema::Decision& decision, Trials& trials, const Fault& fault, const Fits& fits)
      : spec_(trials.spec()),
        trials_(trials),
        decision_(spec_.decisions[std::size_t(&decision - spec_.decisions.data())]),
        kind_(spec_.kinds[static_cast<std::size_t>(decision_.kind)]),
        fault_(fault),
        fits_(fits) {}

  std::vector<std::string> run() {
    const std::vector<Number> all = numbers();
    std::vector<Found> near;
    for (const Number& n : all) {
      if (auto found = guess(n)) near.push_back(*found);
    }
    const auto by_change = [](const Found& a, const Found& b) { return a.change() < b.change(); };
    std::stable_sort(near.begin(), near.end(), by_change);
    std::vector<Found> tried;
    for (const Found& each : near) {
      if (tried.size() == offered_most) break;
      if (auto found = nearest(each)) tried.push_back(*found);
    }
    std::stable_sort(tried.begin(), tried.end(), by_change);
    std::ptrdiff_t least = std::numeric_limits<std::ptrdiff_t>::max();
    for (const Found& each : tried) least = std::min(least, left_with(each));
    std::vector<std::string> texts;
    for (const Found& each : tried) {
      if (left_with(each) != least) continue;
      texts.push_back(each.text() + trials_.leaves(dial_of(*each.number), each.steps, fault_));
    }
    return texts;
  }

  // Where neither alone is enough, both of what is measured of a place and of a speed, each by the
  // same share of what it is.
  std::vector<std::string> errors_together() {
    constexpr std::int64_t whole = 1000, per_unit = 1000;
    if (!kind_.position || !kind_.velocity) return {};
    Rational &place = kind_.position->error.value, &speed = kind_.velocity->error.value;
    const Rational place_before = place, speed_before = speed;
    if (place_before <= 0 || speed_before <= 0) return {};
    const auto share = [&](const Rational& of, std::int64_t steps) {
      Rational left(floor_to_int(Rational(of * steps * per_unit / whole)), per_unit);
      left.canonicalize();
      return left;
    };
    const auto write_both = [&](std::int64_t steps) {
      place = share(place_before, steps), speed = share(speed_before, steps);
      return place > 0 && speed > 0 && allowed();
    };
    const auto restore = [&] { place = place_before, speed = speed_before; };
    const std::int64_t least = std::max(ceil_to_int(Rational(whole / (per_unit * place_before))),
                                        ceil_to_int(Rational(whole / (per_unit * speed_before))));
    const auto near = at_most(least, whole, [&](std::int64_t steps) {
      return write_both(steps) && fits_(trial_of(spec_, kind_, decision_));
    });
    restore();
    if (!near) return {};
    const Dial dial{"the errors of " + decision_.name, whole, least, write_both, restore};
    const auto steps = trials_.nearest(dial, *near, fault_);
    if (!steps) return {};
    return {"an `error` of the position of at most " + to_decimal(share(place_before, *steps)) +
            " m with one of the velocity of at most " + to_decimal(share(speed_before, *steps)) +
            " m/s" + trials_.leaves(dial.name, *steps, fault_)};
  }

 private:
  struct Found {
    const Number* number;
    std::int64_t written, steps;  // `written`: at or beyond what is written
    // How many times as much, or as little.
    [[nodiscard]] double change() const {
      const double ratio = static_cast<double>(written) / static_cast<double>(steps);
      return number->grows ? 1 / ratio : ratio;
    }
    [[nodiscard]] std::string text() const {
      const Rational shown(static_cast<long>(steps) * number->shown_per_unit, number->per_unit);
      return number->what + (number->grows ? " of at least " : " of at most ") + to_decimal(shown) +
             " " + number->unit;
    }
  };
  bool write(const Number& n, std::int64_t steps) {
    Rational& value = n.of(kind_, decision_)->value;
    value = Rational(steps, n.per_unit);
    value.canonicalize();
    return allowed();
  }
  std::optional<Found> guess(const Number& n) {
    sema::Quantity* const value = n.of(kind_, decision_);
    if (value == nullptr) return std::nullopt;
    if (&decision_.period->value == &value->value && asks_for_the_past(spec_, decision_)) {
      return std::nullopt;
    }
    const Rational before = value->value;
    const auto fits = [&](std::int64_t steps) {
      return write(n, steps) && fits_(trial_of(spec_, kind_, decision_));
    };
    const std::int64_t floor = floor_to_int(Rational(before * n.per_unit));
    const std::int64_t written = n.grows ? floor : floor + 1;
    const std::optional<std::int64_t> found =
        n.grows ? at_least(written, fits) : at_most(least_allowed(n, written), written, fits);
    value->value = before;
    return found ? std::optional(Found{&n, written, *found}) : std::nullopt;
  }
  // No robot is slower than its recoveries drive.
  std::int64_t least_allowed(const Number& n, std::int64_t written) {
    std::int64_t low = n.least - 1, high = written;
    if (write(n, n.least)) return n.least;
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (write(n, middle) ? high : low) = middle;
    }
    return high;
  }
  [[nodiscard]] std::string dial_of(const Number& n) const {
    return n.what + (n.grows ? " or more of " : " of ") + decision_.name;
  }
  // What is not shown with one number, and is with another, is what the fault is about.
  [[nodiscard]] std::ptrdiff_t left_with(const Found& found) const {
    return trials_.left_with(dial_of(*found.number), found.steps);
  }
  std::optional<Found> nearest(const Found& near) {
    const Number& n = *near.number;
    const Rational before = n.of(kind_, decision_)->value;
    const auto far = n.grows ? grown_most : least_allowed(n, near.written);
    n.of(kind_, decision_)->value = before;
    const Dial dial{dial_of(n), near.written, far,
                    [&](std::int64_t steps) { return write(n, steps); },
                    [&] { n.of(kind_, decision_)->value = before; }};
    const auto found = trials_.nearest(dial, near.steps, fault_);
    return found ? std::optional(Found{&n, near.written, *found}) : std::nullopt;
  }
  template <class Works>
  static std::optional<std::int64_t> at_most(std::int64_t low, std::int64_t high,
                                             const Works& works) {
    if (low >= high || !works(low)) return std::nullopt;
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (works(middle) ? low : high) = middle;
    }
    return low;
  }
  // What brakes harder may be pushed sideways harder, too, so that too much does not fit again.
  template <class Works>
  static std::optional<std::int64_t> at_least(std::int64_t high, const Works& works) {
    std::int64_t low = high;
    do {
      low = high;
      high = std::max<std::int64_t>(1, 2 * high);
      if (high > grown_most) return std::nullopt;
    } while (!works(high));
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (works(middle) ? high : low) = middle;
    }
    return high;
  }

  // By the checks of the numbers themselves: no recovery is faster than the robot, what pushes it
  // is weaker than what it does against that, and no step is later than the next one.
  bool allowed() const {
    const sema::Motion& m = kind_.motion;
    const Rational pushed = disturbance_of(kind_), spare(1, 500);
    if (pushed > 0 && pushed > std::min(m.brake.value, m.accel.value) - spare) return false;
    if (decision_.jitter && decision_.jitter->value >= decision_.period->value) return false;
    for (const sema::Controller& c : spec_.controllers) {
      if (&spec_[c.kind] != &spec_[decision_.kind]) continue;
      for (const sema::Template& what : sema::templates_of(c)) {
        const auto speed = sema::speed_of(what);
        if (speed && *speed > m.speed.value) return false;
      }
      const auto claim = sema::claim_of(c);
      if (claim && claim->speed.value > m.speed.value) return false;
    }
    return true;
  }

  sema::Spec& spec_;
  Trials& trials_;
  sema::Decision& decision_;
  sema::RobotKind& kind_;
  const Fault& fault_;
  const Fits& fits_;
};

}  // namespace

Trial trial_of(const sema::Spec& spec, const sema::Decision& decision) {
  return trial_of(spec, spec[decision.kind], decision);
}

Trial with_lookahead(const sema::Spec& spec, const sema::Decision& decision, std::int64_t most_us) {
  return trial_of(spec, spec[decision.kind], decision, most_us);
}

std::vector<std::string> repairs(const sema::Decision& decision, Trials* trials, const Fault& fault,
                                 const Fits& fits) {
  return trials != nullptr ? Search(decision, *trials, fault, fits).run()
                           : std::vector<std::string>{};
}

std::vector<std::string> repairs_or_both_errors(const sema::Decision& decision, Trials* trials,
                                                const Fault& fault, const Fits& fits) {
  if (trials == nullptr) return {};
  Search search(decision, *trials, fault, fits);
  std::vector<std::string> alone = search.run();
  return alone.empty() ? search.errors_together() : alone;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    all += (i == 0 ? "" : i + 1 == texts.size() ? ", or " : ", ") + texts[i];
  }
  return all;
}

}  // namespace rtac::analysis
