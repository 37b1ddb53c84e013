#include "compiler/analysis/return_met.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/site_room.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/operands.h"

namespace rtac::analysis {
namespace {

using How = ir::Returns::How;

// Of what inputs say: whatever they said before, they may say it again. That is not so of what
// one moment decides for ever.
class ComesAgain {
 public:
  explicit ComesAgain(const ir::Block& block) : block_(block) {}

  // `value`: to be true or false; none: either.
  bool is_so(ir::ValueId id, std::optional<bool> value) {
    const int which = !value ? 2 : *value ? 1 : 0;
    const auto known = known_.find({id, which});
    if (known != known_.end()) return known->second;
    const bool found = find(id, value);
    known_.emplace(std::pair(id, which), found);
    return found;
  }

 private:
  bool find(ir::ValueId id, std::optional<bool> value) {
    const ir::Op& op = block_[id].op;
    const auto* const once = std::get_if<ir::Once>(&op);
    const auto* const always = std::get_if<ir::Historically>(&op);
    const auto* const of = std::get_if<ir::Aggregate>(&op);
    if (once != nullptr && once->window.to < 0 && !value.value_or(false)) return false;
    if (always != nullptr && always->window.to < 0 && value.value_or(true)) return false;
    if (of != nullptr && of->window.to < 0) return false;
    if (std::holds_alternative<ir::Elapsed>(op)) return value.value_or(true);
    const bool either = std::holds_alternative<ir::Or>(op),
               both = std::holds_alternative<ir::And>(op);
    const bool plain = either || both || once != nullptr || always != nullptr ||
                       std::holds_alternative<ir::HeldFor>(op) ||
                       std::holds_alternative<ir::Previously>(op) ||
                       std::holds_alternative<ir::Since>(op);
    std::optional<bool> of_sides = plain ? value : std::nullopt;
    if (std::holds_alternative<ir::Not>(op) && value) of_sides = !*value;
    bool all = true, any = false;
    ir::for_each_operand(op, [&](ir::ValueId side) {
      const bool again = is_so(side, of_sides);
      all = all && again;
      any = any || again;
    });
    const bool one_will_do = value && ((either && *value) || (both && !*value));
    return one_will_do ? any : all;
  }

  const ir::Block& block_;
  std::map<std::pair<ir::ValueId, int>, bool> known_;
};

class Met {
 public:
  Met(const ir::Module& module, const ir::Decision& decision, std::size_t k, const ExactZone& exact,
      const ExactSolid& solid)
      : module_(module),
        decision_(decision),
        monitor_(decision.monitors[k]),
        motion_(decision.motions[k + 1]),
        drives_mmps_(fastest_while_driving(decision, k)),
        last_(ir::last_step(monitor_.recovery)),
        leads_(ir::moves(last_.kind) && last_.kind != ir::RecoveryKind::yield),
        exact_(exact),
        solid_(solid) {}

  ir::Returns run() {
    const ir::Block& when = *monitor_.return_when;
    const Part all = of(when, when.result);
    found_.how = all.how;
    found_.shown_mmps = all.shown_mmps;
    found_.shown_high_mm = all.shown_high_mm;
    found_.lands_above = all.lands_above;
    found_.stuck_mm = some_place(all.stuck);
    return found_;
  }

 private:
  // What becomes of a part of the condition, and what is known of one that is open.
  struct Part {
    How how = How::open;
    geometry::Region stuck{};  // where the recovery leaves a robot, and this does not hold
    // with a limit of this speed, nothing of it were open; or of this height
    std::optional<std::int64_t> shown_mmps{}, shown_high_mm{};
    bool lands_above = false;  // a landing ends higher than it asks for
  };

  // Several conditions may share one.
  Part of(const ir::Block& block, ir::ValueId id) {
    const std::tuple key(&block, id, turned_, lasts_);
    const auto known = parts_.find(key);
    if (known != parts_.end()) return known->second;
    return parts_.emplace(key, find(block, id)).first->second;
  }
  Part find(const ir::Block& block, ir::ValueId id) {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) return both(of(block, v->a), of(block, v->b));
    if (const auto* v = std::get_if<ir::Or>(&op)) return either(of(block, v->a), of(block, v->b));
    if (const auto* v = std::get_if<ir::HeldFor>(&op)) {
      return lasting(block, v->a, v->ticks * decision_.period_us);
    }
    if (const auto* v = std::get_if<ir::Previously>(&op)) {
      return lasting(block, v->a, decision_.period_us);
    }
    if (const auto* v = std::get_if<ir::Truth>(&op)) {
      return {v->value ? How::itself : How::open};
    }
    if (const auto* v = std::get_if<ir::Fact>(&op)) return of_fact(*v);
    if (const auto* v = std::get_if<ir::Once>(&op)) {
      // what does not hold where it stands may have held on the way there
      const std::int64_t after_us = v->window.from * decision_.period_us;
      return {(after_us > 0 ? lasting(block, v->a, after_us) : of(block, v->a)).how};
    }
    if (const auto* v = std::get_if<ir::Historically>(&op)) {
      if (v->window.to < 0) return {};
      return lasting(block, v->a, v->window.to * decision_.period_us);
    }
    if (std::holds_alternative<ir::InputTruth>(op) || std::holds_alternative<ir::InputIs>(op)) {
      return {How::told};
    }
    if (const auto* v = std::get_if<ir::Not>(&op)) {
      turned_ = !turned_;
      const How how = of(block, v->a).how;
      turned_ = !turned_;
      return {how == How::told ? How::told : How::open};
    }
    if (const auto* v = std::get_if<ir::ForOthers>(&op)) {
      // of all others, where there is none; that there is one never comes about then
      return {v->universal && decision_.robots < 2 ? How::itself : How::open};
    }
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    if (compare == nullptr || !ir::has_form(block, *compare)) return {};
    return comes_about(block, *compare);
  }
  // What has to have been so at other moments than this one.
  Part lasting(const ir::Block& block, ir::ValueId id, std::int64_t after_us) {
    found_.after_us += after_us;
    const bool before = std::exchange(lasts_, true);
    const Part part = of(block, id);
    lasts_ = before;
    return part;
  }
  Part of_fact(const ir::Fact& fact) {
    const ir::Block& judged = decision_.facts.monitors[fact.index].property;
    if (fact.of_robot) return of(judged, judged.result);
    return {ComesAgain(judged).is_so(judged.result, !turned_) ? How::told : How::open};
  }
  static Part both(const Part& a, const Part& b) {
    Part all{std::max(a.how, b.how), a.stuck.unite(b.stuck)};
    all.lands_above = a.lands_above || b.lands_above;
    const auto with = [&](std::optional<std::int64_t> Part::*limit) -> std::optional<std::int64_t> {
      if (a.how != How::open) return b.*limit;
      if (b.how != How::open) return a.*limit;
      return a.*limit && b.*limit ? std::max(a.*limit, b.*limit) : std::nullopt;
    };
    all.shown_mmps = with(&Part::shown_mmps);
    all.shown_high_mm = with(&Part::shown_high_mm);
    return all;
  }
  // Of a choice the side that is asked for may be either; it fails where both sides do. Who loiters
  // is slow and is not in turn, which inputs do not make up for.
  [[nodiscard]] Part either(const Part& a, const Part& b) const {
    Part any{std::min(a.how, b.how)};
    if (in_laps() && any.how == How::told && a.how != b.how) return {How::open};
    if (any.how != How::open) return any;
    any.stuck = a.stuck.intersect(b.stuck);
    any.shown_mmps = a.shown_mmps ? a.shown_mmps : b.shown_mmps;
    any.shown_high_mm = a.shown_high_mm ? a.shown_high_mm : b.shown_high_mm;
    any.lands_above = a.lands_above && b.lands_above;
    return any;
  }
  Part comes_about(const ir::Block& block, const ir::AtLeast& compare) {
    const auto found = [](bool holds) { return Part{holds ? How::itself : How::open}; };
    const auto& params = decision_.facts.params;
    if (const auto way = ir::charge_for_way(block, compare, params)) {
      return found(last_.charges && way->site == last_.site);
    }
    const auto least = ir::lower_bound(block, compare, params);
    const auto most = ir::upper_bound(block, compare);
    if (least && least->leaf.kind == ir::Leaf::Kind::battery) return found(last_.charges);
    if (least && least->leaf.kind == ir::Leaf::Kind::clearance && leads_) {
      return clear(ir::ZoneIndex{least->leaf.table}, least->need.strictest);
    }
    if (most && most->leaf.kind == ir::Leaf::Kind::speed) return slow(most->most);
    if (last_.kind == ir::RecoveryKind::land) return landed(least, most);
    return found(height(least, most));
  }
  [[nodiscard]] bool in_laps() const { return lasts_ && last_.kind == ir::RecoveryKind::loiter; }
  // At rest, it is seen to be so slow whatever the sample: that some sample would show it is not
  // enough, as all of them may be as old as they may. Who loiters rests between laps alone.
  [[nodiscard]] Part slow(std::int64_t most_mmps) const {
    const std::int64_t shown_mmps = shown_speed_mmps(decision_, motion_);
    if (in_laps()) {
      const std::int64_t laps_mmps = std::max(shown_mmps, drives_mmps_ + seen_faster_mmps());
      return {most_mmps >= laps_mmps ? How::itself : How::open};
    }
    if (most_mmps >= shown_mmps) return {How::itself};
    return {How::open, {}, shown_mmps};
  }
  // Than it is: as fast as one may look that stands.
  [[nodiscard]] std::int64_t seen_faster_mmps() const {
    ir::Motion stands = motion_;
    stands.speed_mmps = 0;
    return shown_speed_mmps(decision_, stands);
  }
  // As clear of its own zone as it is where it has led, a robot is seen to be so clear of this one.
  Part clear(ir::ZoneIndex zone, std::int64_t least_mm) {
    const std::int64_t need_mm = shown_clearance_mm(decision_, motion_, least_mm);
    const std::int64_t more_mm = need_mm - last_.return_clearance_mm;
    if (zone == last_.zone) return {more_mm <= 0 ? How::itself : How::open};
    if (module_[zone].has_height() || module_[last_.zone].has_height()) {
      const bool holds = more_mm <= 0 && solid_(last_.zone).subtract(solid_(zone)).empty();
      return {holds ? How::itself : How::open};
    }
    const geometry::Region& own = exact_(last_.zone);
    const auto deep = within(exact_(zone), std::max<std::int64_t>(0, more_mm));
    if (deep && deep->contains(own)) return {How::itself};
    if (last_.kind == ir::RecoveryKind::route) {
      if (sites_clear(zone, need_mm)) return {How::itself};
      return {How::open, least_mm < 0 ? geometry::Region() : parked_outside(zone)};
    }
    // less than touching it may hold outside
    if (least_mm < 0 || last_.kind != ir::RecoveryKind::retreat) return {};
    const std::int64_t surely_mm =
        decision_.body.radius_mm + least_mm - rests_off_mm(decision_.body);
    const auto has = within(exact_(zone), std::max<std::int64_t>(surely_mm, 0));
    return {How::open, stuck_outside(own.subtract(has.value_or(exact_(zone))))};
  }
  [[nodiscard]] bool sites_clear(ir::ZoneIndex zone, std::int64_t need_mm) const {
    const auto deep = within(exact_(zone), need_mm + parked_mm);
    const auto& places = module_[last_.site].places;
    return deep && std::all_of(places.begin(), places.end(), [&](const ir::SiteTable::Place& p) {
             return deep->contains({metres_of(p.x_mm), metres_of(p.y_mm)});
           });
  }
  // Where robots come to rest, if no robot does so with its centre in the zone.
  [[nodiscard]] geometry::Region parked_outside(ir::ZoneIndex zone) const {
    const std::int64_t off_mm = std::max(parked_mm, rests_off_mm(decision_.body));
    std::vector<geometry::Ring> around;
    for (const ir::SiteTable::Place& p : module_[last_.site].places) {
      const auto low = [&](std::int64_t mm) { return metres_of(mm - off_mm); };
      const auto high = [&](std::int64_t mm) { return metres_of(mm + off_mm); };
      around.push_back({{low(p.x_mm), low(p.y_mm)},
                        {high(p.x_mm), low(p.y_mm)},
                        {high(p.x_mm), high(p.y_mm)},
                        {low(p.x_mm), high(p.y_mm)}});
    }
    const geometry::Region all = geometry::Region::of_rings(around);
    return all.intersect(exact_(zone)).empty() ? all : geometry::Region();
  }
  // The places outside that the recovery leads nowhere from, as they are clear enough already.
  [[nodiscard]] geometry::Region stuck_outside(const geometry::Region& outside) const {
    const auto rests = within(exact_(last_.zone), last_.return_clearance_mm + 5);
    return rests ? rests->intersect(outside) : geometry::Region();
  }
  static std::optional<std::pair<std::int64_t, std::int64_t>> some_place(
      const geometry::Region& left) {
    if (left.empty()) return std::nullopt;
    const auto parts = left.polygons();
    geometry::Point low = parts.front().outer.front(), high = low;
    for (const geometry::Point& p : parts.front().outer) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const geometry::Point middle{Rational((low.x + high.x) / 2), Rational((low.y + high.y) / 2)};
    const geometry::Point at = left.contains(middle) ? middle : parts.front().outer.front();
    return {{floor_to_int(Rational(at.x * 1000)), floor_to_int(Rational(at.y * 1000))}};
  }
  // Of where a sample shows it to be, which errors and its hold make of where it is.
  [[nodiscard]] std::int64_t height_errs_mm() const {
    return shown_clearance_mm(decision_, motion_, 0) - decision_.body.radius_mm;
  }
  // Who is lower than where a landing ends is held there.
  [[nodiscard]] Part landed(const std::optional<ir::LowerBound>& least,
                            const std::optional<ir::UpperBound>& most) const {
    const bool low = least && least->leaf.kind == ir::Leaf::Kind::altitude;
    const bool high = most && most->leaf.kind == ir::Leaf::Kind::altitude;
    if (low || !high) return {};
    const std::int64_t strays_mm = decision_.body.hold_mm + height_errs_mm();
    if (last_.land_mm + strays_mm <= most->most) return {How::itself};
    Part part;
    part.shown_high_mm = last_.land_mm + strays_mm;
    part.lands_above = last_.land_mm - strays_mm > most->most;
    return part;
  }
  [[nodiscard]] bool height(const std::optional<ir::LowerBound>& least,
                            const std::optional<ir::UpperBound>& most) const {
    const bool low = least && least->leaf.kind == ir::Leaf::Kind::altitude;
    const bool high = most && most->leaf.kind == ir::Leaf::Kind::altitude;
    const auto& slabs = module_[last_.zone].slabs;
    if ((!low && !high) || !leads_ || slabs.empty()) return false;
    const std::int64_t rest_mm = last_.return_clearance_mm - height_errs_mm();
    return (!low || slabs.front().floor_mm + rest_mm >= least->need.strictest) &&
           (!high || slabs.back().ceiling_mm - rest_mm <= most->most);
  }

  const ir::Module& module_;
  const ir::Decision& decision_;
  const ir::Monitor& monitor_;
  const ir::Motion& motion_;
  const std::int64_t drives_mmps_;
  const ir::Recovery& last_;
  const bool leads_;
  const ExactZone& exact_;
  const ExactSolid& solid_;
  bool lasts_ = false;   // what is asked of has to last, or was so earlier
  bool turned_ = false;  // it is to be false
  ir::Returns found_;
  std::map<std::tuple<const ir::Block*, ir::ValueId, bool, bool>, Part> parts_;
};

}  // namespace

void judge_return_conditions(ir::Module& module, const ExactZone& exact, const ExactSolid& solid) {
  for (ir::Decision& decision : module.decisions) {
    if (decision.on_plan) continue;
    for (std::size_t k = 0; k < decision.monitors.size(); ++k) {
      if (!decision.monitors[k].return_when) continue;
      decision.monitors[k].returns = Met(module, decision, k, exact, solid).run();
    }
  }
}

}  // namespace rtac::analysis
