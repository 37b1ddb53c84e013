#include "compiler/driver/mends.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>

#include "compiler/analysis/sides.h"
#include "compiler/driver/model_checker.h"
#include "compiler/geometry/looks.h"
#include "compiler/support/words.h"
#include "compiler/verify/obligations.h"

namespace rtac::driver {
namespace {

using verify::EarlierReturn;
using verify::LaterReturn;
using verify::Mend;
using verify::Obligation;
using verify::SameRecovery;
using verify::Status;

// Each is as much work as the specification itself: so many, and none of what has taken more than
// some 20 s (geometry/looks.h).
constexpr std::size_t tries_most = 4;
constexpr std::int64_t looks_most = 800'000'000;

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

// The number that the `return when` of a monitor compares the clearance from a zone with, as one of
// all that have to hold; null: there is none.
sema::Constant* clearance_asked(const sema::Spec& spec, sema::Monitor& monitor,
                                const std::string& zone) {
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
  return monitor.return_when ? in(*monitor.return_when, in) : nullptr;
}
Rational less(const sema::Constant& asked, const EarlierReturn& earlier) {
  return asked.value - analysis::metres_of(earlier.less_mm);
}

// "`recover back;` in `quiet` works"
std::string text_of(const sema::Spec&, const sema::Monitor& monitor, const SameRecovery& same) {
  return "`recover " + same.recovery + ";` in `" + monitor.name + "` works";
}
// "`return when clearance(r, hall) >= 0.89 m;` in `quiet` works"
std::string text_of(const sema::Spec&, const sema::Monitor& monitor, const LaterReturn& later) {
  std::string text;
  for (const auto& [zone, mm] : later.clearances_mm) {
    text += (text.empty() ? "" : " and ") + std::string("clearance(") + monitor.robot + ", " +
            zone + ") >= " + metres(mm);
  }
  return "`return when " + text + ";` in `" + monitor.name + "` works";
}
// "`clearance(r, hall) >= 1.2 m` in the `return when` of `quiet` works"
std::string text_of(const sema::Spec& spec, sema::Monitor& monitor, const EarlierReturn& earlier) {
  const sema::Constant* const asked = clearance_asked(spec, monitor, earlier.zone);
  return "`clearance(" + monitor.robot + ", " + earlier.zone +
         ") >= " + metres(less(*asked, earlier)) + "` in the `return when` of `" + monitor.name +
         "` works";
}

// Of what is not proved or accepted, or of that what is refuted: the decision, the kind, the
// monitor and the recovery.
using Open = std::set<std::tuple<std::string, verify::Kind, std::string, std::string>>;
Open open_of(const verify::Report& report, bool refuted) {
  Open open;
  for (const verify::Decision& d : report.decisions) {
    for (const Obligation& o : d.obligations) {
      if (o.status == Status::proved || o.status == Status::acknowledged) continue;
      if (refuted && o.status != Status::refuted) continue;
      open.insert({d.name, o.kind, o.monitor, o.recovery});
    }
  }
  return open;
}

// What is written in a specification is something else for as long as this is there.
template <class T>
class Changed {
 public:
  Changed(T& written, T to) : written_(written), other_(std::move(to)) {
    std::swap(written_, other_);
  }
  Changed(const Changed&) = delete;
  Changed& operator=(const Changed&) = delete;
  ~Changed() { std::swap(written_, other_); }

 private:
  T& written_;
  T other_;
};

// Where something is open that shall be shown.
struct Place {
  const std::string& decision;
  const Obligation& open;
};

// That it is shown, and nothing is open, or refuted, that was not.
bool is_shown(Compilation& c, const verify::Report& report, const Place& place) {
  const auto built = build_anew(*c.spec, c.sources);
  if (!built) return false;
  const verify::Report anew =
      verify::verify(*c.spec, &built->module, built->tables, built->diagnostics.all(), check_model);
  const Obligation& open = place.open;
  Open before = open_of(report, false);
  before.erase({place.decision, open.kind, open.monitor, open.recovery});
  return std::ranges::includes(before, open_of(anew, false)) &&
         std::ranges::includes(open_of(report, true), open_of(anew, true));
}
bool works(Compilation& c, const verify::Report& report, const Place& place, sema::Monitor& monitor,
           const LaterReturn& later) {
  if (monitor.return_when) return false;
  const Changed waits(monitor.return_when, condition_of(*c.spec, later, monitor.always_range));
  return is_shown(c, report, place);
}
bool works(Compilation& c, const verify::Report& report, const Place& place, sema::Monitor& monitor,
           const SameRecovery& same) {
  const auto& controllers = c.spec->controllers;
  const auto found = std::ranges::find(controllers, same.recovery, &sema::Controller::name);
  if (found == controllers.end()) return false;
  const auto id = static_cast<sema::ControllerId>(found - controllers.begin());
  const Changed follows(monitor.recover, std::optional(id));
  return is_shown(c, report, place);
}
bool works(Compilation& c, const verify::Report& report, const Place& place, sema::Monitor& monitor,
           const EarlierReturn& earlier) {
  sema::Constant* const asked = clearance_asked(*c.spec, monitor, earlier.zone);
  if (asked == nullptr || less(*asked, earlier) < 0) return false;
  const Changed sooner(asked->value, less(*asked, earlier));
  return is_shown(c, report, place);
}
// In words, if it works; else "".
std::string tried(Compilation& c, const verify::Report& report, const Place& place,
                  const Mend& mend) {
  return std::visit(
      [&](const auto& change) -> std::string {
        auto& monitors = c.spec->monitors;
        const auto monitor = std::ranges::find(monitors, change.monitor, &sema::Monitor::name);
        const bool mends = monitor != monitors.end() && works(c, report, place, *monitor, change);
        return mends ? text_of(*c.spec, *monitor, change) : "";
      },
      mend);
}

}  // namespace

void offer_mends(Compilation& c, verify::Report& report) {
  for (verify::Decision& d : report.decisions) {
    for (Obligation& o : d.obligations) {
      if (o.status == Status::proved || o.status == Status::acknowledged) continue;
      const std::size_t count = std::min(o.mends.size(), tries_most);
      for (std::size_t k = 0; k < count; ++k) {
        if (geometry::looks() - c.looks_before > looks_most) return;
        std::string works = tried(c, report, {d.name, o}, o.mends[k]);
        if (works.empty()) continue;
        o.repair = std::move(works);
        break;
      }
    }
  }
}

}  // namespace rtac::driver
