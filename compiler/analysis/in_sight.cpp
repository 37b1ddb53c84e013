#include "compiler/analysis/in_sight.h"

#include <algorithm>
#include <cmath>

#include "compiler/analysis/liveness.h"
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

InSight::InSight(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
                 const ir::Decision& decision, const ir::Recovery& recovery)
    : cells_(cells), grid_(grid_of(cells)), route_mm_(recovery.route_clearance_mm) {
  if (!ir::goes_back(recovery.kind)) return;
  for (const std::int64_t goal_mm : goals_mm(decision, recovery)) {
    legs_.emplace_back(edges, grid_, in_mm(decision.body.radius_mm), in_mm(goal_mm));
  }
}

std::optional<std::int64_t> InSight::longest_mm(std::size_t at, std::size_t goal) {
  const auto leg = goal < legs_.size() ? legs_[goal].longest_from(at) : std::nullopt;
  return leg ? std::optional(whole_mm(*leg)) : std::nullopt;
}

std::optional<std::int64_t> InSight::longest_deeper_mm(const Marks& lost, const Marks& endless) {
  std::int64_t longest = 0;
  for (std::size_t goal = 1; goal < legs_.size(); ++goal) {
    const bool ends = std::ranges::count(endless[goal], true) == 0;
    const std::vector<bool> from = beside(lost[goal]);
    for (std::size_t at = 0; at < from.size(); ++at) {
      if (!from[at]) continue;
      const auto leg = longest_mm(at, goal);
      if (!leg && !ends) return std::nullopt;
      longest = std::max(longest, leg ? *leg : whole_mm(legs_[goal].farthest_from(at)));
    }
  }
  return longest;
}

// These cells, and those from which a way may begin at one of them.
std::vector<bool> InSight::beside(const std::vector<bool>& lost) const {
  std::vector<bool> all = lost;
  const std::int64_t within = joins_within_mm(cells_) / cells_.cell_mm + 1;
  const auto columns = static_cast<std::int64_t>(cells_.columns);
  const auto rows = static_cast<std::int64_t>(cells_.rows);
  for (std::size_t at = 0; at < lost.size(); ++at) {
    if (!lost[at]) continue;
    const auto column = static_cast<std::int64_t>(at) % columns;
    const auto row = static_cast<std::int64_t>(at) / columns;
    for (auto r = std::max<std::int64_t>(0, row - within); r <= std::min(rows - 1, row + within);
         ++r) {
      for (auto c = std::max<std::int64_t>(0, column - within);
           c <= std::min(columns - 1, column + within); ++c) {
        const auto other = static_cast<std::size_t>(r * columns + c);
        const std::int64_t clearance = cells_.clearance_mm_lo[other];
        if (clearance >= 0 && clearance < route_mm_) all[other] = true;
      }
    }
  }
  return all;
}

}  // namespace rtac::analysis
