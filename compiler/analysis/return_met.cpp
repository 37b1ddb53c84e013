#include "compiler/analysis/return_met.h"

#include <algorithm>

#include "compiler/analysis/limits.h"
#include "compiler/ir/linear.h"
#include "compiler/sema/templates.h"

namespace rtac::analysis {
namespace {

using How = ir::Returns::How;

class Met {
 public:
  Met(const sema::Spec& spec, const sema::Monitor& written, const ir::Module& module,
      const ir::Decision& decision, std::size_t k, const ExactZone& exact, const ExactSolid& solid)
      : module_(module),
        decision_(decision),
        monitor_(decision.monitors[k]),
        motion_(decision.motions[k + 1]),
        last_(ir::last_step(monitor_.recovery)),
        leads_(ir::moves(last_.kind) && last_.kind != ir::RecoveryKind::yield),
        charges_(charges(spec, written)),
        exact_(exact),
        solid_(solid) {}

  ir::Returns run() {
    const ir::Block& when = *monitor_.return_when;
    found_.how = of(when, when.result);
    return found_;
  }

 private:
  static bool charges(const sema::Spec& spec, const sema::Monitor& written) {
    const auto way = sema::route_of(spec[*written.recover]);
    const auto& energy = spec[written.kind].energy;
    return way && energy && energy->charge_at == way->site;
  }

  How of(const ir::Block& block, ir::ValueId id) {
    const ir::Op& op = block[id].op;
    // what holds for a while adds up, and of a choice the side that is asked for may be either
    if (const auto* v = std::get_if<ir::And>(&op)) {
      return std::max(of(block, v->a), of(block, v->b));
    }
    if (const auto* v = std::get_if<ir::Or>(&op)) return std::min(of(block, v->a), of(block, v->b));
    if (const auto* v = std::get_if<ir::HeldFor>(&op)) {
      found_.after_us += v->ticks * decision_.period_us;
      return of(block, v->a);
    }
    if (const auto* v = std::get_if<ir::Truth>(&op)) return v->value ? How::itself : How::open;
    if (const auto* v = std::get_if<ir::Fact>(&op)) return of_fact(*v);
    if (const auto* v = std::get_if<ir::Once>(&op)) return of(block, v->a);
    if (const auto* v = std::get_if<ir::Historically>(&op)) {
      if (v->window.to < 0) return How::open;
      found_.after_us += v->window.to * decision_.period_us;
      return of(block, v->a);
    }
    if (std::holds_alternative<ir::InputTruth>(op) || std::holds_alternative<ir::InputIs>(op)) {
      return How::told;
    }
    if (const auto* v = std::get_if<ir::Not>(&op)) {
      return of(block, v->a) == How::told ? How::told : How::open;
    }
    if (ir::body_of(op) != nullptr) return decision_.robots < 2 ? How::itself : How::open;
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    if (compare == nullptr || !plain(block, compare->a) || !plain(block, compare->b)) {
      return How::open;
    }
    return comes_about(block, *compare) ? How::itself : How::open;
  }
  How of_fact(const ir::Fact& fact) {
    if (!fact.of_robot) return How::told;
    const ir::Block& judged = decision_.facts.monitors[fact.index].property;
    return of(judged, judged.result);
  }
  // What the look-ahead compares, and no other arithmetic.
  static bool plain(const ir::Block& block, ir::ValueId id) {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::Add>(&op)) return plain(block, v->a) && plain(block, v->b);
    if (const auto* v = std::get_if<ir::Negate>(&op)) return plain(block, v->a);
    if (const auto* v = std::get_if<ir::Scale>(&op)) return plain(block, v->a);
    return std::holds_alternative<ir::Const>(op) || std::holds_alternative<ir::ParamValue>(op) ||
           std::holds_alternative<ir::Battery>(op) || std::holds_alternative<ir::Clearance>(op) ||
           std::holds_alternative<ir::Distance>(op) || std::holds_alternative<ir::Speed>(op) ||
           std::holds_alternative<ir::Altitude>(op) || std::holds_alternative<ir::EnergyTo>(op) ||
           std::holds_alternative<ir::AgentDistance>(op) ||
           std::holds_alternative<ir::CountOthers>(op);
  }

  bool comes_about(const ir::Block& block, const ir::AtLeast& compare) {
    const auto& params = decision_.facts.params;
    if (const auto way = ir::charge_for_way(block, compare, params)) {
      return charges_ && way->site == last_.site;
    }
    const auto least = ir::lower_bound(block, compare, params);
    const auto most = ir::upper_bound(block, compare);
    if (least && least->leaf.kind == ir::Leaf::Kind::battery) return charges_;
    if (least && least->leaf.kind == ir::Leaf::Kind::clearance) {
      return leads_ && clear(ir::ZoneIndex{least->leaf.table}, least->need.strictest);
    }
    if (most && most->leaf.kind == ir::Leaf::Kind::speed) {
      return most->most >= decision_.body.velocity_error_mmps;
    }
    return height(least, most);
  }
  // As clear of its own zone as it is where it has led, a robot is seen to be so clear of this one.
  bool clear(ir::ZoneIndex zone, std::int64_t least_mm) {
    const std::int64_t need_mm = shown_clearance_mm(decision_, motion_, least_mm);
    const std::int64_t more_mm = need_mm - last_.return_clearance_mm;
    if (zone == last_.zone) return more_mm <= 0;
    if (module_[zone].has_height() || module_[last_.zone].has_height()) {
      return more_mm <= 0 && solid_(last_.zone).subtract(solid_(zone)).empty();
    }
    const geometry::Region& own = exact_(last_.zone);
    const auto deep = within(exact_(zone), std::max<std::int64_t>(0, more_mm));
    if (deep && deep->contains(own)) return true;
    if (last_.kind == ir::RecoveryKind::route) return sites_clear(zone, need_mm);
    stuck_outside(own.subtract(exact_(zone)));
    return false;
  }
  [[nodiscard]] bool sites_clear(ir::ZoneIndex zone, std::int64_t need_mm) const {
    constexpr std::int64_t parked_mm = 100;  // a robot counts as parked within this of its site
    const auto deep = within(exact_(zone), need_mm + parked_mm);
    const auto& places = module_[last_.site].places;
    return deep && std::all_of(places.begin(), places.end(), [&](const ir::SiteTable::Place& p) {
             return deep->contains({Rational(p.x_mm, 1000), Rational(p.y_mm, 1000)});
           });
  }
  // A place outside that the recovery leads nowhere from, as it is clear enough already.
  void stuck_outside(const geometry::Region& outside) {
    if (found_.stuck_mm) return;
    const auto rests = within(exact_(last_.zone), last_.return_clearance_mm + 5);
    if (!rests) return;
    const geometry::Region left = rests->intersect(outside);
    if (left.empty()) return;
    const auto parts = left.polygons();
    geometry::Point low = parts.front().outer.front(), high = low;
    for (const geometry::Point& p : parts.front().outer) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const geometry::Point middle{Rational((low.x + high.x) / 2), Rational((low.y + high.y) / 2)};
    const geometry::Point at = left.contains(middle) ? middle : low;
    if (!left.contains(at)) return;
    found_.stuck_mm = {floor_to_int(Rational(at.x * 1000)), floor_to_int(Rational(at.y * 1000))};
  }
  [[nodiscard]] bool height(const std::optional<ir::LowerBound>& least,
                            const std::optional<ir::UpperBound>& most) const {
    const bool low = least && least->leaf.kind == ir::Leaf::Kind::altitude;
    const bool high = most && most->leaf.kind == ir::Leaf::Kind::altitude;
    const auto& slabs = module_[last_.zone].slabs;
    if ((!low && !high) || !leads_ || slabs.empty()) return false;
    const std::int64_t errs_mm =
        shown_clearance_mm(decision_, motion_, 0) - decision_.body.radius_mm;
    const std::int64_t rest_mm = last_.return_clearance_mm - errs_mm;
    return (!low || slabs.front().floor_mm + rest_mm >= least->need.strictest) &&
           (!high || slabs.back().ceiling_mm - rest_mm <= most->most);
  }

  const ir::Module& module_;
  const ir::Decision& decision_;
  const ir::Monitor& monitor_;
  const ir::Motion& motion_;
  const ir::Recovery& last_;
  const bool leads_, charges_;
  const ExactZone& exact_;
  const ExactSolid& solid_;
  ir::Returns found_;
};

}  // namespace

void judge_return_conditions(const sema::Spec& spec, ir::Module& module, const ExactZone& exact,
                             const ExactSolid& solid) {
  for (std::size_t n = 0; n < module.decisions.size(); ++n) {
    ir::Decision& decision = module.decisions[n];
    const sema::Decision& from = spec.decisions[n];
    if (decision.on_plan) continue;
    for (std::size_t k = 0; k < decision.monitors.size(); ++k) {
      if (!decision.monitors[k].return_when) continue;
      decision.monitors[k].returns =
          Met(spec, spec[from.priority[k]], module, decision, k, exact, solid).run();
    }
  }
}

}  // namespace rtac::analysis
