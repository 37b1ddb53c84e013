#include "compiler/analysis/common_zone.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "compiler/analysis/sides.h"
#include "compiler/analysis/zone_text.h"

namespace rtac::analysis {
namespace {

using sema::ZoneExpr;
using sema::ZoneExprPtr;
using sema::ZoneOp;

// From the lowest place of a zone to the highest one, or farther; m.
struct Heights {
  Rational floor, ceiling;
};
Heights united(const Heights& a, const Heights& b) {
  return {std::min(a.floor, b.floor), std::max(a.ceiling, b.ceiling)};
}
// nullopt: it lies in the plane, or is not told by numbers in the specification.
std::optional<Heights> heights_of(const sema::Spec& spec, const ZoneExpr& zone) {
  if (const auto* ref = std::get_if<sema::ZoneRef>(&zone.node)) {
    return heights_of(spec, *spec[ref->zone].value);
  }
  if (const auto* prism = std::get_if<sema::ZonePrism>(&zone.node)) {
    return Heights{prism->floor, prism->ceiling};
  }
  if (const auto* by = std::get_if<sema::ZoneOffset>(&zone.node)) {
    auto of = heights_of(spec, *by->operand);
    if (of) of = Heights{of->floor - by->distance, of->ceiling + by->distance};
    return of;
  }
  const auto* both = std::get_if<sema::ZoneBinary>(&zone.node);
  if (both == nullptr) return std::nullopt;
  const auto left = heights_of(spec, *both->left);
  if (both->op != ZoneOp::unite) return left;
  const auto right = heights_of(spec, *both->right);
  return left && right ? std::optional(united(*left, *right)) : std::nullopt;
}

class Writer {
 public:
  Writer(const sema::Spec& spec, const SourceRange& range) : spec_(spec), range_(range) {}

  [[nodiscard]] bool have_height(const std::vector<DeclaredPart>& parts) const {
    return std::ranges::any_of(parts, [&](const DeclaredPart& part) {
      return part.layer || std::ranges::any_of(part.either, [&](sema::ZoneId zone) {
               return spec_[zone].has_height;
             });
    });
  }
  // Null: zones of the plane have to be as high as one that does not say how high it is.
  [[nodiscard]] ZoneExprPtr common(const std::vector<DeclaredPart>& parts) {
    as_high_as_ = heights(parts);
    if (have_height(parts) && !as_high_as_ && std::ranges::any_of(parts, [&](const auto& part) {
          return std::ranges::any_of(part.either, [&](sema::ZoneId z) { return is_flat(z); });
        })) {
      return nullptr;
    }
    ZoneExprPtr all, without, rest;  // `rest`: of the plane
    for (const DeclaredPart& part : parts) {
      if (part.layer) {
        if (part.layer->box) join(all, ZoneOp::intersect, prism(*part.layer));
        continue;
      }
      const auto hole = part.either.size() == 1 ? outside_of(part.either[0]) : std::nullopt;
      if (hole) {
        join(rest, ZoneOp::intersect, offset(make(sema::ZoneComplement{*hole}), -part.off_mm));
        auto grown = offset(make(sema::ZoneRef{*hole}), part.off_mm);
        join(without, ZoneOp::unite, is_flat(*hole) ? as_high(std::move(grown)) : std::move(grown));
        continue;
      }
      // what lies in the plane is offset there
      const bool flat = std::ranges::all_of(part.either, [&](auto zone) { return is_flat(zone); });
      ZoneExprPtr some;
      for (const sema::ZoneId zone : part.either) {
        auto one = make(sema::ZoneRef{zone});
        join(some, ZoneOp::unite,
             is_flat(zone) && !flat ? as_high(std::move(one)) : std::move(one));
      }
      some = offset(std::move(some), -part.off_mm);
      join(all, ZoneOp::intersect, flat ? as_high(std::move(some)) : std::move(some));
    }
    if (!all && rest && have_height(parts)) all = as_high(std::move(rest));
    if (!all) return rest;
    if (without) join(all, ZoneOp::subtract, std::move(without));
    return all;
  }

 private:
  template <class Node>
  ZoneExprPtr make(Node node) const {
    auto made = std::make_unique<ZoneExpr>();
    made->range = range_;
    made->node = std::move(node);
    return made;
  }
  [[nodiscard]] ZoneExprPtr offset(ZoneExprPtr of, std::int64_t by_mm) const {
    return by_mm == 0 ? std::move(of) : make(sema::ZoneOffset{std::move(of), metres_of(by_mm)});
  }
  [[nodiscard]] ZoneExprPtr prism(const Layer& layer) const {
    return make(sema::ZonePrism{make(rectangle(*layer.box)), metres_of(layer.floor_mm),
                                metres_of(layer.ceiling_mm)});
  }
  void join(ZoneExprPtr& to, ZoneOp op, ZoneExprPtr more) const {
    to = to ? make(sema::ZoneBinary{op, std::move(to), std::move(more)}) : std::move(more);
  }
  // The zone that one is the rest of the plane of.
  [[nodiscard]] std::optional<sema::ZoneId> outside_of(sema::ZoneId zone) const {
    const auto* of = std::get_if<sema::ZoneComplement>(&spec_[zone].value->node);
    return of == nullptr ? std::nullopt : std::optional(of->zone);
  }

  [[nodiscard]] bool is_flat(sema::ZoneId zone) const { return !spec_[zone].has_height; }
  // Of the first part that says so.
  [[nodiscard]] std::optional<Heights> heights(const std::vector<DeclaredPart>& parts) const {
    for (const DeclaredPart& part : parts) {
      if (part.layer) {
        return Heights{metres_of(part.layer->floor_mm), metres_of(part.layer->ceiling_mm)};
      }
      const bool hole = part.either.size() == 1 && outside_of(part.either[0]);
      const auto of = hole ? std::nullopt : of_all(part.either);
      if (of) return of;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::optional<Heights> of_all(const std::vector<sema::ZoneId>& zones) const {
    std::optional<Heights> all;
    for (const sema::ZoneId zone : zones) {
      const auto of = heights_of(spec_, *spec_[zone].value);
      if (!of) return std::nullopt;
      all = all ? united(*all, *of) : *of;
    }
    return all;
  }
  [[nodiscard]] ZoneExprPtr as_high(ZoneExprPtr of) const {
    if (!as_high_as_) return of;
    return make(sema::ZonePrism{std::move(of), as_high_as_->floor, as_high_as_->ceiling});
  }

  const sema::Spec& spec_;
  SourceRange range_;
  std::optional<Heights> as_high_as_;  // zones of the plane; none: all of them lie there
};

}  // namespace

std::optional<Layer> layer_around(const geometry::Solid& solid) {
  if (solid.slabs().empty()) return std::nullopt;
  std::vector<Rational> xs, ys;
  for (const geometry::Slab& slab : solid.slabs()) {
    for (const auto& ring : slab.region.rings()) {
      for (const geometry::Point& p : ring) {
        xs.push_back(p.x);
        ys.push_back(p.y);
      }
    }
  }
  return Layer{Box{floor_to_int(std::ranges::min(xs)), floor_to_int(std::ranges::min(ys)),
                   ceil_to_int(std::ranges::max(xs)), ceil_to_int(std::ranges::max(ys))},
               floor_to_int(Rational(solid.slabs().front().floor * 1000)),
               ceil_to_int(Rational(solid.slabs().back().ceiling * 1000))};
}

std::optional<Layer> between(Layer layer, std::optional<std::int64_t> least_mm,
                             std::optional<std::int64_t> most_mm) {
  if (least_mm) layer.floor_mm = std::max(layer.floor_mm, *least_mm);
  if (most_mm) layer.ceiling_mm = std::min(layer.ceiling_mm, *most_mm);
  return layer.floor_mm < layer.ceiling_mm ? std::optional(layer) : std::nullopt;
}

sema::ZonePolygon rectangle(const Box& box) {
  const auto corner = [](std::int64_t x_m, std::int64_t y_m) {
    return sema::Point{Rational(static_cast<long>(x_m)), Rational(static_cast<long>(y_m))};
  };
  sema::ZonePolygon made;
  made.outer.points = {corner(box.low_x, box.low_y), corner(box.high_x, box.low_y),
                       corner(box.high_x, box.high_y), corner(box.low_x, box.high_y)};
  return made;
}

std::optional<std::vector<DeclaredPart>> declared(const std::vector<ZonePart>& parts,
                                                  const ZoneOf& zone_of) {
  std::vector<DeclaredPart> all;
  for (const ZonePart& part : parts) {
    DeclaredPart& of = all.emplace_back();
    of.off_mm = part.off_mm;
    of.layer = part.layer;
    for (const ir::ZoneIndex zone : part.either) {
      const auto id = zone_of(zone);
      if (!id) return std::nullopt;
      of.either.push_back(*id);
    }
  }
  return all;
}

sema::Zone common_zone(const sema::Spec& spec, sema::ZoneId from,
                       const std::vector<DeclaredPart>& parts) {
  const sema::Zone& moved_in = spec[from];
  Writer writer(spec, moved_in.value->range);
  return {"", moved_in.name_range, writer.common(parts), moved_in.frame, writer.have_height(parts),
          {}};
}

std::string common_text(const sema::Spec& spec, const std::vector<DeclaredPart>& parts) {
  const auto zone = Writer(spec, {}).common(parts);
  return zone ? zone_text(spec, *zone) : "";
}

}  // namespace rtac::analysis
