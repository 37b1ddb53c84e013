#include "compiler/analysis/widening.h"

#include <algorithm>

#include "compiler/analysis/sides.h"
#include "compiler/analysis/zones.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

// Up to 0.1 s a trial.
constexpr std::size_t vertices_most = 200, cells_tried_most = 100'000;

std::optional<geometry::BakedZone> grown(const geometry::Region& zone, std::int64_t by_mm) {
  // zones to stay in grow less than they are told (zones.cpp, offsets)
  const Rational by_m = Rational(static_cast<long>(by_mm)) / 1000 - geometry::offset_excess_m();
  const auto snapped = geometry::snap_inside(zone.grow(std::max(by_m, Rational(0))));
  if (!snapped) return std::nullopt;
  return baked(*snapped);
}

// What is grown over, walls among it, is no longer kept out of: corners alone are no gap.
bool closes_a_gap(const geometry::Region& zone, std::int64_t by_mm) {
  const Rational by_m = metres_of(by_mm);
  const geometry::Region filled = zone.grow(by_m).shrink(by_m).subtract(zone);
  return !filled.shrink(Rational(by_m / 2)).empty();
}

}  // namespace

std::optional<std::int64_t> widening_mm(const geometry::Region& zone, std::int64_t most_mm,
                                        const FitsZone& fits, const FitsZone& whole) {
  if (zone.vertices() > vertices_most) return std::nullopt;
  const auto holds = [&](const FitsZone& what, std::int64_t by_mm) {
    const auto wider = grown(zone, by_mm);
    if (!wider || wider->cells.clearance_mm_lo.size() > cells_tried_most) return false;
    const geometry::CellGrid& c = wider->cells;
    return what(wider->edges,
                {c.origin.x_mm, c.origin.y_mm, c.cell_mm, c.columns, c.rows, c.clearance_mm_lo});
  };
  const auto works = [&](std::int64_t by_mm) { return holds(fits, by_mm); };
  std::int64_t low = 0, high = 1;
  while (high < most_mm && !works(high)) {
    low = high;
    high = std::min(2 * high, most_mm);
  }
  if (high >= most_mm && !works(high)) return std::nullopt;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (works(middle) ? high : low) = middle;
  }
  if (closes_a_gap(zone, high) || (whole && !holds(whole, high))) return std::nullopt;
  return high;
}

std::optional<std::string> growth_that_works(Trials& trials, const std::string& zone,
                                             const geometry::Region& exact, std::int64_t guess_mm,
                                             std::int64_t most_mm, const Fault& fault,
                                             std::int64_t least_mm) {
  auto& zones = trials.spec().zones;
  const auto named = [&](const sema::Zone& z) { return !z.name.empty() && z.name == zone; };
  const auto found = std::ranges::find_if(zones, named);
  if (found == zones.end()) return std::nullopt;
  sema::ZoneExprPtr& value = found->value;
  const SourceRange range = value->range;
  const Dial dial{"the growth of " + zone,
                  std::max<std::int64_t>(least_mm - 1, 0),
                  std::max(guess_mm, most_mm),
                  [&](std::int64_t mm) {
                    auto grown = std::make_unique<sema::ZoneExpr>();
                    grown->range = range;
                    grown->node = sema::ZoneOffset{std::move(value), metres_of(mm)};
                    value = std::move(grown);
                    return true;
                  },
                  [&] {
                    auto written = std::move(std::get<sema::ZoneOffset>(value->node).operand);
                    value = std::move(written);
                  },
                  true};
  const auto by_mm = trials.nearest(dial, guess_mm, fault);
  if (!by_mm || closes_a_gap(exact, *by_mm)) return std::nullopt;
  return "`grow(" + zone + ", " + metres(*by_mm) + ")` in its place works";
}

}  // namespace rtac::analysis
