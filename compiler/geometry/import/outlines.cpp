#include "compiler/geometry/import/outlines.h"

#include <algorithm>
#include <cmath>

namespace rtac::geometry::import {
namespace {

bool is_same(Position a, Position b) {
  return a.x == b.x && a.y == b.y;
}

bool is_longitude(double value) {
  return std::abs(value) <= 180;
}
bool is_latitude(double value) {
  return std::abs(value) <= 90;
}

// Calls `visit(position, place)` until it returns false; `place` makes the text only when asked.
template <class Visit>
bool all_of_ring(const Ring& ring, const Visit& visit) {
  for (std::size_t i = 0; i < ring.positions.size(); ++i) {
    if (!visit(ring.positions[i], [&] { return place_of_position(ring, i); })) return false;
  }
  return true;
}

template <class Visit>
bool all_of_part(const Part& part, const Visit& visit) {
  if (const auto* circle = std::get_if<Circle>(&part.shape)) {
    return visit(circle->centre, [&] { return circle->where; });
  }
  const auto& polygon = std::get<Polygon>(part.shape);
  return all_of_ring(polygon.outer, visit) &&
         std::all_of(polygon.holes.begin(), polygon.holes.end(),
                     [&](const Ring& hole) { return all_of_ring(hole, visit); });
}

template <class Visit>
bool all_positions(const Areas& areas, const Visit& visit) {
  for (const Area& area : areas.areas) {
    for (const Part& part : area.parts) {
      if (!all_of_part(part, visit)) return false;
    }
  }
  return true;
}

bool fits(const Areas& areas, bool is_swapped) {
  return all_positions(areas, [&](Position p, const auto&) {
    return is_longitude(is_swapped ? p.y : p.x) && is_latitude(is_swapped ? p.x : p.y);
  });
}

// The first position off the globe, if there is one.
std::optional<Failure> off_globe(const Areas& areas, std::string_view help) {
  std::optional<Failure> failure;
  all_positions(areas, [&](Position p, const auto& place) {
    if (is_longitude(p.x) && is_latitude(p.y)) return true;
    failure = Failure{place(),
                      "the position with longitude " + shown(p.x) + " and latitude " + shown(p.y) +
                          " is off the globe",
                      std::string(help)};
    return false;
  });
  return failure;
}

// Neither order may be taken for granted: one of them has to fit all positions.
bool check_unordered_globe(const Areas& areas, Findings& findings) {
  if (fits(areas, false) || fits(areas, true)) return true;
  const auto is_on_globe = [](Position p) {
    return (is_longitude(p.x) && is_latitude(p.y)) || (is_latitude(p.x) && is_longitude(p.y));
  };
  const bool is_each_on_globe = all_positions(areas, [&](Position p, const auto& place) {
    return is_on_globe(p) ||
           findings.fail(place(), "the position " + shown(p) + " is off the globe in either order",
                         "longitudes are within -180 and 180 degrees, latitudes within -90 and 90");
  });
  return is_each_on_globe && findings.fail("the whole text",
                                           "some positions are on the globe only with the latitude "
                                           "first, others only with the longitude first",
                                           "write all positions in one order");
}

// Between such neighbours a line could run either way around the globe.
bool check_steps(const Ring& ring, Findings& findings) {
  for (std::size_t i = 0; i < ring.positions.size(); ++i) {
    const Position a = ring.positions[i];
    const Position b = ring.positions[(i + 1) % ring.positions.size()];
    if (std::abs(a.x - b.x) <= 180) continue;
    return findings.fail(place_of_position(ring, i),
                         "the longitude steps from " + shown(a.x) + " to " + shown(b.x) +
                             ": more than half around the globe",
                         "cut the area in two at the longitude 180");
  }
  return true;
}

bool check_all_steps(const Areas& areas, Findings& findings) {
  for (const Area& area : areas.areas) {
    for (const Part& part : area.parts) {
      const auto* polygon = std::get_if<Polygon>(&part.shape);
      if (polygon == nullptr) continue;
      if (!check_steps(polygon->outer, findings)) return false;
      for (const Ring& hole : polygon->holes) {
        if (!check_steps(hole, findings)) return false;
      }
    }
  }
  return true;
}

bool check_extent(const Areas& areas, Findings& findings) {
  constexpr double circumference_m = 40'075'017;  // of the equator, WGS 84
  return all_positions(areas, [&](Position p, const auto& place) {
    return (std::abs(p.x) <= circumference_m && std::abs(p.y) <= circumference_m) ||
           findings.fail(place(), "the position " + shown(p) + " is not on earth in any unit",
                         "metres within 40075 km, or degrees");
  });
}

}  // namespace

std::string place_of_position(const Ring& ring, std::size_t index) {
  return ring.where + ", position " + std::to_string(index + 1);
}

bool finish_ring(Ring& ring, Closing closing, Findings& findings) {
  auto& positions = ring.positions;
  ring.closed = positions.size() > 1 && is_same(positions.front(), positions.back());
  if (closing == Closing::required && !ring.closed && positions.size() > 2) {
    return findings.fail(place_of_position(ring, positions.size() - 1),
                         "the ring is open: it starts at " + shown(positions.front()) +
                             " and ends at " + shown(positions.back()),
                         "repeat the first position at the end, if the ring is complete");
  }
  if (ring.closed) positions.pop_back();
  if (positions.size() >= 3) return true;
  return findings.fail(ring.where,
                       "the ring has " + std::to_string(positions.size()) +
                           (positions.size() == 1 ? " position" : " positions") +
                           (ring.closed ? " besides the one that closes it" : "") +
                           "; it encloses nothing",
                       "three are the least");
}

bool check_band(const Band& band, const std::string& where, Findings& findings) {
  constexpr double height_max_m = 1'000'000;  // higher than what flies
  for (const auto& limit : {band.floor, band.ceiling}) {
    if (!limit || std::abs(limit->value_m) <= height_max_m) continue;
    return findings.fail(where, "a limit of height of " + shown(limit->value_m) + " m",
                         "limits within 1000 km work");
  }
  if (!band.floor || !band.ceiling || band.floor->reference != band.ceiling->reference ||
      band.floor->value_m <= band.ceiling->value_m) {
    return true;
  }
  return findings.fail(where,
                       "the band of altitude is upside down: from " + shown(band.floor->value_m) +
                           " m up to " + shown(band.ceiling->value_m) + " m",
                       "the lower limit is the smaller one");
}

bool check_radius(double radius_m, const std::string& where, Findings& findings) {
  constexpr double radius_max_m = 20'000'000;  // half around the earth
  if (radius_m > 0 && radius_m <= radius_max_m) return true;
  return findings.fail(where, "a circle with a radius of " + shown(radius_m) + " m",
                       "radii are above 0 and at most 20000 km");
}

void refuse(Area& area, std::string where, std::string message, std::string help) {
  if (area.refusal) return;
  area.refusal = Failure{std::move(where), std::move(message), std::move(help)};
}

void add_rings(const std::vector<const Area*>& areas, std::vector<const Ring*>& rings) {
  for (const Area* area : areas) {
    for (const Part& part : area->parts) {
      const auto* polygon = std::get_if<Polygon>(&part.shape);
      if (polygon == nullptr) continue;
      rings.push_back(&polygon->outer);
      for (const Ring& hole : polygon->holes) rings.push_back(&hole);
    }
  }
}

bool add_area(Area area, const Limits& limits, Areas& areas, Findings& findings) {
  if (areas.areas.size() >= limits.areas_max) {
    return findings.fail(area.where, "more than " + std::to_string(limits.areas_max) + " areas",
                         "split the file, or leave out what is no zone");
  }
  areas.areas.push_back(std::move(area));
  return true;
}

bool check_positions(Areas& areas, Findings& findings) {
  if (areas.unit != Unit::degrees) return check_extent(areas, findings);
  if (areas.axes == Axes::unstated) return check_unordered_globe(areas, findings);
  if (fits(areas, false)) return check_all_steps(areas, findings);
  if (fits(areas, true)) {
    areas.only_turned =
        off_globe(areas,
                  "every position of the file is on the globe when latitude and longitude change "
                  "places: the axes look swapped; write them in the order of the format");
    return true;
  }
  return findings.fail(
      *off_globe(areas, "longitudes are within -180 and 180 degrees, latitudes within -90 and 90"));
}

}  // namespace rtac::geometry::import
