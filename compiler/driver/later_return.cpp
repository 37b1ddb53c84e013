#include "compiler/driver/later_return.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "compiler/analysis/sides.h"
#include "compiler/driver/model_checker.h"
#include "compiler/geometry/looks.h"
#include "compiler/support/words.h"
#include "compiler/verify/obligations.h"

namespace rtac::driver {
namespace {

using verify::LaterReturn;
using verify::Obligation;
using verify::Status;

// Each is as much work as the specification itself: so many, and none of what has taken more than
// some 20 s (geometry/looks.h).
constexpr std::size_t tries_most = 3;
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

// A monitor with that `return when`, which has none of its own, for as long as this is there.
class Waiting {
 public:
  Waiting(sema::Monitor& monitor, sema::ExprPtr condition) : monitor_(monitor) {
    monitor_.return_when = std::move(condition);
  }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;
  ~Waiting() { monitor_.return_when = nullptr; }

 private:
  sema::Monitor& monitor_;
};

// With it that switching is shown, nothing is open that was not, and nothing is refuted.
bool works(Compilation& c, const verify::Report& report, const std::string& decision,
           const LaterReturn& later) {
  sema::Spec& spec = *c.spec;
  const auto monitor = std::ranges::find(spec.monitors, later.monitor, &sema::Monitor::name);
  if (monitor == spec.monitors.end() || monitor->return_when) return false;
  const Waiting waits(*monitor, condition_of(spec, later, monitor->always_range));
  const auto built = build_anew(spec, c.sources);
  if (!built) return false;
  const verify::Report anew =
      verify::verify(spec, &built->module, built->tables, built->diagnostics.all(), check_model);
  Open before = open_of(report);
  before.erase({decision, verify::Kind::switching, "", ""});
  return verify::worst(anew) != Status::refuted && std::ranges::includes(before, open_of(anew));
}

}  // namespace

void offer_later_return(Compilation& c, verify::Report& report) {
  if (geometry::looks() - c.looks_before > looks_most) return;
  for (verify::Decision& d : report.decisions) {
    for (Obligation& o : d.obligations) {
      if (o.status != Status::unknown) continue;
      const std::size_t count = std::min(o.later.size(), tries_most);
      for (std::size_t k = 0; k < count; ++k) {
        const LaterReturn& later = o.later[k];
        if (!works(c, report, d.name, later)) continue;
        const auto monitor =
            std::ranges::find(c.spec->monitors, later.monitor, &sema::Monitor::name);
        o.repair = text_of(*monitor, later);
        break;
      }
    }
  }
}

}  // namespace rtac::driver
