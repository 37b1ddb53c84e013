#include "compiler/driver/rewriting.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/analysis/common_zone.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/widening.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"
#include "compiler/support/words.h"

namespace rtac::driver {
namespace {

using verify::EarlierReturn;
using verify::LaterReturn;
using verify::LessApart;
using verify::LongerWait;
using verify::OtherLanding;
using verify::OtherZone;
using verify::RoomToPass;
using verify::SameRecovery;
using verify::SlowerRecovery;
using verify::WiderZone;
using Undo = std::function<void()>;  // none: nothing was changed

template <class T>
Undo exchanged(T& written, T by) {
  const auto other = std::make_shared<T>(std::move(by));
  std::swap(written, *other);
  return [&written, other] { std::swap(written, *other); };
}
template <class Named>
Named* named(std::vector<Named>& all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &Named::name);
  return found == all.end() ? nullptr : &*found;
}
const std::string& robot_of(const sema::Spec& spec, const std::string& monitor) {
  return std::ranges::find(spec.monitors, monitor, &sema::Monitor::name)->robot;
}
std::string in_monitor(const std::string& monitor) {
  return " in `" + monitor + "`";
}

// ---- when control is given back ----------------------------------------------------------------

sema::ExprPtr clearance_of(const sema::Spec& spec, const std::string& zone, std::int64_t mm,
                           const SourceRange& at) {
  const auto declared = std::ranges::find(spec.zones, zone, &sema::Zone::name);
  const auto id = static_cast<sema::ZoneId>(declared - spec.zones.begin());
  sema::Expr gap{at, false, {.m = 1}, sema::Clearance{id}};
  sema::Expr least{at, false, {.m = 1}, sema::Constant{analysis::metres_of(mm)}};
  sema::Compare compare{sema::CompareOp::greater_equal,
                        std::make_unique<sema::Expr>(std::move(gap)),
                        std::make_unique<sema::Expr>(std::move(least))};
  return std::make_unique<sema::Expr>(sema::Expr{at, true, {}, std::move(compare)});
}
sema::ExprPtr condition_of(const sema::Spec& spec, const LaterReturn& later,
                           const SourceRange& at) {
  sema::Logic all{sema::LogicOp::logical_and, {}};
  for (const auto& [zone, mm] : later.clearances_mm) {
    all.operands.push_back(clearance_of(spec, zone, mm, at));
  }
  if (all.operands.size() == 1) return std::move(all.operands.front());
  return std::make_unique<sema::Expr>(sema::Expr{at, true, {}, std::move(all)});
}
Undo rewritten(sema::Spec& spec, const LaterReturn& later) {
  sema::Monitor* const monitor = named(spec.monitors, later.monitor);
  if (monitor == nullptr || monitor->return_when) return {};
  return exchanged(monitor->return_when, condition_of(spec, later, monitor->always_range));
}
// "`return when clearance(r, hall) >= 0.89 m;` in `quiet`"
std::string text(const sema::Spec& spec, const LaterReturn& later) {
  std::string all;
  for (const auto& [zone, mm] : later.clearances_mm) {
    all += (all.empty() ? "" : " and ") + std::string("clearance(") +
           robot_of(spec, later.monitor) + ", " + zone + ") >= " + metres(mm);
  }
  return "`return when " + all + ";`" + in_monitor(later.monitor);
}

// The number that the `return when` of a monitor compares the clearance from a zone with, as one of
// all that have to hold; null: there is none.
template <class Monitor>
auto* clearance_asked(const sema::Spec& spec, Monitor& monitor, const std::string& zone) {
  const auto in = [&](sema::Expr& e, const auto& self) -> sema::Constant* {
    if (auto* const all = std::get_if<sema::Logic>(&e.node)) {
      if (all->op != sema::LogicOp::logical_and) return nullptr;
      for (const sema::ExprPtr& each : all->operands) {
        if (sema::Constant* const found = self(*each, self)) return found;
      }
      return nullptr;
    }
    auto* const compare = std::get_if<sema::Compare>(&e.node);
    if (compare == nullptr) return nullptr;
    const auto* const gap = std::get_if<sema::Clearance>(&compare->left->node);
    const bool of_it = gap != nullptr && spec[gap->zone].name == zone;
    const bool least = compare->op == sema::CompareOp::greater_equal;
    return of_it && least ? std::get_if<sema::Constant>(&compare->right->node) : nullptr;
  };
  sema::Constant* const none = nullptr;
  return monitor.return_when ? in(*monitor.return_when, in) : none;
}
Rational less(const sema::Constant& asked, const EarlierReturn& earlier) {
  return asked.value - analysis::metres_of(earlier.less_mm);
}
Undo rewritten(sema::Spec& spec, const EarlierReturn& earlier) {
  sema::Monitor* const monitor = named(spec.monitors, earlier.monitor);
  sema::Constant* const asked =
      monitor != nullptr ? clearance_asked(spec, *monitor, earlier.zone) : nullptr;
  if (asked == nullptr || less(*asked, earlier) < 0) return {};
  return exchanged(asked->value, less(*asked, earlier));
}
// "`clearance(r, hall) >= 1.2 m` in the `return when` of `quiet`"
std::string text(const sema::Spec& spec, const EarlierReturn& earlier) {
  const auto& monitor = *std::ranges::find(spec.monitors, earlier.monitor, &sema::Monitor::name);
  const sema::Constant* const asked = clearance_asked(spec, monitor, earlier.zone);
  if (asked == nullptr) return "";
  return "`clearance(" + monitor.robot + ", " + earlier.zone +
         ") >= " + metres(less(*asked, earlier)) + "` in the `return when` of `" + monitor.name +
         "`";
}

// ---- how far apart robots stay ------------------------------------------------------------------

// "distance(r, q) >= 3 m", of each that asks for more.
Undo rewritten(sema::Spec& spec, const LessApart& less) {
  sema::Monitor* const monitor = named(spec.monitors, less.monitor);
  if (monitor == nullptr) return {};
  const Rational most = analysis::metres_of(less.most_mm);
  std::vector<std::pair<sema::Constant*, Rational>> written;
  const auto lower = [&](sema::Expr& e, const auto& self) -> void {
    sema::for_each_operand(e, [&](const sema::ExprPtr& operand) { self(*operand, self); });
    auto* const compare = std::get_if<sema::Compare>(&e.node);
    if (compare == nullptr || compare->op != sema::CompareOp::greater_equal) return;
    if (!std::holds_alternative<sema::Distance>(compare->left->node)) return;
    auto* const asked = std::get_if<sema::Constant>(&compare->right->node);
    if (asked == nullptr || asked->value <= most) return;
    written.emplace_back(asked, std::exchange(asked->value, most));
  };
  lower(*monitor->always, lower);
  if (written.empty()) return {};
  return [written] {
    for (const auto& [asked, value] : written) asked->value = value;
  };
}
// "a distance of at most 1.2 m in `apart`"
std::string text(const sema::Spec&, const LessApart& less) {
  return "a distance of at most " + metres(less.most_mm) + in_monitor(less.monitor);
}

// ---- recoveries --------------------------------------------------------------------------------

Undo rewritten(sema::Spec& spec, const SameRecovery& same) {
  sema::Monitor* const monitor = named(spec.monitors, same.monitor);
  sema::Controller* const recovery = named(spec.controllers, same.recovery);
  if (monitor == nullptr || recovery == nullptr) return {};
  const auto id = static_cast<sema::ControllerId>(recovery - spec.controllers.data());
  return exchanged(monitor->recover, std::optional(id));
}
// "`recover back;` in `quiet`"
std::string text(const sema::Spec&, const SameRecovery& same) {
  return "`recover " + same.recovery + ";`" + in_monitor(same.monitor);
}

// Of a recovery that is built in, as nobody can say what another one does.
template <class Change>
Undo changed_whole(sema::Spec& spec, const std::string& recovery, const Change& change) {
  sema::Controller* const controller = named(spec.controllers, recovery);
  if (controller == nullptr ||
      std::holds_alternative<sema::ExternController>(controller->implementation)) {
    return {};
  }
  auto copy = controller->implementation;
  Undo undo = exchanged(controller->implementation, std::move(copy));
  change(*controller);
  return undo;
}
// Each of its steps.
template <class Change>
Undo changed(sema::Spec& spec, const std::string& recovery, const Change& change) {
  return changed_whole(spec, recovery,
                       [&](sema::Controller& whole) { sema::change_each(whole, change); });
}
Undo rewritten(sema::Spec& spec, const SlowerRecovery& slower) {
  return changed(spec, slower.recovery, [&](auto& each) {
    if constexpr (requires { each.speed; }) {
      each.speed.value = std::min(each.speed.value, analysis::metres_of(slower.mmps));
    }
  });
}
// "a speed of `home` of 0.44 m/s"
std::string text(const sema::Spec&, const SlowerRecovery& slower) {
  return "a speed of `" + slower.recovery + "` of " + to_decimal(analysis::metres_of(slower.mmps)) +
         " m/s";
}
Undo rewritten(sema::Spec& spec, const OtherLanding& other) {
  return changed_whole(spec, other.recovery, [&](sema::Controller& whole) {
    sema::land_at(whole, analysis::metres_of(other.height_mm));
  });
}
// "`land to 4.2 m` in `down`"
std::string text(const sema::Spec&, const OtherLanding& other) {
  return "`land to " + metres(other.height_mm) + "` in `" + other.recovery + "`";
}
// The zone that is asked for, if it has a name.
std::optional<sema::ZoneId> named_zone(const sema::Spec& spec, const OtherZone& other) {
  if (other.parts.size() != 1) return std::nullopt;
  const analysis::DeclaredPart& part = other.parts.front();
  const bool whole = part.either.size() == 1 && part.off_mm == 0 && !part.layer;
  if (!whole || spec[part.either.front()].name.empty()) return std::nullopt;
  return part.either.front();
}
// Ways over cells are of the plane, and so is what lies in a frame of its own.
bool can_move_within(const sema::Spec& spec, const OtherZone& other, const sema::Zone& zone) {
  if (zone.has_height && zone.frame != sema::map_frame) return false;
  const auto recovery =
      std::ranges::find(spec.controllers, other.recovery, &sema::Controller::name);
  if (recovery == spec.controllers.end()) return false;
  const auto steps = sema::templates_of(*recovery);
  return !zone.has_height || std::ranges::none_of(steps, [](const sema::Template& what) {
    return std::holds_alternative<sema::Route>(what) || std::holds_alternative<sema::Yield>(what);
  });
}
Undo rewritten(sema::Spec& spec, const OtherZone& other) {
  const auto known = named_zone(spec, other);
  sema::Zone zone = analysis::common_zone(spec, other.from, other.parts);
  if (!known && !zone.value) return {};
  if (!can_move_within(spec, other, known ? spec[*known] : zone)) return {};
  const sema::ZoneId next{static_cast<std::uint32_t>(spec.zones.size())};
  const Undo undo = changed(spec, other.recovery, [&](auto& each) {
    if constexpr (requires { each.zone; }) {
      if (each.zone == other.from) each.zone = known.value_or(next);
    }
  });
  if (!undo || known) return undo;
  spec.zones.push_back(std::move(zone));
  return [&spec, undo] {
    undo();
    spec.zones.pop_back();
  };
}
// "`within dry` in `home`"
std::string text(const sema::Spec& spec, const OtherZone& other) {
  if (const auto known = named_zone(spec, other)) {
    return "`within " + spec[*known].name + "` in `" + other.recovery + "`";
  }
  const std::string zone = analysis::common_text(spec, other.parts);
  if (zone.empty()) return "";
  return "`" + other.recovery + "` within a zone that is `" + zone + "`";
}

// ---- zones and robots --------------------------------------------------------------------------

Undo rewritten(sema::Spec& spec, const WiderZone& wider) {
  sema::Zone* const zone = named(spec.zones, wider.zone);
  if (zone == nullptr || !zone->value) return {};
  const std::ptrdiff_t at = zone - spec.zones.data();  // the list may move meanwhile
  analysis::offset(zone->value, wider.by_mm);
  return
      [&spec, at] { analysis::take_offset_back(spec.zones[static_cast<std::size_t>(at)].value); };
}
// "`grow(yard, 1.2 m)` in place of `yard`"
std::string text(const sema::Spec&, const WiderZone& wider) {
  return "`grow(" + wider.zone + ", " + metres(wider.by_mm) + ")` in place of `" + wider.zone + "`";
}

// A rectangle along the axes that a zone is written as: its corners, and of which coordinate it has
// less. nullopt: it is none.
struct Across {
  Rational sema::Point::*coordinate;
  Rational low, high;
};
std::optional<Across> across(const sema::Zone& zone) {
  const auto* const polygon =
      zone.value ? std::get_if<sema::ZonePolygon>(&zone.value->node) : nullptr;
  if (polygon == nullptr || polygon->outer.points.size() != 4 || !polygon->holes.empty()) return {};
  const std::vector<sema::Point>& points = polygon->outer.points;
  const auto of = [&](Rational sema::Point::*c) {
    const auto [low, high] = std::ranges::minmax(points, {}, c);
    return Across{c, low.*c, high.*c};
  };
  const Across x = of(&sema::Point::x), y = of(&sema::Point::y);
  const auto is_end = [](const sema::Point& p, const Across& a) {
    return p.*a.coordinate == a.low || p.*a.coordinate == a.high;
  };
  for (const sema::Point& p : points) {
    if (!is_end(p, x) || !is_end(p, y)) return {};
  }
  return x.high - x.low < y.high - y.low ? x : y;
}
Undo rewritten(sema::Spec& spec, const RoomToPass& more) {
  sema::Zone* const zone = named(spec.zones, more.zone);
  const auto of = zone != nullptr ? across(*zone) : std::nullopt;
  if (!of) return {};
  auto& points = std::get<sema::ZonePolygon>(zone->value->node).outer.points;
  auto wider = points;
  const Rational by = analysis::metres_of(more.by_mm);
  for (sema::Point& p : wider) {
    p.*of->coordinate += p.*of->coordinate == of->low ? Rational(-by) : by;
  }
  return exchanged(points, std::move(wider));
}
// "`aisle` wider by 0.95 m on both of its long sides, 4.9 m in all,"
std::string text(const sema::Spec& spec, const RoomToPass& more) {
  const auto zone = std::ranges::find(spec.zones, more.zone, &sema::Zone::name);
  const auto of = zone != spec.zones.end() ? across(*zone) : std::nullopt;
  if (!of) return "";
  const Rational by = analysis::metres_of(more.by_mm);
  return "`" + more.zone + "` wider by " + metres(by) + " on both of its long sides, " +
         metres(of->high - of->low + 2 * by) + " in all,";
}
Undo rewritten(sema::Spec& spec, const LongerWait& longer) {
  sema::RobotKind* const kind = named(spec.kinds, longer.kind);
  if (kind == nullptr || !kind->energy) return {};
  return exchanged(kind->energy->held.value, Rational(static_cast<long>(longer.seconds)));
}
// "`held <= 1200 s` in `Cart`"
std::string text(const sema::Spec&, const LongerWait& longer) {
  return "`held <= " + std::to_string(longer.seconds) + " s` in `" + longer.kind + "`";
}

}  // namespace

std::string text_of(const sema::Spec& spec, const verify::Mend& mend) {
  return std::visit([&](const auto& each) { return text(spec, each); }, mend);
}

Rewriting::Rewriting(sema::Spec& spec, const verify::Mend& mend)
    : undo_(std::visit([&](const auto& each) { return rewritten(spec, each); }, mend)) {}

}  // namespace rtac::driver
