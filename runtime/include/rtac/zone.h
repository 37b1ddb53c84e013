// Read-only view of a baked zone: constant tables inside generated code, used by the safe
// controllers (doubles) and drawn by the simulator. Units are in the names.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rtac/types.h"

namespace rtac {

// Most cells of a zone that recoveries search. The compiler keeps to it, with wider cells where a
// zone is large; generated code refuses a runtime with a lower limit.
inline constexpr std::size_t max_zone_cells = 40'000;

struct ZoneOutline;  // rtac/zone_table.h

struct ZoneView {
  const char* name = "";
  // Edges a -> b in mm, the zone on their left; `ring_start[i]` is the first edge of ring i.
  const std::int32_t* edges_mm = nullptr;  // ax, ay, bx, by per edge
  std::size_t edge_count = 0;
  const std::size_t* ring_start = nullptr;
  std::size_t ring_count = 0;
  // Square cells, row by row from the south-west; lower bound of the clearance over the whole
  // closed cell in mm, 0 where it meets the boundary, -1 outside.
  std::int32_t origin_x_mm = 0, origin_y_mm = 0, cell_mm = 100, columns = 0, rows = 0;
  const std::int32_t* clearance_mm_lo = nullptr;
  // Which edges matter for a place: the tables of the module's kernel, of zones of more than 16
  // edges. Then what is asked below takes as long as a cell has edges, at most 16, for a place, and
  // as the cells that a segment passes; null: every question looks at all edges.
  const ZoneOutline* tree = nullptr;
};

// A zone with height: zones of the plane, each from one height to another, from below to above.
struct SlabView {
  const ZoneView* base = nullptr;
  double floor_m = 0, ceiling_m = 0;  // both belong to it
};
struct SolidView {
  const char* name = "";
  const SlabView* slabs = nullptr;
  std::size_t slab_count = 0;
};

// Signed distance (m) from `p` to the boundary: positive inside, negative outside. Exact up to
// double rounding: for controllers and for judging the true state, not for decisions. With a tree,
// places inside that are farther from the boundary than it tells (the manifest's `exact_mm`) get a
// lower bound, which is no less than that; far outside all edges are looked at.
double signed_clearance(const ZoneView& zone, Vec2 p);
// The same for the segment a-b: the smallest signed clearance on it. Exact for a segment inside the
// zone, up to the same bound; at most 0, and within 1 mm of the true minimum, for one that meets or
// crosses the boundary.
double signed_clearance(const ZoneView& zone, Vec2 a, Vec2 b);
// Is that at least `least_m`? Sooner known than the clearance itself.
bool keeps_clearance(const ZoneView& zone, Vec2 a, Vec2 b, double least_m);
// Of a zone with height, in space, likewise.
double signed_clearance(const SolidView& zone, Vec3 p);
// Closest point of the boundary.
Vec2 nearest_boundary(const ZoneView& zone, Vec2 p);
// Unit vector out of danger: outside towards the closest point of the boundary, inside away from
// it, on the boundary into the zone; between both sides on a vertex.
Vec2 inward(const ZoneView& zone, Vec2 p);
// How far (m) a disc may move from `a` towards `b` before it is not in the zone any more: until its
// middle is closer to the boundary than `radius_m`, or on it. 0 when that is so at `a`, infinite
// when it is nowhere so up to `b`. Divided by a speed, the time to leave. For controllers: the
// kernel of the module answers it in integers, never late (`..._leave_mm`).
double distance_to_leave(const ZoneView& zone, Vec2 a, Vec2 b, double radius_m = 0);

}  // namespace rtac
