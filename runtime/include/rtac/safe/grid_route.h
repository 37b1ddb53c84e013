// Shortest ways over the cells of a baked zone: bounded search, no allocation after construction.
#pragma once

#include <cstdint>
#include <vector>

#include "rtac/types.h"
#include "rtac/zone.h"

namespace rtac::safe {

struct Circle {
  Vec2 centre;
  double radius_m = 0;
};

struct RouteQuery {
  // Only cells whose clearance is at least this everywhere are entered.
  double clearance_m = 0;
  Vec2 start;
  // Robots that stand: no leg comes closer, except one that leads out of a circle which already
  // holds the start.
  FixedList<Circle, max_robots> avoid;
  // Points to which no leg may come nearer than where it begins (HELD robots behind a gate).
  FixedList<Vec2, max_robots> recede_from;
  // The first way-point is the start itself: for a way that begins where the last one was cut off,
  // and not quite where the robot stands.
  bool over_start = false;
};

// A test of places, as an interface so that the search is compiled once.
class PlaceTest {
 public:
  virtual ~PlaceTest() = default;
  [[nodiscard]] virtual bool accepts(Vec2 place, double clearance_m) const = 0;
};

class GridRoute {
 public:
  static constexpr std::size_t max_cells = max_zone_cells;

  // A zone with more cells than `max_cells`, or without any, is refused by every query.
  explicit GridRoute(const ZoneView& zone);

  // Fill `way` with the way-points after the start; false: no way. Of more way-points than a path
  // holds, the first ones (`cut`): whoever has driven them searches again from the last. A start in
  // a cell of too little clearance is joined to that cell within about half a metre that makes the
  // way shortest and can be reached straight without losing clearance; when there is none, to the
  // nearest one farther off, as is a goal.
  bool to_point(const RouteQuery& query, Vec2 goal, Path& way);
  // The same to the nearest place, along the way, that `test` accepts. Where it may only recede and
  // no way leads on from the middle of its own cell, it looks for one from those within reach.
  bool to_place(const RouteQuery& query, const PlaceTest& test, Path& way);
  // The nearest place that `test` accepts and that can be reached in one straight leg on which the
  // clearance stays at least `floor_m`.
  bool straight_to_place(const RouteQuery& query, const PlaceTest& test, double floor_m,
                         Path& way) const;
  // The rule for robots of `query` alone: avoided circles and points to recede from.
  [[nodiscard]] bool leg_allowed(const RouteQuery& query, Vec2 a, Vec2 b) const;

  // Length of the cells' way found last, before it was straightened, in metres.
  [[nodiscard]] double length_m() const { return length_m_; }
  // Length of the way found last, straightened, in metres, what was cut off included.
  [[nodiscard]] double way_length_m() const { return way_length_m_; }
  // The way found last goes on after its last way-point.
  [[nodiscard]] bool cut() const { return cut_; }

 private:
  struct Goal;

  [[nodiscard]] int cell_of(Vec2 p) const;  // -1: outside the grid
  [[nodiscard]] Vec2 centre(int cell) const;
  [[nodiscard]] bool admissible(int cell, double clearance_m) const;
  [[nodiscard]] bool straight(const RouteQuery& query, Vec2 a, Vec2 b) const;
  template <class Accept>
  [[nodiscard]] int nearest_cell(Vec2 p, const Accept& accept) const;
  [[nodiscard]] bool joins(const RouteQuery& query, Vec2 p, int cell, bool leaving) const;
  [[nodiscard]] int landing(const RouteQuery& query, Vec2 goal) const;
  bool open_own_start(const RouteQuery& query, const Goal& goal);
  void open_starts(const RouteQuery& query, const Goal& goal);
  void open(const Goal& goal, int cell, int parent, double cost_m);
  void forget();
  bool begin_and_search(const RouteQuery& query, const Goal& goal, int& last);
  bool search(const RouteQuery& query, const Goal& goal, int& last);
  void relax(const RouteQuery& query, const Goal& goal, int from);
  void trace(const RouteQuery& query, int last, const Vec2* end, Path& way);
  void sift_up(int at);
  void sift_down(int at);
  int pop();

  const ZoneView& zone_;
  std::vector<float> cost_, rank_;  // metres from the start; plus the estimate to the goal
  std::vector<std::int32_t> parent_, heap_, place_in_heap_;
  int heap_size_ = 0;
  double length_m_ = 0, way_length_m_ = 0;
  bool cut_ = false;
};

// Smallest distance from `p` to the segment a-b.
double distance_to_segment(Vec2 p, Vec2 a, Vec2 b);
// Distance to `from` does not shrink while going straight from a to b.
inline bool recedes(Vec2 a, Vec2 b, Vec2 from) {
  return dot(b - a, a - from) >= 0;
}

}  // namespace rtac::safe
