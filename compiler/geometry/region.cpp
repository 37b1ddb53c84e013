#include "compiler/geometry/region.h"

#include <algorithm>
#include <utility>

#include "compiler/geometry/kept.h"
#include "compiler/geometry/moved.h"
#include "compiler/geometry/offset.h"
#include "compiler/geometry/overlay.h"
#include "compiler/geometry/ring.h"
#include "compiler/geometry/validate.h"

namespace rtac::geometry {

// The canonical parts are the whole state: plain rationals, so that no chain of lazy exact
// numbers outlives one operation.
struct Region::Impl {
  std::vector<PolygonWithHoles> parts;

  [[nodiscard]] std::vector<Ring> rings() const {
    std::vector<Ring> all;
    for (const PolygonWithHoles& part : parts) {
      all.push_back(part.outer);
      all.insert(all.end(), part.holes.begin(), part.holes.end());
    }
    return all;
  }

  [[nodiscard]] std::size_t vertices() const {
    std::size_t all = 0;
    for (const PolygonWithHoles& part : parts) {
      all += part.outer.size();
      for (const Ring& hole : part.holes) all += hole.size();
    }
    return all;
  }

  // No place of a part is farther from its boundary than half of the shorter side of the rectangle
  // around it.
  [[nodiscard]] bool vanishes(const Rational& distance) const {
    return std::all_of(parts.begin(), parts.end(), [&](const PolygonWithHoles& part) {
      const auto [left, right] =
          std::minmax_element(part.outer.begin(), part.outer.end(),
                              [](const auto& p, const auto& q) { return p.x < q.x; });
      const auto [low, high] =
          std::minmax_element(part.outer.begin(), part.outer.end(),
                              [](const auto& p, const auto& q) { return p.y < q.y; });
      return std::min(Rational(right->x - left->x), Rational(high->y - low->y)) <= 2 * distance;
    });
  }

  [[nodiscard]] std::size_t slanting_edges() const {
    std::size_t all = 0;
    for (const Ring& ring : rings()) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
        if (a.x != b.x && a.y != b.y) ++all;
      }
    }
    return all;
  }

  // Of large outlines and of round corners: pieces for every edge and corner, united, take up to a
  // hundred times as long. Those of others are exact where edges are parallel to an axis.
  [[nodiscard]] std::optional<std::vector<PolygonWithHoles>> moved(const Rational& distance,
                                                                   const Rational& excess,
                                                                   BandSide side) const {
    constexpr std::size_t vertices_large = 400, slanting_many = 16;
    const bool at_once = vertices() >= vertices_large || slanting_edges() >= slanting_many;
    return at_once ? moved_at_once(parts, distance, excess, side) : std::nullopt;
  }
};

namespace {

// Parts with, or without, a band along their boundary. The same zones are grown and shrunk by the
// same distances for each monitor, and for each number that is tried.
struct Banded {
  std::vector<Ring> rings;
  Rational distance, excess;
  BandSide side;
  bool operator==(const Banded&) const = default;
};
std::vector<PolygonWithHoles> with_band(const std::vector<Ring>& rings,
                                        const std::vector<PolygonWithHoles>& parts,
                                        const Rational& distance, const Rational& excess,
                                        BandSide side) {
  thread_local Kept<Banded, std::vector<PolygonWithHoles>> kept;
  return kept.find({rings, distance, excess, side}, [&] {
    return overlay_band(rings, boundary_band(parts, distance, excess, side),
                        side == BandSide::exterior ? Combine::unite : Combine::subtract);
  });
}

}  // namespace

Region::Region() : impl_(std::make_unique<Impl>()) {}
Region::Region(std::vector<PolygonWithHoles> parts)
    : impl_(std::make_unique<Impl>(Impl{std::move(parts)})) {}
Region::~Region() = default;
Region::Region(const Region& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
Region::Region(Region&& other) noexcept = default;
Region& Region::operator=(Region other) {
  impl_ = std::move(other.impl_);
  return *this;
}

std::variant<Region, Problem> Region::polygon(const Ring& outer, const std::vector<Ring>& holes) {
  if (auto problem = find_problem(outer, holes)) return *problem;
  // Valid rings touch one another in points at most, and are what `overlay` would cut the boundary
  // into: turning them round and sorting makes them canonical.
  PolygonWithHoles part;
  part.outer = canonical(twice_area(outer) > 0 ? outer : reversed(outer));
  for (const Ring& hole : holes) {
    part.holes.push_back(canonical(twice_area(hole) < 0 ? hole : reversed(hole)));
  }
  std::sort(part.holes.begin(), part.holes.end(), ring_order);
  return Region({std::move(part)});
}

Region Region::of_rings(const std::vector<Ring>& rings) {
  return Region(overlay(rings, {}, Combine::unite));
}

Region Region::everywhere() {
  // Less than 2^29 mm, so that what is snapped around it stays on the grid.
  const Rational reach_m = 536'000;
  return Region({PolygonWithHoles{
      {{-reach_m, -reach_m}, {reach_m, -reach_m}, {reach_m, reach_m}, {-reach_m, reach_m}}, {}}});
}

std::size_t circle_edges(const Rational& radius) {
  std::size_t edges = 32;
  while (edges < 256 && circle_error(radius, edges) > Rational(1, 100)) edges *= 2;
  return edges;
}
Rational circle_error(const Rational& radius, std::size_t edges) {
  // Half the angle of an edge is at most h = pi / edges + 5e-4; the middle of an inscribed edge is
  // r (1 - cos h) off, the corner of a circumscribed one r (1 / cos h - 1) < r h^2 / 2 * 1.01.
  const Rational half = Rational(355, 113) / static_cast<unsigned long>(edges) + Rational(1, 2000);
  return radius * half * half * Rational(101, 200);
}

Region Region::circle(const Point& centre, const Rational& radius, bool inner) {
  if (radius <= 0) return {};
  const std::vector<Point> directions = regular_directions(circle_edges(radius));
  const Ring ring =
      inner ? inscribed(centre, radius, directions) : circumscribed(centre, radius, directions);
  return Region({PolygonWithHoles{canonical(ring), {}}});
}

Rational offset_excess_m(std::size_t nested) {
  // A share is longer than what straight edges give away (offset.cpp).
  constexpr std::size_t nested_max = 1000;
  return Rational(static_cast<long>(offset_excess_um)) / 1'000'000 / std::min(nested, nested_max);
}

Region Region::unite(const Region& other) const {
  return Region(overlay(impl_->rings(), other.impl_->rings(), Combine::unite));
}

Region Region::intersect(const Region& other) const {
  return Region(overlay(impl_->rings(), other.impl_->rings(), Combine::intersect));
}

Region Region::subtract(const Region& other) const {
  return Region(overlay(impl_->rings(), other.impl_->rings(), Combine::subtract));
}

namespace {
// GMP takes 230/200 and 23/20 for different numbers, and what meets in one place is torn apart.
Rational lowest_terms(Rational value) {
  value.canonicalize();
  return value;
}
}  // namespace

Region Region::shrink(const Rational& by, std::size_t nested) const {
  const Rational distance = lowest_terms(by);
  if (distance <= 0) return *this;
  if (impl_->vanishes(distance)) return {};
  const Rational excess = offset_excess_m(nested);
  if (auto moved = impl_->moved(distance, excess, BandSide::interior)) {
    return Region(std::move(*moved));
  }
  return Region(with_band(impl_->rings(), impl_->parts, distance, excess, BandSide::interior));
}

Region Region::grow(const Rational& by, std::size_t nested) const {
  const Rational distance = lowest_terms(by);
  if (distance <= 0) return *this;
  const Rational excess = offset_excess_m(nested);
  if (auto moved = impl_->moved(distance, excess, BandSide::exterior)) {
    return Region(std::move(*moved));
  }
  return Region(with_band(impl_->rings(), impl_->parts, distance, excess, BandSide::exterior));
}

std::optional<Region> Region::offset(const Rational& by, std::size_t nested) const {
  const Rational distance = lowest_terms(by);
  const bool grows = distance > 0;
  if (vertices() > offset_vertices_max && distance != 0) {
    auto moved = impl_->moved(abs(distance), offset_excess_m(nested),
                              grows ? BandSide::exterior : BandSide::interior);
    return moved ? std::optional(Region(std::move(*moved))) : std::nullopt;
  }
  return grows ? grow(distance, nested) : shrink(-distance, nested);
}

std::optional<Region> Region::widened(const Rational& error) const {
  if (error == 0) return *this;
  const Rational distance = lowest_terms(abs(error));
  if (error < 0 && impl_->vanishes(distance)) return Region();
  const BandSide side = error > 0 ? BandSide::exterior : BandSide::interior;
  const Rational excess = std::max(offset_excess_m(), distance);
  if (auto moved = impl_->moved(distance, excess, side)) return Region(std::move(*moved));
  if (vertices() > offset_vertices_max) return std::nullopt;
  return Region(with_band(impl_->rings(), impl_->parts, distance, excess, side));
}

bool Region::empty() const {
  return impl_->parts.empty();
}

std::size_t Region::vertices() const {
  return impl_->vertices();
}

bool Region::contains(const Point& p) const {
  return std::any_of(impl_->parts.begin(), impl_->parts.end(), [&](const PolygonWithHoles& part) {
    return locate(p, part.outer) != Side::outside &&
           std::none_of(part.holes.begin(), part.holes.end(),
                        [&](const Ring& hole) { return locate(p, hole) == Side::inside; });
  });
}

bool Region::contains(const Region& other) const {
  return overlay(other.impl_->rings(), impl_->rings(), Combine::subtract).empty();
}

Rational Region::area() const {
  Rational twice = 0;
  for (const Ring& ring : impl_->rings()) twice += twice_area(ring);
  return twice / 2;
}

std::vector<Ring> Region::rings() const {
  return impl_->rings();
}

std::vector<PolygonWithHoles> Region::polygons() const {
  return impl_->parts;
}

}  // namespace rtac::geometry
