#include "compiler/driver/end_of_turns.h"

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

using verify::EndOfTurns;
using verify::LaterReturn;
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

// "`recover back;` in `quiet` works"
std::string text_of(const sema::Monitor& monitor, const SameRecovery& same) {
  return "`recover " + same.recovery + ";` in `" + monitor.name + "` works";
}
// "`return when clearance(r, hall) >= 0.89 m;` in `quiet` works"
std::string text_of(const sema::Monitor& monitor, const LaterReturn& later) {
  std::string text;
  for (const auto& [zone, mm] : later.clearances_mm) {
    text += (text.empty() ? "" : " and ") + std::string("clearance(") + monitor.robot + ", " +
            zone + ") >= " + metres(mm);
  }
  return "`return when " + text + ";` in `" + monitor.name + "` works";
}

// Of what is not proved or accepted: the decision, the kind, the monitor and the recovery.
using Open = std::set<std::tuple<std::string, verify::Kind, std::string, std::string>>;
Open open_of(const verify::Report& report) {
  Open open;
  for (const verify::Decision& d : report.decisions) {
    for (const Obligation& o : d.obligations) {
      if (o.status == Status::proved || o.status == Status::acknowledged) continue;
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

// That switching is shown, nothing is open that was not, and nothing is refuted.
bool is_shown(Compilation& c, const verify::Report& report, const std::string& decision) {
  const auto built = build_anew(*c.spec, c.sources);
  if (!built) return false;
  const verify::Report anew =
      verify::verify(*c.spec, &built->module, built->tables, built->diagnostics.all(), check_model);
  Open before = open_of(report);
  before.erase({decision, verify::Kind::switching, "", ""});
  return verify::worst(anew) != Status::refuted && std::ranges::includes(before, open_of(anew));
}
bool works(Compilation& c, const verify::Report& report, const std::string& decision,
           sema::Monitor& monitor, const LaterReturn& later) {
  if (monitor.return_when) return false;
  const Changed waits(monitor.return_when, condition_of(*c.spec, later, monitor.always_range));
  return is_shown(c, report, decision);
}
bool works(Compilation& c, const verify::Report& report, const std::string& decision,
           sema::Monitor& monitor, const SameRecovery& same) {
  const auto& controllers = c.spec->controllers;
  const auto found = std::ranges::find(controllers, same.recovery, &sema::Controller::name);
  if (found == controllers.end()) return false;
  const auto id = static_cast<sema::ControllerId>(found - controllers.begin());
  const Changed follows(monitor.recover, std::optional(id));
  return is_shown(c, report, decision);
}
// In words, if it works; else "".
std::string tried(Compilation& c, const verify::Report& report, const std::string& decision,
                  const EndOfTurns& end) {
  return std::visit(
      [&](const auto& change) -> std::string {
        auto& monitors = c.spec->monitors;
        const auto monitor = std::ranges::find(monitors, change.monitor, &sema::Monitor::name);
        const bool mends =
            monitor != monitors.end() && works(c, report, decision, *monitor, change);
        return mends ? text_of(*monitor, change) : "";
      },
      end);
}

}  // namespace

void offer_end_of_turns(Compilation& c, verify::Report& report) {
  if (geometry::looks() - c.looks_before > looks_most) return;
  for (verify::Decision& d : report.decisions) {
    for (Obligation& o : d.obligations) {
      const std::size_t count = std::min(o.ends.size(), tries_most);
      for (std::size_t k = 0; k < count; ++k) {
        std::string works = tried(c, report, d.name, o.ends[k]);
        if (works.empty()) continue;
        o.repair = std::move(works);
        break;
      }
    }
  }
}

}  // namespace rtac::driver
