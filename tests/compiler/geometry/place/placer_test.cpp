// From degrees to the map: exact places, long edges in pieces, and no place for what cannot have
// one.
#include "compiler/geometry/place/placer.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>
#include <algorithm>
#include <cmath>
#include <random>

namespace rtac::geometry {
namespace {

using GeographicLib::Geodesic;
using import::Position;

constexpr Origin field{47.3977, 8.5456};

import::Ring ring_of(std::vector<Position> positions){return {std::move(positions), true, "ring"};
}  // namespace
PlacedRing placed(Placer& placer, const import::Ring& ring) {
  auto result = placer.place(ring);
  if (auto* good = std::get_if<PlacedRing>(&result)) return std::move(*good);
  ADD_FAILURE() << "no place for vertex " << std::get<NoPlace>(result).vertex;
  return {};
}
NoPlace fault_of(Placer& placer, const import::Ring& ring) {
  const auto result = placer.place(ring);
  if (const auto* fault = std::get_if<NoPlace>(&result)) return *fault;
  ADD_FAILURE() << "it has a place";
  return {};
}

// How far `p` is from the edge between two places of the map.
double off_edge_m(const PlacedPoint& a, const PlacedPoint& b, const PlacedPoint& p) {
  const double ax = a.x.get_d(), ay = a.y.get_d();
  const double dx = b.x.get_d() - ax, dy = b.y.get_d() - ay;
  const double qx = p.x.get_d() - ax, qy = p.y.get_d() - ay;
  const double share = std::clamp((qx * dx + qy * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(qx - share * dx, qy - share * dy);
}

// 100 m to the north of the origin and to the east of it, by geodesics.
TEST(Placer, PutsNorthUpAndEastToTheRight) {
  double latitude = 0, longitude = 0;
  Geodesic::WGS84().Direct(field.latitude_deg, field.longitude_deg, 90, 100, latitude, longitude);
  Placer placer({}, field);
  const PlacedRing ring =
      placed(placer, ring_of({{field.longitude_deg, field.latitude_deg}, {longitude, latitude}}));
  EXPECT_EQ(ring.points[0].x, 0);
  EXPECT_EQ(ring.points[0].y, 0);
  EXPECT_EQ(ring.points[1].x, 100);
  EXPECT_EQ(ring.points[1].y, 0);
  EXPECT_EQ(ring.points[1].vertex, 1U);
}

TEST(Placer, SwapsAxesThatAreTheOtherWayRound) {
  Placer one({}, field), other({true, true, true}, field);
  const PlacedRing a = placed(one, ring_of({{8.55, 47.40}}));
  const PlacedRing b = placed(other, ring_of({{47.40, 8.55}}));
  ASSERT_EQ(a.points.size(), 1U);
  ASSERT_EQ(b.points.size(), 1U);
  EXPECT_EQ(a.points[0].x, b.points[0].x);
  EXPECT_EQ(a.points[0].y, b.points[0].y);
}

// Neighbours that share an edge get the same points on it, whichever way round they have it: no
// gap opens between them.
TEST(Placer, DividesASharedEdgeInTheSameWayFromBothEnds) {
  Placer placer({}, field);
  const Position a{8.50, 47.35}, b{8.62, 47.43};
  const PlacedRing there = placed(placer, ring_of({a, b}));
  const PlacedRing back = placed(placer, ring_of({b, a}));
  ASSERT_GT(there.points.size(), 20U);
  ASSERT_EQ(there.points.size(), back.points.size());
  const std::size_t count = there.points.size() / 2;
  for (std::size_t i = 0; i <= count; ++i) {
    EXPECT_EQ(there.points[i].x, back.points[count - i].x);
    EXPECT_EQ(there.points[i].y, back.points[count - i].y);
  }
}

// What touches in degrees touches on the map: a parallel is no straight line there.
TEST(Placer, EdgesPassThroughTheVerticesOfOtherRingsOnThem) {
  const import::Ring outer =
      ring_of({{8.54, 47.39}, {8.55, 47.39}, {8.55, 47.40}, {8.545, 47.39}, {8.54, 47.40}});
  const import::Ring hole = ring_of({{8.5443, 47.39}, {8.545, 47.395}, {8.54, 47.3944}});
  const auto at = [](const PlacedRing& ring, const PlacedPoint& p) {
    return std::find_if(ring.points.begin(), ring.points.end(),
                        [&](const PlacedPoint& q) { return q.x == p.x && q.y == p.y; });
  };
  Placer apart({}, field), together({}, field);
  together.meet({&outer, &hole});
  const PlacedRing whole = placed(apart, outer), met = placed(together, outer);
  const PlacedRing touching = placed(together, hole);
  for (const auto& [vertex, edge] : {std::pair<std::uint32_t, std::uint32_t>{0, 0}, {2, 4}}) {
    const auto mine = std::find_if(touching.points.begin(), touching.points.end(),
                                   [&, n = vertex](const PlacedPoint& p) { return p.vertex == n; });
    EXPECT_EQ(at(whole, *mine), whole.points.end());
    ASSERT_NE(at(met, *mine), met.points.end());
    EXPECT_EQ(at(met, *mine)->vertex, edge);
  }
  // Its own vertex on an edge is a fault of the ring, which is told of the vertices as read.
  Placer alone({}, field);
  alone.meet({&outer});
  EXPECT_EQ(placed(alone, outer).points.size(), whole.points.size());
}

// Of KML nobody knows how an edge runs: it may be the shortest way, and still passes through what
// touches its parallel. Either way is within the error of it.
TEST(Placer, EdgesThatMayBeTheShortestWaysMeetAsWell) {
  const import::Ring outer = ring_of({{8.48, 47.39}, {8.61, 47.39}, {8.55, 47.40}});
  const import::Ring hole = ring_of({{8.5443, 47.39}, {8.545, 47.395}, {8.5401, 47.39}});
  const Reading unknown_edges{true, false, false};
  Placer apart(unknown_edges, field), together(unknown_edges, field);
  together.meet({&outer, &hole});
  EXPECT_EQ(placed(apart, outer).points.size(), 3U);
  const PlacedRing met = placed(together, outer), touching = placed(together, hole);
  ASSERT_EQ(met.points.size(), 5U);
  for (const auto& [on_edge, of_hole] : {std::pair<std::size_t, std::size_t>{1, 2}, {2, 0}}) {
    EXPECT_EQ(met.points[on_edge].x, touching.points[of_hole].x);
    EXPECT_EQ(met.points[on_edge].y, touching.points[of_hole].y);
  }
  EXPECT_GT(together.error(), apart.error());
  const double error_m = together.error().get_d();
  const auto line = Geodesic::WGS84().InverseLine(47.39, 8.48, 47.39, 8.61);
  for (int k = 1; k < 100; ++k) {
    Position shortest;
    line.Position(line.Distance() * k / 100, shortest.y, shortest.x);
    Placer pin({}, field);
    const PlacedPoint p = placed(pin, ring_of({shortest})).points[0];
    double off_m = 1e9;
    for (std::size_t i = 0; i < 3; ++i) {
      off_m = std::min(off_m, off_edge_m(met.points[i], met.points[i + 1], p));
    }
    EXPECT_LE(off_m, error_m);
  }
}

// Every point of a long parallel lies as near to the placed line as is said; as one straight edge
// it would be off by metres.
TEST(Placer, LongEdgesAreDividedUntilTheyAreTrue) {
  const Position a{8.48, 47.42}, b{8.62, 47.42};  // 10 km
  Placer divided({}, field), whole({true, false, false}, field);
  const PlacedRing line = placed(divided, ring_of({a, b}));
  placed(whole, ring_of({a, b}));
  EXPECT_GT(line.points.size(), 40U);
  EXPECT_LT(divided.error(), Rational(6, 1000));
  EXPECT_GT(whole.error(), 2) << "either way the edge is meant, it is covered";
  EXPECT_LT(whole.error(), 3);
}

// A zone of a few hundred metres: its error is a fraction of a millimetre, and said as such.
TEST(Placer, SmallZonesHaveSmallErrors) {
  Placer placer({}, field);
  placed(placer, ring_of({{8.545, 47.397}, {8.546, 47.397}, {8.546, 47.398}, {8.545, 47.398}}));
  EXPECT_GT(placer.error(), 0);
  EXPECT_LT(placer.error(), Rational(1, 1000));
  EXPECT_GT(placer.farthest_m(), 80);
  EXPECT_LT(placer.farthest_m(), 100);
}

// Coordinates in metres are what they say, to the decimal: no error, whatever a double makes of it.
TEST(Placer, MetresAreExact) {
  Placer placer({false, false, true}, std::nullopt);
  const PlacedRing ring = placed(placer, ring_of({{0.1, -2.345678}, {1e5, 3}}));
  EXPECT_EQ(ring.points[0].x, Rational(1, 10));
  EXPECT_EQ(ring.points[0].y, Rational(-1'172'839, 500'000));
  EXPECT_EQ(placer.error(), 0);
  placed(placer, ring_of({{0.12345678, 0}}));
  EXPECT_EQ(placer.error(), Rational(1, 1'000'000));
}

TEST(Placer, CirclesReachAsFarAsTheirRadius) {
  Placer placer({}, field);
  const auto result = placer.place(import::Circle{{8.5456, 47.3977}, 250, "circle"});
  const auto& circle = std::get<PlacedCircle>(result);
  EXPECT_EQ(circle.x, 0);
  EXPECT_EQ(circle.radius, 250);
  EXPECT_NEAR(placer.farthest_m(), 250, 1e-9);
}

TEST(Placer, SwappedAxesAreSuspected) {
  Placer placer({}, field);
  const NoPlace fault = fault_of(placer, ring_of({{47.3977, 8.5456}}));
  EXPECT_EQ(fault.kind, NoPlace::Kind::far_away);
  EXPECT_TRUE(fault.near_swapped);
  EXPECT_GT(fault.distance_m, 1e6);
}

TEST(Placer, HasNoPlaceForWhatIsFarAway) {
  Placer placer({}, field);
  const NoPlace fault = fault_of(placer, ring_of({{8.5, 47.4}, {10.5, 47.4}}));
  EXPECT_EQ(fault.kind, NoPlace::Kind::far_away);
  EXPECT_EQ(fault.vertex, 1U);
  EXPECT_FALSE(fault.near_swapped);
  Placer metres({false, false, true}, std::nullopt);
  EXPECT_EQ(fault_of(metres, ring_of({{1e308, 0}})).kind, NoPlace::Kind::far_away);
}

TEST(Placer, HasNoPlaceOffTheGlobeNorAtThePoles) {
  Placer placer({}, Origin{88.8, 0});
  EXPECT_EQ(fault_of(placer, ring_of({{0, 91}})).kind, NoPlace::Kind::off_globe);
  EXPECT_EQ(fault_of(placer, ring_of({{181, 88.8}})).kind, NoPlace::Kind::off_globe);
  EXPECT_EQ(fault_of(placer, ring_of({{0, 89.1}})).kind, NoPlace::Kind::near_pole);
}

// From 179.9 to -179.9 degrees: 360 degrees less a bit, or a bit? It is not guessed.
TEST(Placer, HasNoPlaceForEdgesAcrossTheDateLine) {
  Placer placer({}, Origin{-17, 180});
  const NoPlace fault = fault_of(placer, ring_of({{179.9, -17}, {-179.9, -17}}));
  EXPECT_EQ(fault.kind, NoPlace::Kind::across_the_map);
  EXPECT_EQ(fault.vertex, 0U);
}

// Cut in two at the date line, as files have it: both halves have the same border.
TEST(Placer, HalvesOnBothSidesOfTheDateLineMeet) {
  Placer placer({}, Origin{-17, 179.99});
  const PlacedRing east = placed(placer, ring_of({{180, -17.1}, {180, -16.9}}));
  const PlacedRing west = placed(placer, ring_of({{-180, -17.1}, {-180, -16.9}}));
  ASSERT_EQ(east.points.size(), west.points.size());
  for (std::size_t i = 0; i < east.points.size(); ++i) {
    EXPECT_EQ(east.points[i].x, west.points[i].x);
    EXPECT_EQ(east.points[i].y, west.points[i].y);
  }
}

// The whole promise: how far a place is from a zone is on the map what it is on the globe, within
// the error that is said. The true outline is sampled finely along edges straight in degrees.
TEST(Placer, ClearancesAreTrueWithinTheError) {
  std::mt19937_64 random(7);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const Geodesic& globe = Geodesic::WGS84();
  for (int zone = 0; zone < 60; ++zone) {
    const Origin origin{draw(-80, 80), draw(-170, 170)};
    const double size_m = std::pow(10, draw(2, 4.6));
    const auto anywhere = [&] {
      Position p;
      globe.Direct(origin.latitude_deg, origin.longitude_deg, draw(-180, 180),
                   size_m * std::sqrt(draw(0, 1)), p.y, p.x);
      return p;
    };
    const import::Ring outline = ring_of({anywhere(), anywhere(), anywhere()});
    Placer placer({}, origin);
    const PlacedRing ring = placed(placer, outline);
    const double error_m = placer.error().get_d();
    for (int k = 0; k < 5; ++k) {
      const Position at = anywhere();
      Placer pin({}, origin);
      const PlacedPoint p = placed(pin, ring_of({at})).points[0];
      double on_map = 1e9;
      for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const PlacedPoint& a = ring.points[i];
        const PlacedPoint& b = ring.points[(i + 1) % ring.points.size()];
        on_map = std::min(on_map, off_edge_m(a, b, p));
      }
      // Samples lie at most half a step from the nearest place of the outline.
      double sampled = 1e9, half_step = 0;
      constexpr int steps = 1000;
      for (std::size_t i = 0; i < 3; ++i) {
        const Position& a = outline.positions[i];
        const Position& b = outline.positions[(i + 1) % 3];
        half_step = std::max(half_step, length_m_up({a.x, a.y, b.x, b.y}) / steps / 2);
        for (int s = 0; s < steps; ++s) {
          const double share = static_cast<double>(s) / steps;
          double distance = 0;
          globe.Inverse(at.y, at.x, a.y + share * (b.y - a.y), a.x + share * (b.x - a.x), distance);
          sampled = std::min(sampled, distance);
        }
      }
      EXPECT_LE(on_map, sampled + error_m);
      // The nearest place is at most half a step along the outline from a sample.
      EXPECT_GE(on_map, std::sqrt(std::max(0.0, sampled * sampled - half_step * half_step)) -
                            half_step - error_m);
    }
  }
}

// On the map a parallel is bent, and other lines are by a little.
TEST(Placer, KnowsRingsThatEncloseNothing) {
  const auto of = [](const std::vector<Position>& positions) {
    return encloses_nothing(ring_of(positions));
  };
  EXPECT_TRUE(of({{8.548, 47.397}, {8.549, 47.397}, {8.550, 47.397}}));  // along a parallel
  EXPECT_TRUE(of({{8.548, 47.397}, {8.548, 47.398}, {8.548, 47.399}}));
  EXPECT_TRUE(of({{8.548, 47.397}, {8.549, 47.398}, {8.550, 47.399}}));  // not quite, of doubles
  EXPECT_TRUE(of({{8.1, 47.3}, {8.4, 47.9}, {8.3, 47.7}, {8.2, 47.5}}));
  EXPECT_FALSE(of({{8.548, 47.397}, {8.549, 47.397}, {8.550, 47.3970001}}));       // a centimetre
  EXPECT_FALSE(of({{8.548, 47.397}, {8.549, 47.397000000001}, {8.550, 47.397}}));  // 0.1 um
  EXPECT_FALSE(of({{8, 47}, {9, 47}, {9, 48}}));
  EXPECT_FALSE(of({{8, 47}, {9, 47}, {10, 47}, {9, 47}}));  // repeats a vertex, which is told
  EXPECT_FALSE(of({{8, 47}, {9, 47}}));
}

TEST(Placer, KnowsWhichWayRoundARingGoes) {
  EXPECT_TRUE(counter_clockwise(ring_of({{8, 47}, {9, 47}, {9, 48}})));
  EXPECT_FALSE(counter_clockwise(ring_of({{8, 47}, {9, 48}, {9, 47}})));
}

}  // namespace rtac::geometry
}  // namespace rtac::geometry
