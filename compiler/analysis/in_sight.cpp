#include "compiler/analysis/in_sight.h"

#include <algorithm>
#include <cmath>

#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/tables.h"

namespace rtac::analysis {
namespace {

// More clearance than it needs that a loitering robot would like to have (LoiterManoeuvre).
constexpr std::int64_t loiter_room_mm = 500;

std::int32_t in_mm(std::int64_t length) {
  return static_cast<std::int32_t>(length);
}
std::int64_t whole_mm(double length) {
  return static_cast<std::int64_t>(std::ceil(length)) + 1;
}

}  // namespace

std::vector<std::int64_t> goals_mm(const ir::Decision& decision, const ir::Recovery& recovery) {
  const std::int64_t needed_mm = recovery.return_clearance_mm;
  const ir::Body& body = decision.body;
  std::vector<std::int64_t> goals = {needed_mm,
                                     needed_mm + body.end_reach_mm + body.position_error_mm};
  if (recovery.kind == ir::RecoveryKind::loiter) goals.push_back(goals.back() + loiter_room_mm);
  return goals;
}

std::optional<std::size_t> led_nowhere(const std::vector<geometry::EdgeRow>& edges,
                                       const ir::Cells& cells, const ir::Decision& decision,
                                       const ir::Recovery& recovery, std::int64_t kept_mm,
                                       const geometry::Region& zone) {
  const ir::Body& body = decision.body;
  const std::int64_t least_mm = body.radius_mm + kept_mm - body.position_error_mm;
  if (!ir::goes_back(recovery.kind) || least_mm >= body.radius_mm) return std::nullopt;
  // a way ends short of where it aims, by a measurement, and what legs keep has room for that
  const std::int64_t fits_mm = body.radius_mm + body.end_reach_mm + body.position_error_mm;
  const std::int64_t goal_mm = std::min(fits_mm, recovery.route_clearance_mm);
  const geometry::CellGrid grid = grid_of(cells);
  const std::int32_t least = in_mm(std::max<std::int64_t>(least_mm, 0)), goal = in_mm(goal_mm);
  std::optional<geometry::StraightLegs> legs;
  legs.emplace(edges, grid, least, goal);
  bool from_bodies = false;
  for (std::size_t at = 0; at < cells.clearance_mm_lo.size(); ++at) {
    if (cells.clearance_mm_lo[at] >= goal_mm || !legs->holds_some(at)) continue;
    if (legs->longest_from(at)) continue;
    if (from_bodies) return at;
    // it is seen as far from where it is as its error, and there a body has to fit
    const auto bodies =
        within(zone, std::max<std::int64_t>(body.radius_mm + kept_mm - offsets_round_mm, 0));
    if (!bodies) return at;
    from_bodies = true;
    legs.emplace(edges, grid, least, goal, *bodies, in_mm(body.position_error_mm));
    if (!legs->longest_from(at)) return at;
  }
  return std::nullopt;
}

// It tries its goals from the deepest on, and searches for no way: what it takes is straight away
// from the boundary, or in sight.
std::optional<LedIn> led_in(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
                            const ir::Decision& decision, const ir::Recovery& recovery) {
  const ir::Body& body = decision.body;
  const std::int64_t least_mm =
      body.radius_mm + starts_off_mm(decision, recovery) - body.position_error_mm;
  if (least_mm >= body.radius_mm) return LedIn{};
  if (least_mm <= 0) return std::nullopt;
  const geometry::CellGrid grid = grid_of(cells);
  const std::int32_t least = in_mm(least_mm);
  const std::int64_t route_mm = recovery.route_clearance_mm;
  geometry::StraightLegs near(edges, grid, least, in_mm(route_mm));
  const std::vector<std::int64_t> goals = goals_mm(decision, recovery);
  std::vector<geometry::StraightLegs> far;  // the deepest first
  for (auto goal = goals.rbegin(); goal != goals.rend(); ++goal) {
    far.emplace_back(edges, grid, least, in_mm(*goal));
  }
  LedIn in{route_mm, goals.back(), std::vector<std::int64_t>(cells.clearance_mm_lo.size(), 0)};
  for (std::size_t at = 0; at < cells.clearance_mm_lo.size(); ++at) {
    const std::int64_t clearance = cells.clearance_mm_lo[at];
    if (clearance < 0 || clearance >= body.radius_mm) continue;
    const auto leg = near.longest_from(at);
    const std::int64_t first_mm = whole_mm(leg ? *leg : near.farthest_from(at));
    std::int64_t all_mm = 0;
    for (geometry::StraightLegs& legs : far) {
      const auto all = legs.longest_from(at);
      all_mm = std::max(all_mm, whole_mm(all ? *all : legs.farthest_from(at)));
      if (all) break;  // what is in sight is taken
    }
    in.first_mm = std::max(in.first_mm, first_mm);
    in.all_mm = std::max(in.all_mm, all_mm);
    in.from_mm[at] = std::max(first_mm, all_mm) + cells.cell_mm;
  }
  in.first_mm += cells.cell_mm;
  in.all_mm += cells.cell_mm;
  return in;
}

InSight::InSight(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
                 const ir::Decision& decision, const ir::Recovery& recovery)
    : cells_(cells),
      grid_(grid_of(cells)),
      route_mm_(recovery.route_clearance_mm),
      body_mm_(decision.body.radius_mm + starts_off_mm(decision, recovery)),
      return_mm_(recovery.return_clearance_mm) {
  if (!ir::goes_back(recovery.kind)) return;
  for (const std::int64_t goal_mm : goals_mm(decision, recovery)) {
    deepest_mm_ = goal_mm;
    legs_.emplace_back(edges, grid_, in_mm(decision.body.radius_mm), in_mm(goal_mm));
  }
}

std::optional<std::int64_t> InSight::longest_mm(std::size_t at, std::size_t goal) {
  if (goal >= legs_.size()) return std::nullopt;
  const auto [known, is_new] = found_.try_emplace({goal, at});
  if (!is_new) return known->second;
  const auto leg = legs_[goal].longest_from(at);
  if (leg) known->second = whole_mm(*leg);
  if (goal == 0 && !leg && legs_[goal].gave_up()) given_up_.insert(at);
  return known->second;
}

// A retreat looks for the deepest goal first, and a leg to it that is in sight and no longer than
// twice what it wants is taken without a search. Straight away from the boundary it goes less far.
std::optional<std::int64_t> InSight::surely_taken_mm(std::size_t at) {
  // twice what is wanted, which is rounded up here, and so is what is found
  constexpr std::int64_t rounded_mm = 6;
  const auto leg = legs_.back().longest_from(at, double(2 * deepest_mm_ - rounded_mm));
  return leg ? std::optional(whole_mm(*leg)) : std::nullopt;
}

std::optional<std::int64_t> InSight::always_mm() {
  if (legs_.empty()) return std::nullopt;
  std::int64_t longest = deepest_mm_;
  for (std::size_t at = 0; at < cells_.clearance_mm_lo.size(); ++at) {
    const std::int64_t clearance = cells_.clearance_mm_lo[at];
    if (clearance < 0 || clearance >= return_mm_) continue;
    const auto leg = surely_taken_mm(at);
    if (!leg) return std::nullopt;
    longest = std::max(longest, *leg);
  }
  return longest;
}

std::optional<std::int64_t> InSight::longest_deeper_mm(const Marks& lost, const Marks& endless) {
  std::int64_t longest = 0;
  for (std::size_t goal = 1; goal < legs_.size(); ++goal) {
    const bool ends = std::ranges::count(endless[goal], true) == 0;
    const std::vector<bool> from = beside(cut_off(lost[goal]));
    for (std::size_t at = 0; at < from.size(); ++at) {
      if (!from[at]) continue;
      const auto leg = longest_mm(at, goal);
      if (!leg && !ends) return std::nullopt;
      longest = std::max(longest, leg ? *leg : whole_mm(legs_[goal].farthest_from(at)));
    }
  }
  return longest;
}

// Of the square of cells that are no more than `within` columns and rows off.
template <class Visit>
void InSight::for_each_around(std::size_t at, std::int64_t within, const Visit& visit) const {
  const auto columns = static_cast<std::int64_t>(cells_.columns);
  const auto rows = static_cast<std::int64_t>(cells_.rows);
  const auto column = static_cast<std::int64_t>(at) % columns;
  const auto row = static_cast<std::int64_t>(at) / columns;
  const auto left = std::max<std::int64_t>(0, column - within);
  const auto right = std::min(columns - 1, column + within);
  const auto top = std::min(rows - 1, row + within);
  for (auto r = std::max<std::int64_t>(0, row - within); r <= top; ++r) {
    for (auto c = left; c <= right; ++c) visit(static_cast<std::size_t>(r * columns + c));
  }
}

// These cells, and those too near to the boundary for a way to begin on them that have none with a
// way in reach: from there the nearest one is taken, however far off that is.
std::vector<bool> InSight::cut_off(const std::vector<bool>& lost) const {
  std::vector<bool> leads(lost.size(), false), all = lost;
  for (std::size_t at = 0; at < lost.size(); ++at) {
    leads[at] = !lost[at] && cells_.clearance_mm_lo[at] >= body_mm_;
  }
  const std::int64_t within =
      std::max<std::int64_t>(joins_within_mm(cells_) / cells_.cell_mm - 1, 1);
  for (std::size_t at = 0; at < lost.size(); ++at) {
    const std::int64_t clearance = cells_.clearance_mm_lo[at];
    if (lost[at] || clearance < 0 || clearance >= body_mm_) continue;
    bool some = false;
    for_each_around(at, within, [&](std::size_t other) { some = some || leads[other]; });
    all[at] = !some;
  }
  return all;
}

// These cells, and those from which a way may begin at one of them.
std::vector<bool> InSight::beside(const std::vector<bool>& lost) const {
  std::vector<bool> all = lost;
  const std::int64_t within = joins_within_mm(cells_) / cells_.cell_mm + 1;
  for (std::size_t at = 0; at < lost.size(); ++at) {
    if (!lost[at]) continue;
    for_each_around(at, within, [&](std::size_t other) {
      const std::int64_t clearance = cells_.clearance_mm_lo[other];
      if (clearance >= 0 && clearance < route_mm_) all[other] = true;
    });
  }
  return all;
}

}  // namespace rtac::analysis
