// What an author may write as a polygon, and how each mistake is named: kind, ring, vertices as
// written and the exact place. A diagnostic can only be as good as this.
#include <gtest/gtest.h>

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

TEST(Validate, HoleMustLieStrictlyInside) {
  expect_problem(problem(kBig, {box_ring(20000, 0, 21000, 1000)}), Kind::hole_outside_ring, 1, 0, 0,
                 pt(20, 0));
  expect_problem(problem(kBig, {{pt(9, 5), pt(11, 5), pt(9, 6)}}), Kind::hole_outside_ring, 1, 0, 1,
                 pt(10, 5));
  // Touching from inside at a point.
  expect_problem(problem(kBig, {{pt(8, 4), pt(10, 5), pt(8, 6)}}), Kind::hole_outside_ring, 1, 0, 1,
                 pt(10, 5));
  // Around the outer ring instead of inside it.
  EXPECT_EQ(problem(box_ring(4000, 4000, 5000, 5000), {kBig}).kind, Kind::hole_outside_ring);
}

TEST(Validate, HolesMustNotOverlapOrTouch) {
  const Ring first = box_ring(1000, 1000, 4000, 4000);
  expect_problem(problem(kBig, {first, box_ring(3000, 2000, 6000, 3000)}), Kind::holes_overlap, 1,
                 1, 2, pt(4, 2));
  expect_problem(problem(kBig, {first, box_ring(4000, 4000, 5000, 5000)}), Kind::holes_overlap, 1,
                 1, 2, pt(4, 4));
  expect_problem(problem(kBig, {first, box_ring(2000, 2000, 3000, 3000)}), Kind::holes_overlap, 1,
                 0, 2, pt(2, 2));
  expect_problem(
      problem(kBig, {box_ring(6000, 6000, 7000, 7000), box_ring(2000, 2000, 3000, 3000), first}),
      Kind::holes_overlap, 2, 0, 3, pt(2, 2));
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

TEST(Validate, AgreesWithAllPairsOnRandomRings) {
  // Small integer coordinates make touching and overlapping edges frequent. The reference
  // compares every two edges, by signs only.
  Random random(7);
  int simple = 0;
  for (int i = 0; i < 3000; ++i) {
    Ring ring;
    const long n = pick(random, 3, 6);
    for (long k = 0; k < n; ++k) ring.push_back(pt(pick(random, 0, 4), pick(random, 0, 4)));
    const auto side = [](const Point& a, const Point& b, const Point& c) {
      return sgn(Rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
    };
    bool meets = false;
    const auto size = static_cast<std::size_t>(n);
    for (std::size_t e = 0; e < size; ++e) {
      const Segment s{ring[e], ring[(e + 1) % size]};
      if (s.a.x == s.b.x && s.a.y == s.b.y) {
        meets = true;
        continue;
      }
      // A vertex that is not an end of the edge lies on it, or two edges cross.
      for (std::size_t v = 0; v < size; ++v) {
        if (v != e && v != (e + 1) % size) meets = meets || squared_distance(ring[v], s) == 0;
      }
      for (std::size_t f = 0; f < size; ++f) {
        const Segment t{ring[f], ring[(f + 1) % size]};
        meets = meets || (side(s.a, s.b, t.a) * side(s.a, s.b, t.b) < 0 &&
                          side(t.a, t.b, s.a) * side(t.a, t.b, s.b) < 0);
      }
    }
    EXPECT_EQ(std::holds_alternative<Problem>(Region::polygon(ring, {})), meets) << i;
    simple += meets ? 0 : 1;
  }
  EXPECT_GT(simple, 300);
}

}  // namespace
}  // namespace rtac::geometry
