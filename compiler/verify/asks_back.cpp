// What all monitors together ask of a place where they give control back: by their properties, and
// by `return when`. Others are far from there, batteries full, and inputs as they should be.
#include <algorithm>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"
#include "compiler/verify/at_place.h"
#include "compiler/verify/common_place.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

void add(std::vector<Need>& all, const Need& need) {
  const auto known =
      std::find_if(all.begin(), all.end(), [&](const Need& n) { return n.zone == need.zone; });
  if (known == all.end()) {
    all.push_back(need);
  } else {
    known->clearance_mm = std::max(known->clearance_mm, need.clearance_mm);
  }
}

// Of the `return when` of one monitor.
class AsksBack {
 public:
  AsksBack(const Subject& s, std::size_t k)
      : subject_(s),
        decision_(s.decision),
        monitor_(s.decision.monitors[k]),
        motion_(s.decision.motions[k + 1]) {}

  struct Part {
    bool known = true;  // it asks for these zones, and for nothing else of the place
    std::vector<Need> zones{};
    bool one_of_several = false;
    bool of_others = false;            // it asks for distances, which there has to be room for
    bool is_choice_of_others = false;  // or for something else instead
    std::int64_t low_mm = JointNeeds().low_mm, high_mm = JointNeeds().high_mm;
    [[nodiscard]] bool of_places() const {
      return !zones.empty() || low_mm != JointNeeds().low_mm || high_mm != JointNeeds().high_mm;
    }
  };
  [[nodiscard]] Part run() const {
    Part all = of(*monitor_.return_when, monitor_.return_when->result);
    all.known = all.known && (is_alone() || !all.is_choice_of_others);
    return all;
  }

 private:
  [[nodiscard]] Part of(const ir::Block& block, ir::ValueId id) const {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) return both(of(block, v->a), of(block, v->b));
    if (const auto* v = std::get_if<ir::Or>(&op)) return either(of(block, v->a), of(block, v->b));
    // who stays there fulfils what is asked of its past
    if (const auto* v = std::get_if<ir::HeldFor>(&op)) return of(block, v->a);
    if (const auto* v = std::get_if<ir::Previously>(&op)) return of(block, v->a);
    if (const auto* v = std::get_if<ir::Once>(&op)) return of(block, v->a);
    if (const auto* v = std::get_if<ir::Historically>(&op)) {
      return v->window.to < 0 ? Part{false} : of(block, v->a);
    }
    if (const auto* v = std::get_if<ir::Truth>(&op)) return {v->value};
    if (const auto* v = std::get_if<ir::Fact>(&op)) {
      if (!v->of_robot) return {};
      const ir::Block& judged = decision_.facts.monitors[v->index].property;
      return of(judged, judged.result);
    }
    if (std::holds_alternative<ir::InputTruth>(op) || std::holds_alternative<ir::InputIs>(op)) {
      return {};
    }
    if (const auto* v = std::get_if<ir::Not>(&op)) return {told(block, v->a)};
    if (const auto* v = std::get_if<ir::ForOthers>(&op)) {
      if (!v->universal) return {false};
      return is_alone() ? Part{} : of(*v->body, v->body->result);
    }
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    return compare != nullptr ? comparison(block, *compare) : Part{false};
  }
  static bool told(const ir::Block& block, ir::ValueId id) {
    const auto* fact = std::get_if<ir::Fact>(&block[id].op);
    return (fact != nullptr && !fact->of_robot) ||
           std::holds_alternative<ir::InputTruth>(block[id].op) ||
           std::holds_alternative<ir::InputIs>(block[id].op);
  }
  [[nodiscard]] bool is_alone() const { return decision_.robots < 2 && !decision_.open_fleet; }
  static Part both(Part a, const Part& b) {
    a.known = a.known && b.known;
    a.of_others = a.of_others || b.of_others;
    a.is_choice_of_others = a.is_choice_of_others || b.is_choice_of_others;
    a.one_of_several = a.one_of_several || b.one_of_several;
    for (const Need& need : b.zones) add(a.zones, need);
    a.low_mm = std::max(a.low_mm, b.low_mm);
    a.high_mm = std::min(a.high_mm, b.high_mm);
    return a;
  }
  // Any side of which all is known, best one that asks for no place.
  static Part either(Part a, Part b) {
    if (!a.known || (b.known && !b.of_places())) std::swap(a, b);
    if (!a.known) return {false};  // what both sides ask for is no more than a guess
    a.one_of_several = a.one_of_several || a.of_places();
    a.is_choice_of_others = a.is_choice_of_others || a.of_others;
    return a;
  }
  [[nodiscard]] Part comparison(const ir::Block& block, const ir::AtLeast& compare) const {
    using Kind = ir::Leaf::Kind;
    if (!ir::has_form(block, compare)) return {false};
    const auto& params = decision_.facts.params;
    // which place leaves enough of it is a matter of prices (at_place.h)
    if (ir::charge_for_way(block, compare, params)) return {};
    const auto least = ir::lower_bound(block, compare, params);
    if (least && least->leaf.kind == Kind::clearance) {
      const std::int64_t mm =
          analysis::shown_clearance_mm(decision_, motion_, least->need.strictest);
      if (mm < 0) return {false};  // it may be outside
      return {true, {{ir::ZoneIndex{least->leaf.table}, mm}}};
    }
    const auto most = ir::upper_bound(block, compare);
    const auto is = [](const auto& bound, Kind kind) { return bound && bound->leaf.kind == kind; };
    if (is(least, Kind::altitude) || is(most, Kind::altitude)) {
      const std::int64_t errs_mm =
          analysis::shown_clearance_mm(decision_, motion_, 0) - decision_.body.radius_mm;
      Part part;
      if (least) part.low_mm = least->need.strictest + errs_mm;
      if (most) part.high_mm = most->most - errs_mm;
      return part;
    }
    if (is(most, Kind::speed)) {
      return {most->most >= analysis::shown_speed_mmps(decision_, motion_)};
    }
    if (is(least, Kind::agent)) {
      const ir::AgentIndex agent{least->leaf.table};
      return {!is_out_of_sight(subject_, agent, least->need.strictest)};
    }
    const bool none_counted = is(most, Kind::count) && is_alone() && most->most >= 0;
    Part part{is(least, Kind::battery) || is(least, Kind::distance) || none_counted};
    part.of_others = is(least, Kind::distance);
    return part;
  }

  const Subject& subject_;
  const ir::Decision& decision_;
  const ir::Monitor& monitor_;
  const ir::Motion& motion_;
};

}  // namespace

JointNeeds joint_needs_of(const Subject& s, std::optional<std::size_t> at_once) {
  JointNeeds all;
  const auto& params = s.decision.facts.params;
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    const ir::Monitor& m = s.decision.monitors[k];
    if (s.looks_at_places(k)) {
      const std::int64_t back_mm =
          analysis::return_clearance_mm(s.decision, m.lookahead.duration_us);
      for (const ir::ZoneIndex zone : analysis::fences_of(m.property, params)) {
        add(all.zones, {zone, back_mm + analysis::fence_standoff_mm(m.property, params, zone)});
      }
    }
    if (!m.return_when || k == at_once) continue;
    const AsksBack::Part part = AsksBack(s, k).run();
    for (const Need& need : part.zones) add(all.returned, need);
    all.low_mm = std::max(all.low_mm, part.low_mm);
    all.high_mm = std::min(all.high_mm, part.high_mm);
    all.one_of_several = all.one_of_several || part.one_of_several;
    if (!part.known) all.open.push_back(m.name);
  }
  return all;
}

std::vector<Sides> ways_to_choose(
    const Subject& s, const std::vector<const ir::Monitor*>& monitors,
    const std::function<std::int64_t(const ir::Monitor&, std::int64_t)>& ask,
    const std::function<std::int64_t(const ir::Monitor&)>& rest_mmps) {
  constexpr std::size_t ways_most = 64;
  const auto& params = s.decision.facts.params;
  std::vector<Sides> all(1);
  for (const ir::Monitor* m : monitors) {
    std::map<ir::ZoneIndex, std::int64_t> asked;
    ir::for_each_comparison(m->property, [&](const ir::Block& block, const ir::AtLeast& c) {
      const auto bound = ir::lower_bound(block, c, params);
      if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance) return;
      std::int64_t& mm = asked[ir::ZoneIndex{bound->leaf.table}];
      mm = std::max(mm, bound->need.strictest);
    });
    const std::int64_t mmps = rest_mmps ? rest_mmps(*m) : 0;
    for (const analysis::Choice& choice : analysis::choices_of(m->property, params, mmps)) {
      std::vector<Sides> more;
      for (const Sides& before : all) {
        for (const ir::ZoneIndex zone : choice) {
          if (more.size() == ways_most) break;
          more.push_back(before);
          add(more.back(), {zone, ask(*m, asked[zone])});
        }
      }
      all = std::move(more);
    }
  }
  return all;
}

std::vector<Mend> earlier_returns(const Subject& s) {
  std::vector<Mend> all;
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    const ir::Monitor& m = s.decision.monitors[k];
    if (!m.return_when) continue;
    const std::vector<Need> others = all_of(joint_needs_of(s, k)), own = AsksBack(s, k).run().zones;
    for (const Need& need : own) {
      std::vector<Need> with = others;
      for (const Need& other : own) {
        if (other.zone != need.zone) add(with, other);
      }
      // at most so clear: `high_mm` is not found, `low_mm` is
      std::int64_t low_mm = -1, high_mm = need.clearance_mm;
      while (high_mm - low_mm > 1) {
        const std::int64_t middle_mm = low_mm < 0 ? 0 : (low_mm + high_mm) / 2;
        std::vector<Need> asked = with;
        add(asked, {need.zone, middle_mm});
        (common_place(s, asked) ? low_mm : high_mm) = middle_mm;
      }
      if (low_mm <= 0) continue;
      all.emplace_back(EarlierReturn{m.name, s.module[need.zone].name, need.clearance_mm - low_mm});
    }
  }
  return all;
}

std::vector<Need> all_of(const JointNeeds& needs) {
  std::vector<Need> all = needs.zones;
  for (const Need& need : needs.returned) add(all, need);
  return all;
}

std::vector<Claim> returned_claims(const Subject& s, std::int64_t x_mm, std::int64_t y_mm,
                                   std::optional<std::int64_t> z_mm) {
  const auto& monitors = s.decision.monitors;
  if (std::ranges::none_of(monitors, [](const ir::Monitor& m) { return !!m.return_when; })) {
    return {};
  }
  Claim claim{"returned",
              {{"decision", s.decision.name},
               {"x_mm", std::to_string(x_mm)},
               {"y_mm", std::to_string(y_mm)}}};
  if (z_mm) claim.values["z_mm"] = std::to_string(*z_mm);
  return {claim};
}

Obligation returns_open(const JointNeeds& needs, Obligation o) {
  std::string names;
  for (const std::string& name : needs.open) names += (names.empty() ? "" : ", ") + quoted(name);
  o.status = Status::unknown;
  o.method = "no proof";
  o.because = "whether `return when` of " + names +
              " holds at a place where all monitors give control back is not shown";
  return o;
}

}  // namespace rtac::verify
