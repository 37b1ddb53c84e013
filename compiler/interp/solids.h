// Zones with height, in exact numbers, as the zones of the plane that they are made of.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "compiler/geometry/solid.h"
#include "compiler/interp/outline.h"
#include "compiler/interp/span.h"
#include "compiler/sema/nested_offsets.h"
#include "compiler/sema/spec.h"

namespace rtac::interp {

// Where a place is; without `z`: in the plane.
struct Whereabouts {
  Span x, y;
  std::optional<Span> z;
};

// A zone is known as what surely lies in it, and as what surely contains it.
enum class Bound { within, around };

// The boundary of a zone with height: its walls, and what is floor or ceiling where neighbouring
// slabs differ.
class Surface {
 public:
  // Of a solid that is not empty.
  explicit Surface(const geometry::Solid& solid);

  // The boundary belongs to the zone.
  [[nodiscard]] bool contains(const Place& place, const Rational& z) const;
  // Signed, negative outside.
  [[nodiscard]] Root clearance(const Place& place, const Rational& z) const;
  struct Box {
    Place low, high;
    Rational z_low, z_high;
  };
  // No place of the box is farther from the zone, no place of the zone farther from its boundary.
  [[nodiscard]] Rational farthest(const Box& box) const;
  [[nodiscard]] Rational deepest() const;

 private:
  struct Level {
    Rational floor, ceiling;
    Outline outline;
  };
  [[nodiscard]] Rational square_to(const Place& place, const Rational& z) const;

  std::vector<Level> levels_;  // from below to above
};

class Solids {
 public:
  // Of a zone of the plane; none: faulty, which others report.
  using Base =
      std::function<std::optional<geometry::Region>(const sema::ZoneExpr& base, Bound bound)>;
  Solids(const sema::Spec& spec, Base base);

  // See Zones.
  Span clearance(sema::ZoneId zone, const Whereabouts& at);
  Span clearance_of_robots(sema::ZoneId zone, const Place& place, const Rational& z);
  bool outside(sema::ZoneId zone, const Whereabouts& at);
  Span range(sema::ZoneId zone, const Whereabouts& at);
  // What surely lies in the zone, or contains it; nullptr: it is not known, or of the plane.
  const geometry::Solid* of(sema::ZoneId zone, Bound bound);
  const geometry::Solid* within(sema::ZoneId zone) { return of(zone, Bound::within); }

 private:
  using Solid = std::optional<geometry::Solid>;
  struct Evaluate;
  const Solid& solid(sema::ZoneId zone, Bound bound);
  struct Known {
    std::array<std::optional<Solid>, 2> solids;  // none: not asked for yet
    bool surfaced = false;
    std::unique_ptr<Surface> within, around;
    bool snapped = false;
    std::unique_ptr<Surface> of_robots;
  };
  const Known& surfaces(sema::ZoneId zone);

  const sema::Spec& spec_;
  const sema::NestedOffsets nested_;
  Base base_;
  std::vector<Known> known_;
};

}  // namespace rtac::interp
