#include "compiler/analysis/arbitration.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "compiler/analysis/around.h"
#include "compiler/analysis/boundless.h"
#include "compiler/analysis/by_border.h"
#include "compiler/analysis/company.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/led_in_height.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/paces.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/stays_put.h"
#include "compiler/analysis/straight_in.h"
#include "compiler/analysis/waits.h"
#include "compiler/analysis/windows.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

std::string seconds_text(const Rational& s) {
  return to_decimal(Rational(ceil_to_int(Rational(s * 10)), 10)) + " s";
}
std::string about_metres(const Rational& m) {
  return to_decimal(Rational(ceil_to_int(Rational(m * 100)), 100)) + " m";
}

// More than any zone has.
constexpr std::int64_t unbounded_mm = 1 << 30;

// When recoveries end, each found once: of those that several monitors share, too.
class Endings {
 public:
  Endings(const sema::RobotKind& kind, const ir::Module& module, const ir::Decision& decision)
      : kind_(kind), module_(module), decision_(decision) {}

  const std::optional<Ending>& of(const ir::Recovery& recovery) {
    const ir::Recovery& last = ir::last_step(recovery);
    const Key key{recovery.name, last.return_clearance_mm, last.route_clearance_mm};
    const auto found = found_.find(key);
    if (found != found_.end()) return found->second;
    return found_.emplace(key, ending_of(kind_, module_, decision_, recovery)).first->second;
  }

 private:
  using Key = std::tuple<std::string, std::int64_t, std::int64_t>;
  const sema::RobotKind& kind_;
  const ir::Module& module_;
  const ir::Decision& decision_;
  std::map<Key, std::optional<Ending>> found_;
};

// What a recovery may do to the property of another monitor of its decision. `by_itself`: the other
// monitor's recovery is not there to answer to inputs, to others and to zones that come and go.
class Pair {
 public:
  Pair(const sema::RobotKind& kind, const ir::Module& module, const ir::Decision& decision,
       const ExactZone& exact, const ExactSolid& solid, Endings& endings, std::size_t driving,
       std::size_t judged, bool by_itself)
      : kind_(kind),
        module_(module),
        decision_(decision),
        exact_(exact),
        solid_(solid),
        endings_(endings),
        drives_(driving),
        driving_(decision.monitors[driving]),
        recovery_(driving_.recovery),
        judged_(decision.monitors[judged]),
        by_itself_(by_itself),
        take_over_{module, decision, exact, solid, judged} {}

  // nullopt: it keeps the property.
  std::optional<Entry> broken() {
    const ir::Block& says = judged_.property;
    const bool heard = by_itself_ && speaks_of_inputs(says, says.result);
    if (!keeps(says, says.result) || (heard && !answers_to_inputs())) {
      entry_.answered = by_itself_ && is_answered();
      return entry_;
    }
    if (by_itself_ && others_may_break(decision_, judged_, recovery_)) return before_others();
    if (!by_itself_ && stands(judged_.recovery) && !stands(recovery_) &&
        asks_by_inputs(says, says.result)) {
      entry_.why = quoted(recovery_.name) + " drives on, whatever inputs ask of " +
                   quoted(judged_.recovery.name);
      entry_.help.clear();
      entry_.silences = true;
      return entry_;
    }
    return std::nullopt;
  }

 private:
  bool keeps(const ir::Block& block, ir::ValueId id) {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) return keeps(block, v->a) && keeps(block, v->b);
    // Whichever side holds at the take-over, it goes on to hold, or another one does. That a zone
    // lies in the union of two is not enough: a body on their seam is in neither.
    if (const auto* v = std::get_if<ir::Or>(&op)) {
      // Of zones that come and go, only the monitor's own recovery leads out in time, and whoever
      // outranks it needs an acknowledgement of its own (5031).
      if (speaks_of_windows(block, id)) return !by_itself_ || keeps_windows();
      if (keeps_a_side(module_, decision_, exact_, drives_, block, id)) {
        return has_slow_side(module_, decision_, drives_, block, *v) || starts_in_its_zones();
      }
      if (!by_itself_ && too_fast_while_told(block, id)) return false;
      return keeps(block, v->a) && keeps(block, v->b);
    }
    if (const ir::Block* body = ir::body_of(op)) return keeps(*body, body->result);
    if (const auto* v = std::get_if<ir::AtLeast>(&op)) return keeps_comparison(block, *v);
    // What the robot has no part in, plans, which are judged before they are driven, and what
    // cannot be looked ahead, which is refused (5006).
    return !by_itself_ || std::holds_alternative<ir::Truth>(op) || answers_to_inputs();
  }
  [[nodiscard]] Pace pace(const ir::Block& block, ir::ValueId id) {
    return pace_of(block, id, fastest_while_driving(decision_, drives_),
                   fastest_from_rest(decision_, judged_.lookahead.duration_us),
                   [&](const ir::Block& b, const ir::AtLeast& compare) {
                     return keeps_comparison(b, compare);
                   });
  }
  [[nodiscard]] bool is_answered() {
    const Entry found = entry_;
    const bool answered = pace(judged_.property, judged_.property.result) != Pace::broken;
    entry_ = found;
    return answered;
  }
  // `estop implies d.speed <= c`: the brake of who takes over is the answer to the input.
  bool too_fast_while_told(const ir::Block& block, ir::ValueId id) {
    if (pace(block, id) != Pace::while_told) return false;
    const std::int64_t mmps = fastest_while_driving(decision_, drives_);
    entry_.why = quoted(recovery_.name) + " drives at up to " +
                 to_decimal(Rational(static_cast<long>(mmps), 1000)) + " m/s, and the inputs of " +
                 quoted(judged_.name) + " may allow less";
    entry_.help.clear();
    entry_.while_told = true;
    return true;
  }
  static bool stands(const ir::Recovery& recovery) {
    return std::ranges::all_of(ir::steps_of(recovery), [](const ir::Recovery* step) {
      return step->kind == ir::RecoveryKind::brake;
    });
  }
  // Something that has to hold, whatever the robot does.
  static bool asks_by_inputs(const ir::Block& block, ir::ValueId id) {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) {
      return asks_by_inputs(block, v->a) || asks_by_inputs(block, v->b);
    }
    if (const ir::Block* body = ir::body_of(op)) return asks_by_inputs(*body, body->result);
    return told(block, id);
  }
  // Perhaps of one side of it alone, where the recovery keeps another one.
  static bool speaks_of_inputs(const ir::Block& block, ir::ValueId id) {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::Not>(&op)) return speaks_of_inputs(block, v->a);
    if (const auto* v = std::get_if<ir::And>(&op)) {
      return speaks_of_inputs(block, v->a) || speaks_of_inputs(block, v->b);
    }
    if (const auto* v = std::get_if<ir::Or>(&op)) {
      return speaks_of_inputs(block, v->a) || speaks_of_inputs(block, v->b);
    }
    if (const ir::Block* body = ir::body_of(op)) return speaks_of_inputs(*body, body->result);
    return told(block, id);
  }
  // Of what only the recovery that the author has chosen for it is the answer to. `why`: of the
  // other one.
  bool is_not_the_answer(const std::string& why) {
    entry_.why = quoted(recovery_.name) + why;
    entry_.help =
        quoted(judged_.recovery.name) + " as the recovery of " + quoted(driving_.name) + " works";
    const ir::Monitor* const first = decision_.monitors.data();
    entry_.change = Change{};
    entry_.change->follows = {std::size_t(&driving_ - first), std::size_t(&judged_ - first)};
    return false;
  }
  // No recovery makes an input true again, and none makes it false. But its own one is the answer
  // to it, and whoever coordinates must not take another one for as good.
  bool answers_to_inputs() {
    return is_not_the_answer(" is not the answer to what " + quoted(judged_.name) +
                             " says of inputs");
  }
  // Every recovery stands still before others, who may come nearer all the same.
  Entry before_others() {
    (void)is_not_the_answer(" is not the answer to others that come near");
    entry_.answered = is_answered();
    return entry_;
  }
  // Who coordinates has to know who leads out.
  bool keeps_windows() {
    return is_not_the_answer(" does not lead out of zones that come and go in time");
  }
  bool keeps_comparison(const ir::Block& block, const ir::AtLeast& compare) {
    bool kept = true;
    for (const auto& [leaf, coefficient] : ir::linear_form(block, compare).terms) {
      switch (leaf.kind) {
        case ir::Leaf::Kind::clearance:
          // at most so clear: cannot be looked ahead (5006)
          if (sgn(coefficient) < 0) break;
          kept = kept && keeps_clearance(ir::ZoneIndex{leaf.table}, beyond_mm(block, compare));
          break;
        case ir::Leaf::Kind::received:
          kept = kept && keeps_received(ir::ReceivedIndex{leaf.table});
          break;
        case ir::Leaf::Kind::battery:
          kept = kept && keeps_charge();
          break;
        case ir::Leaf::Kind::altitude:
          kept = kept && keeps_height(block, compare);
          break;
        case ir::Leaf::Kind::count:
          kept = kept && keeps_number(block, compare);
          break;
        // Every mode that moves is gated by the distances, whatever the priority; a way costs what
        // the charge pays for; a limit of speed is compared with every recovery (5033).
        case ir::Leaf::Kind::distance:
        case ir::Leaf::Kind::agent:
        case ir::Leaf::Kind::energy_to:
        case ir::Leaf::Kind::speed:
          break;
      }
    }
    return kept;
  }

  // What is only counted may be as near as it likes, and gates nobody: who moves may drive up to
  // any number of others.
  bool keeps_number(const ir::Block& block, const ir::AtLeast& compare) {
    const auto most = ir::upper_bound(block, compare);
    if (most && most->most + 1 >= std::int64_t{decision_.robots}) return true;
    for (const ir::Recovery* step : ir::steps_of(recovery_)) {
      if (step->kind == ir::RecoveryKind::brake) continue;
      entry_.why = quoted(recovery_.name) + " may drive up to more others than " +
                   quoted(judged_.name) + " allows: it keeps distances, and counts nobody";
      entry_.help.clear();
      return false;
    }
    return true;
  }
  // Where a zone that is received will be nobody knows: who moves may leave it, or enter it.
  bool keeps_received(ir::ReceivedIndex zone) {
    for (const ir::Recovery* step : ir::steps_of(recovery_)) {
      if (step->kind == ir::RecoveryKind::brake) continue;
      const ir::Received& received = decision_.facts[zone];
      entry_.why = "where " + quoted(received.name) + " is received to be is not known, and " +
                   quoted(recovery_.name) + (received.outside ? " may enter it" : " may leave it");
      offer_to_stand();
      return false;
    }
    return true;
  }
  // The zone that a step moves within; none: it stays where the brake ends, which the look-ahead of
  // every monitor has found clear.
  [[nodiscard]] std::optional<ir::ZoneIndex> moves_within(const ir::Recovery& step) const {
    if (stays_put(module_, decision_, exact_, driving_, step, judged_)) return std::nullopt;
    if (ir::moves(step.kind) || step.claims) return step.zone;
    return std::nullopt;
  }
  // What is asked of a clearance beyond touching, whatever parameters become; none: it is compared
  // with more than that.
  [[nodiscard]] std::optional<std::int64_t> beyond_mm(const ir::Block& block,
                                                      const ir::AtLeast& compare) const {
    const auto least = ir::lower_bound(block, compare, decision_.facts.params);
    if (!least) return std::nullopt;
    return std::max<std::int64_t>(least->need.strictest, 0);
  }
  bool keeps_clearance(ir::ZoneIndex fence, std::optional<std::int64_t> beyond_mm) {
    for (const ir::Recovery* step : ir::steps_of(recovery_)) {
      if (step->kind == ir::RecoveryKind::land && !reaches_down(fence, beyond_mm, step->land_mm)) {
        return false;
      }
      const auto zone = moves_within(*step);
      if (!zone || (*zone == fence && !step->claims)) continue;
      const Entry before = entry_;
      if (keeps_in_zone(*step, fence, beyond_mm)) continue;
      if (!keeps_by_border(*step, {fence, beyond_mm.value_or(unbounded_mm)})) return false;
      entry_ = before;
    }
    return true;
  }
  // Anywhere in the zone of the step.
  bool keeps_in_zone(const ir::Recovery& step, ir::ZoneIndex fence,
                     std::optional<std::int64_t> beyond_mm) {
    const bool high = module_[fence].has_height() || module_[step.zone].has_height();
    return (high ? in_space(step, fence, beyond_mm) : in_plane(step, fence, beyond_mm)) &&
           keeps_its_standoff(step, fence, beyond_mm) && comes_in(step, fence);
  }
  [[nodiscard]] bool keeps_by_border(const ir::Recovery& step, const Standoff& fence) const {
    const auto near_mm = by_border_mm(kind_, take_over_, driving_);
    return near_mm && border_lies_deep(take_over_, step.zone, *near_mm, fence);
  }
  bool in_plane(const ir::Recovery& step, ir::ZoneIndex fence,
                std::optional<std::int64_t> beyond_mm) {
    if (exact_(fence).contains(exact_(step.zone))) return true;
    const geometry::Region beyond = exact_(step.zone).subtract(exact_(fence));
    const std::string name = name_as_written(module_[fence]);
    entry_.why = square_metres(beyond.area()) + " of " + name_as_written(module_[step.zone]) +
                 ", where " + quoted(recovery_.name) + " may drive, lie outside " + name;
    offer_within(step.zone, fence);
    offer_shared(step.zone, fence, beyond_mm);
    return false;
  }
  // From outside of its zone; what only claims to stay there is braked instead.
  bool comes_in(const ir::Recovery& step, ir::ZoneIndex fence) {
    if (step.claims || comes_in_within(take_over_, step, fence)) return true;
    const std::string name = name_as_written(module_[fence]);
    entry_.why = "from outside of " + name_as_written(module_[step.zone]) + " " +
                 quoted(recovery_.name) + " makes straight for it, and may leave " + name +
                 " on its way, which is not convex";
    entry_.help = begins_inside(module_[step.zone]);
    offer_within(step.zone, fence);
    return false;
  }
  // Of an `or` a side holds as long as it is in its zone; from outside it might cross a seam.
  bool starts_in_its_zones() {
    for (const ir::Recovery* step : ir::steps_of(recovery_)) {
      if (!ir::moves(step->kind) || !moves_within(*step)) continue;
      if (starts_within(take_over_, step->zone)) continue;
      entry_.why = "from outside of " + name_as_written(module_[step->zone]) + " " +
                   quoted(recovery_.name) + " makes straight for it, and may leave each side of " +
                   quoted(judged_.name) + " on its way";
      entry_.help = begins_inside(module_[step->zone]);
      return false;
    }
    return true;
  }
  // What lies in the fence, and need not keep what is asked beyond that.
  bool keeps_its_standoff(const ir::Recovery& step, ir::ZoneIndex fence,
                          std::optional<std::int64_t> beyond_mm) {
    const std::int64_t asked_mm = beyond_mm.value_or(unbounded_mm);
    const Standoff asked{fence, asked_mm};
    if (keeps_off(module_, decision_, exact_, solid_, driving_, judged_, step, asked) ||
        keeps_around(kind_, module_, decision_, exact_, driving_, judged_, asked)) {
      return true;
    }
    const std::string name = name_as_written(module_[fence]);
    const std::string far = beyond_mm ? metres(asked_mm) : "what is asked";
    entry_.why = "places of " + name_as_written(module_[step.zone]) + ", where " +
                 quoted(recovery_.name) + " may drive, are nearer than " + far +
                 " to the boundary of " + name;
    offer_shared(step.zone, fence, beyond_mm);
    return false;
  }
  void offer_to_stand() {
    entry_.help = "`brake_and_hold` as the recovery of " + quoted(driving_.name) + " works";
    entry_.change = Change{};
    entry_.change->stands = static_cast<std::size_t>(&driving_ - decision_.monitors.data());
  }
  void offer_to_land(std::int64_t mm) {
    entry_.help = "`land to " + metres(mm) + "` works";
    entry_.change = Change{};
    entry_.change->lands = {static_cast<std::size_t>(&driving_ - decision_.monitors.data()), mm};
  }
  void offer_within(ir::ZoneIndex zone, ir::ZoneIndex fence) {
    if (is_boundless(module_, fence)) return;
    const ir::Recovery& last = ir::last_step(recovery_);
    const std::string name = name_as_written(module_[fence]);
    entry_.within.push_back({last.kind == ir::RecoveryKind::route
                                 ? "a way to " + quoted(module_[last.site].name) + " within " + name
                                 : "a recovery within " + name,
                             zone,
                             {{{fence}}}});
  }
  // A zone within both, as far off the fence as is asked.
  void offer_shared(ir::ZoneIndex zone, ir::ZoneIndex fence,
                    std::optional<std::int64_t> beyond_mm) {
    const std::string shared = beyond_mm ? deep_text(module_, zone, {fence, *beyond_mm}) : "";
    if (shared.empty()) return;
    // a zone of the plane is to be as high as the other one, and that is written with it
    const bool as_high = module_[zone].has_height() != module_[fence].has_height();
    entry_.within.push_back({as_high ? "" : "a recovery within a zone that is `" + shared + "`",
                             zone,
                             {{{zone}}, {{fence}, std::max<std::int64_t>(*beyond_mm, 0)}}});
  }
  // What of a zone lies within the heights that are allowed, as a box tells that is around it.
  void offer_between(ir::ZoneIndex zone, std::optional<std::int64_t> least_mm,
                     std::optional<std::int64_t> most_mm) {
    const auto around = layer_around(solid_(zone));
    const auto layer = around ? between(*around, least_mm, most_mm) : std::nullopt;
    if (layer) entry_.within.push_back({"", zone, {{{zone}}, {{}, 0, layer}}});
  }
  // Straight down from anywhere above: what is in a slab is in the one below, down to the lowest of
  // which that is so, and a landing ends above the floor of that. Whatever else is not shown.
  bool reaches_down(ir::ZoneIndex fence, std::optional<std::int64_t> beyond_mm,
                    std::int64_t land_mm) {
    if (!module_[fence].has_height()) return true;
    const ir::Body& body = decision_.body;
    const std::int64_t over_mm =
        beyond_mm.value_or(0) + body.radius_mm + 2 * body.position_error_mm + body.hold_mm;
    const geometry::Solid solid = solid_(fence);
    const auto& slabs = solid.slabs();
    const bool down = beyond_mm && !slabs.empty();
    std::int64_t least_mm = 0;
    if (down) {
      auto lowest = std::prev(slabs.end());
      while (lowest != slabs.begin() && std::prev(lowest)->ceiling == lowest->floor &&
             std::prev(lowest)->region.contains(lowest->region)) {
        --lowest;
      }
      least_mm = ceil_to_int(Rational(lowest->floor * 1000)) + over_mm;
    }
    if (down && land_mm >= least_mm) return true;
    entry_.why = "whether the way down of " + quoted(recovery_.name) + " lies in " +
                 quoted(module_[fence].name) + " is not shown";
    if (down && least_mm < slabs.back().ceiling * 1000) {
      offer_to_land(least_mm);
    } else {
      offer_to_stand();
    }
    return false;
  }
  // What keeps its height (rule 7.8) is in the fence as long as that has the zone at each height.
  bool in_space(const ir::Recovery& step, ir::ZoneIndex fence,
                std::optional<std::int64_t> beyond_mm) {
    const ir::ZoneIndex zone = step.zone;
    if (!step.claims && lies_level(module_, exact_, solid_, zone, {fence, 0})) return true;
    const geometry::Solid beyond = solid_(zone).subtract(solid_(fence));
    if (beyond.empty()) return true;
    const geometry::Slab& slab = beyond.slabs().front();
    const bool flat = !module_[zone].has_height();
    const std::string name = name_as_written(module_[zone]);
    const std::string outside = name_as_written(module_[fence]);
    const std::string part = "a part of " + name + ", where " + quoted(recovery_.name) +
                             " may drive, lies outside " + outside;
    if (flat && step.claims) {
      entry_.why = "what is claimed of " + quoted(recovery_.name) + " bounds no height, and " +
                   outside + " has some";
    } else if (flat) {
      entry_.why = "at a height of " + metres(height_without(fence, zone)) + " " + part;
    } else {
      entry_.why = "from " + metres(slab.floor) + " to " + metres(slab.ceiling) + " " + part;
    }
    offer_within(zone, fence);
    offer_shared(zone, fence, beyond_mm);
    return false;
  }
  // Some height of the fence at which it does not contain the zone of the plane.
  [[nodiscard]] Rational height_without(ir::ZoneIndex fence, ir::ZoneIndex zone) const {
    const geometry::Solid solid = solid_(fence);
    for (const geometry::Slab& slab : solid.slabs()) {
      if (!slab.region.contains(exact_(zone))) return slab.floor;
    }
    return solid.slabs().front().floor;
  }
  // A retreat within a zone of the plane keeps its height (rule 7.8), which nobody claims of what
  // is external. A landing ends as far above its end as it strays from any place of rest.
  bool keeps_height(const ir::Block& block, const ir::AtLeast& compare) {
    const auto most = ir::upper_bound(block, compare);
    const auto least = ir::lower_bound(block, compare, decision_.facts.params);
    for (const ir::Recovery* step : ir::steps_of(recovery_)) {
      bool kept = true;
      std::optional<std::int64_t> high_enough_mm;  // of a landing
      if (step->kind == ir::RecoveryKind::land) {
        const std::int64_t strays_mm = step->route_clearance_mm - decision_.body.radius_mm;
        if (least) high_enough_mm = least->need.strictest + strays_mm;
        kept = !high_enough_mm || step->land_mm >= *high_enough_mm;
      } else if (step->claims && !module_[step->zone].has_height()) {
        kept = false;
      } else if (const auto zone = moves_within(*step); zone && module_[*zone].has_height()) {
        const auto [lowest_mm, highest_mm] = led_between_mm(decision_, *step, module_[*zone]);
        kept =
            (!most || highest_mm <= most->most) && (!least || lowest_mm >= least->need.strictest);
      }
      if (kept) continue;
      entry_.why = quoted(recovery_.name) + " may go beyond the height that " +
                   quoted(judged_.name) + " allows";
      if (high_enough_mm) {
        offer_to_land(*high_enough_mm);
      } else {
        offer_to_stand();
      }
      const auto zone = moves_within(*step);
      if (zone && !step->claims) {
        offer_between(*zone, least ? std::optional(least->need.strictest) : std::nullopt,
                      most ? std::optional(most->most) : std::nullopt);
      }
      return false;
    }
    return true;
  }

  // theory, battery: what other recoveries take is bounded by `held` and `detour`, which are paid
  // for in advance. A recovery of which no end is known keeps neither.
  bool keeps_charge() {
    if (!kind_.energy) return true;
    const ir::Recovery& last = ir::last_step(recovery_);
    const std::optional<Ending>& end = endings_.of(recovery_);
    if (!end) {
      entry_.why =
          "nothing bounds how long " + quoted(recovery_.name) + " lasts, and it takes charge";
      entry_.unending = stays_away() && waits_for_outsiders(driving_.property);
      entry_.stands = stays_away() && stands_for_good();
      Change change;
      std::string waiting;
      for (std::size_t k = 0; k < decision_.monitors.size(); ++k) {
        const ir::Monitor& m = decision_.monitors[k];
        if (m.recovery.name != recovery_.name || m.returns.how == ir::Returns::How::itself) {
          continue;
        }
        change.without_return.push_back(k);
        waiting += (waiting.empty() ? "" : " and ") + quoted(m.name);
      }
      if (waiting.empty()) return false;
      entry_.why += ": `return when` of " + waiting + " may never hold where it leads";
      entry_.help = waiting + " without `return when` works";
      entry_.change = change;
      return false;
    }
    // the bound is that of the way alone
    if (const std::string until = waits_until(driving_.property); !until.empty()) {
      entry_.why = "nothing bounds how long " + quoted(recovery_.name) +
                   " lasts, and it takes charge: " + quoted(driving_.name) + " lets go when " +
                   until;
      entry_.unending = stays_away() && waits_for_outsiders(driving_.property);
      return false;
    }
    if (!begins_in_its_zone(last)) return false;
    return lies_within_what_is_paid();
  }
  // A charge suffices nowhere but in the zone of its ways, or within reach of it.
  [[nodiscard]] bool charge_keeps_in(ir::ZoneIndex zone) const {
    bool in = false;
    ir::for_each_comparison(judged_.property, [&](const ir::Block& block, const ir::AtLeast& c) {
      const auto way = ir::charge_for_way(block, c, decision_.facts.params);
      in = in || (way && module_[way->site].zone == zone);
    });
    return in;
  }
  // The way is reckoned over the cells of its zone, and not from outside of that.
  bool begins_in_its_zone(const ir::Recovery& last) {
    if (!ir::moves(last.kind) || charge_keeps_in(last.zone)) return true;
    if (starts_within(take_over_, last.zone)) return true;
    entry_.why = "from outside of " + name_as_written(module_[last.zone]) + " " +
                 quoted(recovery_.name) +
                 " makes straight for it, and nothing bounds how much charge that takes";
    entry_.help = begins_inside(module_[last.zone]);
    return false;
  }
  // It takes charge wherever it ends, which need not be where that is taken up.
  [[nodiscard]] bool stays_away() const {
    return kind_.energy->idle.value > 0 && ir::last_step(recovery_).kind != ir::RecoveryKind::route;
  }
  // It only brakes, and need not be given back where it stands.
  [[nodiscard]] bool stands_for_good() const {
    return ir::last_step(recovery_).kind == ir::RecoveryKind::brake &&
           !holds_in_hold(decision_, driving_);
  }
  // What a charge pays for: as far as a recovery leads the robot away its way home may become
  // longer, unless it ends where it is charged.
  struct Spent {
    Rational seconds = 0, metres = 0;
  };
  [[nodiscard]] Spent spent_by(const ir::Recovery& recovery, const Ending& end) const {
    const Rational back = ir::last_step(recovery).charges ? Rational(0) : end.metres;
    const std::int64_t home_mmps = judged_.recovery.speed_mmps;
    const Rational speed(static_cast<long>(home_mmps), 1000);
    return {home_mmps > 0 ? Rational(end.seconds + back / speed) : end.seconds,
            Rational(end.metres + back)};
  }
  // Of all recoveries that may drive before the one that leads to the dock, by name: each once.
  [[nodiscard]] std::map<std::string, Spent> spent() {
    std::map<std::string, Spent> all;
    const auto judged = static_cast<std::size_t>(&judged_ - decision_.monitors.data());
    for (std::size_t k = 0; k < decision_.monitors.size(); ++k) {
      const ir::Recovery& other = decision_.monitors[k].recovery;
      // who ranks lower lets the charge take over
      const bool before = k == drives_ || decision_.coordinated || (k < judged && drives_ < judged);
      const bool accepted = k != drives_ && ir::acknowledged(decision_, other.name, judged_.name);
      if (!before || accepted || other.name == judged_.recovery.name) continue;
      const std::optional<Ending>& end = endings_.of(other);
      if (!end) continue;  // which is a matter of that pair
      const Spent most = spent_by(other, *end);
      Spent& of = all[other.name];
      of = {std::max(of.seconds, most.seconds), std::max(of.metres, most.metres)};
    }
    return all;
  }
  bool lies_within_what_is_paid() {
    Spent in_all;
    std::string names = quoted(recovery_.name);
    for (const auto& [name, of] : spent()) {
      in_all.seconds += of.seconds;
      in_all.metres += of.metres;
      if (name != recovery_.name) names += " and " + quoted(name);
    }
    const bool longer = in_all.seconds > kind_.energy->held.value;
    const bool farther = in_all.metres > kind_.energy->detour.value;
    if (!longer && !farther) return true;
    const auto reckons = [](const std::string& most) {
      return ", the way back included, and the charge reckons with `" + most + "`";
    };
    Change change;
    if (longer) {
      entry_.why = names + " may last " + seconds_text(in_all.seconds) +
                   reckons("held <= " + seconds_text(kind_.energy->held.value));
      change.held = Rational(ceil_to_int(Rational(in_all.seconds * 10)), 10);
      change.held->canonicalize();
      entry_.help = "`held <= " + seconds_text(in_all.seconds) + "`";
    } else {
      entry_.why = names + " may drive " + about_metres(in_all.metres) +
                   reckons("detour <= " + about_metres(kind_.energy->detour.value));
    }
    if (farther) {
      change.detour = Rational(ceil_to_int(Rational(in_all.metres * 100)), 100);
      change.detour->canonicalize();
      entry_.help +=
          std::string(longer ? " with " : "") + "`detour <= " + about_metres(in_all.metres) + "`";
    }
    entry_.help += " works";
    entry_.change = change;
    return false;
  }

  const sema::RobotKind& kind_;
  const ir::Module& module_;
  const ir::Decision& decision_;
  const ExactZone& exact_;
  const ExactSolid& solid_;
  Endings& endings_;
  const std::size_t drives_;
  const ir::Monitor& driving_;
  const ir::Recovery& recovery_;
  const ir::Monitor& judged_;
  const bool by_itself_;
  const TakeOver take_over_;
  Entry entry_;
};

// Whether a circle is led to from `at`, by pairs that are not kept, among the first `count`. The
// way there is left in `way`; `dead` ones lead to none.
bool finds_circle(const std::vector<std::vector<bool>>& unkept, std::size_t at, std::size_t count,
                  std::vector<std::size_t>& way, std::vector<bool>& dead) {
  if (dead[at]) return false;
  const bool closes = std::find(way.begin(), way.end(), at) != way.end();
  way.push_back(at);
  if (closes) return true;
  for (std::size_t next = 0; next < count; ++next) {
    if (next != at && unkept[at][next] && finds_circle(unkept, next, count, way, dead)) return true;
  }
  way.pop_back();
  dead[at] = true;
  return false;
}

}  // namespace

std::vector<std::size_t> conflict_of(const std::vector<std::vector<bool>>& unkept, std::size_t j) {
  std::vector<std::size_t> way;
  std::vector<bool> dead(j + 1, false);
  finds_circle(unkept, j, j + 1, way, dead);
  return way;
}

Arbitration arbitration_of(const sema::RobotKind& kind, const ir::Module& module,
                           const ir::Decision& decision, const ExactZone& exact,
                           const ExactSolid& solid) {
  const std::size_t count = decision.monitors.size();
  Arbitration all(count, std::vector<Entry>(count));
  std::vector<std::vector<bool>> unkept(count, std::vector<bool>(count, false));
  Endings endings(kind, module, decision);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      // its own property: check_recoveries
      if (decision.monitors[i].recovery.name == decision.monitors[j].recovery.name) continue;
      auto broken =
          Pair(kind, module, decision, exact, solid, endings, i, j, decision.coordinated).broken();
      if (!broken) continue;
      if (broken->silences && j < i) {
        all[i][j].silences = true;
        continue;
      }
      unkept[i][j] = true;
      broken->keeping = j < i ? Keeping::guarded : Keeping::broken;
      all[i][j] = std::move(*broken);
    }
  }
  if (!decision.coordinated) return all;
  for (std::size_t j = 0; j < count; ++j) {
    const std::vector<std::size_t> conflict = conflict_of(unkept, j);
    for (std::size_t i = 0; i < count; ++i) {
      if (!unkept[i][j]) continue;
      all[i][j].keeping = conflict.empty() ? Keeping::coordinated : Keeping::broken;
      all[i][j].conflict = conflict;
    }
  }
  return all;
}

namespace {

using Keeps = std::vector<std::vector<ir::Kept>>;

// `shows(i, j)`: that the recovery of monitor i keeps monitor j.
template <class Shows>
Keeps keeps_of(const ir::Decision& decision, const Shows& shows) {
  const std::size_t count = decision.monitors.size();
  Keeps keeps(count, std::vector<ir::Kept>(count, ir::Kept::unproved));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      if (decision.monitors[i].recovery.name == decision.monitors[j].recovery.name) {
        keeps[i][j] = ir::Kept::own;
      } else if (shows(i, j)) {
        keeps[i][j] = ir::Kept::proved;
      }
    }
  }
  return keeps;
}

// Zones, heights and speed: others and inputs have no part in them, and no charge is spent on them
// that is reckoned with once.
bool is_of_the_robot_alone(const ir::Monitor& monitor) {
  bool alone = true;
  ir::for_each_comparison(monitor.property, [&](const ir::Block& block, const ir::AtLeast& c) {
    for (const auto& [leaf, coefficient] : ir::linear_form(block, c).terms) {
      alone =
          alone && (leaf.kind == ir::Leaf::Kind::clearance ||
                    leaf.kind == ir::Leaf::Kind::altitude || leaf.kind == ir::Leaf::Kind::speed);
    }
  });
  return alone;
}

// With `priority` the matter of those alone that would else take over.
Keeps drives_on(const Decided& of, const ExactZone& exact, const ExactSolid& solid) {
  const sema::RobotKind& kind = of.spec[of.written.kind];
  Endings endings(kind, of.module, of.decision);
  return keeps_of(of.decision, [&](std::size_t i, std::size_t j) {
    return j < i && is_of_the_robot_alone(of.decision.monitors[j]) &&
           keeps_speed_limits(of, i, j) &&
           !Pair(kind, of.module, of.decision, exact, solid, endings, i, j, true).broken();
  });
}

bool shows_any(const ir::Decision& decision) {
  return std::ranges::any_of(decision.keeps, [](const std::vector<ir::Kept>& row) {
    return std::ranges::find(row, ir::Kept::proved) != row.end();
  });
}

}  // namespace

void fill_keeps(const sema::Spec& spec, ir::Module& module, const ExactZone& exact,
                const ExactSolid& solid, const HowItLies& lies) {
  bool one_drives_on = false;
  for (std::size_t n = 0; n < module.decisions.size(); ++n) {
    ir::Decision& decision = module.decisions[n];
    const sema::Decision& written = spec.decisions[n];
    const Decided of{spec, written, module, decision, lies};
    if (decision.coordinated) {
      const Arbitration all = arbitration_of(spec[written.kind], module, decision, exact, solid);
      decision.keeps = keeps_of(decision, [&](std::size_t i, std::size_t j) {
        return all[i][j].keeping == Keeping::kept && keeps_speed_limits(of, i, j);
      });
    } else if (!decision.on_plan) {
      decision.keeps = drives_on(of, exact, solid);
      one_drives_on = one_drives_on || shows_any(decision);
    }
  }
  if (one_drives_on) return;
  for (ir::Decision& decision : module.decisions) {
    if (!decision.coordinated) decision.keeps.clear();
  }
}

std::string conflict_text(const ir::Decision& decision, const Entry& entry) {
  std::string text;
  for (std::size_t k = 0; k + 1 < entry.conflict.size(); ++k) {
    text += (k == 0 ? "" : ", ") + quoted(decision.monitors[entry.conflict[k]].recovery.name) +
            " is not shown to keep " + quoted(decision.monitors[entry.conflict[k + 1]].name);
  }
  return text;
}

}  // namespace rtac::analysis
