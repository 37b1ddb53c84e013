// The only unit that includes CGAL: an arrangement of all edges, winding numbers per face, and the
// boundary between the faces that are kept and those that are not.
//
// Why not General_polygon_set_2: it wants every operand valid (no two pieces overlap, no hole
// touches its ring between vertices), which a heap of offset pieces is not, and the rings it
// returns depend on the order of the operands. Winding numbers need neither.
#include "compiler/geometry/overlay.h"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "compiler/geometry/looks.h"
#include "compiler/geometry/ring.h"

namespace rtac::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using SegmentTraits = CGAL::Arr_segment_traits_2<Kernel>;
using Segment = SegmentTraits::X_monotone_curve_2;
// The data of a curve is the index of the edge it came from; where edges overlap, CGAL keeps the
// set of their indices.
using Traits = CGAL::Arr_consolidated_curve_data_traits_2<SegmentTraits, std::uint32_t>;

struct FaceData {
  bool visited = false;
  bool kept = false;
  std::int32_t left_winding = 0, right_winding = 0;
  std::size_t component = 0;
};
using Dcel = CGAL::Arr_face_extended_dcel<Traits, FaceData>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;
using Halfedge = Arrangement::Halfedge_handle;
using Face = Arrangement::Face_handle;
using Vertex = Arrangement::Vertex_handle;

// What crossing an edge from its right to its left, seen along increasing x (then y), adds to the
// winding number of its operand.
struct EdgeMeaning {
  bool of_left_operand;
  std::int32_t step;
};

struct Input {
  std::vector<Traits::X_monotone_curve_2> curves;
  std::vector<EdgeMeaning> meanings;

  void add(const Segment& segment, bool of_left_operand, std::int32_t step) {
    const auto index = static_cast<std::uint32_t>(meanings.size());
    meanings.push_back({of_left_operand, step});
    curves.emplace_back(segment, index);
  }
};

void add_rings(const std::vector<Ring>& rings, bool of_left_operand, Input& input) {
  for (const Ring& ring : rings) {
    std::vector<Kernel::Point_2> points;
    points.reserve(ring.size());
    for (const Point& p : ring) points.emplace_back(Kernel::FT(p.x), Kernel::FT(p.y));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t next = (i + 1) % ring.size();
      const int order =
          ring[i].x != ring[next].x ? cmp(ring[i].x, ring[next].x) : cmp(ring[i].y, ring[next].y);
      if (order == 0) continue;
      input.add(Segment(points[i], points[next]), of_left_operand, order < 0 ? 1 : -1);
    }
  }
}

bool keeps(const FaceData& face, Combine how) {
  const bool left = face.left_winding > 0;
  const bool right = face.right_winding > 0;
  switch (how) {
    case Combine::unite:
      return left || right;
    case Combine::intersect:
      return left && right;
    case Combine::subtract:
      return left && !right;
  }
  return false;
}

// Calls `visit` for one halfedge of every edge on the boundary of `face`, with that face on its
// left.
template <typename Visit>
void for_each_halfedge(Face face, Visit visit) {
  const auto walk = [&](Arrangement::Ccb_halfedge_circulator start) {
    auto at = start;
    do {
      visit(Halfedge(at));
    } while (++at != start);
  };
  for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb) walk(*ccb);
  for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) walk(*ccb);
}

void compute_windings(Arrangement& arrangement, const Input& input, Combine how) {
  std::vector<Face> stack{arrangement.unbounded_face()};
  stack.back()->data().visited = true;
  while (!stack.empty()) {
    const Face face = stack.back();
    stack.pop_back();
    face->data().kept = keeps(face->data(), how);
    for_each_halfedge(face, [&](Halfedge edge) {
      const Face across = edge->twin()->face();
      if (across->data().visited) return;
      FaceData data = face->data();
      // `face` is on the left of `edge`; the far face is on the right.
      const std::int32_t to_right = edge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? -1 : 1;
      const auto& indices = edge->curve().data();
      for (auto index = indices.begin(); index != indices.end(); ++index) {
        const EdgeMeaning& meaning = input.meanings[*index];
        (meaning.of_left_operand ? data.left_winding : data.right_winding) +=
            to_right * meaning.step;
      }
      across->data() = data;
      stack.push_back(across);
    });
  }
}

bool is_boundary(Halfedge edge) {
  return edge->face()->data().kept && !edge->twin()->face()->data().kept;
}

// Numbers the interior-connected components of the kept faces from 1.
std::size_t number_components(Arrangement& arrangement) {
  std::size_t count = 0;
  for (Face seed : arrangement.face_handles()) {
    if (!seed->data().kept || seed->data().component != 0) continue;
    seed->data().component = ++count;
    std::vector<Face> stack{seed};
    while (!stack.empty()) {
      const Face face = stack.back();
      stack.pop_back();
      for_each_halfedge(face, [&](Halfedge edge) {
        const Face across = edge->twin()->face();
        if (!across->data().kept || across->data().component != 0) return;
        across->data().component = count;
        stack.push_back(across);
      });
    }
  }
  return count;
}

// The next boundary edge with the same piece of interior on its left: turning about the vertex
// through kept faces only.
Halfedge next_boundary(Halfedge edge) {
  Halfedge next = edge->next();
  while (!is_boundary(next)) next = next->twin()->next();
  return next;
}

using VertexLoop = std::vector<Vertex>;

// A walk along the boundary of one interior-connected component passes a vertex several times
// where a hole touches another ring. Cutting it there gives simple rings, always the same ones:
// the walk is a tree of cycles, and its cycles do not depend on where it starts.
void cut_into_simple_loops(const VertexLoop& walk, std::vector<VertexLoop>& loops) {
  VertexLoop open;
  std::map<const void*, std::size_t> position;
  for (const Vertex vertex : walk) {
    const void* key = &*vertex;
    const auto seen = position.find(key);
    if (seen != position.end()) {
      const std::size_t from = seen->second;
      loops.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(from), open.end());
      for (std::size_t i = from; i < open.size(); ++i) position.erase(&*open[i]);
      open.resize(from);
    }
    position.emplace(key, open.size());
    open.push_back(vertex);
  }
  if (!open.empty()) loops.push_back(std::move(open));
}

Ring to_ring(const VertexLoop& loop) {
  Ring ring;
  ring.reserve(loop.size());
  for (const Vertex vertex : loop) {
    ring.push_back({vertex->point().x().exact(), vertex->point().y().exact()});
  }
  return canonical(ring);
}

// The arrangement of the edges, with the windings of its faces.
void arrange(const Input& input, Combine how, Arrangement& arrangement) {
  looks() += overlaid(static_cast<std::int64_t>(input.curves.size()));
  CGAL::insert(arrangement, input.curves.begin(), input.curves.end());
  compute_windings(arrangement, input, how);
}

std::vector<PolygonWithHoles> extract(const Input& input, Combine how) {
  Arrangement arrangement;
  arrange(input, how, arrangement);
  std::vector<PolygonWithHoles> parts(number_components(arrangement));
  std::set<const void*> done;
  for (Halfedge start : arrangement.halfedge_handles()) {
    if (!is_boundary(start) || done.count(&*start) != 0) continue;
    VertexLoop walk;
    Halfedge edge = start;
    do {
      done.insert(&*edge);
      walk.push_back(edge->source());
      edge = next_boundary(edge);
    } while (edge != start);
    std::vector<VertexLoop> loops;
    cut_into_simple_loops(walk, loops);
    PolygonWithHoles& part = parts[start->face()->data().component - 1];
    for (const VertexLoop& loop : loops) {
      Ring ring = to_ring(loop);
      if (twice_area(ring) > 0) {
        part.outer = std::move(ring);
      } else {
        part.holes.push_back(std::move(ring));
      }
    }
  }
  for (PolygonWithHoles& part : parts) {
    std::sort(part.holes.begin(), part.holes.end(), ring_order);
  }
  std::sort(parts.begin(), parts.end(), [](const PolygonWithHoles& a, const PolygonWithHoles& b) {
    return ring_order(a.outer, b.outer);
  });
  return parts;
}

struct DirectedSegment {
  Segment segment;
  std::int32_t step;  // see EdgeMeaning
};

// The boundary of what the pieces [from, to) cover. Neighbours in the list lie next to one another:
// uniting them first removes most edges before they can meet those of pieces far away. Parts of
// edges keep the lines of the edges that they are parts of, so that the exact numbers of one level
// are not those of the level below combined.
std::vector<DirectedSegment> united(const std::vector<Ring>& pieces, std::size_t from,
                                    std::size_t to) {
  constexpr std::size_t at_once = 64;
  Input input;
  if (to - from <= at_once) {
    add_rings({pieces.begin() + static_cast<std::ptrdiff_t>(from),
               pieces.begin() + static_cast<std::ptrdiff_t>(to)},
              true, input);
  } else {
    const std::size_t middle = from + (to - from) / 2;
    for (const auto& [a, b] : {std::pair{from, middle}, std::pair{middle, to}}) {
      for (const DirectedSegment& each : united(pieces, a, b)) {
        input.add(each.segment, true, each.step);
      }
    }
  }
  Arrangement arrangement;
  arrange(input, Combine::unite, arrangement);
  std::vector<DirectedSegment> boundary;
  for (Halfedge edge : arrangement.halfedge_handles()) {
    if (!is_boundary(edge)) continue;
    const Segment& segment = edge->curve();  // without the indices
    boundary.push_back({segment, edge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? 1 : -1});
  }
  return boundary;
}

}  // namespace

std::vector<PolygonWithHoles> overlay(const std::vector<Ring>& left, const std::vector<Ring>& right,
                                      Combine how) {
  Input input;
  add_rings(left, true, input);
  add_rings(right, false, input);
  return extract(input, how);
}

std::vector<PolygonWithHoles> overlay_band(const std::vector<Ring>& rings,
                                           const std::vector<Ring>& pieces, Combine how) {
  Input input;
  add_rings(rings, true, input);
  for (const DirectedSegment& each : united(pieces, 0, pieces.size())) {
    input.add(each.segment, false, each.step);
  }
  return extract(input, how);
}

}  // namespace rtac::geometry
