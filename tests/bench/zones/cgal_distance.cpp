// The best that CGAL has for distances from edges, on doubles: a tree of boxes, which exists in
// three dimensions, and the Voronoi diagram of the edges with a hierarchy. It has no distances of
// segments from edges; whether they meet, the tree of boxes knows.
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Segment_Delaunay_graph_hierarchy_2.h>

#include <cmath>
#include <memory>

#include "tests/bench/zones/contender.h"

namespace rtac::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Segments = std::vector<Kernel::Segment_3>;
using Primitive = CGAL::AABB_segment_primitive<Kernel, Segments::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

struct Boxes {
  Segments segments;
  Tree tree;
};
std::shared_ptr<Boxes> boxes_of(const Outline& outline) {
  const auto all = std::make_shared<Boxes>();
  for (const auto& ring : outline.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const GridPlace a = ring[i], b = ring[(i + 1) % ring.size()];
      all->segments.emplace_back(Kernel::Point_3(a.x_mm, a.y_mm, 0),
                                 Kernel::Point_3(b.x_mm, b.y_mm, 0));
    }
  }
  all->tree.insert(all->segments.cbegin(), all->segments.cend());
  all->tree.build();
  all->tree.accelerate_distance_queries();
  return all;
}

Contender box_tree(const Outline& outline, const std::vector<GridPlace>& places) {
  const auto all = boxes_of(outline);
  const auto points = std::make_shared<std::vector<Kernel::Point_3>>();
  for (const GridPlace& p : places) points->emplace_back(p.x_mm, p.y_mm, 0);
  return {"CGAL, tree of boxes", [all, points](std::size_t first, std::size_t end) {
            double sum = 0;
            for (std::size_t i = first; i < end; ++i) {
              sum += std::sqrt(all->tree.squared_distance((*points)[i]));
            }
            return sum;
          }};
}

using Traits = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Kernel>;
using Graph = CGAL::Segment_Delaunay_graph_hierarchy_2<Traits>;

double distance(const Graph::Site_2& site, const Kernel::Point_2& p) {
  const double squared = site.is_point() ? CGAL::squared_distance(site.point(), p)
                                         : CGAL::squared_distance(site.segment(), p);
  return std::sqrt(squared);
}

Contender voronoi_diagram(const Outline& outline, const std::vector<GridPlace>& places) {
  const auto graph = std::make_shared<Graph>();
  for (const auto& ring : outline.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const GridPlace a = ring[i], b = ring[(i + 1) % ring.size()];
      graph->insert(Graph::Site_2::construct_site_2(Kernel::Point_2(a.x_mm, a.y_mm),
                                                    Kernel::Point_2(b.x_mm, b.y_mm)));
    }
  }
  const auto points = std::make_shared<std::vector<Kernel::Point_2>>();
  for (const GridPlace& p : places) points->emplace_back(p.x_mm, p.y_mm);
  return {"CGAL, Voronoi diagram with hierarchy",
          [graph, points](std::size_t first, std::size_t end) {
            double sum = 0;
            for (std::size_t i = first; i < end; ++i) {
              const auto& p = (*points)[i];
              sum += distance(graph->nearest_neighbor(p)->site(), p);
            }
            return sum;
          }};
}

}  // namespace

std::vector<Contender> cgal_clearance(const Outline& outline,
                                      const std::vector<GridPlace>& places) {
  std::vector<Contender> all{box_tree(outline, places)};
  // Beyond this it takes minutes to build.
  if (outline.vertices() <= 20'000) all.push_back(voronoi_diagram(outline, places));
  return all;
}

std::vector<Contender> cgal_legs(const Outline& outline, const std::vector<GridPlace>& legs) {
  const auto all = boxes_of(outline);
  const auto segments = std::make_shared<Segments>();
  for (std::size_t i = 0; i + 1 < legs.size(); i += 2) {
    segments->emplace_back(Kernel::Point_3(legs[i].x_mm, legs[i].y_mm, 0),
                           Kernel::Point_3(legs[i + 1].x_mm, legs[i + 1].y_mm, 0));
  }
  return {{"CGAL, tree of boxes whether they meet",
           [all, segments](std::size_t first, std::size_t end) {
             int met = 0;
             for (std::size_t i = first; i < end; ++i)
               met += all->tree.do_intersect((*segments)[i]);
             return static_cast<double>(met);
           },
           false}};
}

}  // namespace rtac::bench
