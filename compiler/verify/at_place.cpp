#include "compiler/verify/at_place.h"

#include <algorithm>
#include <limits>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/reach.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/operands.h"
#include "compiler/support/words.h"
#include "compiler/verify/common_place.h"

namespace rtac::verify {
namespace {

using Leaf = ir::Leaf::Kind;

// The most that a way takes which begins within `radius_mm` of a place, as a robot looks it up, of
// all robots. nullopt: from some place there no way is known.
std::optional<std::int64_t> price_at(const ir::Module& module, const ir::SiteTable& site,
                                     const Place& at, std::int64_t radius_mm) {
  const ir::Cells& cells = module[site.zone].cells;
  const auto floor_div = [&](std::int64_t mm) {
    const std::int64_t at_cell = mm / cells.cell_mm;
    return mm < 0 && mm % cells.cell_mm != 0 ? at_cell - 1 : at_cell;
  };
  const std::int64_t x = at.x_mm - cells.origin_x_mm, y = at.y_mm - cells.origin_y_mm;
  const std::int64_t west = std::max<std::int64_t>(0, floor_div(x - radius_mm));
  const std::int64_t east = std::min<std::int64_t>(cells.columns - 1, floor_div(x + radius_mm));
  const std::int64_t south = std::max<std::int64_t>(0, floor_div(y - radius_mm));
  const std::int64_t north = std::min<std::int64_t>(cells.rows - 1, floor_div(y + radius_mm));
  std::int64_t most = ir::no_body;
  for (const ir::SiteTable::Place& place : site.places) {
    if (place.cost_ppm.empty()) return std::nullopt;
    for (std::int64_t row = south; row <= north; ++row) {
      for (std::int64_t column = west; column <= east; ++column) {
        most = std::max<std::int64_t>(
            most, place.cost_ppm[static_cast<std::size_t>(row * cells.columns + column)]);
      }
    }
  }
  return most < 0 || most >= ir::no_way ? std::nullopt : std::optional(most);
}

// Of one monitor, at one place.
class AtPlace {
 public:
  struct Look {
    std::int64_t within_mm = 0;  // how far from there a robot may be, as it is measured, or get
    std::int64_t takes_ppm = 0;  // until its recovery acts, and what others may take
    std::int64_t errs_mm = 0;    // of a height
    std::int64_t rest_mmps = 0;  // as fast as a robot at rest may seem, or become
    std::optional<ir::SiteIndex> home{};  // where whoever asks for charge is led
    bool heights = false;                 // those count, too
  };
  AtPlace(const Subject& s, Look look, const Place& at, const std::vector<Need>& zones)
      : s_(s), look_(look), at_(at), zones_(zones) {}

  [[nodiscard]] bool holds(const ir::Block& block) const { return holds(block, block.result); }
  // Whether it asks for anything that is looked at here.
  [[nodiscard]] bool asks(const ir::Block& block) const { return asks(block, block.result); }

 private:
  [[nodiscard]] const ir::Block* judged(const ir::Op& op) const {
    const auto* const fact = std::get_if<ir::Fact>(&op);
    if (fact == nullptr || !fact->of_robot) return ir::body_of(op);
    return &s_.decision.facts.monitors[fact->index].property;
  }
  [[nodiscard]] bool asks(const ir::Block& block, ir::ValueId id) const {
    const ir::Op& op = block[id].op;
    if (std::holds_alternative<ir::Battery>(op) || std::holds_alternative<ir::EnergyTo>(op) ||
        (look_.heights && std::holds_alternative<ir::Altitude>(op))) {
      return true;
    }
    if (const ir::Block* const of = judged(op)) return asks(*of);
    bool found = false;
    ir::for_each_operand(op, [&](ir::ValueId of) { found = found || asks(block, of); });
    return found;
  }
  // What asks for nothing of this is for others to look at.
  [[nodiscard]] bool holds(const ir::Block& block, ir::ValueId id) const {
    if (!asks(block, id)) return true;
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) return holds(block, v->a) && holds(block, v->b);
    if (const auto* v = std::get_if<ir::Or>(&op)) return is(block, v->a) || is(block, v->b);
    // who stays there fulfils what is asked of its past
    if (const auto* v = std::get_if<ir::HeldFor>(&op)) return holds(block, v->a);
    if (const auto* v = std::get_if<ir::Previously>(&op)) return holds(block, v->a);
    if (const auto* v = std::get_if<ir::Once>(&op)) return holds(block, v->a);
    if (const auto* v = std::get_if<ir::Historically>(&op)) return holds(block, v->a);
    if (const auto* v = std::get_if<ir::Since>(&op)) return holds(block, v->a) && is(block, v->b);
    if (const auto* v = std::get_if<ir::ForOthers>(&op)) return v->universal && holds(*v->body);
    if (std::holds_alternative<ir::Fact>(op)) return holds(*judged(op));
    const auto* const compare = std::get_if<ir::AtLeast>(&op);
    return compare != nullptr && ir::has_form(block, *compare) && compares(block, *compare);
  }
  // On one side of an `or`, what nobody else has to look at: the zones of the place, to be slow,
  // and that others are far.
  [[nodiscard]] bool is(const ir::Block& block, ir::ValueId id) const {
    if (asks(block, id)) return holds(block, id);
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) return is(block, v->a) && is(block, v->b);
    if (const auto* v = std::get_if<ir::Or>(&op)) return is(block, v->a) || is(block, v->b);
    if (const auto* v = std::get_if<ir::Truth>(&op)) return v->value;
    if (const auto* v = std::get_if<ir::ForOthers>(&op)) {
      return v->universal && is(*v->body, v->body->result);
    }
    const auto* const compare = std::get_if<ir::AtLeast>(&op);
    if (compare == nullptr || !ir::has_form(block, *compare)) return false;
    const auto least = ir::lower_bound(block, *compare, s_.decision.facts.params);
    if (least && least->leaf.kind == Leaf::clearance) {
      return std::ranges::any_of(
          zones_, [&](const Need& need) { return need.zone == ir::ZoneIndex{least->leaf.table}; });
    }
    const auto most = ir::upper_bound(block, *compare);
    if (most && most->leaf.kind == Leaf::speed) return look_.rest_mmps <= most->most;
    return least && (least->leaf.kind == Leaf::distance || least->leaf.kind == Leaf::agent);
  }
  [[nodiscard]] bool compares(const ir::Block& block, const ir::AtLeast& compare) const {
    const auto& params = s_.decision.facts.params;
    const std::int64_t strict = compare.strict ? 1 : 0;
    if (const auto way = ir::charge_for_way(block, compare, params)) {
      return is_enough(way->site, way->reserve.strictest + strict);
    }
    const auto least = ir::lower_bound(block, compare, params);
    const auto most = ir::upper_bound(block, compare);
    if (least && least->leaf.kind == Leaf::battery) {
      return is_enough(look_.home, least->need.strictest + strict);
    }
    if (least && least->leaf.kind == Leaf::altitude) {
      return !at_.z_mm || *at_.z_mm - look_.errs_mm >= least->need.strictest + strict;
    }
    if (most && most->leaf.kind == Leaf::altitude) {
      return !at_.z_mm || *at_.z_mm + look_.errs_mm <= most->most - strict;
    }
    return false;
  }
  [[nodiscard]] bool is_enough(std::optional<ir::SiteIndex> site, std::int64_t reserve_ppm) const {
    const std::int64_t full_ppm = analysis::shown_full_ppm(s_.decision.body);
    if (!site)
      return reserve_ppm <= full_ppm;  // what it takes meanwhile is for errors to say (5007)
    const auto price = price_at(s_.module, s_.module[*site], at_, look_.within_mm);
    return price && *price + reserve_ppm + look_.takes_ppm <= full_ppm;
  }

  const Subject& s_;
  const Look look_;
  const Place& at_;
  const std::vector<Need>& zones_;
};

// At this moment, as every sample shows it.
AtPlace::Look seen_now(const Subject& s, const ir::Motion& motion) {
  AtPlace::Look look;
  look.within_mm = analysis::shown_clearance_mm(s.decision, motion, 0) - s.decision.body.radius_mm;
  look.errs_mm = look.within_mm;
  look.rest_mmps = analysis::shown_speed_mmps(s.decision, motion);
  return look;
}
AtPlace::Look ahead_of(const Subject& s, const ir::Monitor& m) {
  const ir::Decision& d = s.decision;
  const std::int64_t ahead_us = m.lookahead.duration_us;
  const std::int64_t ms =
      (analysis::horizon_us_max(d.body, ahead_us) + d.return_extra_us + 999) / 1000;
  AtPlace::Look look;
  look.within_mm = analysis::return_clearance_mm(d, ahead_us) - d.body.radius_mm;
  look.takes_ppm = d.hold_reserve_ppm + (d.body.drain_ppm_per_s * ms + 999) / 1000;
  look.rest_mmps = analysis::fastest_from_rest(d, ahead_us);
  // its own way counts, whether it is asked for or not
  if (m.recovery.kind == ir::RecoveryKind::route) look.home = m.recovery.site;
  return look;
}

}  // namespace

bool is_charged_at(const Subject& s, const Place& at, const std::vector<Need>& zones) {
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    const ir::Monitor& m = s.decision.monitors[k];
    if (s.looks_at_places(k) && !AtPlace(s, ahead_of(s, m), at, zones).holds(m.property)) {
      return false;
    }
    if (!m.return_when) continue;
    const AtPlace now(s, seen_now(s, s.decision.motions[k + 1]), at, zones);
    if (!now.holds(*m.return_when)) return false;
  }
  return true;
}

bool asks_for_charge(const Subject& s) {
  const Place anywhere;
  const std::vector<Need> none;
  const AtPlace looks(s, {}, anywhere, none);
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    const ir::Monitor& m = s.decision.monitors[k];
    if (s.looks_at_places(k) && looks.asks(m.property)) return true;
    if (m.return_when && looks.asks(*m.return_when)) return true;
  }
  return false;
}

bool is_seen_at(const Subject& s, const ir::Block& property, const Place& at,
                const std::vector<Need>& zones) {
  AtPlace::Look look = seen_now(s, s.decision.motions.front());
  look.heights = true;
  return AtPlace(s, look, at, zones).holds(property);
}

bool asks_for_more(const Subject& s, const ir::Block& property) {
  AtPlace::Look look;
  look.heights = true;
  const Place anywhere;
  const std::vector<Need> none;
  return AtPlace(s, look, anywhere, none).asks(property);
}

std::vector<Place> charging_places(const Subject& s) {
  std::vector<Place> all;
  const auto add = [&](ir::SiteIndex site) {
    for (const ir::SiteTable::Place& place : s.module[site].places) {
      all.push_back({place.x_mm, place.y_mm, std::nullopt});
    }
  };
  const auto add_of = [&](const ir::Block& of) {
    ir::for_each_comparison(of, [&](const ir::Block& block, const ir::AtLeast& compare) {
      if (!ir::has_form(block, compare)) return;
      const auto way = ir::charge_for_way(block, compare, s.decision.facts.params);
      if (way) add(way->site);
    });
  };
  for (const ir::Monitor& m : s.decision.monitors) {
    if (m.recovery.kind == ir::RecoveryKind::route) add(m.recovery.site);
    add_of(m.property);
    if (m.return_when) add_of(*m.return_when);
  }
  return all;
}

std::optional<geometry::Point> good_place(const Subject& s, const std::vector<Need>& all,
                                          const std::optional<geometry::Point>& first,
                                          const std::function<bool(const Place&)>& is_good) {
  const auto good = [&](const geometry::Point& p) { return is_good({in_mm(p.x), in_mm(p.y)}); };
  if (first && good(*first)) return first;
  const IsClear is_clear(s, all);
  for (const Place& at : charging_places(s)) {
    const geometry::Point p{analysis::metres_of(at.x_mm), analysis::metres_of(at.y_mm)};
    if (is_clear(p) && good(p)) return p;
  }
  for (const Need& need : all) {
    const ir::Cells& cells = s.module[need.zone].cells;
    for (std::size_t at = 0; at < cells.clearance_mm_lo.size(); ++at) {
      if (cells.clearance_mm_lo[at] < need.clearance_mm) continue;
      const auto columns = static_cast<std::size_t>(cells.columns);
      const std::int64_t half = cells.cell_mm / 2;
      const std::int64_t x_mm =
          cells.origin_x_mm + std::int64_t(at % columns) * cells.cell_mm + half;
      const std::int64_t y_mm =
          cells.origin_y_mm + std::int64_t(at / columns) * cells.cell_mm + half;
      const geometry::Point p{analysis::metres_of(x_mm), analysis::metres_of(y_mm)};
      if (good(p) && is_clear(p)) return p;
    }
  }
  // nobody asks for one
  const geometry::Point any{0, 0};
  return all.empty() && good(any) ? std::optional(any) : std::nullopt;
}

namespace {

bool speaks_of_inputs(const ir::Block& block, ir::ValueId id) {
  const ir::Op& op = block[id].op;
  if (const auto* fact = std::get_if<ir::Fact>(&op)) return !fact->of_robot;
  const ir::Block* const body = ir::body_of(op);
  bool found = body != nullptr && speaks_of_inputs(*body, body->result);
  ir::for_each_operand(op, [&](ir::ValueId of) { found = found || speaks_of_inputs(block, of); });
  return found;
}

}  // namespace

bool settles_places(const Subject& s, const ir::Monitor& m, std::int64_t mmps, bool is_told) {
  const auto rests = [&](ir::ValueId id) {
    return (is_told && speaks_of_inputs(m.property, id)) ||
           analysis::asks_for_slow(s.module, s.decision, m.property, id, mmps);
  };
  return analysis::places_settle(m.property, s.decision.facts.params, {mmps, rests});
}

bool is_out_of_sight(const Subject& s, ir::AgentIndex index, std::int64_t least_mm) {
  constexpr std::int64_t known_mm = 100'000'000;
  const ir::Decision& d = s.decision;
  const ir::Agent& agent = d[index];
  if (agent.present) return false;
  const std::int64_t aged_mm = (agent.speed_mmps * ((agent.age_us + 999) / 1000) + 999) / 1000;
  return analysis::shown_clearance_mm(d, d.motions.front(), least_mm) + agent.radius_mm +
             2 * (agent.error_mm + 2) + aged_mm >
         known_mm;
}

std::string out_of_sight(const Subject& s, std::optional<std::size_t> only) {
  const ir::Decision& d = s.decision;
  for (std::size_t k = 0; k < d.monitors.size() && !d.on_plan; ++k) {
    if ((only && k != *only) || s.told.contains(k)) continue;
    bool far = false;
    const auto look = [&](const ir::Block& block, const ir::AtLeast& compare) {
      if (!ir::has_form(block, compare)) return;
      const auto least = ir::lower_bound(block, compare, d.facts.params);
      if (!least || least->leaf.kind != Leaf::agent) return;
      far = far || is_out_of_sight(s, ir::AgentIndex{least->leaf.table}, least->need.strictest);
    };
    ir::for_each_comparison(d.monitors[k].property, look);
    if (far) return d.monitors[k].name;
  }
  return "";
}

}  // namespace rtac::verify
