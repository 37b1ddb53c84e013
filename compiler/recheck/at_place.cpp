#include "compiler/recheck/at_place.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "compiler/geometry/bake.h"
#include "compiler/recheck/numbers.h"
#include "compiler/recheck/on_grid.h"
#include "compiler/recheck/return_when.h"
#include "compiler/recheck/sums.h"
#include "compiler/recheck/travel.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {

// Of each place of its site how long the way from each cell is, along the middles of cells as clear
// as its ways, at least; -1: there is none, -2: no way begins there.
struct AtPlace::Ways {
  Grid cells;
  std::vector<geometry::Point> sites;
  std::vector<std::vector<double>> lengths;
};

namespace {

// The cells of a zone as a robot has them: 10 cm wide, or as many centimetres more as there would
// be more than 40,000 of them.
std::optional<OnGrid> cells_of(const geometry::Region& zone) {
  const auto snapped = geometry::snap_inside(zone);
  if (!snapped) return std::nullopt;
  const std::vector<Segment> edges = segments_of(geometry::to_region(*snapped));
  if (edges.empty()) return std::nullopt;
  double left = edges[0].ax, low = edges[0].ay, right = left, top = low;
  for (const Segment& s : edges) {
    left = std::min(left, s.ax), low = std::min(low, s.ay);
    right = std::max(right, s.ax), top = std::max(top, s.ay);
  }
  constexpr double most = 40'000, hair = 1e-6;
  const auto count = [&](std::int64_t mm) {
    return std::ceil((right - left) * 1000 / double(mm) - hair) *
           std::ceil((top - low) * 1000 / double(mm) - hair);
  };
  std::int64_t cell_mm = 100;
  while (count(cell_mm) > most) cell_mm += 10;
  return on_grid(zone, {cell_mm, std::lround(left * 1000), std::lround(low * 1000)});
}

bool touches(const Box& b, const geometry::Point& p) {
  const double x = p.x.get_d(), y = p.y.get_d();
  return b.x <= x + slack_m && b.right >= x - slack_m && b.y <= y + slack_m && b.top >= y - slack_m;
}

// A step to a corner needs both cells beside it.
std::vector<double> lengths_to(const Grid& grid, double route, const geometry::Point& site) {
  constexpr double none = -1, inside_only = -2;
  const auto is_clear = [&](std::size_t at) { return grid.clearance[at] >= route - slack_m; };
  std::vector<double> lengths(grid.clearance.size());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::size_t at = 0; at < lengths.size(); ++at) {
    lengths[at] = is_clear(at) ? none : inside_only;
    const Box box = grid.box(at % grid.columns, at / grid.columns, 1);
    if (!is_clear(at) || !touches(box, site)) continue;
    lengths[at] = 0;
    open.emplace(0, at);
  }
  const auto columns = static_cast<std::int64_t>(grid.columns);
  const auto rows = static_cast<std::int64_t>(grid.rows);
  const auto index = [&](std::int64_t x, std::int64_t y) {
    return static_cast<std::size_t>(y * columns + x);
  };
  while (!open.empty()) {
    const auto [length, at] = open.top();
    open.pop();
    if (length > lengths[at]) continue;
    const std::int64_t x = std::int64_t(at) % columns, y = std::int64_t(at) / columns;
    for (std::int64_t k = 0; k < 9; ++k) {
      const std::int64_t dx = k % 3 - 1, dy = k / 3 - 1, to_x = x + dx, to_y = y + dy;
      if (to_x < 0 || to_y < 0 || to_x >= columns || to_y >= rows || k == 4) continue;
      const std::size_t to = index(to_x, to_y);
      const bool aside = is_clear(index(to_x, y)) && is_clear(index(x, to_y));
      if (!is_clear(to) || !aside) continue;
      const double sum = length + grid.cell * std::sqrt(double(dx * dx + dy * dy));
      if (lengths[to] >= 0 && lengths[to] <= sum) continue;
      lengths[to] = sum;
      open.emplace(sum, to);
    }
  }
  return lengths;
}

const sema::Compare* compare_of(const sema::Expr& e) {
  return std::get_if<sema::Compare>(&e.node);
}
// The sides of a comparison which is to be true, or false, the large one first.
std::pair<const sema::Expr*, const sema::Expr*> sides_of(const sema::Compare& v, bool value) {
  using Op = sema::CompareOp;
  const bool at_least = (v.op == Op::greater || v.op == Op::greater_equal) == value;
  return at_least ? std::pair(v.left.get(), v.right.get()) : std::pair(v.right.get(), v.left.get());
}

class SumOfOthers {
 public:
  explicit SumOfOthers(const sema::Spec& spec) : spec_(spec) {}

  // `by` times the expression; false: it speaks of something else.
  bool add(const sema::Expr& e, const Rational& by) {
    if (const auto* v = std::get_if<sema::Arithmetic>(&e.node)) return add(*v, by);
    if (const auto* constant = std::get_if<sema::Constant>(&e.node)) {
      all.rest += by * constant->value;
    } else if (const auto* param = std::get_if<sema::ParamRef>(&e.node)) {
      const sema::Param& of = spec_[param->param];
      all.rest += by * (by > 0 ? of.least.value : of.most.value);
    } else if (const auto* agent = std::get_if<sema::AgentDistance>(&e.node)) {
      all.agents[agent->agent] += by;
    } else if (std::holds_alternative<sema::Distance>(e.node)) {
      all.robots += by;
    } else if (std::holds_alternative<sema::CountOthers>(e.node)) {
      (by > 0 ? all.counts_more : all.counts_less) = true;
    } else {
      return false;
    }
    return true;
  }
  OfOthers all;

 private:
  static std::optional<Rational> number(const sema::Expr& e) {
    if (const auto* v = std::get_if<sema::Constant>(&e.node)) return v->value;
    const auto* v = std::get_if<sema::Arithmetic>(&e.node);
    if (v == nullptr || v->op != sema::ArithmeticOp::negate) return std::nullopt;
    const auto of = number(*v->operands[0]);
    return of ? std::optional(Rational(-*of)) : std::nullopt;
  }
  bool add(const sema::Arithmetic& v, const Rational& by) {
    const sema::Expr& a = *v.operands[0];
    if (v.op == sema::ArithmeticOp::negate) return add(a, Rational(-by));
    const sema::Expr& b = *v.operands[1];
    const auto left = number(a), right = number(b);
    switch (v.op) {
      case sema::ArithmeticOp::add:
        return add(a, by) && add(b, by);
      case sema::ArithmeticOp::subtract:
        return add(a, by) && add(b, Rational(-by));
      case sema::ArithmeticOp::multiply:
        if (left) return add(b, Rational(by * *left));
        return right && add(a, Rational(by * *right));
      case sema::ArithmeticOp::divide:
        return right && *right != 0 && add(a, Rational(by / *right));
      case sema::ArithmeticOp::negate:
        break;
    }
    return false;
  }

  const sema::Spec& spec_;
};

}  // namespace

Spot spot_of(const Claim& claim) {
  const auto x = number(claim.values, "x_mm"), y = number(claim.values, "y_mm");
  const auto z = number(claim.values, "z_mm");
  Spot spot{{milli(x.value_or(0)), milli(y.value_or(0))}, std::nullopt, {}};
  if (z) spot.z = milli(*z);
  return spot;
}

std::optional<OfOthers> of_others(const sema::Expr& large, const sema::Expr& small,
                                  const sema::Spec& spec) {
  SumOfOthers sum(spec);
  if (!sum.add(large, 1) || !sum.add(small, -1)) return std::nullopt;
  return sum.all;
}

bool far_agent(const sema::Spec& spec, const sema::Expr& comparison, bool value) {
  const auto* const compare = compare_of(comparison);
  if (compare == nullptr) return false;
  const auto [large, small] = sides_of(*compare, value);
  const auto others = of_others(*large, *small, spec);
  return others && others->robots == 0 && !others->counts_more && !others->counts_less &&
         others->agents.size() == 1 && others->agents.begin()->second > 0;
}

bool is_out_of_sight(const sema::Spec& spec, const sema::Decision& decision, sema::AgentId agent,
                     const Rational& least) {
  const Rational known = 100'000;
  if (spec[agent].present) return false;
  const sema::RobotKind& kind = spec[decision.kind];
  const Rational off = kind.position ? kind.position->error.value : Rational(0);
  const sema::Agent& of = spec[agent];
  return least + kind.radius.value + of.radius.value + off + of.position.error.value > known;
}

bool asks_out_of_sight(const sema::Spec& spec, const sema::Decision& decision,
                       const sema::Expr& property) {
  bool found = false;
  sema::for_each_expr(property, [&](const sema::Expr& e) {
    if (compare_of(e) == nullptr || !sema::speaks_of<sema::AgentDistance>(e)) return;
    const auto [large, small] = sides_of(*compare_of(e), true);
    const auto others = of_others(*large, *small, spec);
    if (!others || others->agents.size() != 1) return;
    const auto& [agent, by] = *others->agents.begin();
    if (by <= 0) return;
    found = found || is_out_of_sight(spec, decision, agent, Rational(-others->rest / by));
  });
  return found;
}

bool AtPlace::asks(const sema::Expr& e, bool heights) {
  return sema::speaks_of_charge(e) || sema::speaks_of<sema::EnergyTo>(e) ||
         (heights && sema::speaks_of_height(e));
}

AtPlace::Look AtPlace::seen_now() const {
  const Numbers n = numbers_of(spec_, decision_, 0);
  Look look;
  look.within = look.errs = 2 * n.position_error;
  look.rest = 2 * n.velocity_error;
  return look;
}

// Until its recovery acts, with what others may take.
AtPlace::Look AtPlace::ahead_of(const sema::Monitor& m) {
  const Numbers n = numbers_of(spec_, decision_, jitter_of(spec_, decision_));
  const Rational extra = return_extra(spec_, decision_);
  const Rational ahead =
      m.ahead.duration ? m.ahead.duration->value : least_ahead(spec_, decision_, m);
  const Rational until = ahead + extra + n.position_age + n.latency + n.jitter;
  Look look;
  look.within = claims_.return_clearance(decision_, m, extra) - n.radius;
  look.rest = std::min(n.speed, Rational(2 * n.velocity_error + planar_accel(n) * until));
  if (const auto& energy = spec_[decision_.kind].energy) {
    look.takes = energy->idle.value * energy->held.value +
                 energy->drive.value * energy->detour.value + energy->drain.value * until;
  }
  if (m.recover) {
    const auto& what = spec_[*m.recover].implementation;
    if (const auto* route = std::get_if<sema::Route>(&what)) look.home = route->site;
  }
  return look;
}

bool AtPlace::gives_back(const sema::Monitor& m, const Spot& spot) {
  return holds(*m.always, true, ahead_of(m), spot);
}
bool AtPlace::lets_go(const sema::Monitor& m, const Spot& spot) {
  return !m.return_when || holds(*m.return_when, true, seen_now(), spot);
}
bool AtPlace::is_seen(const sema::Monitor& m, const Spot& spot) {
  Look look = seen_now();
  look.heights = true;
  return holds(*m.always, true, look, spot);
}

std::vector<Spot> AtPlace::sites() const {
  std::vector<Spot> all;
  const auto add = [&](sema::SiteId site) {
    for (const auto& place : spec_[site].places) {
      all.push_back({{place.position.x, place.position.y}, std::nullopt, {}});
    }
  };
  const auto add_of = [&](const sema::Expr& e) {
    sema::for_each_expr(e, [&](const sema::Expr& part) {
      if (const auto* way = std::get_if<sema::EnergyTo>(&part.node)) add(way->site);
    });
  };
  for (const sema::MonitorId id : decision_.priority) {
    const sema::Monitor& m = spec_[id];
    const auto way = m.recover ? sema::route_of(spec_[*m.recover]) : std::nullopt;
    if (way) add(way->site);
    add_of(*m.always);
    if (m.return_when) add_of(*m.return_when);
  }
  all.push_back({{0, 0}, std::nullopt, {}});
  return all;
}

// What asks for nothing of this is for others to look at.
bool AtPlace::holds(const sema::Expr& e, bool value, const Look& look, const Spot& spot) {
  if (!asks(e, look.heights)) return true;
  if (const auto* v = std::get_if<sema::Logic>(&e.node)) return holds(*v, value, look, spot);
  if (const auto* v = compare_of(e)) return compares(*v, value, look, spot);
  if (!value) return false;
  const auto of = [&](const sema::ExprPtr& x) { return holds(*x, true, look, spot); };
  if (const auto* v = std::get_if<sema::HeldFor>(&e.node)) return of(v->operand);
  if (const auto* v = std::get_if<sema::Previously>(&e.node)) return of(v->operand);
  if (const auto* v = std::get_if<sema::Past>(&e.node)) return of(v->operand);
  if (const auto* v = std::get_if<sema::Since>(&e.node)) {
    return of(v->left) && is(*v->right, true, look, spot);
  }
  const auto* v = std::get_if<sema::ForOthers>(&e.node);
  return v != nullptr && v->universal && of(v->body);
}

bool AtPlace::holds(const sema::Logic& v, bool value, const Look& look, const Spot& spot) {
  using Op = sema::LogicOp;
  const auto all = [&](const sema::ExprPtr& x) { return holds(*x, value, look, spot); };
  const auto one = [&](std::size_t k, bool wanted) {
    return is(*v.operands[k], wanted, look, spot);
  };
  switch (v.op) {
    case Op::logical_not:
      return holds(*v.operands[0], !value, look, spot);
    case Op::implies:
      return value ? one(0, false) || one(1, true)
                   : holds(*v.operands[0], true, look, spot) &&
                         holds(*v.operands[1], false, look, spot);
    case Op::logical_and:
    case Op::logical_or:
      if ((v.op == Op::logical_and) == value) return std::ranges::all_of(v.operands, all);
      return std::ranges::any_of(v.operands,
                                 [&](const sema::ExprPtr& x) { return is(*x, value, look, spot); });
    case Op::iff:
    case Op::logical_xor:
      break;
  }
  return false;
}

// On one side of an `or`, what nobody else has to look at: the zones of the place, to be slow, and
// that others are far.
bool AtPlace::is(const sema::Expr& e, bool value, const Look& look, const Spot& spot) {
  if (asks(e, look.heights)) return holds(e, value, look, spot);
  if (const auto* v = std::get_if<sema::Truth>(&e.node)) return v->value == value;
  if (const auto* v = compare_of(e)) return is(*v, value, look, spot);
  if (const auto* v = std::get_if<sema::Logic>(&e.node)) {
    using Op = sema::LogicOp;
    const auto of = [&](const sema::ExprPtr& x) { return is(*x, value, look, spot); };
    if (v->op == Op::logical_not) return is(*v->operands[0], !value, look, spot);
    if (v->op != Op::logical_and && v->op != Op::logical_or) return false;
    return (v->op == Op::logical_and) == value ? std::ranges::all_of(v->operands, of)
                                               : std::ranges::any_of(v->operands, of);
  }
  if (!value) return false;
  if (const auto* v = std::get_if<sema::ForOthers>(&e.node)) {
    return v->universal && is(*v->body, true, look, spot);
  }
  const auto* v = std::get_if<sema::InsideZone>(&e.node);
  return v != nullptr && lies_in(v->zone, spot);
}

bool AtPlace::is(const sema::Compare& v, bool value, const Look& look, const Spot& spot) {
  const auto [large, small] = sides_of(v, value);
  if (const auto others = of_others(*large, *small, spec_)) {
    const bool none = others->agents.empty() && others->robots == 0;
    return !none && others->robots >= 0 &&
           std::ranges::all_of(others->agents, [](const auto& of) { return of.second >= 0; });
  }
  const auto sum = difference(spec_, *large, *small);
  if (!sum || sum->terms.size() != 1) return false;
  const auto& [of, by] = *sum->terms.begin();
  if (of.kind == Measured::Kind::clearance) return by > 0 && lies_in(sema::ZoneId{of.index}, spot);
  return of.kind == Measured::Kind::speed && by < 0 && look.rest <= Rational(-sum->least / by);
}

bool AtPlace::lies_in(sema::ZoneId zone, const Spot& spot) {
  if (spot.zones.contains(claims_.zones().name(zone))) return true;
  const Rational& radius = spec_[decision_.kind].radius.value;
  return spot.z ? claims_.zones().clear_in_space(zone, spot.at, *spot.z, radius)
                : claims_.zones().clear(zone, spot.at, radius);
}

bool AtPlace::compares(const sema::Compare& v, bool value, const Look& look, const Spot& spot) {
  using Kind = Measured::Kind;
  const auto [large, small] = sides_of(v, value);
  const auto sum = difference(spec_, *large, *small);
  if (!sum) return false;
  const auto charge = sum->terms.find({Kind::battery, 0});
  if (charge != sum->terms.end() && charge->second > 0) {
    const Rational reserve = -sum->least / charge->second;
    if (sum->terms.size() == 1) return is_enough(look.home, reserve, look, spot);
    const auto way = std::ranges::find_if(
        sum->terms, [](const auto& term) { return term.first.kind == Kind::energy_to; });
    return sum->terms.size() == 2 && way != sum->terms.end() && way->second == -charge->second &&
           is_enough(sema::SiteId{way->first.index}, reserve, look, spot);
  }
  if (sum->terms.size() != 1) return false;
  const auto& [of, by] = *sum->terms.begin();
  if (of.kind != Kind::altitude) return false;
  const Rational limit = -sum->least / by;
  return !spot.z || (by > 0 ? *spot.z - look.errs >= limit : *spot.z + look.errs <= limit);
}

bool AtPlace::is_enough(const std::optional<sema::SiteId>& site, const Rational& reserve,
                        const Look& look, const Spot& spot) {
  const Rational full = shown_full(spec_[decision_.kind]);
  if (!site) return reserve <= full;  // what it takes meanwhile is for other claims to say
  if (sgn(full) == 0) return false;
  const auto way = price(*site, spot.at, look.within);
  return way && *way + reserve + look.takes <= full;
}

// As the recoveries of the decision drive it; or, if none of them does, as any other one would.
std::optional<Rational> AtPlace::price(sema::SiteId site, const geometry::Point& at,
                                       const Rational& within) {
  const auto leads = [&](const sema::Controller& c) {
    const auto route = sema::route_of(c);
    return c.kind == decision_.kind && route && route->site == site;
  };
  std::optional<Rational> most;
  for (const sema::MonitorId id : decision_.priority) {
    const sema::Monitor& m = spec_[id];
    if (!m.recover || !leads(spec_[*m.recover])) continue;
    const auto each = price(spec_[*m.recover], at, within);
    if (!each) return std::nullopt;
    most = std::max(most.value_or(*each), *each);
  }
  if (most) return most;
  std::optional<Rational> least;
  for (const sema::Controller& c : spec_.controllers) {
    const auto each = leads(c) ? price(c, at, within) : std::nullopt;
    if (each) least = std::min(least.value_or(*each), *each);
  }
  return least;
}

std::optional<Rational> AtPlace::price(const sema::Controller& c, const geometry::Point& at,
                                       const Rational& within) {
  const auto ways = ways_of(c);
  const auto route = sema::route_of(c);
  if (ways == nullptr) return std::nullopt;
  const Grid& cells = ways->cells;
  const double x = at.x.get_d(), y = at.y.get_d(), off = within.get_d() - slack_m;
  const auto first = [&](double from, double begin) {
    return static_cast<std::size_t>(std::max(0.0, std::floor((from - off - begin) / cells.cell)));
  };
  const auto last = [&](double from, double begin, std::size_t many) {
    return std::min(double(many) - 1, std::floor((from + off - begin) / cells.cell));
  };
  constexpr double rounded_m = 1e-3;
  const double ends = cells.cell * std::sqrt(2.0) - rounded_m;  // half a diagonal at either one
  double longest = -1;
  bool is_inside = false, leads_nowhere = false, leads_there = false;
  for (std::size_t k = 0; k < ways->sites.size(); ++k) {
    for (std::size_t row = first(y, cells.y); double(row) <= last(y, cells.y, cells.rows); ++row) {
      for (std::size_t column = first(x, cells.x);
           double(column) <= last(x, cells.x, cells.columns); ++column) {
        const std::size_t cell = row * cells.columns + column;
        is_inside = is_inside || cells.clearance[cell] >= 0;
        const double length = ways->lengths[k][cell];
        leads_nowhere = leads_nowhere || length == -1;
        leads_there = leads_there || length >= 0;
        if (length >= 0) longest = std::max(longest, length + ends);
      }
    }
    const geometry::Point& site = ways->sites[k];
    longest = std::max(longest, std::hypot(site.x.get_d() - x, site.y.get_d() - y) - off);
  }
  if (!is_inside || (leads_nowhere && !leads_there)) return std::nullopt;
  const sema::RobotKind& kind = spec_[decision_.kind];
  const Numbers n = numbers_of(spec_, decision_, 0);
  const Rational way = Rational(longest), cell = Rational(std::lround(cells.cell * 1000), 1000);
  const auto seconds = priced_seconds(kind, decision_, route->speed.value, cell, way);
  if (!seconds) return std::nullopt;
  const Rational stop = n.speed * n.speed / (2 * (n.brake - n.disturbance));
  return kind.energy->drive.value * (way + stop) + kind.energy->idle.value * *seconds;
}

std::shared_ptr<const AtPlace::Ways> AtPlace::ways_of(const sema::Controller& c) {
  if (const auto known = ways_.find(&c); known != ways_.end()) return known->second;
  auto& found = ways_[&c];
  const auto route = sema::route_of(c);
  const geometry::Region* const zone = claims_.zones().region(route->zone);
  if (zone == nullptr || zone->empty()) return found;
  auto grid = cells_of(*zone);
  if (!grid) return found;
  // of one that no monitor has, as its own speed asks for
  Rational clearance = spec_[decision_.kind].radius.value;
  for (const sema::MonitorId id : decision_.priority) {
    const sema::Monitor& m = spec_[id];
    if (!m.recover || &spec_[*m.recover] != &c) continue;
    clearance = std::max(clearance, claims_.leg_clearance(decision_, m, route->zone));
  }
  auto ways = std::make_shared<Ways>();
  for (const auto& place : spec_[route->site].places) {
    if (place.robot && spec_[*place.robot].kind != decision_.kind) continue;
    ways->sites.push_back({place.position.x, place.position.y});
    ways->lengths.push_back(lengths_to(grid->cells, clearance.get_d(), ways->sites.back()));
  }
  ways->cells = std::move(grid->cells);
  found = std::move(ways);
  return found;
}

}  // namespace rtac::recheck
