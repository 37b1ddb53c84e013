// What an author may write as a polygon, and how each mistake is named: kind, ring, vertices as
// written and the exact place. A diagnostic can only be as good as this.
#include <gtest/gtest.h>

#include "compiler/geometry/sweep.h"
#include "testing.h"

namespace rtac::geometry {
namespace {

using Kind = Problem::Kind;

Problem problem(const Ring& outer, const std::vector<Ring>& holes = {}) {
  const auto result = Region::polygon(outer, holes);
  EXPECT_TRUE(std::holds_alternative<Problem>(result));
  return std::holds_alternative<Problem>(result) ? std::get<Problem>(result) : Problem{};
}

void expect_problem(const Problem& p, Kind kind, std::size_t ring, std::size_t vertex,
                    std::size_t other, const Point& where) {
  EXPECT_EQ(p.kind, kind);
  EXPECT_EQ(p.ring, ring);
  EXPECT_EQ(p.vertex, vertex);
  EXPECT_EQ(p.other, other);
  EXPECT_EQ(p.where.x, where.x);
  EXPECT_EQ(p.where.y, where.y);
}

const Ring kBig = box_ring(0, 0, 10000, 10000);

TEST(Validate, FewerThanThreeDifferentVerticesAreTooShort) {
  expect_problem(problem({}), Kind::too_short, 0, 0, 0, {});
  expect_problem(problem({pt(1, 1), pt(2, 2)}), Kind::too_short, 0, 0, 0, pt(1, 1));
  // Repeating a vertex does not make a third one.
  expect_problem(problem({pt(0, 0), pt(1, 0), pt(1, 0)}), Kind::too_short, 0, 0, 0, pt(0, 0));
  expect_problem(problem(kBig, {{pt(1, 1)}}), Kind::too_short, 1, 0, 0, pt(1, 1));
}

TEST(Validate, RepeatedVertexNamesBothIndices) {
  expect_problem(problem({pt(0, 0), pt(2, 0), pt(2, 0), pt(0, 2)}), Kind::repeats_vertex, 0, 2, 1,
                 pt(2, 0));
  // An explicit closing vertex, as GeoJSON writes it.
  expect_problem(problem({pt(0, 0), pt(2, 0), pt(0, 2), pt(0, 0)}), Kind::repeats_vertex, 0, 3, 0,
                 pt(0, 0));
}

TEST(Validate, CrossingEdgesAreNamedWithTheirExactMeetingPoint) {
  // Edges 0-1 and 2-3 of (0,0) (3,1) (3,0) (0,2): y = x/3 and y = (6 - 2x)/3 meet at (2, 2/3).
  expect_problem(problem({pt(0, 0), pt(3, 1), pt(3, 0), pt(0, 2)}), Kind::self_intersects, 0, 0, 2,
                 {q(2), q(2, 3)});
}

TEST(Validate, VertexOnAnEdgeIsASelfIntersection) {
  expect_problem(problem({pt(0, 0), pt(4, 0), pt(4, 4), pt(2, 0), pt(0, 4)}), Kind::self_intersects,
                 0, 0, 2, pt(2, 0));
}

TEST(Validate, SpikeIsASelfIntersectionAtItsTip) {
  expect_problem(problem({pt(0, 0), pt(6, 0), pt(4, 0), pt(4, 4)}), Kind::self_intersects, 0, 0, 1,
                 pt(6, 0));
  // Edges that overlap without sharing a vertex meet first at the lowest-left common point.
  expect_problem(problem({pt(0, 0), pt(6, 0), pt(6, 2), pt(5, 0), pt(1, 0), pt(0, 2)}),
                 Kind::self_intersects, 0, 0, 2, pt(5, 0));
}

TEST(Validate, FirstIntersectionInTheOrderOfVerticesIsReported) {
  const Problem p = problem({pt(0, 0), pt(1, 4), pt(2, 0), pt(3, 4), pt(4, 0), pt(4, 2), pt(0, 2)});
  expect_problem(p, Kind::self_intersects, 0, 0, 5, {q(1, 2), q(2)});
}

TEST(Validate, RingOnOneLineHasNoArea) {
  expect_problem(problem({pt(0, 0), pt(2, 2), pt(1, 1)}), Kind::no_area, 0, 0, 0, pt(0, 0));
  expect_problem(problem(kBig, {{pt(1, 1), pt(2, 1), pt(3, 1)}}), Kind::no_area, 1, 0, 0, pt(1, 1));
}

TEST(Validate, KindsAreReportedInTheirOrder) {
  // A repeated vertex in the hole comes before the crossing of the outer ring.
  const Ring bow{pt(0, 0), pt(4, 4), pt(4, 0), pt(0, 4)};
  const Ring repeats{pt(1, 1), pt(2, 1), pt(2, 1), pt(1, 2)};
  EXPECT_EQ(problem(bow, {repeats}).kind, Kind::repeats_vertex);
  EXPECT_EQ(problem(bow, {{pt(7, 7), pt(8, 8), pt(9, 9)}}).kind, Kind::self_intersects);
}

TEST(Validate, HoleMustLieInside) {
  expect_problem(problem(kBig, {box_ring(20000, 0, 21000, 1000)}), Kind::hole_outside_ring, 1, 0, 0,
                 pt(20, 0));
  // The vertex that is outside is named, not the one before it.
  expect_problem(problem(kBig, {{pt(9, 5), pt(11, 5), pt(9, 6)}}), Kind::hole_outside_ring, 1, 1, 0,
                 pt(11, 5));
  expect_problem(problem(kBig, {{pt(11, 4), pt(11, 5), pt(9, 5)}}), Kind::hole_outside_ring, 1, 0,
                 0, pt(11, 4));
  // A part of an edge in common.
  expect_problem(problem(kBig, {box_ring(9000, 4000, 10000, 5000)}), Kind::hole_outside_ring, 1, 0,
                 1, pt(10, 4));
  // Touching from outside, and through a vertex to the outside.
  expect_problem(problem(kBig, {{pt(10, 5), pt(12, 4), pt(12, 6)}}), Kind::hole_outside_ring, 1, 1,
                 0, pt(12, 4));
  expect_problem(problem(kBig, {{pt(9, 9), pt(10, 10), pt(12, 9)}}), Kind::hole_outside_ring, 1, 2,
                 0, pt(12, 9));
  // Around the outer ring instead of inside it, touching it or not.
  EXPECT_EQ(problem(box_ring(4000, 4000, 5000, 5000), {kBig}).kind, Kind::hole_outside_ring);
  EXPECT_EQ(problem({pt(0, 5), pt(5, 4), pt(5, 6)}, {kBig}).kind, Kind::hole_outside_ring);
  // Outside although all vertices touch: across a notch. No vertex is to blame, but an edge.
  const Problem notch =
      problem({pt(0, 0), pt(8, 0), pt(8, 8), pt(4, 1), pt(0, 8)}, {{pt(8, 8), pt(4, 1), pt(0, 8)}});
  EXPECT_EQ(notch.kind, Kind::hole_outside_ring);
  EXPECT_TRUE(notch.of_edge);
}

TEST(Validate, HolesMustNotOverlap) {
  const Ring first = box_ring(1000, 1000, 4000, 4000);
  expect_problem(problem(kBig, {first, box_ring(3000, 2000, 6000, 3000)}), Kind::holes_overlap, 1,
                 1, 2, pt(4, 2));
  // A part of an edge in common.
  expect_problem(problem(kBig, {first, box_ring(4000, 2000, 5000, 3000)}), Kind::holes_overlap, 1,
                 1, 2, pt(4, 2));
  expect_problem(problem(kBig, {first, box_ring(2000, 2000, 3000, 3000)}), Kind::holes_overlap, 1,
                 0, 2, pt(2, 2));
  // One in the other, touching it in a point.
  EXPECT_EQ(problem(kBig, {first, {pt(1, 1), pt(3, 2), pt(2, 3)}}).kind, Kind::holes_overlap);
  EXPECT_EQ(problem(kBig, {{pt(1, 1), pt(3, 2), pt(2, 3)}, first}).kind, Kind::holes_overlap);
  expect_problem(
      problem(kBig, {box_ring(6000, 6000, 7000, 7000), box_ring(2000, 2000, 3000, 3000), first}),
      Kind::holes_overlap, 2, 0, 3, pt(2, 2));
}

TEST(Validate, RingsMayTouchInPoints) {
  // A vertex on an edge of the outer ring, one on its corner, two holes corner to corner, and a
  // hole on the edge of another; rings of both orientations.
  const Ring on_edge{pt(8, 4), pt(10, 5), pt(8, 6)};
  const Ring in_corner{pt(0, 0), pt(2, 1), pt(1, 2)};
  const Ring first = box_ring(3000, 3000, 4000, 4000);
  const Ring at_corner = box_ring(4000, 4000, 5000, 5000);
  const Ring at_edge{pt(7, 3), pt(6, 4), {q(4), q(7, 2)}};
  const Region all = polygon(kBig, {on_edge, in_corner, first, at_corner, at_edge});
  Ring turned = first;
  std::reverse(turned.begin(), turned.end());
  EXPECT_EQ(text(all), text(polygon(kBig, {at_edge, at_corner, turned, in_corner, on_edge})));
  // The same as by the algebra of zones.
  Region subtracted = polygon(kBig);
  for (const Ring& hole : {on_edge, in_corner, first, at_corner, at_edge}) {
    subtracted = subtracted.subtract(polygon(hole));
  }
  EXPECT_EQ(text(all), text(subtracted));
  EXPECT_TRUE(snap_inside(all).has_value());
}

TEST(Validate, TouchesMustNotCutTheArea) {
  // One hole from edge to edge.
  expect_problem(problem(kBig, {{pt(0, 5), pt(5, 4), pt(10, 5), pt(5, 6)}}), Kind::cuts_area, 1, 1,
                 0, pt(10, 5));
  // Two holes that touch each other at two points.
  const Ring cup{pt(2, 2), pt(6, 2), pt(6, 6), pt(4, 3), pt(2, 6)};
  const Ring lid{pt(2, 6), pt(6, 6), pt(4, 8)};
  EXPECT_EQ(problem(kBig, {cup, lid}).kind, Kind::cuts_area);
  // A chain of holes from edge to edge; without its last link it cuts nothing.
  const auto link = [](long x) { return Ring{pt(x, 5), pt(x + 1, 4), pt(x + 2, 5), pt(x + 1, 6)}; };
  std::vector<Ring> chain{link(0), link(2), link(4), link(6)};
  EXPECT_TRUE(std::holds_alternative<Region>(Region::polygon(kBig, chain)));
  chain.push_back(link(8));
  expect_problem(problem(kBig, chain), Kind::cuts_area, 5, 1, 0, pt(10, 5));
  // Several holes at one point cut nothing.
  std::vector<Ring> star;
  for (long k = 0; k < 3; ++k) star.push_back({pt(5, 5), pt(2 + 3 * k, 1), pt(3 + 3 * k, 1)});
  EXPECT_TRUE(std::holds_alternative<Region>(Region::polygon(kBig, star)));
}

TEST(Validate, AnyOrientationAndCollinearVerticesAreAccepted) {
  const Region a = polygon({pt(0, 0), pt(0, 4), pt(2, 4), pt(4, 4), pt(4, 0)},
                           {{pt(1, 1), pt(2, 1), pt(3, 1), pt(3, 3), pt(1, 3)}});
  const Region b =
      polygon({pt(4, 4), pt(0, 4), pt(0, 0), pt(4, 0)}, {{pt(3, 3), pt(3, 1), pt(1, 1), pt(1, 3)}});
  EXPECT_EQ(text(a), text(b));
  EXPECT_EQ(text(a), "part\n(0 0)(4 0)(4 4)(0 4)\n(1 1)(1 3)(3 3)(3 1)\n");
}

TEST(Validate, NearMissesOfOneBillionthAreAccepted) {
  // The vertex above the edge by 1e-12 m does not touch it; on the other side it crosses.
  const auto with_tip = [](const Rational& y) {
    return Region::polygon({pt(0, 0), pt(4, 0), pt(4, 4), {q(2), y}, pt(0, 4)}, {});
  };
  EXPECT_TRUE(std::holds_alternative<Region>(with_tip(q(1, 1000000000000))));
  EXPECT_TRUE(std::holds_alternative<Problem>(with_tip(q(-1, 1000000000000))));
}

int side(const Point& a, const Point& b, const Point& c) {
  return sgn(Rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
}
// Two segments have a common point.
bool meet(const Segment& s, const Segment& t) {
  const auto on = [](const Point& p, const Segment& e) { return squared_distance(p, e) == 0; };
  return on(s.a, t) || on(s.b, t) || on(t.a, s) || on(t.b, s) ||
         (side(s.a, s.b, t.a) * side(s.a, s.b, t.b) < 0 &&
          side(t.a, t.b, s.a) * side(t.a, t.b, s.b) < 0);
}
Segment edge(const Ring& ring, std::size_t i) {
  return {ring[i], ring[(i + 1) % ring.size()]};
}
bool same_place(const Point& p, const Point& q) {
  return p.x == q.x && p.y == q.y;
}
// Edges e < f of a ring have more in common than the vertex that neighbours share.
bool cross_in_ring(const Ring& ring, std::size_t e, std::size_t f) {
  const Segment s = edge(ring, e), t = edge(ring, f);
  if (f == e + 1) return squared_distance(s.a, t) == 0 || squared_distance(t.b, s) == 0;
  if (e == 0 && f + 1 == ring.size()) {
    return squared_distance(t.a, s) == 0 || squared_distance(s.b, t) == 0;
  }
  return meet(s, t);
}
bool repeats(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (same_place(ring[i], ring[k])) return true;
    }
  }
  return false;
}
bool is_flat(const Ring& ring) {
  return std::all_of(ring.begin(), ring.end(),
                     [&](const Point& p) { return side(ring[0], ring[1], p) == 0; });
}
// The first edge that crosses one before it, and the first such one, by comparing every two.
std::optional<std::pair<std::size_t, std::size_t>> first_crossing(const Ring& ring) {
  for (std::size_t f = 1; f < ring.size(); ++f) {
    for (std::size_t e = 0; e < f; ++e) {
      if (cross_in_ring(ring, e, f)) return std::pair{e, f};
    }
  }
  return std::nullopt;
}
Ring random_ring(Random& random, long vertices_max, long low, long high) {
  Ring ring;
  const long n = pick(random, 3, vertices_max);
  for (long k = 0; k < n; ++k) ring.push_back(pt(pick(random, low, high), pick(random, low, high)));
  return ring;
}

TEST(Validate, NamesTheFirstCrossingOfRandomRings) {
  // Small integer coordinates make touching and overlapping edges frequent. The reference compares
  // every two edges.
  Random random(7);
  int simple = 0, crossing = 0;
  for (int i = 0; i < 6000; ++i) {
    const Ring ring = random_ring(random, 8, 0, 5);
    if (repeats(ring)) continue;
    const auto result = Region::polygon(ring, {});
    const auto expected = first_crossing(ring);
    const auto* problem = std::get_if<Problem>(&result);
    ASSERT_EQ(problem != nullptr, expected.has_value()) << i;
    if (problem == nullptr) {
      ++simple;
    } else if (is_flat(ring)) {
      EXPECT_EQ(problem->kind, Kind::no_area) << i;
    } else {
      ++crossing;
      EXPECT_EQ(problem->kind, Kind::self_intersects) << i;
      EXPECT_EQ(std::pair(problem->vertex, problem->other), *expected) << i;
    }
  }
  EXPECT_GT(simple, 300);
  EXPECT_GT(crossing, 300);
}

// Two edges have more than a point in common.
bool share_edges(const Ring& a, const Ring& b) {
  for (std::size_t e = 0; e < a.size(); ++e) {
    for (std::size_t f = 0; f < b.size(); ++f) {
      const Segment s = edge(a, e), t = edge(b, f);
      if (side(s.a, s.b, t.a) != 0 || side(s.a, s.b, t.b) != 0) continue;
      const auto along = [&](const Point& p) -> Rational {
        return (p.x - s.a.x) * (s.b.x - s.a.x) + (p.y - s.a.y) * (s.b.y - s.a.y);
      };
      const Rational from = along(t.a), to = along(t.b), end = along(s.b);
      if ((from > 0 || to > 0) && (from < end || to < end)) return true;
    }
  }
  return false;
}

TEST(Validate, NamesTheFirstMisplacedHoleOfRandomOnes) {
  // Against definitions: a hole lies outside when a part of it is outside or of an edge is shared;
  // two holes overlap when they have an area or a part of an edge in common; the area is cut when
  // what is left has two parts.
  Random random(8);
  int outside = 0, overlapping = 0, cut = 0, valid = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ring outer =
        i % 2 == 0 ? box_ring(-1000, -1000, 9000, 9000) : random_ring(random, 5, 0, 8);
    std::vector<Ring> holes;
    for (long k = pick(random, 1, 3); k > 0; --k) {
      const long x = pick(random, -1, 6), y = pick(random, -1, 6);
      holes.push_back(random_ring(random, 4, 0, 3));
      for (Point& p : holes.back()) p = {p.x + x, p.y + y};
    }
    const auto sound = [](const Ring& r) {
      return !repeats(r) && !is_flat(r) && !first_crossing(r);
    };
    if (!sound(outer) || !std::all_of(holes.begin(), holes.end(), sound)) continue;
    const Region ground = polygon(outer);
    Problem expected{Kind::too_short, 0, 0, 0, {}};
    for (std::size_t s = holes.size(); s > 0; --s) {
      for (std::size_t r = s - 1; r > 0; --r) {
        const Ring &a = holes[r - 1], &b = holes[s - 1];
        if (share_edges(a, b) || !polygon(a).intersect(polygon(b)).empty()) {
          expected = {Kind::holes_overlap, r, 0, s, {}};
        }
      }
    }
    for (std::size_t r = holes.size(); r > 0; --r) {
      if (share_edges(holes[r - 1], outer) || !polygon(holes[r - 1]).subtract(ground).empty()) {
        expected = {Kind::hole_outside_ring, r, 0, 0, {}};
      }
    }
    if (expected.kind == Kind::too_short) {
      Region left = ground;
      for (const Ring& hole : holes) left = left.subtract(polygon(hole));
      if (left.polygons().size() > 1) expected.kind = Kind::cuts_area;
    }
    const auto result = Region::polygon(outer, holes);
    const auto* problem = std::get_if<Problem>(&result);
    ASSERT_EQ(problem == nullptr, expected.kind == Kind::too_short) << i;
    if (problem == nullptr) {
      ++valid;
      continue;
    }
    EXPECT_EQ(problem->kind, expected.kind) << i;
    if (expected.kind == Kind::cuts_area) {
      ++cut;
      continue;
    }
    EXPECT_EQ(problem->ring, expected.ring) << i;
    EXPECT_EQ(problem->kind == Kind::holes_overlap ? problem->other : 0, expected.other) << i;
    (expected.kind == Kind::holes_overlap ? overlapping : outside) += 1;
  }
  EXPECT_GT(valid, 300);
  EXPECT_GT(outside, 300);
  EXPECT_GT(overlapping, 150);
  EXPECT_GT(cut, 30);
}

// ---- large rings ------------------------------------------------------------------------------

// A comb of `teeth` long teeth, 1 m apart, turned by quarters.
Ring comb(long teeth, int quarters) {
  Ring ring{pt(teeth, -1), pt(teeth, 0)};
  for (long i = teeth; i-- > 0;) {
    ring.push_back({q(4 * i + 2, 4), q(teeth)});
    ring.push_back({q(4 * i + 1, 4), q(0)});
  }
  ring.push_back(pt(-1, -1));
  for (Point& p : ring) {
    for (int k = 0; k < quarters; ++k) p = {-p.y, p.x};
  }
  return ring;
}

TEST(Validate, WorkGrowsAsNLogN) {
  // Teeth side by side in every direction: boxes of edges overlap, all of them at once.
  for (int quarters = 0; quarters < 4; ++quarters) {
    const Ring ring = comb(50'000, quarters);
    const Edges edges({&ring});
    const Swept swept = sweep(edges, 0, ring.size());
    EXPECT_FALSE(swept.meet);
    // log2 of 100,000 edges is 17: two searches in a balanced tree for each edge.
    EXPECT_LT(swept.comparisons, 2 * 17 * ring.size()) << quarters;
  }
}

TEST(Validate, ManyHolesAreTold) {
  // 40,000 triangles: comparing every two of them would take minutes.
  const Ring outer = box_ring(-1000, -1000, 401000, 401000);
  std::vector<Ring> holes;
  for (long i = 0; i < 40'000; ++i) {
    const long x = i % 200 * 2, y = i / 200 * 2;
    holes.push_back({pt(x, y), pt(x + 1, y), pt(x, y + 1)});
  }
  EXPECT_TRUE(std::holds_alternative<Region>(Region::polygon(outer, holes)));
  // The last one moves into the one before it.
  for (Point& p : holes.back()) p.x -= q(7, 4);
  const Problem p = problem(outer, holes);
  EXPECT_EQ(p.kind, Kind::holes_overlap);
  EXPECT_EQ(std::pair(p.ring, p.other), std::pair(std::size_t{39'999}, std::size_t{40'000}));
}

TEST(Validate, OneFaultAmongManyVerticesIsNamed) {
  // One vertex of 100,000 slips to the next tooth but one.
  Ring ring = comb(50'000, 1);
  ring[60'000] = ring[60'004];
  EXPECT_EQ(problem(ring).kind, Kind::repeats_vertex);
  ring[60'000].x += q(1, 1000);
  const Problem p = problem(ring);
  EXPECT_EQ(p.kind, Kind::self_intersects);
  EXPECT_EQ(std::pair(p.vertex, p.other), std::pair(std::size_t{59'999}, std::size_t{60'001}));
}

TEST(Validate, VerticesInDisorderAreFoundInBoundedWork) {
  // Half a billion crossings; only the first one is of interest.
  Random random(3);
  Ring ring;
  for (int i = 0; i < 30'000; ++i) {
    ring.push_back(mm(pick(random, 0, 100'000'000), pick(random, 0, 100'000'000)));
  }
  const Problem p = problem(ring);
  EXPECT_EQ(p.kind, Kind::self_intersects);
  EXPECT_LT(p.other, 100U);
}

}  // namespace
}  // namespace rtac::geometry
