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

class Writer {
 public:
  Writer(const sema::Spec& spec, const SourceRange& range) : spec_(spec), range_(range) {}

  [[nodiscard]] ZoneExprPtr common(const std::vector<DeclaredPart>& parts) const {
    ZoneExprPtr all, without, rest;  // `rest`: of the plane
    for (const DeclaredPart& part : parts) {
      if (part.layer) {
        join(all, ZoneOp::intersect, prism(*part.layer));
        continue;
      }
      const auto hole = part.either.size() == 1 ? outside_of(part.either[0]) : std::nullopt;
      if (hole) {
        join(rest, ZoneOp::intersect, offset(make(sema::ZoneComplement{*hole}), -part.off_mm));
        join(without, ZoneOp::unite, offset(make(sema::ZoneRef{*hole}), part.off_mm));
        continue;
      }
      ZoneExprPtr some;
      for (const sema::ZoneId zone : part.either) {
        join(some, ZoneOp::unite, make(sema::ZoneRef{zone}));
      }
      join(all, ZoneOp::intersect, offset(std::move(some), -part.off_mm));
    }
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
    return make(sema::ZonePrism{make(rectangle(layer.box)), metres_of(layer.floor_mm),
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

  const sema::Spec& spec_;
  SourceRange range_;
};

}  // namespace

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
  const bool has_height = std::ranges::any_of(parts, [&](const DeclaredPart& part) {
    const auto is_high = [&](sema::ZoneId zone) { return spec[zone].has_height; };
    return part.layer || std::ranges::any_of(part.either, is_high);
  });
  return {"",
          moved_in.name_range,
          Writer(spec, moved_in.value->range).common(parts),
          moved_in.frame,
          has_height,
          {}};
}

std::string common_text(const sema::Spec& spec, const std::vector<DeclaredPart>& parts) {
  return zone_text(spec, *Writer(spec, {}).common(parts));
}

}  // namespace rtac::analysis
