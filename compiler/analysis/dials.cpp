#include "compiler/analysis/dials.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::analysis {
namespace {

Rational value_of(std::int64_t steps, int per_unit) {
  Rational value(static_cast<long>(steps), per_unit);
  value.canonicalize();
  return value;
}

// A signal, as it is: no multiple of one, and nothing that grows with another one.
bool is_signal(const sema::Expr& e) {
  return std::holds_alternative<sema::SignalRef>(e.node) ||
         std::holds_alternative<sema::Clearance>(e.node) ||
         std::holds_alternative<sema::Distance>(e.node) ||
         std::holds_alternative<sema::AgentDistance>(e.node) ||
         std::holds_alternative<sema::EnergyTo>(e.node);
}
// Collects the terms of a sum that are no signals; false: it is no such sum.
bool terms_of(sema::ExprPtr& side, std::vector<sema::ExprPtr*>& numbers) {
  if (is_signal(*side)) return true;
  if (!sema::speaks_of_robot(*side)) {
    numbers.push_back(&side);
    return true;
  }
  auto* sum = std::get_if<sema::Arithmetic>(&side->node);
  return sum != nullptr && sum->op == sema::ArithmeticOp::add &&
         std::ranges::all_of(sum->operands, [&](auto& each) { return terms_of(each, numbers); });
}
// The one number of each comparison that is written there, where one is; it may be written once and
// stand in several monitors.
void find_asked(sema::ExprPtr& e, const SourceRange& at, std::vector<sema::ExprPtr*>& found) {
  auto* compare = std::get_if<sema::Compare>(&e->node);
  if (compare != nullptr && e->range == at) {
    std::vector<sema::ExprPtr*> numbers;
    const bool sums = terms_of(compare->left, numbers) && terms_of(compare->right, numbers);
    if (sums && numbers.size() == 1) found.push_back(numbers.front());
  }
  sema::for_each_operand(*e, [&](sema::ExprPtr& operand) { find_asked(operand, at, found); });
}

template <class Change>
std::optional<std::int64_t> of_recovery(Trials& trials, const Sought& sought,
                                        const std::string& recovery, const std::string& what,
                                        const Change& change) {
  auto& all = trials.spec().controllers;
  const auto found = std::ranges::find(all, recovery, &sema::Controller::name);
  if (found == all.end()) return std::nullopt;
  const auto written = found->implementation;
  const Dial dial{what + " of " + recovery, sought.written, sought.far,
                  [&](std::int64_t steps) {
                    const Rational value = value_of(steps, sought.per_unit);
                    sema::change_each(*found, [&](auto& each) { change(each, value); });
                    return true;
                  },
                  [&] { found->implementation = written; }};
  return trials.nearest(dial, sought.guess, sought.fault, sought.all_of);
}

}  // namespace

std::optional<std::int64_t> quantity_that_works(Trials& trials, Sought sought,
                                                const std::string& name, sema::Quantity& number) {
  const Rational written = number.value;
  const std::int64_t floor = floor_to_int(Rational(written * sought.per_unit));
  sought.written = sought.guess > floor ? floor : floor + 1;
  const Dial dial{name, sought.written, sought.far,
                  [&](std::int64_t steps) {
                    number.value = value_of(steps, sought.per_unit);
                    return true;
                  },
                  [&] { number.value = written; }};
  return trials.nearest(dial, sought.guess, sought.fault, sought.all_of);
}

std::optional<std::int64_t> asked_that_works(Trials& trials, const Sought& sought,
                                             const SourceRange& comparison) {
  std::vector<sema::ExprPtr*> places;
  for (sema::Monitor& m : trials.spec().monitors) {
    find_asked(m.always, comparison, places);
    if (m.return_when) find_asked(m.return_when, comparison, places);
  }
  if (places.empty()) return std::nullopt;
  std::int64_t from = sought.written;
  if (const auto* constant = std::get_if<sema::Constant>(&(*places.front())->node)) {
    const std::int64_t floor = floor_to_int(Rational(constant->value * sought.per_unit));
    from = sought.guess > floor ? floor : floor + 1;
  }
  std::vector<sema::ExprPtr> written;
  const std::string at = std::to_string(static_cast<std::uint32_t>(comparison.file)) + ":" +
                         std::to_string(comparison.begin);
  const Dial dial{"what is asked for at " + at, from, sought.far,
                  [&](std::int64_t steps) {
                    for (sema::ExprPtr* place : places) {
                      const sema::Expr& was = **place;
                      auto number = std::make_unique<sema::Expr>();
                      number->range = was.range;
                      number->boolean = false;
                      number->dimension = was.dimension;
                      number->node = sema::Constant{value_of(steps, sought.per_unit)};
                      written.push_back(std::exchange(*place, std::move(number)));
                    }
                    return true;
                  },
                  [&] {
                    for (std::size_t i = 0; i < written.size(); ++i) {
                      *places[i] = std::move(written[i]);
                    }
                    written.clear();
                  }};
  return trials.nearest(dial, sought.guess, sought.fault, sought.all_of);
}

std::optional<std::string> recovery_speed_that_works(Trials& trials, const Sought& sought,
                                                     const std::string& recovery) {
  const std::string what = "the speed";
  const auto mmps =
      of_recovery(trials, sought, recovery, what, [](auto& each, const Rational& most) {
        if constexpr (requires { each.speed; }) {
          each.speed.value = std::min(each.speed.value, most);
        }
      });
  if (!mmps) return std::nullopt;
  return "a recovery of at most " + to_decimal(value_of(*mmps, sought.per_unit)) + " m/s works" +
         trials.leaves(what + " of " + recovery, *mmps, sought.fault);
}

std::optional<std::int64_t> landing_that_works(Trials& trials, const Sought& sought,
                                               const std::string& recovery) {
  return of_recovery(trials, sought, recovery, "the landing", [](auto& each, const Rational& at) {
    if constexpr (requires { each.height; }) each.height.value = at;
  });
}

std::optional<std::int64_t> lookahead_that_works(Trials& trials, const Sought& sought,
                                                 const std::string& monitor) {
  auto& all = trials.spec().monitors;
  const auto found = std::ranges::find(all, monitor, &sema::Monitor::name);
  if (found == all.end()) return std::nullopt;
  const auto written = found->ahead.duration;
  const Dial dial{"ahead of " + monitor, sought.written, sought.far,
                  [&](std::int64_t steps) {
                    sema::Quantity duration = written.value_or(sema::Quantity{});
                    duration.value = value_of(steps, sought.per_unit);
                    found->ahead.duration = duration;
                    return true;
                  },
                  [&] { found->ahead.duration = written; }};
  return trials.nearest(dial, sought.guess, sought.fault, sought.all_of);
}

bool works_in_zone(Trials& trials, const Fault& fault, const SourceRange& all_of,
                   const std::string& recovery, const std::string& name, sema::ZoneId from,
                   sema::Zone zone) {
  sema::Spec& spec = trials.spec();
  const auto found = std::ranges::find(spec.controllers, recovery, &sema::Controller::name);
  if (found == spec.controllers.end()) return false;
  const auto written = found->implementation;
  bool over_cells = false;  // which are of the plane
  sema::change_each(*found, [&](auto& each) {
    using Step = std::decay_t<decltype(each)>;
    if constexpr (std::is_same_v<Step, sema::Route> || std::is_same_v<Step, sema::Yield>) {
      over_cells = over_cells || each.zone == from;
    }
  });
  if (over_cells && zone.has_height) return false;
  const sema::ZoneId last{static_cast<std::uint32_t>(spec.zones.size())};
  const Dial dial{"zone of " + recovery + ": " + name,
                  0,
                  1,
                  [&](std::int64_t) {
                    spec.zones.push_back(std::move(zone));
                    sema::change_each(*found, [&](auto& each) {
                      if constexpr (requires { each.zone; }) {
                        if (each.zone == from) each.zone = last;
                      }
                    });
                    return true;
                  },
                  [&] {
                    found->implementation = written;
                    zone = std::move(spec.zones.back());
                    spec.zones.pop_back();
                  },
                  true};
  return trials.nearest(dial, 1, fault, all_of).has_value();
}

bool works_recovered_by(Trials& trials, const Fault& fault, const std::string& monitor,
                        sema::Controller recovery) {
  sema::Spec& spec = trials.spec();
  const auto found = std::ranges::find(spec.monitors, monitor, &sema::Monitor::name);
  if (found == spec.monitors.end()) return false;
  const auto written = found->recover;
  std::vector<sema::Controller> as_written;
  const Dial dial{"recovery of " + monitor + ": " + recovery.name, 0, 1,
                  [&](std::int64_t) {
                    // who looks at one of those that are written goes on doing so
                    as_written = spec.controllers;
                    as_written.swap(spec.controllers);
                    found->recover = sema::ControllerId(spec.controllers.size());
                    spec.controllers.push_back(recovery);
                    return true;
                  },
                  [&] {
                    found->recover = written;
                    spec.controllers = std::move(as_written);
                  }};
  return trials.nearest(dial, 1, fault).has_value();
}

std::optional<std::string> consumption_that_works(Trials& trials, const Fault& fault,
                                                  sema::KindId kind, const Rational& share) {
  sema::RobotKind& robot = trials.spec().kinds[static_cast<std::size_t>(kind)];
  if (!robot.energy || share <= 0) return std::nullopt;
  struct Consumption {
    sema::Quantity& quantity;
    const char *name, *unit;
    int per_unit;
  };
  for (const auto& [quantity, name, unit, per_unit] :
       {Consumption{robot.energy->drive, "drive", "%/m", 10'000},
        Consumption{robot.energy->idle, "idle", "%/s", 1'000'000}}) {
    const std::int64_t written = floor_to_int(Rational(quantity.value * per_unit));
    const std::int64_t guess =
        std::min(floor_to_int(Rational(quantity.value * per_unit / share)), written);
    if (guess < 1) continue;
    const auto found = quantity_that_works(trials, {fault, per_unit, 0, guess, 1},
                                           name + (" of " + robot.name), quantity);
    if (!found) continue;
    return std::string("`") + name + "` of at most " +
           to_decimal(value_of(*found, per_unit / 100)) + " " + unit;
  }
  return std::nullopt;
}

}  // namespace rtac::analysis
