// Limits of speed, height and charge against what sensors can show: a state in which each of them
// is seen to be kept, whatever the errors.
#include <algorithm>
#include <limits>
#include <optional>

#include "compiler/analysis/limits.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

constexpr const char* by_errors = "sensing errors";

// What all have to hold of, each as strict as it gets.
struct Limits {
  std::optional<std::int64_t> most_mmps, least_ppm;
  std::optional<std::int64_t> spare_ppm;  // beyond the way to a site, which takes some as well
  std::int64_t low_mm = std::numeric_limits<std::int32_t>::min();
  std::int64_t high_mm = std::numeric_limits<std::int32_t>::max();
};
void collect(const ir::Block& block, ir::ValueId id, const std::vector<ir::Param>& params,
             Limits& to) {
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::And>(&op)) {
    collect(block, v->a, params, to);
    collect(block, v->b, params, to);
    return;
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  if (compare == nullptr) return;
  using Kind = ir::Leaf::Kind;
  if (const auto most = ir::upper_bound(block, *compare)) {
    if (most->leaf.kind == Kind::speed) {
      to.most_mmps = std::min(to.most_mmps.value_or(most->most), most->most);
    }
    if (most->leaf.kind == Kind::altitude) to.high_mm = std::min(to.high_mm, most->most);
  }
  if (const auto least = ir::lower_bound(block, *compare, params)) {
    const std::int64_t need = least->need.strictest;
    if (least->leaf.kind == Kind::battery) {
      to.least_ppm = std::max(to.least_ppm.value_or(need), need);
    }
    if (least->leaf.kind == Kind::altitude) to.low_mm = std::max(to.low_mm, need);
  }
  if (const auto way = ir::charge_for_way(block, *compare, params)) {
    to.spare_ppm = std::max(to.spare_ppm.value_or(0), way->reserve.strictest);
  }
}

}  // namespace

Obligation not_seen(Obligation o, bool never, const char* how, std::string why) {
  o.status = never ? Status::refuted : Status::unknown;
  o.method = never ? how : "no proof";
  o.because = std::move(why);
  o.claims.clear();
  return o;
}

std::optional<Obligation> limits_unseen(const Subject& s, const ir::Monitor& m,
                                        const Obligation& o) {
  if (s.decision.on_plan) return std::nullopt;
  Limits limits;
  collect(m.property, m.property.result, s.decision.facts.params, limits);
  const ir::Body& body = s.decision.body;
  const ir::Motion& any = s.decision.motions.front();
  if (limits.most_mmps) {
    const std::int64_t shown = analysis::shown_speed_mmps(s.decision, any);
    if (*limits.most_mmps < shown) {
      return not_seen(o, *limits.most_mmps < body.velocity_error_mmps, by_errors,
                      "a robot at rest may be seen as fast as " +
                          to_decimal(Rational(static_cast<long>(shown)) / 1000) + " m/s");
    }
  }
  if (limits.least_ppm || limits.spare_ppm) {
    const std::int64_t shown = analysis::shown_full_ppm(body);
    const std::int64_t asked = std::max(limits.least_ppm.value_or(0), limits.spare_ppm.value_or(0));
    if (asked > shown) {
      const std::string percent = to_decimal(Rational(static_cast<long>(shown)) / 10'000) + " %";
      return not_seen(o, asked > 1'000'000 - body.battery_error_ppm, by_errors,
                      "a full battery is sure to be seen with " + percent);
    }
  }
  const std::int64_t room_mm = limits.high_mm - limits.low_mm;
  const std::int64_t needs_mm =
      2 * (analysis::shown_clearance_mm(s.decision, any, 0) - body.radius_mm);
  if (room_mm < needs_mm) {
    return not_seen(o, room_mm < 2 * body.position_error_mm, by_errors,
                    "its limits of height leave " + metres(std::max<std::int64_t>(room_mm, 0)) +
                        ", and a height is seen within " + metres(needs_mm));
  }
  return std::nullopt;
}

}  // namespace rtac::verify
