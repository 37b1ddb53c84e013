#include "compiler/recheck/claims.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "compiler/recheck/by_border.h"
#include "compiler/recheck/coming_in.h"
#include "compiler/recheck/fails.h"
#include "compiler/recheck/lasting.h"
#include "compiler/recheck/leaving.h"
#include "compiler/recheck/parting.h"
#include "compiler/recheck/return_when.h"
#include "compiler/recheck/sides.h"
#include "compiler/recheck/sums.h"
#include "compiler/recheck/told.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

using Found = std::optional<Doubt>;

}  // namespace

const sema::Monitor* monitor_of(const sema::Spec& spec, const sema::Decision& d,
                                const std::string& name) {
  for (const sema::MonitorId id : d.priority) {
    if (spec[id].name == name) return &spec[id];
  }
  return nullptr;
}
std::set<std::string> names_in(const std::string& text) {
  std::set<std::string> names;
  std::istringstream in(text);
  for (std::string name; std::getline(in, name, ';');) names.insert(name);
  return names;
}

Doubt wrong(std::string why) {
  return {true, std::move(why)};
}
Rational milli(std::int64_t n) {
  return Rational(static_cast<long>(n)) / 1000;
}
Rational without_excess(const Rational& length) {
  return std::max(Rational(length - geometry::offset_excess_m()), Rational(0));
}
Rational micro(std::int64_t n) {
  return Rational(static_cast<long>(n)) / 1'000'000;
}
std::optional<std::int64_t> number(const Values& v, const std::string& key) {
  const auto at = v.find(key);
  if (at == v.end()) return std::nullopt;
  std::int64_t value = 0;
  const char* const end = at->second.data() + at->second.size();
  const auto [stop, error] = std::from_chars(at->second.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}
std::string text(const Values& v, const std::string& key) {
  const auto at = v.find(key);
  return at == v.end() ? "" : at->second;
}
std::vector<sema::ZoneId> all_zones(const sema::Expr& property) {
  std::vector<sema::ZoneId> zones;
  sema::for_each_expr(property, [&](const sema::Expr& e) {
    if (const auto* c = std::get_if<sema::Clearance>(&e.node)) zones.push_back(c->zone);
    if (const auto* i = std::get_if<sema::InsideZone>(&e.node)) zones.push_back(i->zone);
  });
  return zones;
}

namespace {

// The zones of all parts of an `and` for which `counts` says so.
template <class Counts>
std::vector<sema::ZoneId> zones_of_parts(const sema::Spec& spec, const sema::Expr& property,
                                         const Counts& counts) {
  std::vector<sema::ZoneId> zones;
  if (const auto* logic = std::get_if<sema::Logic>(&property.node)) {
    if (logic->op != sema::LogicOp::logical_and) return zones;
    for (const auto& operand : logic->operands) {
      const auto each = zones_of_parts(spec, *operand, counts);
      zones.insert(zones.end(), each.begin(), each.end());
    }
  } else if (const auto floor = floor_of(spec, property); floor && counts(*floor)) {
    zones.push_back(floor->zone);
  }
  return zones;
}
// More than any zone has.
const Rational unbounded_m(1'000'000'000);

}  // namespace

std::vector<sema::ZoneId> kept_in(const sema::Spec& spec, const sema::Expr& property) {
  return zones_of_parts(spec, property, [](const Floor& f) { return f.laxest >= 0; });
}
std::vector<sema::ZoneId> asked_in(const sema::Spec& spec, const sema::Expr& property) {
  return zones_of_parts(spec, property, [](const Floor&) { return true; });
}

std::vector<sema::ZoneId> moves_within(const sema::Controller& controller) {
  std::vector<sema::ZoneId> zones;
  for (const sema::Template& what : sema::templates_of(controller)) {
    if (const auto moves = sema::moves_of(what)) zones.push_back(moves->zone);
  }
  if (const auto claim = sema::claim_of(controller)) zones.push_back(claim->zone);
  return zones;
}

Found Claims::check(const Claim& claim) {
  using Rule = Found (Claims::*)(const Values&);
  static const std::map<std::string, Rule> rules = {
      {"limits", &Claims::limits},       {"horizon", &Claims::horizon},
      {"return", &Claims::returns},      {"output", &Claims::output},
      {"recovery", &Claims::recovery},   {"contained", &Claims::contained},
      {"place", &Claims::place},         {"seen", &Claims::seen},
      {"returned", &Claims::returned},   {"ways", &Claims::ways},
      {"lasts", &Claims::lasts},         {"legs", &Claims::legs},
      {"height", &Claims::height},       {"landing", &Claims::landing},
      {"outranks", &Claims::outranks},   {"fails", &Claims::fails},
      {"start", &Claims::known},         {"judged", &Claims::on_plan},
      {"no_fences", &Claims::no_fences}, {"coordinated", &Claims::coordinated},
      {"sides", &Claims::sides},         {"leaves", &Claims::leaves},
      {"level", &Claims::level},         {"comes_in", &Claims::comes_in},
      {"parting", &Claims::parting},     {"told", &Claims::told},
      {"at_once", &Claims::at_once},     {"by_border", &Claims::by_border},
      {"around", &Claims::around}};
  if (claim.what == "lemma") {
    const std::string name = text(claim.values, "name");
    const auto known = lemmas_.find(name);
    if (known != lemmas_.end()) return known->second;
    return lemmas_.emplace(name, prove_(name)).first->second;
  }
  const auto rule = rules.find(claim.what);
  if (rule == rules.end()) return wrong("no claim is called `" + claim.what + "`");
  if (claim.values.count("extra_us") != 0 && !looks_as_far(claim.values)) {
    return wrong("control is given back on a look-ahead of another length");
  }
  gave_up_ = false;
  Found found = (this->*rule->second)(claim.values);
  if (found && gave_up_) return Doubt{false, "there are too many ways to follow them all"};
  return found;
}

// What is claimed of the return depends on it.
bool Claims::looks_as_far(const Values& v) const {
  const sema::Decision* const d = decision(v);
  const auto extra_us = number(v, "extra_us");
  if (d == nullptr || !extra_us) return false;
  const Rational off = micro(*extra_us) - return_extra(spec_, *d);
  return off >= 0 && off < micro(1);  // a period in whole microseconds
}

const sema::Decision* Claims::decision(const Values& v) const {
  const std::string name = text(v, "decision");
  for (const sema::Decision& d : spec_.decisions) {
    if (d.name == name) return &d;
  }
  return nullptr;
}

// Every number that is declared is rounded to the safe side, and no safer than that: it would not
// be what the modules are compiled with. Of a bound that is derived from rounded numbers that is so
// to a few steps.
Found Claims::limits(const Values& v) {
  const sema::Decision* const d = decision(v);
  const auto jitter = number(v, "jitter_us");
  if (d == nullptr || !jitter || *jitter < 0) return wrong("no such decision, or no jitter");
  if (micro(*jitter) < jitter_of(spec_, *d)) return wrong("jitter_us is too small");
  if (micro(*jitter - 1) >= jitter_of(spec_, *d)) return wrong("jitter_us is too large");
  const Numbers n = numbers_of(spec_, *d, micro(*jitter));
  // a body that is rounded up is that much nearer than it is measured to be
  const Rational rounded =
      spec_[d->kind].position
          ? Rational(Rational(ceil_to_int(Rational(n.radius * 1000))) / 1000 - n.radius)
          : Rational(0);
  const auto rounded_numbers = rounded_numbers_of(spec_, *d, n);
  const Numbers widest = rounded_numbers.value_or(n);
  struct Limit {
    const char* key;
    Rational least;
    int steps;
    std::optional<Rational> most = {};  // of one that is derived
  };
  const Limit all[] = {{"radius_mm", n.radius, 1000},
                       {"position_error_mm", n.position_error + rounded, 1000},
                       {"velocity_error_mmps", n.velocity_error, 1000},
                       {"position_age_us", n.position_age, 1'000'000},
                       {"velocity_age_us", n.velocity_age, 1'000'000},
                       {"latency_us", n.latency, 1'000'000},
                       {"speed_mmps", n.speed, 1000},
                       {"disturbance_mmps2", n.disturbance, 1000},
                       {"brake_lag_permille", n.bend, 1000},
                       {"brake_lag_ms", n.aside, 1000, widest.aside},
                       {"hold_mm", n.hold, 1000, widest.hold}};
  constexpr std::int64_t derived_steps = 8;
  for (const Limit& limit : all) {
    const auto claimed = number(v, limit.key);
    if (!claimed || Rational(*claimed) < limit.least * limit.steps) {
      return wrong(std::string(limit.key) + " is less than what is declared asks for");
    }
    if (limit.most && !rounded_numbers) continue;
    const std::int64_t more = limit.most ? derived_steps : 1;
    if (Rational(*claimed) >= limit.most.value_or(limit.least) * limit.steps + more) {
      return wrong(std::string(limit.key) + " is more than what is declared asks for");
    }
  }
  const auto accel = number(v, "accel_mmps2"), brake = number(v, "brake_mmps2");
  if (!accel || *accel < 0 || milli(*accel) * milli(*accel) < n.accel_square) {
    return wrong("accel_mmps2 is less than the robot may accelerate");
  }
  // of wheels it is made of what has been rounded up before
  const sema::Motion& motion = spec_[d->kind].motion;
  const Rational turns = motion.turn ? motion.turn->value + n.speed + 3 : Rational(0);
  const Rational most = milli(*accel) - (1 + turns) / 1000;
  if (most > 0 && most * most >= n.accel_square) {
    return wrong("accel_mmps2 is more than the robot may accelerate");
  }
  if (!brake || milli(*brake) > n.brake) return wrong("brake_mmps2 is more than is declared");
  if (milli(*brake + 1) <= n.brake) return wrong("brake_mmps2 is less than is declared");
  const auto period = number(v, "period_us");
  if (!period || micro(*period) != n.period) return wrong("period_us is not that of the decision");
  return std::nullopt;
}

Found Claims::horizon(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  const auto ahead = number(v, "lookahead_us"), horizon = number(v, "horizon_us");
  if (m == nullptr || !ahead || !horizon || !d->period) return wrong("no such monitor");
  const sema::RobotKind& kind = spec_[d->kind];
  const Rational least = least_ahead(spec_, *d, *m);
  const Rational looks = m->ahead.duration ? m->ahead.duration->value : least;
  if (micro(*ahead - 1) >= looks) {
    return wrong("it looks less far ahead than " + std::to_string(*ahead) + " us");
  }
  if (micro(*ahead + 1) <= looks) {
    return wrong("it looks further ahead than " + std::to_string(*ahead) + " us");
  }
  if (micro(*ahead) < least) return wrong("the look-ahead is shorter than the period asks for");
  if (kind.latency.value > micro(*ahead)) {
    return wrong("a command acts later than the look-ahead lasts");
  }
  const Rational until = micro(*ahead) + kind.latency.value + jitter_of(spec_, *d);
  if (micro(*horizon) < until) return wrong("the horizon leaves out the latency or the jitter");
  if (micro(*horizon - 2) >= until) return wrong("the horizon is longer than what it is made of");
  return std::nullopt;
}

Found Claims::returns(const Values& v) {
  const sema::Decision* const d = decision(v);
  if (d == nullptr || monitor_of(spec_, *d, text(v, "monitor")) == nullptr) {
    return wrong("no such monitor");
  }
  const auto extra = number(v, "extra_us"), dwell = number(v, "dwell_ticks");
  if (!extra) return wrong("it is not said how far ahead it looks");
  // other claims reckon with it, so that more of it is no better
  if (!dwell || *dwell != dwell_ticks(*d)) {
    return wrong("control returns after another dwell");
  }
  return std::nullopt;
}

Found Claims::output(const Values& v) {
  const sema::Decision* const d = decision(v);
  if (d == nullptr) return wrong("no such decision");
  const auto same = [&](sema::ControllerId id) { return spec_[id].kind == d->kind; };
  bool all = same(d->advanced) && (!d->safe || same(*d->safe));
  for (const sema::MonitorId id : d->priority) {
    all = all && (!spec_[id].recover || same(*spec_[id].recover));
  }
  if (!all) return wrong("its controllers are of different robots");
  return std::nullopt;
}

Found Claims::recovery(const Values& v) {
  static const std::map<std::string, std::size_t> templates = {
      {"extern", 0},         {"retreat", 1}, {"route", 2},    {"yield", 3},
      {"brake_and_hold", 4}, {"loiter", 5},  {"sequence", 6}, {"land", 7}};
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  if (m == nullptr || !m->recover) return wrong("no such monitor, or it has no recovery");
  const sema::Controller& c = spec_[*m->recover];
  const auto kind = templates.find(text(v, "template"));
  if (c.name != text(v, "controller")) return wrong("it recovers with `" + c.name + "`");
  if (kind == templates.end() || kind->second != c.implementation.index()) {
    return wrong("`" + c.name + "` is another kind of recovery");
  }
  return std::nullopt;
}

Found Claims::contained(const Values& v) {
  const auto inner = zones_.find(text(v, "inner")), outer = zones_.find(text(v, "outer"));
  if (!inner || !outer) return wrong("no such zone");
  const bool far = v.count("standoff_mm") != 0;
  if (*inner == *outer) {
    return far ? std::optional(wrong("no zone is so far off itself")) : std::nullopt;
  }
  const auto standoff = far ? number(v, "standoff_mm") : std::optional<std::int64_t>(0);
  if (!standoff || *standoff < 0) return wrong("the standoff is no number");
  const Rational off = without_excess(milli(*standoff));
  const geometry::Region *const in = zones_.region(*inner), *const out = zones_.region(*outer);
  if (in != nullptr && out != nullptr) {
    const auto kept = out->offset(-off);
    if (!kept || !kept->contains(*in)) return wrong("it is not contained");
    return std::nullopt;
  }
  const auto small = zones_.solid(*inner), large = zones_.solid(*outer);
  if (!small || !large) return Doubt{false, "a zone is not known"};
  // a zone of the plane has no ends above and below
  const Rational upright = out == nullptr ? off : Rational(0);
  if (!small->subtract(large->shrink(off, upright)).empty()) return wrong("it is not contained");
  return std::nullopt;
}

Found Claims::level(const Values& v) {
  const auto inner = zones_.find(text(v, "inner")), outer = zones_.find(text(v, "outer"));
  const auto off =
      v.count("standoff_mm") != 0 ? number(v, "standoff_mm") : std::optional<std::int64_t>(0);
  if (!inner || !outer || !off || *off < 0) return wrong("no such zone or standoff");
  if (lies_level(*this, *inner, *outer, without_excess(milli(*off)))) return std::nullopt;
  return wrong("it is not contained at each height");
}

Found Claims::comes_in(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  const auto zone = zones_.find(text(v, "zone")), fence = zones_.find(text(v, "fence"));
  if (m == nullptr || !zone || !fence) return wrong("no such monitor or zone");
  if (comes_in_within(spec_, *d, *this, *m, *zone, *fence, v)) return std::nullopt;
  return wrong("from outside of its zone the recovery may lead across what is not convex");
}

// Of a comparison that speaks of the zone in another way than as a bound, nothing is known.
Rational gap_of(const sema::Spec& spec, const sema::Expr& property, sema::ZoneId zone) {
  Rational most = 0;
  sema::for_each_expr(property, [&](const sema::Expr& e) {
    const auto* compare = std::get_if<sema::Compare>(&e.node);
    if (compare == nullptr) return;
    const auto zones = all_zones(e);
    if (std::ranges::find(zones, zone) == zones.end()) return;
    for (const auto& [a, b] : {std::pair(compare->left.get(), compare->right.get()),
                               std::pair(compare->right.get(), compare->left.get())}) {
      const auto sum = difference(spec, *a, *b);
      const bool bound = sum && sum->terms.size() == 1;
      const Rational asked =
          bound ? Rational(-sum->least / sum->terms.begin()->second) : unbounded_m;
      most = std::max(most, asked);
    }
  });
  return most;
}
Rational sure_gap_of(const sema::Spec& spec, const sema::Expr& property, sema::ZoneId zone) {
  if (const auto* logic = std::get_if<sema::Logic>(&property.node)) {
    Rational most = 0;
    if (logic->op != sema::LogicOp::logical_and) return most;
    for (const sema::ExprPtr& each : logic->operands) {
      most = std::max(most, sure_gap_of(spec, *each, zone));
    }
    return most;
  }
  const auto floor = floor_of(spec, property);
  return floor && floor->zone == zone ? floor->laxest : Rational(0);
}

namespace {

// Of its own alone: how high others are is for who judges them.
bool speaks_of_own_height(const sema::Expr& comparison) {
  bool own = false, others = false;
  sema::for_each_expr(comparison, [&](const sema::Expr& e) {
    const auto* signal = std::get_if<sema::SignalRef>(&e.node);
    if (signal == nullptr || signal->signal != sema::Signal::altitude) return;
    (signal->subject == sema::Subject::self ? own : others) = true;
  });
  return own && !others;
}
// How far a height is from the limit of a comparison with it that has to be true, or false, to the
// good side; nullopt: it is none.
std::optional<Rational> room_of(const sema::Spec& spec, const sema::Expr& comparison, bool value,
                                const Rational& z, Heights which) {
  if (!speaks_of_own_height(comparison)) return std::nullopt;
  const auto limit = limit_of_one(spec, comparison, value);
  if (!limit || limit->of.kind != Measured::Kind::altitude) return Rational(-1);
  const Heights other = limit->at_least ? Heights::from_above : Heights::from_below;
  if (which == other) return std::nullopt;
  return limit->at_least ? Rational(z - limit->bound) : Rational(limit->bound - z);
}

// The least room of all limits of height in what has to be true, or false; of what is both, of
// `iff` and `xor`, on either side.
std::optional<Rational> room_at(const sema::Spec& spec, const sema::Expr& e, bool value,
                                const Rational& z, Heights which) {
  if (std::holds_alternative<sema::Compare>(e.node)) return room_of(spec, e, value, z, which);
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  std::optional<Rational> least;
  const auto count = [&](const sema::Expr& operand, bool wanted) {
    const auto room = room_at(spec, operand, wanted, z, which);
    if (room && (!least || *room < *least)) least = *room;
  };
  bool first = true;
  sema::for_each_operand(e, [&](const sema::ExprPtr& operand) {
    const bool negated = logic != nullptr && (logic->op == sema::LogicOp::logical_not ||
                                              (logic->op == sema::LogicOp::implies && first));
    const bool both = logic != nullptr &&
                      (logic->op == sema::LogicOp::iff || logic->op == sema::LogicOp::logical_xor);
    count(*operand, value != negated);
    if (both) count(*operand, value == negated);
    first = false;
  });
  return least;
}

}  // namespace

bool keeps_heights(const sema::Spec& spec, const sema::Expr& property, bool value,
                   const Rational& z, const Rational& gap, Heights which) {
  const auto room = room_at(spec, property, value, z, which);
  return !room || *room >= gap;
}
bool keeps_heights_inside(const sema::Spec& spec, const sema::Expr& property, bool value,
                          const geometry::Solid& solid, const Rational& left, const Rational& gap) {
  return keeps_heights(spec, property, value, solid.slabs().front().floor + left, gap) &&
         keeps_heights(spec, property, value, solid.slabs().back().ceiling - left, gap);
}

Found Claims::lasts(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  if (m == nullptr || !m->recover || !d->period) return wrong("no such monitor");
  return check_lasting(spec_, *d, *this, *m, v);
}

Found Claims::by_border(const Values& v) {
  const sema::Decision* const d = decision(v);
  if (d == nullptr || !d->period) return wrong("no such decision");
  return check_by_border(spec_, *d, *this, v);
}

Found Claims::around(const Values& v) {
  const sema::Decision* const d = decision(v);
  if (d == nullptr || !d->period) return wrong("no such decision");
  return check_around(spec_, *d, *this, v);
}

Found Claims::leaves(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  if (m == nullptr || !m->recover || !d->period) return wrong("no such monitor");
  return check_leaving(spec_, *d, *this, *m, v);
}

Found Claims::parting(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  if (m == nullptr || !m->recover || !d->period) return wrong("no such monitor");
  return check_parting(spec_, *d, *this, *m, v);
}

Found Claims::outranks(const Values& v) {
  const sema::Decision* const d = decision(v);
  if (d == nullptr) return wrong("no such decision");
  const auto rank = [&](const std::string& name) {
    std::size_t at = 0;
    while (at < d->priority.size() && spec_[d->priority[at]].name != name) ++at;
    return at;
  };
  if (d->coordinated) return wrong("who ranks higher does not take over under `coordinate`");
  const std::size_t high = rank(text(v, "higher")), low = rank(text(v, "lower"));
  if (low == d->priority.size() || high >= low) return wrong("it does not rank higher");
  return std::nullopt;
}

Found Claims::sides(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  if (m == nullptr) return wrong("no such monitor");
  for (const sema::MonitorId id : d->priority) {
    if (!spec_[id].recover || spec_[*spec_[id].recover].name != text(v, "controller")) continue;
    const sema::Controller& recovery = spec_[*spec_[id].recover];
    Sides sides(spec_, *d, *this);
    const Keeping kept = sides.keeping(recovery, *m->always);
    if (!kept.by_sides) return wrong("no side of it holds wherever the recovery drives");
    const auto zone = zones_.find(text(v, "zone"));
    const std::vector<sema::ZoneId> moves = moves_within(recovery);
    if (!zone || std::ranges::find(moves, *zone) == moves.end()) return wrong("no such zone");
    if (sema::claim_of(recovery) || sides.straight_between(kept.either) ||
        comes_in_by_sides(spec_, *d, *this, *m, *zone, kept.either, v)) {
      return std::nullopt;
    }
    return wrong("from outside of its zone the recovery may lead out of each side");
  }
  return wrong("no such recovery");
}

// That nobody leads round in a circle is a matter of all pairs: recheck.cpp.
Found Claims::coordinated(const Values& v) {
  const sema::Decision* const d = decision(v);
  if (d == nullptr || !d->coordinated || d->on_plan) return wrong("nobody coordinates");
  for (const char* const who : {"driving", "judged"}) {
    if (monitor_of(spec_, *d, text(v, who)) == nullptr) return wrong("no such monitor");
  }
  return std::nullopt;
}

Found Claims::fails(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  if (m == nullptr) return wrong("no such monitor");
  if (!can_be(spec_, zones_, *d, *m->always, false)) return wrong("the property is never false");
  return std::nullopt;
}

// What the specification says by itself.
Found Claims::known(const Values& v) {
  if (decision(v) == nullptr) return wrong("no such decision");
  return std::nullopt;
}

Found Claims::on_plan(const Values& v) {
  const sema::Decision* const d = decision(v);
  if (d == nullptr || !d->on_plan) return wrong("the decision does not run on a plan");
  return std::nullopt;
}

Found Claims::no_fences(const Values& v) {
  const sema::Decision* const d = decision(v);
  if (d == nullptr) return wrong("no such decision");
  for (const sema::MonitorId id : d->priority) {
    if (spec_[id].ahead.waypoints_only) continue;  // it looks at plans, not at places
    if (!asked_in(spec_, *spec_[id].always).empty())
      return wrong("`" + spec_[id].name + "` has a zone");
    // outside of all zones
    constexpr long nowhere_m = 10'000'000;
    if (lets_go_at(spec_, *d, *this, spec_[id], {nowhere_m, nowhere_m}, std::nullopt)) continue;
    return wrong("`return when` of `" + spec_[id].name + "` may hold at some places alone");
  }
  return std::nullopt;
}

}  // namespace rtac::recheck
