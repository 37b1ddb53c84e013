// The best that CGAL has for places in a polygon, on doubles: locating a place in a triangulation
// with constraints, by a walk through its triangles from where a hierarchy says, or in the
// trapezoids of an arrangement. Both say in which face it is; which faces are in the zone is known
// beforehand.
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_non_caching_segment_traits_2.h>
#include <CGAL/Arr_trapezoid_ric_point_location.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_hierarchy_2.h>
#include <CGAL/Triangulation_vertex_base_2.h>

#include <memory>
#include <utility>

#include "tests/bench/zones/contender.h"

namespace rtac::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Points = std::vector<Kernel::Point_2>;

Points points_of(const std::vector<GridPlace>& places) {
  Points points;
  for (const GridPlace& p : places) points.emplace_back(p.x_mm, p.y_mm);
  return points;
}

namespace triangles {
using Vertex =
    CGAL::Triangulation_hierarchy_vertex_base_2<CGAL::Triangulation_vertex_base_2<Kernel>>;
using Face = CGAL::Triangulation_face_base_with_info_2<
    int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;  // info: edges to infinity
using Flat =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                               CGAL::No_constraint_intersection_tag>;
using Hierarchy = CGAL::Triangulation_hierarchy_2<Flat>;

// Faces in the zone are those behind an odd number of constraints.
void mark(Hierarchy& all) {
  for (const auto& face : all.all_face_handles()) face->info() = -1;
  std::vector<Hierarchy::Face_handle> queue{all.infinite_face()};
  queue.front()->info() = 0;
  while (!queue.empty()) {
    const auto face = queue.back();
    queue.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      if (next->info() >= 0) continue;
      next->info() = face->info() ^ (face->is_constrained(i) ? 1 : 0);
      queue.push_back(next);
    }
  }
}
}  // namespace triangles

Contender triangulation(const Outline& outline, const std::shared_ptr<Points>& points) {
  using namespace triangles;
  const auto all = std::make_shared<Hierarchy>();
  for (const auto& ring : outline.rings) {
    const Points corners = points_of(ring);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      all->insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
    }
  }
  mark(*all);
  return {"CGAL, triangulation with hierarchy", [all, points](std::size_t first, std::size_t end) {
            int inside = 0;
            for (std::size_t i = first; i < end; ++i) inside += all->locate((*points)[i])->info();
            return static_cast<double>(inside);
          }};
}

namespace trapezoids {
using Traits = CGAL::Arr_non_caching_segment_traits_2<Kernel>;
using Dcel = CGAL::Arr_face_extended_dcel<Traits, int>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;
using Locator = CGAL::Arr_trapezoid_ric_point_location<Arrangement>;
struct Located {
  Arrangement arrangement;
  Locator locator;
};

void mark(Arrangement& all) {
  for (auto face = all.faces_begin(); face != all.faces_end(); ++face) face->set_data(0);
  // Holes of the unbounded face are outer rings; holes of their faces, holes.
  for (auto outer = all.unbounded_face()->holes_begin(); outer != all.unbounded_face()->holes_end();
       ++outer) {
    const Arrangement::Halfedge_handle edge = (*outer)->twin();
    edge->face()->set_data(1);
  }
}
}  // namespace trapezoids

Contender trapezoid_map(const Outline& outline, const std::shared_ptr<Points>& points) {
  using namespace trapezoids;
  std::vector<Traits::X_monotone_curve_2> edges;
  for (const auto& ring : outline.rings) {
    const Points corners = points_of(ring);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      edges.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
    }
  }
  const auto all = std::make_shared<Located>();
  CGAL::insert_non_intersecting_curves(all->arrangement, edges.begin(), edges.end());
  mark(all->arrangement);
  all->locator.attach(all->arrangement);
  return {"CGAL, trapezoids of an arrangement", [all, points](std::size_t first, std::size_t end) {
            int inside = 0;
            for (std::size_t i = first; i < end; ++i) {
              const auto found = all->locator.locate((*points)[i]);
              // On the boundary: inside, as it belongs to the zone.
              const auto* face = boost::get<Arrangement::Face_const_handle>(&found);
              inside += face == nullptr ? 1 : (*face)->data();
            }
            return static_cast<double>(inside);
          }};
}

}  // namespace

std::vector<Contender> cgal_inside(const Outline& outline, const std::vector<GridPlace>& places) {
  const auto points = std::make_shared<Points>(points_of(places));
  return {triangulation(outline, points), trapezoid_map(outline, points)};
}

}  // namespace rtac::bench
