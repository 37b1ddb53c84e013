#include "compiler/interp/solids.h"

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <variant>

namespace rtac::interp {
namespace {

bool is_missing(const Whereabouts& at) {
  return at.x.missing.missing || at.y.missing.missing || at.z->missing.missing;
}
bool is_finite(const Whereabouts& at) {
  const std::initializer_list<const Span*> all = {&at.x, &at.y, &*at.z};
  return std::ranges::all_of(
      all, [](const Span* span) { return span->lo.is_finite() && span->hi.is_finite(); });
}
Rational middle(const Span& span) {
  return (span.lo.value() + span.hi.value()) / 2;
}
Rational square(const Rational& value) {
  return value * value;
}
// From a height to a band of heights.
Rational gap(const Rational& z, const Rational& floor, const Rational& ceiling) {
  return std::max({Rational(floor - z), Rational(z - ceiling), Rational(0)});
}

}  // namespace

Surface::Surface(const geometry::Solid& solid) {
  for (const geometry::Slab& slab : solid.slabs()) {
    levels_.push_back({slab.floor, slab.ceiling, Outline(slab.region)});
  }
}

bool Surface::contains(const Place& place, const Rational& z) const {
  return std::ranges::any_of(levels_, [&](const Level& level) {
    return level.floor <= z && z <= level.ceiling && level.outline.contains(place);
  });
}

// A floor or ceiling counts straight below or above only: what is nearest of it elsewhere is its
// edge, where a wall begins.
Rational Surface::square_to(const Place& place, const Rational& z) const {
  std::optional<Rational> least;
  const auto take = [&](const Rational& square) {
    if (!least || square < *least) least = square;
  };
  bool below = false;  // the place is in the slab that ends where the next one may begin
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    const Level& level = levels_[i];
    const bool touches = i > 0 && levels_[i - 1].ceiling == level.floor;
    const bool inside = level.outline.contains(place);
    if (below && !touches) take(square(z - levels_[i - 1].ceiling));
    if (inside != (touches && below)) take(square(z - level.floor));
    take(level.outline.square_to(place) + square(gap(z, level.floor, level.ceiling)));
    below = inside;
  }
  if (below) take(square(z - levels_.back().ceiling));
  return *least;
}

Root Surface::clearance(const Place& place, const Rational& z) const {
  const Root distance = square_root(square_to(place, z));
  if (contains(place, z)) return distance;
  return {-distance.above, -distance.below};
}

// Of the corners, the one whose farthest corner of the box is nearest.
Rational Surface::farthest(const Box& box) const {
  std::optional<Rational> least;
  for (const Level& level : levels_) {
    const Rational across = level.outline.square_of_farthest(box.low, box.high);
    for (const Rational& height : {level.floor, level.ceiling}) {
      const Rational up =
          std::max(abs(Rational(box.z_low - height)), abs(Rational(box.z_high - height)));
      const Rational all = across + square(up);
      if (!least || all < *least) least = all;
    }
  }
  return square_root(*least).above;
}

Rational Surface::deepest() const {
  auto [low, high] = levels_.front().outline.extent();
  for (const Level& level : levels_) {
    const auto [from, to] = level.outline.extent();
    low = {std::min(low.x, from.x), std::min(low.y, from.y)};
    high = {std::max(high.x, to.x), std::max(high.y, to.y)};
  }
  return std::min({Rational(high.x - low.x), Rational(high.y - low.y),
                   Rational(levels_.back().ceiling - levels_.front().floor)}) /
         2;
}

struct Solids::Evaluate {
  Solids& solids;
  Bound bound;

  static Bound other(Bound b) { return b == Bound::within ? Bound::around : Bound::within; }
  Solid of(const sema::ZoneExpr& expr, Bound of_bound) const {
    return std::visit(Evaluate{solids, of_bound}, expr.node);
  }
  Solid operator()(const sema::ZonePrism& node) const {
    auto base = solids.base_(*node.base, bound);
    if (!base) return std::nullopt;
    return geometry::Solid::prism(std::move(*base), node.floor, node.ceiling);
  }
  // As zones of the plane are: heights have no error.
  Solid operator()(const sema::ZoneImport& node) const {
    Solid zone = geometry::Solid();
    for (const auto& group : node.inclusions) {
      Solid all;
      for (const auto& each : group) {
        const Solid one = area(each, bound);
        if (!one) return std::nullopt;
        all = all ? all->intersect(*one) : *one;
      }
      if (all) zone = zone->unite(*all);
    }
    for (const auto& each : node.exclusions) {
      const Solid one = area(each, other(bound));
      if (!one) return std::nullopt;
      zone = zone->subtract(*one);
    }
    return bound == Bound::within ? zone->shrink(node.error, 0) : zone->grow(node.error, 0);
  }
  Solid area(const sema::ZoneImport::Area& area, Bound of_bound) const {
    if (area.bands.size() != area.parts.size()) return std::nullopt;  // of the plane
    const Rational farthest = 536'000;  // without a limit: as far as zones reach
    geometry::Solid all;
    for (std::size_t i = 0; i < area.parts.size(); ++i) {
      const sema::ZoneExpr shape{
          {},
          std::visit([](const auto& part) { return decltype(sema::ZoneExpr::node)(part); },
                     area.parts[i])};
      auto base = solids.base_(shape, of_bound);
      if (!base) return std::nullopt;
      const auto& [floor, ceiling] = area.bands[i];
      all = all.unite(geometry::Solid::prism(std::move(*base), floor.value_or(-farthest),
                                             ceiling.value_or(farthest)));
    }
    return all;
  }
  Solid operator()(const sema::ZoneRef& node) const { return solids.solid(node.zone, bound); }
  Solid operator()(const sema::ZoneComplement& node) const {
    const Solid& of = solids.solid(node.zone, other(bound));
    return of ? Solid(geometry::Solid::everywhere().subtract(*of)) : std::nullopt;
  }
  Solid operator()(const sema::ZoneBinary& node) const {
    const bool subtracts = node.op == sema::ZoneOp::subtract;
    const Solid left = of(*node.left, bound);
    const Solid right = of(*node.right, subtracts ? other(bound) : bound);
    if (!left || !right) return std::nullopt;
    if (subtracts) return left->subtract(*right);
    return node.op == sema::ZoneOp::unite ? left->unite(*right) : left->intersect(*right);
  }
  // Sideways as in the plane; up and down exact.
  Solid operator()(const sema::ZoneOffset& node) const {
    const Solid operand = of(*node.operand, bound);
    if (!operand) return std::nullopt;
    const Rational upright = abs(node.distance);
    const bool shrinks = sgn(node.distance) < 0;
    Rational across = upright;
    const std::size_t nested = solids.nested_.with(node);
    if (shrinks != (bound == Bound::within)) across -= geometry::offset_excess_m(nested);
    return shrinks ? operand->shrink(across, upright, nested)
                   : operand->grow(across, upright, nested);
  }
  // Zones of the plane stand under a prism.
  template <class Flat>
  Solid operator()(const Flat&) const {
    return std::nullopt;
  }
};

Solids::Solids(const sema::Spec& spec, Base base)
    : spec_(spec), nested_(spec), base_(std::move(base)), known_(spec.zones.size()) {}

const Solids::Solid& Solids::solid(sema::ZoneId zone, Bound bound) {
  std::optional<Solid>& known =
      known_[static_cast<std::size_t>(zone)].solids[bound == Bound::within ? 0 : 1];
  if (!known) {
    Solid made = std::visit(Evaluate{*this, bound}, spec_[zone].value->node);
    known = made && !made->empty() ? std::move(made) : std::nullopt;
  }
  return *known;
}

const geometry::Solid* Solids::of(sema::ZoneId zone, Bound bound) {
  const Solid& known = solid(zone, bound);
  return known ? &*known : nullptr;
}

const Solids::Known& Solids::surfaces(sema::ZoneId zone) {
  Known& known = known_[static_cast<std::size_t>(zone)];
  if (!known.surfaced) {
    known.surfaced = true;
    const Solid within = solid(zone, Bound::within), around = solid(zone, Bound::around);
    if (within && around) {
      known.within = std::make_unique<Surface>(*within);
      known.around = std::make_unique<Surface>(*around);
    }
  }
  return known;
}

Span Solids::clearance(sema::ZoneId zone, const Whereabouts& at) {
  for (const Span* span : {&at.x, &at.y, &*at.z}) {
    if (span->missing.missing) return unknown(span->missing.input);
  }
  const Known& known = surfaces(zone);
  if (!known.within) return unknown(std::nullopt);
  if (!is_finite(at)) return between(Extended::infinity(-1), known.around->deepest());
  const Place place{middle(at.x), middle(at.y)};
  const Rational z = middle(*at.z);
  const Root lower = known.within->clearance(place, z);
  const Root upper = known.around->clearance(place, z);
  const Rational half_square = square(at.x.hi.value() - place.x) +
                               square(at.y.hi.value() - place.y) + square(at.z->hi.value() - z);
  if (half_square == 0) return between(lower.below, upper.above);
  const Rational half = square_root(half_square).above;
  return between(Rational(lower.below - half), Rational(upper.above + half));
}

Span Solids::clearance_of_robots(sema::ZoneId zone, const Place& place, const Rational& z) {
  Known& known = known_[static_cast<std::size_t>(zone)];
  if (!known.snapped) {
    known.snapped = true;
    const Solid& within = solid(zone, Bound::within);
    const auto on_grid = within ? geometry::snap_inside(*within) : std::nullopt;
    std::vector<geometry::Slab> slabs;
    for (const geometry::SnappedSlab& s : on_grid.value_or(geometry::SnappedSolid{})) {
      slabs.push_back(
          {Rational(s.floor_mm, 1000), Rational(s.ceiling_mm, 1000), geometry::to_region(s.zone)});
      slabs.back().floor.canonicalize();
      slabs.back().ceiling.canonicalize();
    }
    if (!slabs.empty()) {
      known.of_robots = std::make_unique<Surface>(geometry::Solid::of_slabs(slabs));
    }
  }
  if (!known.of_robots) return unknown(std::nullopt);
  const Root gap = known.of_robots->clearance(place, z);
  return between(gap.below, gap.above);
}

bool Solids::outside(sema::ZoneId zone, const Whereabouts& at) {
  const Known& known = surfaces(zone);
  if (is_missing(at) || !known.around || !is_finite(at)) return false;
  const std::initializer_list<const Span*> all = {&at.x, &at.y, &*at.z};
  const bool exact =
      std::ranges::all_of(all, [](const Span* span) { return compare(span->lo, span->hi) == 0; });
  return exact && !known.around->contains({at.x.lo.value(), at.y.lo.value()}, at.z->lo.value());
}

Span Solids::range(sema::ZoneId zone, const Whereabouts& at) {
  const Known& known = surfaces(zone);
  if (is_missing(at) || !known.within || !is_finite(at)) return unknown(std::nullopt);
  const Rational farthest = known.within->farthest({{at.x.lo.value(), at.y.lo.value()},
                                                    {at.x.hi.value(), at.y.hi.value()},
                                                    at.z->lo.value(),
                                                    at.z->hi.value()});
  return between(Rational(-farthest), known.around->deepest());
}

}  // namespace rtac::interp
