// P2b, at the end of the way: what a monitor says beside how clear its robot is of one zone. A way
// to a clearance gives control back where that is all; other robots may be near, and of an `or` no
// side alone may hold there.
#include <algorithm>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/straight_in.h"
#include "compiler/analysis/windows.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/centres.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

// Of a robot at rest with the clearance of return: whether a part of its property gives it back.
// `told`: that depends on inputs alone, whatever the robot does. `slow`: it holds, and would not as
// soon as the robot speeds up; `until_told`: that is so as long as inputs say so.
enum class AtRest { given_back, kept, told, slow, until_told };

class Rest {
 public:
  Rest(const Subject& s, std::size_t k)
      : s_(s),
        monitor_(s.decision.monitors[k]),
        last_(ir::last_step(monitor_.recovery)),
        return_mm_(analysis::return_clearance_mm(s.decision, monitor_.lookahead.duration_us)),
        from_rest_mmps_(analysis::fastest_from_hold(s.decision, monitor_.lookahead.duration_us)) {}

  AtRest judge() { return judge(monitor_.property, monitor_.property.result, false); }
  [[nodiscard]] bool by_others() const { return others_; }
  [[nodiscard]] bool uncharged() const { return uncharged_; }
  // Where it is stuck between the sides of an `or`.
  [[nodiscard]] const std::optional<geometry::Point>& stuck() const { return stuck_; }
  // A zone with heights that it does not lead to.
  [[nodiscard]] const std::optional<ir::ZoneIndex>& high() const { return high_; }

 private:
  AtRest judge(const ir::Block& block, ir::ValueId id, bool of_choice) {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) {
      const AtRest a = judge(block, v->a, of_choice), b = judge(block, v->b, of_choice);
      for (const AtRest worst : {AtRest::kept, AtRest::slow, AtRest::until_told}) {
        if (a == worst || b == worst) return worst;
      }
      return a == AtRest::told && b == AtRest::told ? AtRest::told : AtRest::given_back;
    }
    // of zones that come and go: the recovery leads to where they do not matter (5030)
    if (analysis::speaks_of_windows(block, id)) return AtRest::given_back;
    if (const auto* v = std::get_if<ir::Or>(&op)) return choice(block, id, *v);
    if (const auto* compare = std::get_if<ir::AtLeast>(&op)) {
      return comparison(block, *compare, of_choice);
    }
    if (const auto* each = std::get_if<ir::ForOthers>(&op)) {
      // of all others, where there is none; that there is one never holds then
      if (s_.decision.robots < 2) return each->universal ? AtRest::given_back : AtRest::kept;
      others_ = true;
      return AtRest::kept;
    }
    if (const auto* v = std::get_if<ir::Not>(&op)) {
      return judge(block, v->a, true) == AtRest::told ? AtRest::told : AtRest::kept;
    }
    return AtRest::told;
  }
  AtRest choice(const ir::Block& block, ir::ValueId id, const ir::Or& v) {
    const bool others = others_;
    const AtRest a = judge(block, v.a, true), b = judge(block, v.b, true);
    const bool told = a == AtRest::told || b == AtRest::told;
    if (a == AtRest::told && b == AtRest::told) return AtRest::told;
    const bool inputs = speaks_of_inputs(block, v.a) || speaks_of_inputs(block, v.b);
    const auto is_slow = [&](ir::ValueId side) {
      return analysis::asks_for_slow(s_.module, s_.decision, block, side, from_rest_mmps_);
    };
    if (inputs && (is_slow(v.a) || is_slow(v.b))) {
      others_ = others;
      return AtRest::given_back;
    }
    const auto waits = [](AtRest one) { return one == AtRest::slow || one == AtRest::until_told; };
    if (inputs && (waits(a) || waits(b)) && a != AtRest::kept && b != AtRest::kept) {
      others_ = others;
      return a == AtRest::slow && b == AtRest::slow ? AtRest::slow : AtRest::until_told;
    }
    // an input may keep its own side from holding for ever: both have to do
    const bool back = inputs ? a != AtRest::kept && b != AtRest::kept
                             : a == AtRest::given_back || b == AtRest::given_back;
    if (back || (!told && somewhere(block, id))) {
      others_ = others;
      return AtRest::given_back;
    }
    return AtRest::kept;
  }
  AtRest comparison(const ir::Block& block, const ir::AtLeast& compare, bool of_choice) {
    AtRest all = AtRest::told;
    for (const auto& [leaf, coefficient] : ir::linear_form(block, compare).terms) {
      all = AtRest::given_back;
      if (leaf.kind == ir::Leaf::Kind::altitude &&
          !rests_at_height(s_, last_, return_mm_ - s_.decision.body.radius_mm, block, compare)) {
        return AtRest::kept;
      }
      if (leaf.kind == ir::Leaf::Kind::received) return AtRest::kept;
      if (is_charge(leaf) && !gets_charged(block, compare)) return AtRest::kept;
      if (leaf.kind == ir::Leaf::Kind::count && s_.decision.robots > 1) {
        others_ = true;
        return AtRest::kept;
      }
      if (leaf.kind == ir::Leaf::Kind::clearance && beyond_its_height(ir::ZoneIndex{leaf.table})) {
        return AtRest::kept;
      }
      if (!of_choice) continue;  // errors of the analysis are about the rest of it
      if (leaf.kind == ir::Leaf::Kind::clearance &&
          !lies_in(s_, last_.zone, ir::ZoneIndex{leaf.table})) {
        return AtRest::kept;
      }
    }
    const auto most = ir::upper_bound(block, compare);
    if (most && most->leaf.kind == ir::Leaf::Kind::speed && from_rest_mmps_ > most->most) {
      return AtRest::slow;
    }
    return all;
  }
  static bool is_charge(const ir::Leaf& leaf) {
    return leaf.kind == ir::Leaf::Kind::battery || leaf.kind == ir::Leaf::Kind::energy_to;
  }
  // Enough of it comes back where the robot is charged, and nowhere else.
  bool gets_charged(const ir::Block& block, const ir::AtLeast& compare) {
    const auto& params = s_.decision.facts.params;
    const bool enough =
        ir::lower_bound(block, compare, params) || ir::charge_for_way(block, compare, params);
    if (enough && last_.charges) return true;
    uncharged_ = true;
    return false;
  }
  // Near its floor or ceiling control is not given back, and who keeps its height leads to no
  // other.
  bool beyond_its_height(ir::ZoneIndex zone) {
    if (!s_.module[zone].has_height() || s_.module[last_.zone].has_height()) return false;
    high_ = zone;
    return true;
  }
  // Every place that is as clear is deep enough in one of the zones of an `or`.
  bool somewhere(const ir::Block& block, ir::ValueId id) {
    const auto zones = analysis::sides_in_zones(s_.module, s_.decision, block, id);
    if (zones.empty() || s_.module[last_.zone].has_height()) return false;
    const std::int64_t mm = std::max(last_.return_clearance_mm, return_mm_);
    const geometry::Region& own = s_.exact(last_.zone);
    constexpr std::int64_t round_mm = analysis::offsets_round_mm;
    const auto left = analysis::between(own, zones, s_.exact, mm - round_mm, mm + round_mm);
    if (left && left->empty()) return true;
    // and a place where a robot stands in one of them, and is not given back, wherever the errors
    // of its position have it seen
    const ir::Body& body = s_.decision.body;
    const std::int64_t off_mm = 2 * body.position_error_mm + 10 + round_mm;
    const std::int64_t ends_mm =
        ir::goes_back(last_.kind) ? std::max(mm, analysis::aims_at_mm(s_.decision, last_)) : mm;
    const auto sure = analysis::between(own, zones, s_.exact, ends_mm + off_mm, mm - off_mm);
    for (const ir::ZoneIndex zone : zones) {
      if (!sure || stuck_) break;
      const auto fits = analysis::within(s_.exact(zone), body.radius_mm + off_mm);
      if (fits) stuck_ = some_place(sure->intersect(*fits));
    }
    return false;
  }
  // Of the largest part the middle of the box around it, or else a corner.
  static std::optional<geometry::Point> some_place(const geometry::Region& region) {
    std::optional<geometry::Point> found;
    Rational most = -1;
    for (const geometry::PolygonWithHoles& part : region.polygons()) {
      geometry::Point low = part.outer.front(), high = low;
      for (const geometry::Point& p : part.outer) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
      const Rational size = (high.x - low.x) * (high.y - low.y);
      if (size <= most) continue;
      most = size;
      const geometry::Point middle{Rational((low.x + high.x) / 2), Rational((low.y + high.y) / 2)};
      found = region.contains(middle) ? middle : part.outer.front();
    }
    return found;
  }
  static bool speaks_of_inputs(const ir::Block& block, ir::ValueId id) {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) {
      return speaks_of_inputs(block, v->a) || speaks_of_inputs(block, v->b);
    }
    if (const auto* v = std::get_if<ir::Or>(&op)) {
      return speaks_of_inputs(block, v->a) || speaks_of_inputs(block, v->b);
    }
    if (const auto* v = std::get_if<ir::Not>(&op)) return speaks_of_inputs(block, v->a);
    return std::holds_alternative<ir::Fact>(op);
  }

  const Subject& s_;
  const ir::Monitor& monitor_;
  const ir::Recovery& last_;
  const std::int64_t return_mm_;
  const std::int64_t from_rest_mmps_;
  bool others_ = false, uncharged_ = false;
  std::optional<geometry::Point> stuck_;
  std::optional<ir::ZoneIndex> high_;
};

// What is not given back for a limit of speed, and how high that has to be.
Obligation by_its_speed(const Subject& s, const ir::Monitor& m, bool is_slow, Obligation o) {
  const ir::Recovery& last = ir::last_step(m.recovery);
  const std::int64_t mmps = analysis::fastest_from_hold(s.decision, m.lookahead.duration_us);
  const bool may_be_slower = mmps < s.decision.motions.front().speed_mmps;
  const std::string slowest = to_decimal(Rational(static_cast<long>(mmps), 1000)) + " m/s";
  if (is_slow && may_be_slower) {
    o.because += ": at rest it may be taken for one of " + slowest;
    o.repair = "a limit of " + slowest + " lets a robot at rest go";
  }
  if (!s.is_read) return o;  // nobody looks for a run
  if (!atoms_of(m.property).speed || s.decision.body.in_space || !ir::moves(last.kind)) return o;
  // where nothing but a limit of speed lets it go, a run may show that it is never slow enough
  if (analysis::least_limit_mmps(m.property) >= mmps) return o;
  o.place_mm = deep_in(centres_of(s, m, 0).intersect(s.exact(last.zone)).subtract(unlimited(s, m)));
  if (!o.place_mm) return o;
  o.status = Status::refuted;
  o.method = by_geometry;
  o.by_a_run = true;
  o.because = "a robot at rest may be taken for one of " + slowest + ", and " + quoted(m.name) +
              " lets none go that may be faster than its limit";
  // as fast as it may ever be no limit says anything
  o.repair = may_be_slower
                 ? "a limit of " + slowest + " lets a robot at rest go"
                 : "a shorter `ahead`, less latency or fresher samples are needed: at rest it is "
                   "taken for one at its greatest speed";
  return o;
}

}  // namespace

Obligation returned_at_rest(const Subject& s, std::size_t k, Obligation proved) {
  const ir::Monitor& m = s.decision.monitors[k];
  Rest rest(s, k);
  const AtRest found = rest.judge();
  if (found == AtRest::until_told) {
    proved.because += "; it waits at rest while inputs ask it to be slow";
    return proved;
  }
  if (found != AtRest::kept && found != AtRest::slow) return proved;
  Obligation o;
  o.kind = proved.kind;
  o.monitor = proved.monitor;
  o.method = "no proof";
  const ir::Recovery& last = ir::last_step(m.recovery);
  if (rest.by_others()) {
    o.because = quoted(m.recovery.name) + " leads away from boundaries, and from no other robot: " +
                "that robots which have stopped near each other part is not shown";
    o.repair = "`hold when violated \"why\"` accepts that they may wait for each other";
    return o;
  }
  if (rest.uncharged()) {
    o.because = "nobody charges the robot where " + quoted(m.recovery.name) + " leads";
    o.repair = "a recovery `route to` the site where it is charged";
    return o;
  }
  if (rest.stuck() && ir::goes_back(last.kind)) {
    const bool stands = last.kind == ir::RecoveryKind::retreat;
    o.status = Status::refuted;
    o.method = by_geometry;
    o.by_a_run = !stands;  // who circles may come off it
    o.place_mm = {floor_to_int(Rational(rest.stuck()->x * 1000)),
                  floor_to_int(Rational(rest.stuck()->y * 1000))};
    o.because = std::string(stands ? "at rest at (" : "about (") + metres(o.place_mm->first) +
                ", " + metres(o.place_mm->second) + ") a robot is so clear of the boundary of " +
                quoted(s.module[last.zone].name) + " that " + quoted(m.recovery.name) +
                (stands ? " leads no further" : " circles there") +
                ", and in no zone of the `or` the " + metres(last.return_clearance_mm) +
                " from its boundary where control returns";
    o.repair = "zones that overlap more there, or a recovery within one of them";
    return o;
  }
  if (rest.high()) {
    o.because = quoted(m.recovery.name) +
                " keeps its height, and near the floor or the ceiling of " +
                quoted(s.module[*rest.high()].name) + " control is not given back";
    o.repair =
        "a recovery within " + quoted(s.module[*rest.high()].name) + " leads up or down, too";
    return o;
  }
  o.because = "that control is given back where " + quoted(m.recovery.name) + " has led, by what " +
              quoted(m.name) + " says, is not shown";
  return by_its_speed(s, m, found == AtRest::slow, std::move(o));
}

}  // namespace rtac::verify
