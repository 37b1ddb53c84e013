#include "compiler/interp/zones.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "compiler/geometry/apart.h"
#include "compiler/geometry/bake.h"
#include "compiler/sema/received.h"

namespace rtac::interp {
namespace {

bool is_finite(const Span& x, const Span& y) {
  return x.lo.is_finite() && x.hi.is_finite() && y.lo.is_finite() && y.hi.is_finite();
}

// Signed distance from the boundary.
Root clearance_of(const Outline& outline, const Place& place) {
  const Root gap = outline.distance(place);
  if (outline.contains(place)) return gap;
  return {-gap.above, -gap.below};
}

bool same(const geometry::Region& a, const geometry::Region& b) {
  const auto points = [](const geometry::Point& p, const geometry::Point& q) {
    return p.x == q.x && p.y == q.y;
  };
  const auto rings = [&](const geometry::Ring& p, const geometry::Ring& q) {
    return std::ranges::equal(p, q, points);
  };
  return std::ranges::equal(a.polygons(), b.polygons(), [&](const auto& p, const auto& q) {
    return rings(p.outer, q.outer) && std::ranges::equal(p.holes, q.holes, rings);
  });
}

geometry::Ring ring(const sema::ZonePolygon::Ring& from) {
  geometry::Ring to;
  for (const sema::Point& p : from.points) to.push_back({p.x, p.y});
  return to;
}

geometry::Region together(const std::vector<geometry::Region>& regions) {
  std::vector<geometry::Ring> rings;
  for (const geometry::Region& region : regions) {
    for (const geometry::PolygonWithHoles& polygon : region.polygons()) {
      rings.push_back(polygon.outer);
      rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
    }
  }
  return geometry::Region::of_rings(rings);
}

}  // namespace

// Curves and offsets are known within polygons: from inside, or from outside where the zone is
// subtracted. Offsets reach `offset_excess_m` too far at most, so that on the other side as much is
// taken off their distance.
struct Zones::Evaluate {
  Zones& zones;
  Bound bound;

  Region of(const sema::ZoneExpr& expr, Bound of_bound) const {
    return std::visit(Evaluate{zones, of_bound}, expr.node);
  }
  Region operator()(const sema::ZoneRef& node) const { return zones.region(node.zone, bound); }
  Region operator()(const sema::ZoneComplement& node) const {
    const Region& of = zones.region(node.zone, other(bound));
    return of ? Region(geometry::Region::everywhere().subtract(*of)) : std::nullopt;
  }
  Region operator()(const sema::ZonePrism&) const { return std::nullopt; }  // has height
  Region operator()(const sema::ZoneCircle& node) const {
    return geometry::Region::circle({node.centre.x, node.centre.y}, node.radius,
                                    bound == Bound::within);
  }
  Region operator()(const sema::ZonePolygon& node) const {
    std::vector<geometry::Ring> holes;
    for (const auto& hole : node.holes) holes.push_back(ring(hole));
    auto result = geometry::Region::polygon(ring(node.outer), holes);
    auto* good = std::get_if<geometry::Region>(&result);
    return good != nullptr ? Region(std::move(*good)) : std::nullopt;
  }
  // The boundary is known within the error of the file: what surely lies inside, or may.
  Region operator()(const sema::ZoneImport& node) const {
    std::vector<geometry::Region> groups, exclusions;
    for (const auto& group : node.inclusions) {
      Region all;
      for (const auto& each : group) {
        Region region = area(each, bound);
        if (!region) return std::nullopt;
        all = all ? all->intersect(*region) : std::move(*region);
      }
      if (all) groups.push_back(std::move(*all));
    }
    for (const auto& each : node.exclusions) {
      Region region = area(each, other(bound));
      if (!region) return std::nullopt;
      exclusions.push_back(std::move(*region));
    }
    const geometry::Region zone = together(groups).subtract(together(exclusions));
    return zone.widened(bound == Bound::within ? Rational(-node.error) : node.error);
  }
  Region area(const sema::ZoneImport::Area& area, Bound of_bound) const {
    std::vector<geometry::Region> parts;
    for (const auto& part : area.parts) {
      Region region = std::visit(Evaluate{zones, of_bound}, part);
      if (!region) return std::nullopt;
      parts.push_back(std::move(*region));
    }
    return together(parts);
  }
  Region operator()(const sema::ZoneBinary& node) const {
    const bool subtracts = node.op == sema::ZoneOp::subtract;
    const Region left = of(*node.left, bound);
    const Region right = of(*node.right, subtracts ? other(bound) : bound);
    if (!left || !right) return std::nullopt;
    if (subtracts) return left->subtract(*right);
    return node.op == sema::ZoneOp::unite ? left->unite(*right) : left->intersect(*right);
  }
  // Not made, but received.
  Region operator()(const sema::ZoneReceived&) const { return std::nullopt; }
  Region operator()(const sema::ZoneOffset& node) const {
    const Region operand = of(*node.operand, bound);
    if (!operand) return std::nullopt;
    Rational by = abs(node.distance);
    const bool shrinks = sgn(node.distance) < 0;
    const std::size_t nested = zones.nested_.with(node);
    if (shrinks != (bound == Bound::within)) by -= geometry::offset_excess_m(nested);
    return shrinks ? operand->shrink(by, nested) : operand->grow(by, nested);
  }
};

Zones::Zones(const sema::Spec& spec)
    : spec_(spec),
      nested_(spec),
      known_(spec.zones.size()),
      solids_(spec, [this](const sema::ZoneExpr& base, Bound bound) {
        return std::visit(Evaluate{*this, bound}, base.node);
      }) {}

const geometry::Region* Zones::within(sema::ZoneId zone) {
  const Region& known = region(zone, Bound::within);
  return known ? &*known : nullptr;
}

const Zones::Region& Zones::region(sema::ZoneId zone, Bound bound) {
  Known& known = known_[static_cast<std::size_t>(zone)];
  std::optional<Region>& region = known.regions[bound == Bound::within ? 0 : 1];
  if (!region) {
    Region made = std::visit(Evaluate{*this, bound}, spec_[zone].value->node);
    region = made && !made->empty() ? std::move(made) : std::nullopt;
  }
  return *region;
}

void Zones::receive(sema::ZoneId zone, std::shared_ptr<const ReceivedZone> received) {
  Known& known = known_[static_cast<std::size_t>(zone)];
  if (known.received == received) return;
  known = {};
  known.received = std::move(received);
  if (known.received == nullptr) return;
  const geometry::ReceivedRegions& regions = known.received->regions;
  known.regions = {Region(regions.within), Region(regions.around)};
}

Zones::Outlines Zones::outlines(sema::ZoneId zone) {
  Known& known = known_[static_cast<std::size_t>(zone)];
  if (!known.outlined) {
    known.outlined = true;
    const Region within = region(zone, Bound::within), around = region(zone, Bound::around);
    if (within && around) {
      known.within = std::make_unique<Outline>(*within);
      if (!same(*within, *around)) known.around = std::make_unique<Outline>(*around);
    }
  }
  return {known.within.get(), known.around ? known.around.get() : known.within.get()};
}

Span Zones::clearance(sema::ZoneId zone, const Whereabouts& at) {
  if (at.z) return solids_.clearance(zone, at);
  const auto& [x, y, none] = at;
  if (x.missing.missing) return unknown(x.missing.input);
  if (y.missing.missing) return unknown(y.missing.input);
  const Outlines zones = outlines(zone);
  const auto* received = std::get_if<sema::ZoneReceived>(&spec_[zone].value->node);
  if (zones.within == nullptr && received != nullptr) return unknown(received->input);
  if (zones.within == nullptr) return unknown(std::nullopt);
  if (!is_finite(x, y)) return between(Extended::infinity(-1), zones.around->deepest());
  const Place middle{(x.lo.value() + x.hi.value()) / 2, (y.lo.value() + y.hi.value()) / 2};
  const Root lower = clearance_of(*zones.within, middle);
  const Root upper = zones.around == zones.within ? lower : clearance_of(*zones.around, middle);
  const Rational width = x.hi.value() - middle.x, height = y.hi.value() - middle.y;
  if (width == 0 && height == 0) return between(lower.below, upper.above);
  const Rational half = square_root(Rational(width * width + height * height)).above;
  return between(Rational(lower.below - half), Rational(upper.above + half));
}

Span Zones::clearance(sema::ZoneId zone, const Trail& trail, bool greatest) {
  if (trail.is_unknown()) return unknown(trail.missing.input);
  const Outlines zones = outlines(zone);
  const auto* received = std::get_if<sema::ZoneReceived>(&spec_[zone].value->node);
  if (zones.within == nullptr) {
    return unknown(received != nullptr ? std::optional(received->input) : std::nullopt);
  }
  return clearance_of(*zones.within, *zones.around, trail, greatest);
}

std::optional<Rational> Zones::square_apart(sema::ZoneId one, sema::ZoneId other, Bound bound) {
  if (spec_[one].has_height) {
    const geometry::Solid *const a = solids_.of(one, bound), *const b = solids_.of(other, bound);
    return a && b ? std::optional(geometry::square_apart(*a, *b)) : std::nullopt;
  }
  const Region &a = region(one, bound), &b = region(other, bound);
  return a && b ? std::optional(geometry::square_apart(*a, *b)) : std::nullopt;
}

// What contains them is nearer than what surely lies in them.
Span Zones::apart(sema::ZoneId one, sema::ZoneId other) {
  if (other < one) std::swap(one, other);
  const auto known = apart_.find({one, other});
  if (known != apart_.end()) return known->second;
  const auto nearer = square_apart(one, other, Bound::around);
  const auto farther = nearer ? square_apart(one, other, Bound::within) : std::nullopt;
  const Span span = farther ? between(square_root(*nearer).below, square_root(*farther).above)
                            : unknown(std::nullopt);
  return apart_.emplace(std::pair(one, other), span).first->second;
}

bool Zones::surely_leaves(sema::ZoneId zone, const Trail& trail, bool outside) {
  const Outlines zones = outlines(zone);
  return zones.within != nullptr &&
         interp::surely_leaves(*zones.within, *zones.around, trail, outside);
}

const Outline* Zones::of_robots(sema::ZoneId zone) {
  Known& known = known_[static_cast<std::size_t>(zone)];
  if (!known.snapped) {
    known.snapped = true;
    const Region& within = region(zone, Bound::within);
    const auto on_grid = within ? geometry::snap_inside(*within) : std::nullopt;
    if (on_grid) known.of_robots = std::make_unique<Outline>(geometry::to_region(*on_grid));
  }
  return known.of_robots.get();
}

const Outline* Zones::around_received(sema::ZoneId zone) {
  Known& known = known_[static_cast<std::size_t>(zone)];
  if (!known.robots_around && known.received != nullptr) {
    const auto on_grid = geometry::snap_around(known.received->regions.around);
    if (on_grid) known.robots_around = std::make_unique<Outline>(geometry::to_region(*on_grid));
  }
  return known.robots_around.get();
}

Span Zones::clearance_of_robots(sema::ZoneId zone, const Place& place,
                                const std::optional<Rational>& height) {
  if (spec_[zone].has_height) {
    return height ? solids_.clearance_of_robots(zone, place, *height) : unknown(std::nullopt);
  }
  const auto received = sema::received_by(spec_, zone);
  const bool outside = received && received->outside;
  const Outline* const outline = outside ? around_received(received->zone) : of_robots(zone);
  if (outline == nullptr) return unknown(received ? std::optional(received->input) : std::nullopt);
  const Root gap = clearance_of(*outline, place);
  if (outside) return between(Rational(-gap.above), Rational(-gap.below));
  return between(gap.below, gap.above);
}

Zones::WayClearance Zones::clearance_of_way(sema::ZoneId zone, const Place& from, const Place& to) {
  const Outline* const outline = of_robots(zone);
  if (outline == nullptr) return {unknown(std::nullopt)};
  const Root gap = outline->distance(from, to);
  if (outline->contains(from, to)) return {between(gap.below, gap.above)};
  return {between(Rational(-gap.above), Rational(-gap.below)), true};
}

bool Zones::outside(sema::ZoneId zone, const Whereabouts& at) {
  if (at.z) return solids_.outside(zone, at);
  const auto& [x, y, none] = at;
  const Outlines zones = outlines(zone);
  if (x.missing.missing || y.missing.missing || zones.around == nullptr) return false;
  if (!is_finite(x, y) || compare(x.lo, x.hi) != 0 || compare(y.lo, y.hi) != 0) return false;
  return !zones.around->contains({x.lo.value(), y.lo.value()});
}

Span Zones::range(sema::ZoneId zone, const Whereabouts& at) {
  if (at.z) return solids_.range(zone, at);
  const auto& [x, y, none] = at;
  const bool is_received = std::holds_alternative<sema::ZoneReceived>(spec_[zone].value->node);
  if (is_received) return unknown(std::nullopt);  // it may be anything
  const Outlines zones = outlines(zone);
  if (x.missing.missing || y.missing.missing || zones.within == nullptr || !is_finite(x, y)) {
    return unknown(std::nullopt);
  }
  const Rational farthest =
      zones.within->farthest({x.lo.value(), y.lo.value()}, {x.hi.value(), y.hi.value()});
  return between(Rational(-farthest), zones.around->deepest());
}

}  // namespace rtac::interp
