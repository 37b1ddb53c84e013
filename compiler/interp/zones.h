// Zones of a specification, in exact numbers. A zone without curves and offsets is one region; of
// another one the region that surely lies in it and the one that surely contains it are known.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/interp/outline.h"
#include "compiler/interp/received.h"
#include "compiler/interp/solids.h"
#include "compiler/interp/span.h"
#include "compiler/interp/trail.h"
#include "compiler/sema/nested_offsets.h"
#include "compiler/sema/spec.h"

namespace rtac::interp {

class Zones {
 public:
  // The specification outlives the zones.
  explicit Zones(const sema::Spec& spec);
  Zones(const Zones&) = delete;
  Zones& operator=(const Zones&) = delete;
  ~Zones() = default;
  // How far a place is from the boundary, negative outside: that of the middle of its box, less and
  // more half of the diagonal; see `range` for what it cannot be.
  Span clearance(sema::ZoneId zone, const Whereabouts& at);
  // The same of the zone as robots know it, which lies within it: curves as polygons, on the grid
  // of 1 mm; what is outside of a zone that is received is the outside of a zone around that.
  // `place` is exact, and so is how high it is, which zones of the plane do not ask for.
  Span clearance_of_robots(sema::ZoneId zone, const Place& place,
                           const std::optional<Rational>& height);
  // The same of the straight way between two places. It is negative where all of the way lies
  // outside; where a part of it does, it is 0.
  struct WayClearance {
    Span gap;
    bool leaves = false;  // some of it lies outside
  };
  WayClearance clearance_of_way(sema::ZoneId zone, const Place& from, const Place& to);
  // Of a leg or a path: the least signed distance of its places from the boundary, or the greatest.
  Span clearance(sema::ZoneId zone, const Trail& trail, bool greatest);
  // The least distance between places of two zones that stay as they are.
  Span apart(sema::ZoneId one, sema::ZoneId other);
  // Whether some place of it lies outside for sure, however near; `outside`: in the zone.
  bool surely_leaves(sema::ZoneId zone, const Trail& trail, bool outside);
  // What a zone of the specification is from now on that is received; nullptr: unknown.
  void receive(sema::ZoneId zone, std::shared_ptr<const ReceivedZone> received);
  // Whether a place that is known exactly lies outside for sure, however near.
  bool outside(sema::ZoneId zone, const Whereabouts& at);
  // What surely lies in a zone of the plane; nullptr: it is not known.
  const geometry::Region* within(sema::ZoneId zone);
  // The same of a zone with height.
  const geometry::Solid* solid_within(sema::ZoneId zone) { return solids_.within(zone); }
  // Whatever the clearance may be while the place is anything in its box.
  Span range(sema::ZoneId zone, const Whereabouts& at);

 private:
  using Region = std::optional<geometry::Region>;  // none: faulty, which others report
  static Bound other(Bound b) { return b == Bound::within ? Bound::around : Bound::within; }
  struct Evaluate;
  const Region& region(sema::ZoneId zone, Bound bound);
  struct Outlines {  // null, both: there is no such zone
    const Outline *within, *around;
  };
  Outlines outlines(sema::ZoneId zone);
  std::optional<Rational> square_apart(sema::ZoneId one, sema::ZoneId other, Bound bound);
  const Outline* of_robots(sema::ZoneId zone);
  const Outline* around_received(sema::ZoneId zone);

  struct Known {
    std::array<std::optional<Region>, 2> regions;  // none: not asked for yet
    std::shared_ptr<const ReceivedZone> received;
    bool outlined = false;
    std::unique_ptr<Outline> within, around;  // `around` only where it differs
    bool snapped = false;
    std::unique_ptr<Outline> of_robots;
    std::unique_ptr<Outline> robots_around;  // of one that is received, to stay outside of
  };
  const sema::Spec& spec_;
  const sema::NestedOffsets nested_;
  std::vector<Known> known_;
  Solids solids_;
  std::map<std::pair<sema::ZoneId, sema::ZoneId>, Span> apart_;
};

}  // namespace rtac::interp
