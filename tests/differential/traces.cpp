#include "tests/differential/traces.h"

#include <algorithm>
#include <utility>

namespace rtac::differential {
namespace {

using driver::Observed;
using Kind = interp::Reading::Kind;

class Source {
 public:
  Source(std::mt19937& random, const std::vector<Signal>& signals, Troubles& troubles)
      : random_(random), signals_(signals), troubles_(troubles) {
    std::size_t components = 0;
    for (const Signal& s : signals_) components += s.components;
    present_.resize(components);
    last_stamps_us_.resize(signals_.size(), INT64_MIN);
    for (std::size_t i = 0; i < signals_.size(); ++i) bias_.push_back(below(7) + 1);
  }

  std::vector<Observed> next(std::int64_t now_us) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < signals_.size(); ++i) {
      const Signal& s = signals_[i];
      const bool arrives = below(16) != 0;
      troubles_.missing += arrives ? 0 : 1;
      const std::int64_t stamp_us = arrives ? stamp(now_us, last_stamps_us_[i]) : 0;
      for (std::size_t c = 0; c < s.components; ++c, ++at) {
        present_[at].is_new = arrives;
        if (arrives) present_[at] = {reading(s, bias_[i]), stamp_us, true};
      }
    }
    return present_;
  }
  // The same samples once more.
  std::vector<Observed> again() {
    for (Observed& o : present_) o.is_new = false;
    return present_;
  }

 private:
  std::size_t below(std::size_t count) { return random_() % count; }
  Micro between(Micro least, Micro most) {
    return least + static_cast<Micro>(random_() % static_cast<std::uint64_t>(most - least + 1));
  }

  std::int64_t stamp(std::int64_t now_us, std::int64_t& last_us) {
    std::int64_t stamp_us = now_us;
    const std::size_t kind = below(24);
    if (kind == 0) {
      stamp_us += between(1, 2 * period_us);
      ++troubles_.future;
      return stamp_us;  // not remembered: it shuts out none of the others
    }
    if (kind < 4) stamp_us -= between(0, period_us / 2);
    if (kind == 4) stamp_us -= below(2) == 0 ? 2 * period_us : between(period_us, 4 * period_us);
    troubles_.old += kind == 4 ? 1 : 0;
    troubles_.backwards += stamp_us < last_us ? 1 : 0;
    last_us = std::max(last_us, stamp_us);
    return stamp_us;
  }

  // Limits that formulas mention, and their neighbours.
  Micro value(const Signal& s) {
    constexpr Micro half = 500000;
    const Micro offsets[] = {0, 1, s.resolution / 2, s.resolution, s.error, s.error + s.resolution};
    const Micro offset = offsets[below(6)] * (below(2) == 0 ? 1 : -1);
    switch (below(6)) {
      case 0:
      case 1:
        ++troubles_.at_limit;
        return between(s.least / half, s.most / half) * half + offset;
      case 2:
        ++troubles_.at_limit;
        return (below(2) == 0 ? s.least : s.most) + offset;
      default:
        return between(s.least, s.most);
    }
  }

  interp::Reading reading(const Signal& s, std::size_t bias) {
    if (below(24) == 0) {
      ++troubles_.not_a_number;
      return {Kind::unknown, {}};
    }
    if (s.kind == Signal::Kind::truth) {
      return {Kind::number, interp::Decimal(below(8) < bias ? 1 : 0)};
    }
    if (s.kind == Signal::Kind::choice) {
      return {Kind::number, interp::Decimal(static_cast<std::int64_t>(below(3)))};
    }
    if (s.kind == Signal::Kind::whole) {
      std::int64_t whole = between(s.least, s.most);
      if (below(16) == 0) whole = s.most + 1 + static_cast<std::int64_t>(below(3));
      troubles_.out_of_range += whole > s.most ? 1 : 0;
      return {Kind::number, interp::Decimal(whole)};
    }
    Micro micro = value(s);
    if (below(24) == 0) micro = (micro < 0 ? s.least : s.most) * 2 + 7;
    // about as far as an input without limits goes (a number of 2^44 steps)
    if (!s.has_range && below(24) == 0) micro = (Micro{1} << 44) * s.resolution + between(-2, 2);
    troubles_.out_of_range += s.has_range && (micro < s.least || micro > s.most) ? 1 : 0;
    return {Kind::number, *interp::Decimal::parse(decimal(micro))};
  }

  std::mt19937& random_;
  const std::vector<Signal>& signals_;
  Troubles& troubles_;
  std::vector<Observed> present_;
  std::vector<std::int64_t> last_stamps_us_;
  std::vector<std::size_t> bias_;  // of truth values, in eighths
};

// What an application may do to a parameter: mostly a small move in the direction that tightens, on
// the grid and off it, but also back, and beyond the range.
class Parameters {
 public:
  Parameters(std::mt19937& random, const std::vector<sema::Param>& params, Troubles& troubles)
      : random_(random), params_(params), troubles_(troubles) {
    for (const sema::Param& param : params) present_.push_back(param.value.value);
  }

  std::vector<ParamChange> next() {
    std::vector<ParamChange> changes;
    for (std::size_t k = 0; k < params_.size(); ++k) {
      if (random_() % 16 == 0) changes.push_back({k, moved(params_[k], present_[k])});
    }
    return changes;
  }

 private:
  Rational moved(const sema::Param& param, Rational& present) {
    const Rational width = param.most.value - param.least.value;
    const Rational by = width * Rational(static_cast<long>(random_() % 1000), 16000);
    const auto kind = random_() % 8;
    if (kind == 0) {
      ++troubles_.beyond_range;
      return random_() % 2 == 0 ? Rational(param.least.value - by - width)
                                : Rational(param.most.value + by + width);
    }
    if (kind < 3) {
      ++troubles_.loosened;
      return present - by * param.tightens;
    }
    ++troubles_.tightened;
    const Rational wanted = present + by * param.tightens;
    if (wanted >= param.least.value && wanted <= param.most.value) present = wanted;
    return wanted;
  }

  std::mt19937& random_;
  const std::vector<sema::Param>& params_;
  Troubles& troubles_;
  std::vector<Rational> present_;
};

}  // namespace

Steps random_run(std::mt19937& random, std::size_t steps, const std::vector<Signal>& signals,
                 const std::vector<sema::Param>& params, Troubles& troubles) {
  Source source(random, signals, troubles);
  Parameters parameters(random, params, troubles);
  Steps run;
  std::int64_t tick = static_cast<std::int64_t>(random() % 1000);
  while (run.size() < steps) {
    // Up to half a period early or late is the same tick; the first step defines tick 0.
    const std::int64_t jitter_us =
        run.empty() || random() % 2 == 0
            ? 0
            : static_cast<std::int64_t>(random() % (period_us * 8 / 10)) - period_us * 4 / 10;
    const std::int64_t now_us = tick * period_us + jitter_us;
    run.push_back({now_us, source.next(now_us), parameters.next()});
    if (random() % 24 == 0) {
      ++troubles.twice;
      const std::int64_t again_us = now_us + (random() % 2 == 0 ? -1 : 1);
      run.push_back({again_us, source.again(), parameters.next()});
    }
    const auto kind = random() % 32;
    const std::int64_t missed = kind == 0  ? static_cast<std::int64_t>(4 + random() % 4)
                                : kind < 4 ? static_cast<std::int64_t>(1 + random() % 4)
                                           : 0;
    troubles.missed_ticks += missed > 0 ? 1 : 0;
    troubles.forgotten += missed > 4 ? 1 : 0;
    tick += 1 + missed;
  }
  if (!run.empty()) run.front().is_restart = true;
  return run;
}

Steps random_runs(std::uint32_t seed, std::size_t runs, std::size_t steps, const sema::Spec& spec,
                  Troubles& troubles) {
  std::mt19937 random(seed);
  const std::vector<Signal> signals = signals_of(spec);
  Steps all;
  for (std::size_t i = 0; i < runs; ++i) {
    for (Step& step : random_run(random, steps, signals, spec.params, troubles)) {
      all.push_back(std::move(step));
    }
  }
  return all;
}

}  // namespace rtac::differential
