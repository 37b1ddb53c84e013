#include "compiler/geometry/place/placer.h"

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace rtac::geometry {
namespace {

using import::Position;

constexpr double um_per_m = 1e6;
// The projection is exact within 0.02 um (Karney, Algorithms for geodesics, 2013), rounding within
// 0.71 um.
constexpr double rounding_error_m = 0.8e-6;

std::int64_t in_um(double value_m) {
  return std::llround(value_m * um_per_m);
}
Rational metres_of(std::int64_t um) {
  Rational value(static_cast<long>(um), 1'000'000UL);
  value.canonicalize();
  return value;
}

struct Place {
  double x_m, y_m;
};

// A vertex on a meridian or a parallel: which one, where on it, and of which ring; of several:
// null.
struct Knot {
  double line, at;
  const import::Ring* ring;
};
bool is_before(const Knot& a, const Knot& b) {
  return std::tie(a.line, a.at) < std::tie(b.line, b.at);
}

void sort_once(std::vector<Knot>& knots) {
  std::sort(knots.begin(), knots.end(), is_before);
  std::size_t count = 0;
  for (const Knot& knot : knots) {
    if (count == 0 || is_before(knots[count - 1], knot)) {
      knots[count++] = knot;
    } else if (knots[count - 1].ring != knot.ring) {
      knots[count - 1].ring = nullptr;
    }
  }
  knots.resize(count);
}

}  // namespace

struct Placer::Impl {
  Reading reading;
  std::optional<Origin> origin;
  GeographicLib::AzimuthalEquidistant projection;
  double farthest_m = 0, edge_error_m = 0;
  bool rounded = false, radius_rounded = false;
  std::size_t points = 0;
  std::vector<Knot> on_meridians{}, on_parallels{};  // of the rings that meet, in order
  std::size_t knots_met = 0;

  [[nodiscard]] Position position(const Position& p) const {
    return reading.degrees && reading.latitude_first ? Position{p.y, p.x} : p;
  }
  [[nodiscard]] Place project(const Position& p) const {
    double x = 0, y = 0;
    double azimuth = 0, scale = 0;
    projection.Forward(origin->latitude_deg, origin->longitude_deg, p.y, p.x, x, y, azimuth, scale);
    return {x, y};
  }
  [[nodiscard]] bool is_near(const Position& p) const {
    if (std::abs(p.y) > latitude_deg_max || std::abs(p.x) > 180) return false;
    const Place place = project(p);
    return std::hypot(place.x_m, place.y_m) <= reach_m_max;
  }

  // `p` in the order of `reading`.
  std::variant<Place, NoPlace> place(const Position& p) {
    using Kind = NoPlace::Kind;
    const bool degrees = reading.degrees;
    if (degrees && (std::abs(p.y) > 90 || std::abs(p.x) > 180)) {
      return NoPlace{Kind::off_globe, 0, 0, is_near({p.y, p.x})};
    }
    if (degrees && std::abs(p.y) > latitude_deg_max) {
      return NoPlace{Kind::near_pole, 0, 0, is_near({p.y, p.x})};
    }
    const Place place = degrees ? project(p) : Place{p.x, p.y};
    const double distance_m = std::hypot(place.x_m, place.y_m);
    if (distance_m > (degrees ? reach_m_max : metres_max)) {
      return NoPlace{Kind::far_away, 0, distance_m, degrees && is_near({p.y, p.x})};
    }
    farthest_m = std::max(farthest_m, distance_m);
    return place;
  }

  [[nodiscard]] PlacedPoint point(const Place& place, std::size_t vertex) {
    const std::int64_t x = in_um(place.x_m), y = in_um(place.y_m);
    const auto moved = [](std::int64_t um, double m) {
      return static_cast<double>(um) / um_per_m != m;
    };
    rounded = rounded || reading.degrees || moved(x, place.x_m) || moved(y, place.y_m);
    ++points;
    return {metres_of(x), metres_of(y), static_cast<std::uint32_t>(vertex)};
  }

  // Into how many pieces the edge is divided; a zone that shares it gets the same ones.
  std::size_t pieces(const DegreeEdge& edge) {
    const double length_m = length_m_up(edge), bend = bend_per_m(edge);
    const double pieces_due = reading.straight_in_degrees
                                  ? std::ceil(length_m * std::sqrt(bend / (8 * edge_error_m_due)))
                                  : 1;
    const double pieces = std::max(pieces_due, 1.0);
    const double piece_m = length_m / pieces;
    edge_error_m = std::max(edge_error_m, piece_m * piece_m * bend / 8);
    return static_cast<std::size_t>(pieces);
  }

  // The vertices of other rings within the edge from `a` to `b` of `ring`, on its way.
  [[nodiscard]] std::vector<Position> knots_within(const Position& a, const Position& b,
                                                   const import::Ring& ring) {
    std::vector<Position> found;
    const bool upright = a.x == b.x;
    if (!upright && a.y != b.y) return found;
    const std::vector<Knot>& knots = upright ? on_meridians : on_parallels;
    const double line = upright ? a.x : a.y;
    const auto [from, until] = upright ? std::minmax(a.y, b.y) : std::minmax(a.x, b.x);
    auto knot = std::upper_bound(knots.begin(), knots.end(), Knot{line, from, nullptr}, is_before);
    for (; knot != knots.end() && knot->line == line && knot->at < until; ++knot) {
      if (++knots_met > points_max) break;  // who asks tells it
      if (knot->ring == &ring) continue;
      found.push_back(upright ? Position{line, knot->at} : Position{knot->at, line});
    }
    if (upright ? b.y < a.y : b.x < a.x) std::reverse(found.begin(), found.end());
    return found;
  }

  // An edge that may as well be the shortest way passes through places of its parallel: these, and
  // the edge that is meant, may lie on two sides of the straight line on the map, each within the
  // bound of it. A meridian is the shortest way.
  void leaves_the_line(const DegreeEdge& edge) {
    const double length_m = length_m_up(edge);
    edge_error_m = std::max(edge_error_m, 2 * length_m * length_m * bend_per_m(edge) / 8);
  }

  // The points within the edge of `from` from `a` to `b`, the first of which is in `ring` already.
  std::optional<NoPlace> divide(const Position& a, const Position& b, std::size_t vertex,
                                const import::Ring& from, PlacedRing& ring) {
    if (std::abs(a.x - b.x) > 180) return NoPlace{NoPlace::Kind::across_the_map, vertex};
    Position last = a;
    const std::vector<Position> knots = knots_within(a, b, from);
    const bool of_parallel = !knots.empty() && a.y == b.y;
    if (of_parallel && !reading.straight_in_degrees) leaves_the_line({a.x, a.y, b.x, b.y});
    for (const Position& knot : knots) {
      if (auto fault = divide_piece(last, knot, vertex, ring)) return fault;
      const auto placed = place(knot);
      if (const auto* fault = std::get_if<NoPlace>(&placed)) return at(*fault, vertex);
      ring.points.push_back(point(std::get<Place>(placed), vertex));
      last = knot;
    }
    if (knots_met > points_max) return NoPlace{NoPlace::Kind::too_many, vertex};
    return divide_piece(last, b, vertex, ring);
  }
  std::optional<NoPlace> divide_piece(const Position& a, const Position& b, std::size_t vertex,
                                      PlacedRing& ring) {
    const std::size_t count = pieces({a.x, a.y, b.x, b.y});
    if (points + count > points_max) return NoPlace{NoPlace::Kind::too_many, vertex};
    const bool forward = std::tie(a.x, a.y) <= std::tie(b.x, b.y);
    const Position& from = forward ? a : b;
    const Position& to = forward ? b : a;
    for (std::size_t i = 1; i < count; ++i) {
      const double share =
          static_cast<double>(forward ? i : count - i) / static_cast<double>(count);
      const auto placed =
          place({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
      if (const auto* fault = std::get_if<NoPlace>(&placed)) return at(*fault, vertex);
      ring.points.push_back(point(std::get<Place>(placed), vertex));
    }
    return std::nullopt;
  }

  static NoPlace at(NoPlace fault, std::size_t vertex) {
    fault.vertex = vertex;
    return fault;
  }
};

Placer::Placer(const Reading& reading, const std::optional<Origin>& origin)
    : impl_(std::make_unique<Impl>()) {
  impl_->reading = reading;
  impl_->origin = origin;
}
Placer::~Placer() = default;

void Placer::meet(const std::vector<const import::Ring*>& rings) {
  if (!impl_->reading.degrees) return;
  for (const import::Ring* ring : rings) {
    for (const Position& read : ring->positions) {
      const Position p = impl_->position(read);
      impl_->on_meridians.push_back({p.x, p.y, ring});
      impl_->on_parallels.push_back({p.y, p.x, ring});
    }
  }
  sort_once(impl_->on_meridians);
  sort_once(impl_->on_parallels);
}

std::variant<PlacedRing, NoPlace> Placer::place(const import::Ring& ring) {
  const std::size_t count = ring.positions.size();
  if (impl_->points + count > points_max) return NoPlace{NoPlace::Kind::too_many};
  std::vector<Place> places;
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = impl_->place(impl_->position(ring.positions[i]));
    if (const auto* fault = std::get_if<NoPlace>(&place)) return Impl::at(*fault, i);
    places.push_back(std::get<Place>(place));
  }
  PlacedRing result;
  for (std::size_t i = 0; i < count; ++i) {
    result.points.push_back(impl_->point(places[i], i));
    if (!impl_->reading.degrees) continue;
    const Position here = impl_->position(ring.positions[i]);
    const Position next = impl_->position(ring.positions[(i + 1) % count]);
    if (auto fault = impl_->divide(here, next, i, ring, result)) return *fault;
  }
  return result;
}

std::variant<PlacedCircle, NoPlace> Placer::place(const import::Circle& circle) {
  const auto placed = impl_->place(impl_->position(circle.centre));
  if (const auto* fault = std::get_if<NoPlace>(&placed)) return *fault;
  const double limit_m = impl_->reading.degrees ? reach_m_max : metres_max;
  const PlacedPoint centre = impl_->point(std::get<Place>(placed), 0);
  const Place& at = std::get<Place>(placed);
  const double reach_m = std::hypot(at.x_m, at.y_m) + circle.radius_m;
  if (reach_m > limit_m) return NoPlace{NoPlace::Kind::far_away, 0, reach_m, false};
  impl_->farthest_m = std::max(impl_->farthest_m, reach_m);
  const std::int64_t radius_um = in_um(circle.radius_m);
  impl_->radius_rounded =
      impl_->radius_rounded || static_cast<double>(radius_um) / um_per_m != circle.radius_m;
  return PlacedCircle{centre.x, centre.y, metres_of(radius_um)};
}

double Placer::farthest_m() const {
  return impl_->farthest_m;
}

std::size_t Placer::points() const {
  return impl_->points;
}

Rational Placer::error() const {
  double error_m = impl_->rounded ? rounding_error_m : 0;
  if (impl_->radius_rounded) error_m += 0.5 / um_per_m;
  if (impl_->reading.degrees) {
    const double reach_m = impl_->farthest_m + impl_->edge_error_m + around_m;
    error_m += distance_error_m(reach_m) + impl_->edge_error_m;
  }
  constexpr double rounding_of_bounds = 1 + 1e-9;
  return metres_of(static_cast<std::int64_t>(std::ceil(error_m * rounding_of_bounds * um_per_m)));
}

namespace {

double apart(const Position& a, const Position& b) {
  return std::abs(a.x - b.x) + std::abs(a.y - b.y);
}

bool repeats_position(std::vector<Position> all) {
  std::sort(all.begin(), all.end(), [](const Position& a, const Position& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
  });
  const auto same = [](const Position& a, const Position& b) { return a.x == b.x && a.y == b.y; };
  return std::adjacent_find(all.begin(), all.end(), same) != all.end();
}

}  // namespace

// The line goes through the first vertex and the one farthest from it. Each coordinate is read
// within half a unit in its last place, each difference of two within one, which moves the area of
// a triangle by at most this much.
bool encloses_nothing(const import::Ring& ring) {
  const auto& all = ring.positions;
  if (all.size() < 3) return false;
  const Position a = all.front();
  const Position b = *std::max_element(
      all.begin(), all.end(),
      [&](const Position& p, const Position& q) { return apart(a, p) < apart(a, q); });
  const bool straight = std::all_of(all.begin(), all.end(), [&](const Position& p) {
    constexpr double unit = 2 * std::numeric_limits<double>::epsilon();
    const double most = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    const double twice_area = (b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y);
    return std::abs(twice_area) <= unit * most * (apart(a, b) + apart(a, p));
  });
  return straight && !repeats_position(all);
}

bool counter_clockwise(const import::Ring& ring) {
  double twice_area = 0;
  const auto& all = ring.positions;
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    twice_area += (all[i].x - all[0].x) * (all[i + 1].y - all[0].y) -
                  (all[i + 1].x - all[0].x) * (all[i].y - all[0].y);
  }
  return twice_area > 0;
}

}  // namespace rtac::geometry
