// Exact zones with height: stacks of slabs, each of them a region of the plane that reaches from
// one height to another. As Region, plain exact rationals in metres.
#pragma once

#include <functional>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/region.h"

namespace rtac::geometry {

// Closed: floor and ceiling belong to it.
struct Slab {
  Rational floor, ceiling;  // floor < ceiling
  Region region;            // not empty
};

class Solid {
 public:
  Solid() = default;  // empty
  // Empty where the region is, or where the floor is not below the ceiling.
  static Solid prism(Region region, const Rational& floor, const Rational& ceiling);
  // The union of any slabs, however they lie to each other: one sweep for each height.
  static Solid of_slabs(const std::vector<Slab>& slabs);
  // The places that coordinates on the grid may name: Region::everywhere, and as far up and down.
  static Solid everywhere();

  // Regular, as those of regions: closed, without dangling walls or ceilings.
  [[nodiscard]] Solid unite(const Solid& other) const;
  [[nodiscard]] Solid intersect(const Solid& other) const;
  [[nodiscard]] Solid subtract(const Solid& other) const;
  // What is reached by going up to `across` sideways, as Region::grow has it, and then up to
  // `upright` up or down: every place within the smaller of both, and more.
  // `nested`: as of regions.
  [[nodiscard]] Solid grow(const Rational& across, const Rational& upright,
                           std::size_t nested = 1) const;
  // The places from which all that is reached that way lies within, as Region::shrink has it.
  [[nodiscard]] Solid shrink(const Rational& across, const Rational& upright,
                             std::size_t nested = 1) const;
  // Every place from which a ball of that radius lies within, but for what offsets reach farther
  // than they are told, and at edges some more: what shrinks by cylinders that lie in the ball have
  // in common.
  [[nodiscard]] Solid shrink_by_ball(const Rational& radius) const;

  [[nodiscard]] bool empty() const { return slabs_.empty(); }
  [[nodiscard]] bool contains(const Point& p, const Rational& z) const;  // closed
  // From below to above. Their insides are apart; neighbours that touch have different regions: the
  // same solid always gives the same list.
  [[nodiscard]] const std::vector<Slab>& slabs() const& { return slabs_; }
  const std::vector<Slab>& slabs() const&& = delete;  // of a temporary they would not last

 private:
  using Combination = std::function<Region(const Region* left, const Region* right)>;
  // Slab by slab of both; null: there is none at that height.
  static Solid combine(const Solid& left, const Solid& right, const Combination& region_of);
  void add(const Rational& floor, const Rational& ceiling, Region region);

  std::vector<Slab> slabs_;
};

// A solid whose corners lie on the grid of 1 mm.
struct SnappedSlab {
  std::int32_t floor_mm = 0, ceiling_mm = 0;
  SnappedZone zone;
};
using SnappedSolid = std::vector<SnappedSlab>;

// A snapped solid that is a subset of `solid`, or of which it is one; as close to it as snapped
// regions come, and the same where it lies on the grid. Empty: nothing is left. nullopt: a
// coordinate exceeds the grid.
std::optional<SnappedSolid> snap_inside(const Solid& solid);
std::optional<SnappedSolid> snap_around(const Solid& solid);

}  // namespace rtac::geometry
