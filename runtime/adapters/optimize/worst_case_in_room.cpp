#include <cstddef>
#include <cstdint>

#include "rtac/optimize/worst_case.h"

namespace rtac {
namespace {

constexpr double m_per_mm = 1e-3;

struct Edge {
  std::int64_t ax, ay, bx, by;  // mm
};

Edge edge_of(const ZoneView& zone, std::size_t i) {
  const std::int32_t* e = zone.edges_mm + 4 * i;
  return {e[0], e[1], e[2], e[3]};
}

// One ring that never turns right. Exact: 32-bit coordinates, 64-bit products.
bool convex(const ZoneView& zone) {
  if (zone.ring_count != 1) return false;
  for (std::size_t i = 0; i < zone.edge_count; ++i) {
    const Edge e = edge_of(zone, i), next = edge_of(zone, (i + 1) % zone.edge_count);
    const std::int64_t ux = e.bx - e.ax, uy = e.by - e.ay;
    const std::int64_t vx = next.bx - next.ax, vy = next.by - next.ay;
    if (ux * vy < uy * vx) return false;
  }
  return true;
}

// The zone is on the left of its edges, so that outward is to their right.
ReachProblem across(const ReachProblem& problem, const Edge& e) {
  const Vec2 a{double(e.ax) * m_per_mm, double(e.ay) * m_per_mm};
  const Vec2 right{double(e.by - e.ay), double(e.ax - e.bx)};
  ReachProblem result = problem;
  result.normal = (1 / norm(right)) * right;
  result.offset_m = dot(result.normal, a);
  return result;
}

// The weaker of two: invalid, then stopped early, then converged.
SearchStatus weaker(SearchStatus a, SearchStatus b) {
  for (const auto s : {SearchStatus::invalid_problem, SearchStatus::stopped_early}) {
    if (a == s || b == s) return s;
  }
  return SearchStatus::converged;
}

}  // namespace

RoomWorstCase worst_case_in_room(const ReachProblem& problem, const ZoneView& room) {
  RoomWorstCase result;
  if (room.edges_mm == nullptr || room.edge_count < 3) return result;
  result.status = SearchStatus::not_convex;
  if (!convex(room)) return result;
  result.status = SearchStatus::converged;
  for (std::size_t i = 0; i < room.edge_count; ++i) {
    result.edges.push_back(worst_case(across(problem, edge_of(room, i))));
    const WorstCase& found = result.edges.back();
    result.status = weaker(result.status, found.status);
    if (found.excursion_m > result.edges[result.worst_edge].excursion_m) result.worst_edge = i;
  }
  return result;
}

}  // namespace rtac
