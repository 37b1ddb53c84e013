// From the positions of a file to places of the map: exact rationals in m, x east, y north.
// Positions in degrees are projected about the origin of the map; how far the result may be from
// the truth is part of it. The same file gives the same places everywhere: they are on a grid of
// 1 um, far coarser than the last bits in which machines differ.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/geometry/import/areas.h"
#include "compiler/geometry/place/bounds.h"
#include "compiler/support/rational.h"

namespace rtac::geometry {

struct Origin {  // of the map, on WGS 84
  double latitude_deg = 0, longitude_deg = 0;
};

// How the numbers of a file are meant.
struct Reading {
  bool degrees = true;
  bool latitude_first = false;  // of degrees
  // Edges are straight in longitude and latitude; else they may as well be the shortest ways.
  bool straight_in_degrees = true;
};

struct PlacedPoint {
  Rational x, y;             // m
  std::uint32_t vertex = 0;  // of the ring as read; of a point on an edge, the one before it
};
struct PlacedRing {
  std::vector<PlacedPoint> points;
};
struct PlacedCircle {
  Rational x, y, radius;  // m
};

// Why a position has no place.
struct NoPlace {
  enum class Kind {
    off_globe,       // no such longitude or latitude
    near_pole,       // longitudes mean little there
    across_the_map,  // the edge to the next vertex takes more than half of all longitudes
    far_away,        // from the origin, or of metres from (0 m, 0 m)
    too_many,        // more than `points_max`, those on long edges in degrees included
  };
  Kind kind;
  std::size_t vertex = 0;
  double distance_m = 0;      // of far_away
  bool near_swapped = false;  // it would be near with longitude and latitude the other way round
};

// Positions nearer to a pole are refused: 1 deg, 111 km.
inline constexpr double latitude_deg_max = 89;
// Farther from (0 m, 0 m) the grid of the kernel ends.
inline constexpr double metres_max = 500'000;
// Of the outlines of one zone, wherever they come from. Tables take about 40 us and 1 kB a vertex,
// what combines the parts of a zone twice as much.
inline constexpr std::size_t points_max = 250'000;
// Edges that are straight in degrees are divided until they are so near to the straight line on
// the map: as offsets of zones are.
inline constexpr double edge_error_m_due = 0.002;

class Placer {
 public:
  // `origin` may be missing for metres.
  Placer(const Reading& reading, const std::optional<Origin>& origin);
  ~Placer();
  Placer(const Placer&) = delete;
  Placer& operator=(const Placer&) = delete;

  // All rings that are combined, before they are placed. An edge along a meridian or a parallel
  // then passes on the map, too, through the vertices of other rings that lie on it: what touches
  // in the file touches there, and no gap opens between areas. Where an edge may as well be the
  // shortest way, the error counts both.
  void meet(const std::vector<const import::Ring*>& rings);

  std::variant<PlacedRing, NoPlace> place(const import::Ring& ring);
  std::variant<PlacedCircle, NoPlace> place(const import::Circle& circle);

  // Of everything placed so far.
  [[nodiscard]] double farthest_m() const;  // from the origin
  [[nodiscard]] std::size_t points() const;
  // How far places, edges and distances of it are from the truth at most, in m.
  [[nodiscard]] Rational error() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Do all vertices lie on one line, as closely as doubles tell (within 0.1 um, less than the grid of
// places)? On the map the line may be bent, and look as if it enclosed something. False of a ring
// that repeats a vertex, which is the better reason.
bool encloses_nothing(const import::Ring& ring);

// Do the vertices go round counter-clockwise, longitude to the right and latitude up?
bool counter_clockwise(const import::Ring& ring);

}  // namespace rtac::geometry
