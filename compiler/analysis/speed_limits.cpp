#include "compiler/analysis/speed_limits.h"

#include <algorithm>

#include "compiler/analysis/reach.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

std::string speed_text(std::int64_t mmps) {
  return to_decimal(Rational(mmps, 1000)) + " m/s";
}

// What the kernel may take a robot at rest for, until a recovery would act: it is measured to have
// the error of the velocity, which counts once more, and each component lies on the grid.
std::int64_t fastest_from_rest(const ir::Decision& decision, const ir::Monitor& monitor) {
  constexpr std::int64_t grid_mmps = 4;
  const ir::Body& body = decision.body;
  const std::int64_t us =
      horizon_us_max(body, monitor.lookahead.duration_us) + decision.return_extra_us;
  // theory, horizon: stamps that differ add to the error of the velocity
  const std::int64_t apart_us = std::max(body.position_age_us, body.velocity_age_us);
  const Rational gained = Rational(body.accel_mmps2) * Rational(us + apart_us, 1'000'000);
  const std::int64_t mmps = 2 * body.velocity_error_mmps + grid_mmps + ceil_to_int(gained);
  return std::min(decision.motions[0].speed_mmps, mmps);
}

diag::Diagnostic finding(const SourceRange& range, std::string message, std::string help) {
  return {diag::Code::speed_limit_unkept, range, std::move(message), "", {}, std::move(help), {}};
}

}  // namespace

std::vector<diag::Diagnostic> unkept_speed_limits(const ir::Decision& decision) {
  std::vector<diag::Diagnostic> all;
  for (const ir::Monitor& monitor : decision.monitors) {
    for (const ir::Value& value : monitor.property.values) {
      const auto* compare = std::get_if<ir::AtLeast>(&value.op);
      const auto bound = compare ? ir::upper_bound(monitor.property, *compare) : std::nullopt;
      if (!bound || bound->leaf.kind != ir::Leaf::Kind::speed) continue;
      for (std::size_t k = 0; k < decision.monitors.size(); ++k) {
        const std::string& name = decision.monitors[k].recovery.name;
        const std::int64_t mmps = decision.motions[k + 1].speed_mmps;
        if (mmps <= bound->most || ir::acknowledged(decision, name, monitor.name)) continue;
        all.push_back(finding(value.source,
                              "the recovery `" + name + "` drives at up to " + speed_text(mmps) +
                                  ", and `" + monitor.name + "` allows " + speed_text(bound->most),
                              "at most " + speed_text(bound->most) + " works; or `acknowledge " +
                                  name + " may break " + monitor.name + " \"why\"`"));
      }
      const std::int64_t need = fastest_from_rest(decision, monitor);
      if (need <= bound->most) continue;
      all.push_back(finding(value.source,
                            "monitor `" + monitor.name +
                                "` can never hand control back: from rest the robot may reach " +
                                speed_text(need) + " before a recovery acts",
                            "a limit of " + speed_text(need) + " works, or a lower `accel`"));
    }
  }
  return all;
}

}  // namespace rtac::analysis
