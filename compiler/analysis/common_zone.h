// What several zones have in common, as it can be written: a zone that a recovery might move in.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/boundless.h"
#include "compiler/geometry/solid.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// What is above or below a box, or anything, between two heights.
struct Layer {
  std::optional<Box> box;
  std::int64_t floor_mm = 0, ceiling_mm = 0;
  bool operator==(const Layer&) const = default;
};
// What is in one of these zones, and so far from the boundary; or else in a layer.
template <class Zone>
struct PartOf {
  std::vector<Zone> either;
  std::int64_t off_mm = 0;
  std::optional<Layer> layer{};
  bool operator==(const PartOf&) const = default;
};
using ZonePart = PartOf<ir::ZoneIndex>;
using DeclaredPart = PartOf<sema::ZoneId>;

// The zone that a table has been made of; none: a slab alone.
using ZoneOf = std::function<std::optional<sema::ZoneId>(ir::ZoneIndex)>;
// None: one of them is a slab.
std::optional<std::vector<DeclaredPart>> declared(const std::vector<ZonePart>& parts,
                                                  const ZoneOf& zone_of);

// What all of these have in common, which are at least one, in the place of `from`. A zone of the
// plane among others is as high as these; without a value where that is not told by numbers.
sema::Zone common_zone(const sema::Spec& spec, sema::ZoneId from,
                       const std::vector<DeclaredPart>& parts);
// As in zone_text.h.
std::string common_text(const sema::Spec& spec, const std::vector<DeclaredPart>& parts);

// The box around a solid, from its floor to its ceiling; rounded outwards. nullopt: it is empty.
std::optional<Layer> layer_around(const geometry::Solid& solid);
// What of a layer lies between these heights, where there are any. nullopt: nothing.
std::optional<Layer> between(Layer layer, std::optional<std::int64_t> least_mm,
                             std::optional<std::int64_t> most_mm);

// A box as a zone.
sema::ZonePolygon rectangle(const Box& box);

}  // namespace rtac::analysis
