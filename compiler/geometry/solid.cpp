#include "compiler/geometry/solid.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace rtac::geometry {
namespace {

bool same(const Ring& a, const Ring& b) {
  return std::ranges::equal(
      a, b, [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; });
}

std::vector<Rational> sorted(std::vector<Rational> heights) {
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

std::vector<Rational> ends(const std::vector<Slab>& slabs) {
  std::vector<Rational> heights;
  for (const Slab& slab : slabs) {
    heights.push_back(slab.floor);
    heights.push_back(slab.ceiling);
  }
  return heights;
}

// Of slabs that end nowhere between two heights, the one there.
const Region* at(const std::vector<Slab>& slabs, const Rational& low, const Rational& high) {
  for (const Slab& slab : slabs) {
    if (slab.floor <= low && high <= slab.ceiling) return &slab.region;
  }
  return nullptr;
}

// The regions of a part of the height; none where something of it is in no slab.
struct Within {
  std::vector<const Region*> regions;
  bool covered = false;
};
Within within(const std::vector<Slab>& slabs, const Rational& low, const Rational& high) {
  Within part;
  Rational reached = low;
  for (const Slab& slab : slabs) {
    if (slab.ceiling <= low || slab.floor >= high) continue;
    part.regions.push_back(&slab.region);
    if (slab.floor <= reached) reached = slab.ceiling;
  }
  part.covered = reached >= high;
  return part;
}

Region common(const Within& part) {
  if (!part.covered) return {};
  Region all = *part.regions.front();
  for (std::size_t i = 1; i < part.regions.size() && !all.empty(); ++i) {
    all = all.intersect(*part.regions[i]);
  }
  return all;
}

Region any(const Within& part) {
  if (part.regions.size() == 1) return *part.regions.front();
  std::vector<Ring> rings;
  for (const Region* region : part.regions) {
    std::ranges::move(region->rings(), std::back_inserter(rings));
  }
  return Region::of_rings(rings);
}

// Whether both are the same set of places: they have the same canonical parts.
bool same(const Region& a, const Region& b) {
  return std::ranges::equal(a.polygons(), b.polygons(), [](const auto& p, const auto& q) {
    return same(p.outer, q.outer) &&
           std::ranges::equal(p.holes, q.holes,
                              [](const Ring& r, const Ring& s) { return same(r, s); });
  });
}

}  // namespace

// Added from below to above.
void Solid::add(const Rational& floor, const Rational& ceiling, Region region) {
  if (region.empty() || floor >= ceiling) return;
  if (!slabs_.empty() && slabs_.back().ceiling == floor && same(slabs_.back().region, region)) {
    slabs_.back().ceiling = ceiling;
  } else {
    slabs_.push_back({floor, ceiling, std::move(region)});
  }
}

Solid Solid::prism(Region region, const Rational& floor, const Rational& ceiling) {
  Solid solid;
  solid.add(floor, ceiling, std::move(region));
  return solid;
}

Solid Solid::of_slabs(const std::vector<Slab>& slabs) {
  const std::vector<Rational> heights = sorted(ends(slabs));
  Solid result;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    result.add(heights[i - 1], heights[i], any(within(slabs, heights[i - 1], heights[i])));
  }
  return result;
}

Solid Solid::everywhere() {
  const Rational reach_m = 536'000;
  return prism(Region::everywhere(), -reach_m, reach_m);
}

Solid Solid::combine(const Solid& left, const Solid& right, const Combination& region_of) {
  std::vector<Rational> heights = ends(left.slabs_);
  std::ranges::copy(ends(right.slabs_), std::back_inserter(heights));
  heights = sorted(std::move(heights));
  Solid result;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const Rational &low = heights[i - 1], &high = heights[i];
    result.add(low, high, region_of(at(left.slabs_, low, high), at(right.slabs_, low, high)));
  }
  return result;
}

Solid Solid::unite(const Solid& other) const {
  return combine(*this, other, [](const Region* left, const Region* right) {
    if (left == nullptr || right == nullptr) {
      const Region* const one = left != nullptr ? left : right;
      return one != nullptr ? *one : Region();
    }
    return left->unite(*right);
  });
}

Solid Solid::intersect(const Solid& other) const {
  return combine(*this, other, [](const Region* left, const Region* right) {
    return left != nullptr && right != nullptr ? left->intersect(*right) : Region();
  });
}

Solid Solid::subtract(const Solid& other) const {
  return combine(*this, other, [](const Region* left, const Region* right) {
    if (left == nullptr) return Region();
    return right != nullptr ? left->subtract(*right) : *left;
  });
}

Solid Solid::grow(const Rational& across, const Rational& upright, std::size_t nested) const {
  const Rational up = std::max(upright, Rational(0));
  std::vector<Slab> grown;
  for (const Slab& slab : slabs_) {
    grown.push_back({slab.floor - up, slab.ceiling + up, slab.region.grow(across, nested)});
  }
  return of_slabs(grown);
}

// At a height, all that is reached from it up and down has to fit: what is common to the slabs
// there.
Solid Solid::shrink(const Rational& across, const Rational& upright, std::size_t nested) const {
  const Rational up = std::max(upright, Rational(0));
  std::vector<Slab> shrunk;
  std::vector<Rational> heights;
  for (const Slab& slab : slabs_) {
    shrunk.push_back({slab.floor, slab.ceiling, slab.region.shrink(across, nested)});
    for (const Rational& end : {slab.floor, slab.ceiling}) {
      heights.emplace_back(end - up);
      heights.emplace_back(end + up);
    }
  }
  heights = sorted(std::move(heights));
  Solid result;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const Rational middle = (heights[i - 1] + heights[i]) / 2;
    result.add(heights[i - 1], heights[i], common(within(shrunk, middle - up, middle + up)));
  }
  return result;
}

Solid Solid::shrink_by_ball(const Rational& radius) const {
  if (radius <= 0) return *this;
  // one that is flat, one that is upright, and between them one whose edges lie in the ball
  const Rational edge = radius * Rational(7, 10);
  return shrink(radius, 0).intersect(shrink(0, radius)).intersect(shrink(edge, edge));
}

bool Solid::contains(const Point& p, const Rational& z) const {
  return std::ranges::any_of(slabs_, [&](const Slab& slab) {
    return slab.floor <= z && z <= slab.ceiling && slab.region.contains(p);
  });
}

namespace {

constexpr std::int64_t limit_mm = std::int64_t{1} << 29;

Rational metres(std::int64_t mm) {
  Rational value(static_cast<long>(mm), 1000);
  value.canonicalize();
  return value;
}

// The heights of the grid next to those of the slabs, from below to above. Where a slab ends
// between two of them, both sides of that end have to do with what lies between them.
std::optional<std::vector<std::int64_t>> grid_heights(const std::vector<Slab>& slabs) {
  std::vector<std::int64_t> heights;
  for (const Rational& end : ends(slabs)) {
    const Rational mm = end * 1000;
    if (abs(mm) > limit_mm) return std::nullopt;
    heights.push_back(floor_to_int(mm));
    heights.push_back(ceil_to_int(mm));
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

SnappedSlab slab_of(std::int64_t floor_mm, std::int64_t ceiling_mm, SnappedZone zone) {
  return {static_cast<std::int32_t>(floor_mm), static_cast<std::int32_t>(ceiling_mm),
          std::move(zone)};
}

}  // namespace

std::optional<SnappedSolid> snap_inside(const Solid& solid) {
  const auto heights = grid_heights(solid.slabs());
  if (!heights) return std::nullopt;
  SnappedSolid snapped;
  for (std::size_t i = 1; i < heights->size(); ++i) {
    const std::int64_t low = (*heights)[i - 1], high = (*heights)[i];
    auto zone = snap_inside(common(within(solid.slabs(), metres(low), metres(high))));
    if (zone) snapped.push_back(slab_of(low, high, std::move(*zone)));
  }
  return snapped;
}

std::optional<SnappedSolid> snap_around(const Solid& solid) {
  const auto heights = grid_heights(solid.slabs());
  if (!heights) return std::nullopt;
  SnappedSolid snapped;
  for (std::size_t i = 1; i < heights->size(); ++i) {
    const std::int64_t low = (*heights)[i - 1], high = (*heights)[i];
    const Within part = within(solid.slabs(), metres(low), metres(high));
    if (part.regions.empty()) continue;
    auto zone = snap_around(any(part));
    if (!zone) return std::nullopt;
    snapped.push_back(slab_of(low, high, std::move(*zone)));
  }
  return snapped;
}

}  // namespace rtac::geometry
