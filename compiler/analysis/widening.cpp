#include "compiler/analysis/widening.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "compiler/analysis/dials.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/zone_text.h"
#include "compiler/analysis/zones.h"
#include "compiler/geometry/looks.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

// What all widths that are tried may take: some 10 s (geometry/looks.h).
constexpr std::int64_t looks_most = 150'000'000;
// Mostly up to 0.1 s a trial.
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

// Sideways, or between two slabs.
bool closes_a_gap(const geometry::Solid& zone, std::int64_t by_mm) {
  const auto& slabs = zone.slabs();
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    if (closes_a_gap(slabs[k].region, by_mm)) return true;
    const bool apart = k > 0 && slabs[k - 1].ceiling < slabs[k].floor;
    if (apart && slabs[k].floor - slabs[k - 1].ceiling <= metres_of(2 * by_mm)) return true;
  }
  return false;
}

// The offsets of a zone that make it narrower, or, of what is taken out of one, wider, the last one
// first; in what has no name of its own.
void find_narrowing(sema::Spec& spec, sema::ZoneExpr& zone, bool kept,
                    std::vector<sema::ZoneExpr*>& found) {
  const auto behind = [&](sema::ZoneId id) {
    sema::Zone& of = spec.zones[static_cast<std::size_t>(id)];
    return of.name.empty() ? of.value.get() : nullptr;
  };
  if (auto* both = std::get_if<sema::ZoneBinary>(&zone.node)) {
    find_narrowing(spec, *both->right, both->op == sema::ZoneOp::subtract ? !kept : kept, found);
    find_narrowing(spec, *both->left, kept, found);
  } else if (auto* by = std::get_if<sema::ZoneOffset>(&zone.node)) {
    if ((by->distance < 0) == kept) found.push_back(&zone);
    find_narrowing(spec, *by->operand, kept, found);
  } else if (const auto* ref = std::get_if<sema::ZoneRef>(&zone.node)) {
    if (auto* of = behind(ref->zone)) find_narrowing(spec, *of, kept, found);
  } else if (const auto* out = std::get_if<sema::ZoneComplement>(&zone.node)) {
    if (auto* of = behind(out->zone)) find_narrowing(spec, *of, !kept, found);
  }
}

// Whether it is all but another zone.
bool is_all_but(const sema::Spec& spec, const sema::ZoneExpr& part) {
  if (std::holds_alternative<sema::ZoneComplement>(part.node)) return true;
  const auto* ref = std::get_if<sema::ZoneRef>(&part.node);
  return ref != nullptr && is_all_but(spec, *spec[ref->zone].value);
}

// Whether something is taken out of a zone, in what has no name of its own, and that without a
// distance to keep off it.
bool leaves_out_plainly(sema::Spec& spec, sema::ZoneExpr& zone) {
  const auto plainly = [&](sema::ZoneExpr& out, bool kept) {
    std::vector<sema::ZoneExpr*> distances;
    find_narrowing(spec, out, kept, distances);
    return distances.empty();
  };
  if (auto* both = std::get_if<sema::ZoneBinary>(&zone.node)) {
    const bool right = both->op == sema::ZoneOp::subtract ? plainly(*both->right, false)
                                                          : leaves_out_plainly(spec, *both->right);
    return right || leaves_out_plainly(spec, *both->left);
  }
  if (is_all_but(spec, zone)) return plainly(zone, true);
  if (const auto* ref = std::get_if<sema::ZoneRef>(&zone.node)) {
    const sema::Zone& of = spec.zones[static_cast<std::size_t>(ref->zone)];
    return of.name.empty() && leaves_out_plainly(spec, *of.value);
  }
  return false;
}

// As far as a zone may grow without reaching what its author keeps it off.
std::int64_t kept_off_mm(sema::Spec& spec, const sema::Zone& zone) {
  if (leaves_out_plainly(spec, *zone.value)) return 0;
  std::vector<sema::ZoneExpr*> narrows;
  find_narrowing(spec, *zone.value, true, narrows);
  std::int64_t least_mm = std::numeric_limits<std::int64_t>::max();
  for (const sema::ZoneExpr* each : narrows) {
    const Rational& by = std::get<sema::ZoneOffset>(each->node).distance;
    least_mm = std::min(least_mm, floor_to_int(Rational((by < 0 ? -by : by) * 1000)));
  }
  return least_mm;
}

// What is grown, and what it is called where it is written.
struct Growing {
  sema::ZoneExprPtr& value;
  std::string called;
  bool named;
};

// What is left where nothing is taken out of a zone; nullptr: nothing is.
sema::ZoneExprPtr* whole_of(const sema::Spec& spec, sema::ZoneExpr& zone) {
  auto* const both = std::get_if<sema::ZoneBinary>(&zone.node);
  if (both == nullptr || both->op == sema::ZoneOp::unite) return nullptr;
  if (both->op == sema::ZoneOp::subtract || is_all_but(spec, *both->right)) return &both->left;
  return is_all_but(spec, *both->left) ? &both->right : nullptr;
}

// Of a zone that something is taken out of: what that is taken out of.
std::optional<Growing> around_what_is_kept_off(sema::Spec& spec, sema::Zone& zone) {
  sema::ZoneExprPtr* value = &zone.value;
  std::string name;
  while (true) {
    if (sema::ZoneExprPtr* whole = whole_of(spec, **value)) {
      value = whole;
      name.clear();
    } else if (const auto* ref = std::get_if<sema::ZoneRef>(&(*value)->node)) {
      sema::Zone& of = spec.zones[static_cast<std::size_t>(ref->zone)];
      value = &of.value;
      name = of.name;
    } else {
      break;
    }
  }
  const bool narrowed = std::holds_alternative<sema::ZoneOffset>((*value)->node);
  if (value == &zone.value || narrowed || is_all_but(spec, **value)) return std::nullopt;
  const bool named = !name.empty();
  if (!named) name = zone_text(spec, **value);
  if (name.empty()) return std::nullopt;
  return Growing{*value, std::move(name), named};
}

using Works = std::function<bool(std::int64_t by_mm)>;

// Between what does not work and what does.
std::int64_t least_between(std::int64_t low_mm, std::int64_t high_mm, const Works& works) {
  while (high_mm - low_mm > 1) {
    const std::int64_t middle_mm = low_mm + (high_mm - low_mm) / 2;
    (works(middle_mm) ? high_mm : low_mm) = middle_mm;
  }
  return high_mm;
}
// More than what does not work, by steps that double: each trial bakes the zone.
std::optional<std::int64_t> least_above(std::int64_t low_mm, std::int64_t most_mm,
                                        const Works& works) {
  for (std::int64_t step_mm = 1; low_mm < most_mm; step_mm *= 2) {
    const std::int64_t high_mm = std::min(low_mm + step_mm, most_mm);
    if (works(high_mm)) return least_between(low_mm, high_mm, works);
    low_mm = high_mm;
  }
  return std::nullopt;
}
// From a guess on: the least is near to it.
std::optional<std::int64_t> least_that_works(std::int64_t guess_mm, std::int64_t most_mm,
                                             const Works& works) {
  std::int64_t high_mm = std::clamp<std::int64_t>(guess_mm, 1, most_mm);
  if (!works(high_mm)) return least_above(high_mm, most_mm, works);
  for (std::int64_t step_mm = 1; high_mm > 0; step_mm *= 2) {
    const std::int64_t low_mm = std::max<std::int64_t>(high_mm - step_mm, 0);
    if (low_mm == 0 || !works(low_mm)) return least_between(low_mm, high_mm, works);
    high_mm = low_mm;
  }
  return high_mm;
}

}  // namespace

void offset(sema::ZoneExprPtr& value, std::int64_t by_mm) {
  auto by = std::make_unique<sema::ZoneExpr>();
  by->range = value->range;
  by->node = sema::ZoneOffset{std::move(value), metres_of(by_mm)};
  value = std::move(by);
}
void take_offset_back(sema::ZoneExprPtr& value) {
  auto written = std::move(std::get<sema::ZoneOffset>(value->node).operand);
  value = std::move(written);
}

std::optional<std::int64_t> widening_mm(const geometry::Region& zone, std::int64_t guess_mm,
                                        std::int64_t most_mm, const FitsZone& fits,
                                        const FitsZone& whole) {
  if (zone.vertices() > vertices_most) return std::nullopt;
  const std::int64_t looks_end = geometry::looks() + looks_most;
  const auto holds = [&](const FitsZone& what, std::int64_t by_mm) {
    if (geometry::looks() > looks_end) return false;
    const auto wider = grown(zone, by_mm);
    if (!wider || wider->cells.clearance_mm_lo.size() > cells_tried_most) return false;
    const geometry::CellGrid& c = wider->cells;
    return what(wider->edges,
                {c.origin.x_mm, c.origin.y_mm, c.cell_mm, c.columns, c.rows, c.clearance_mm_lo});
  };
  auto by_mm = least_that_works(guess_mm, most_mm, [&](auto mm) { return holds(fits, mm); });
  // the grid of a zone that is a little wider may tell less of its passages than its walls do
  if (by_mm && whole && !holds(whole, *by_mm)) {
    by_mm =
        least_above(*by_mm, most_mm, [&](auto mm) { return holds(fits, mm) && holds(whole, mm); });
  }
  const bool ran_out = geometry::looks() > looks_end;  // then nobody knows whether less works
  if (!by_mm || ran_out || closes_a_gap(zone, *by_mm)) return std::nullopt;
  return by_mm;
}

std::optional<std::string> growth_that_works(Trials& trials, ir::ZoneIndex table,
                                             const ExactShape& exact, std::int64_t guess_mm,
                                             std::int64_t most_mm, const Fault& fault,
                                             std::int64_t least_mm) {
  const auto id = trials.zone_of(table);
  if (!id) return std::nullopt;
  sema::Zone& zone = trials.spec().zones[static_cast<std::size_t>(*id)];
  const bool unnamed = zone.name.empty();
  const std::string name = unnamed ? zone_text(trials.spec(), *zone.value) : zone.name;
  // where the author has written a distance, that is what is changed
  if (auto works = distance_that_works(trials, table, guess_mm, fault)) return works;
  if (name.empty() || std::holds_alternative<sema::ZoneComplement>(zone.value->node)) {
    return std::nullopt;
  }
  const auto grow = [&](const Growing& wider, std::int64_t far_mm) -> std::optional<std::string> {
    const std::string& called = wider.called;
    const Dial dial{"the growth of " + called,
                    std::max<std::int64_t>(least_mm - 1, 0),
                    far_mm,
                    [&](std::int64_t mm) {
                      offset(wider.value, mm);
                      return true;
                    },
                    [&] { take_offset_back(wider.value); },
                    true};
    const auto by_mm = trials.nearest(dial, guess_mm, fault);
    const auto closes = [&](const auto& shape) { return closes_a_gap(shape, *by_mm); };
    const bool itself = &wider.value == &zone.value;
    if (!by_mm || (itself && std::visit(closes, exact))) return std::nullopt;
    // in its declaration, so that recoveries move in what is wider, too
    return "`grow(" + called + ", " + metres(*by_mm) + ")` in place of `" + called + "`" +
           (wider.named ? " wherever it is named" : "") + " works" +
           trials.leaves(dial.name, *by_mm, fault);
  };
  const std::int64_t far_mm = std::max(guess_mm, most_mm);
  const std::int64_t own_mm = std::min(far_mm, kept_off_mm(trials.spec(), zone));
  if (guess_mm <= own_mm) return grow({zone.value, name, !unnamed}, own_mm);
  const auto around = around_what_is_kept_off(trials.spec(), zone);
  return around ? grow(*around, far_mm) : std::nullopt;
}

std::optional<std::string> opening_that_works(Trials& trials, ir::ZoneIndex table,
                                              std::int64_t guess_mm, std::int64_t most_mm,
                                              const Fault& fault) {
  const auto id = trials.zone_of(table);
  if (!id) return std::nullopt;
  sema::Zone& zone = trials.spec().zones[static_cast<std::size_t>(*id)];
  if (zone.name.empty() || std::holds_alternative<sema::ZoneComplement>(zone.value->node)) {
    return std::nullopt;
  }
  sema::ZoneExprPtr& value = zone.value;
  const Dial dial{"the opening of " + zone.name,
                  0,
                  most_mm,
                  [&](std::int64_t mm) {
                    offset(value, -mm);
                    offset(value, mm);
                    return true;
                  },
                  [&] {
                    take_offset_back(value);
                    take_offset_back(value);
                  },
                  true,
                  true};
  const auto by_mm = trials.nearest(dial, guess_mm, fault);
  if (!by_mm) return std::nullopt;
  const std::string by = metres(*by_mm);
  return "`grow(shrink(" + zone.name + ", " + by + "), " + by +
         ")`, which leaves out what is too narrow, in place of `" + zone.name +
         "` wherever it is named works" + trials.leaves(dial.name, *by_mm, fault);
}

std::optional<std::string> distance_that_works(Trials& trials, ir::ZoneIndex table,
                                               std::int64_t guess_mm, const Fault& fault) {
  const auto id = trials.zone_of(table);
  // each trial evaluates offsets anew, which a remark is not worth
  const bool error = diag::info(fault.code).severity == diag::Severity::error;
  if (!id || !error) return std::nullopt;
  sema::Spec& spec = trials.spec();
  std::vector<sema::ZoneExpr*> narrows;
  find_narrowing(spec, *spec.zones[static_cast<std::size_t>(*id)].value, true, narrows);
  for (sema::ZoneExpr* each : narrows) {
    auto& distance = std::get<sema::ZoneOffset>(each->node).distance;
    const Rational written = distance;
    const bool shrinks = written < 0;
    const std::int64_t from_mm = ceil_to_int(Rational((shrinks ? -written : written) * 1000));
    const std::int64_t far_mm = std::max<std::int64_t>(1, from_mm / asked_share);
    const std::int64_t begin_mm = std::max(from_mm - std::max<std::int64_t>(guess_mm, 1), far_mm);
    if (begin_mm >= from_mm) continue;
    const std::string was = zone_text(spec, *each);
    const std::string at = std::to_string(static_cast<std::uint32_t>(each->range.file)) + ":" +
                           std::to_string(each->range.begin);
    const Dial dial{"the distance at " + at,
                    from_mm,
                    far_mm,
                    [&](std::int64_t mm) {
                      distance = metres_of(shrinks ? -mm : mm);
                      return true;
                    },
                    [&] { distance = written; },
                    true};
    const auto mm = trials.nearest(dial, begin_mm, fault);
    if (!mm) continue;
    distance = metres_of(shrinks ? -*mm : *mm);
    const std::string is = zone_text(spec, *each);
    distance = written;
    if (is.empty()) {
      return std::string("`") + (shrinks ? "shrink" : "grow") + "` by at most " + metres(*mm) +
             " in its expression works" + trials.leaves(dial.name, *mm, fault);
    }
    return "`" + is + "` in place of `" + was + "` works" + trials.leaves(dial.name, *mm, fault);
  }
  return std::nullopt;
}

}  // namespace rtac::analysis
