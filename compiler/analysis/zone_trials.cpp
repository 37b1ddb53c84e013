#include "compiler/analysis/zone_trials.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "compiler/analysis/boundless.h"
#include "compiler/analysis/dials.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/zone_text.h"

namespace rtac::analysis {
namespace {

using sema::ZoneExpr;
using sema::ZoneExprPtr;
using sema::ZoneOp;

sema::ZonePolygon rectangle(const Box& box) {
  const auto corner = [](std::int64_t x_m, std::int64_t y_m) {
    return sema::Point{Rational(static_cast<long>(x_m)), Rational(static_cast<long>(y_m))};
  };
  sema::ZonePolygon made;
  made.outer.points = {corner(box.low_x, box.low_y), corner(box.high_x, box.low_y),
                       corner(box.high_x, box.high_y), corner(box.low_x, box.high_y)};
  return made;
}

// Writes a zone of others.
class Writer {
 public:
  Writer(const Trials& trials, const ir::Module& module, const SourceRange& range)
      : trials_(trials), module_(module), range_(range) {}

  // Null: a part is a slab.
  ZoneExprPtr common(const std::vector<ZonePart>& parts) const {
    ZoneExprPtr all, without, rest;  // `rest`: of the plane
    for (const ZonePart& part : parts) {
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
      for (const ir::ZoneIndex zone : part.either) {
        const auto id = trials_.zone_of(zone);
        if (!id) return nullptr;
        join(some, ZoneOp::unite, make(sema::ZoneRef{*id}));
      }
      join(all, ZoneOp::intersect, offset(std::move(some), -part.off_mm));
    }
    if (!all) return rest;
    if (without) join(all, ZoneOp::subtract, std::move(without));
    return all;
  }
  [[nodiscard]] bool has_height(const std::vector<ZonePart>& parts) const {
    return std::ranges::any_of(parts, [&](const ZonePart& part) {
      return part.layer || std::ranges::any_of(part.either, [&](ir::ZoneIndex zone) {
               return module_[zone].has_height();
             });
    });
  }

 private:
  template <class Node>
  ZoneExprPtr make(Node node) const {
    auto made = std::make_unique<ZoneExpr>();
    made->range = range_;
    made->node = std::move(node);
    return made;
  }
  ZoneExprPtr offset(ZoneExprPtr of, std::int64_t by_mm) const {
    return by_mm == 0 ? std::move(of) : make(sema::ZoneOffset{std::move(of), metres_of(by_mm)});
  }
  [[nodiscard]] ZoneExprPtr prism(const Layer& layer) const {
    return make(sema::ZonePrism{make(rectangle(layer.box)), metres_of(layer.floor_mm),
                                metres_of(layer.ceiling_mm)});
  }
  void join(ZoneExprPtr& to, ZoneOp op, ZoneExprPtr more) const {
    to = to ? make(sema::ZoneBinary{op, std::move(to), std::move(more)}) : std::move(more);
  }
  // The zone that a table is the rest of the plane of.
  std::optional<sema::ZoneId> outside_of(ir::ZoneIndex zone) const {
    const auto id = trials_.zone_of(zone);
    if (!id) return std::nullopt;
    const auto* of = std::get_if<sema::ZoneComplement>(&trials_.spec()[*id].value->node);
    return of == nullptr ? std::nullopt : std::optional(of->zone);
  }

  const Trials& trials_;
  const ir::Module& module_;
  SourceRange range_;
};

// nullopt: as of the writer.
std::optional<sema::Zone> made(const Trials& trials, const ir::Module& module, ir::ZoneIndex from,
                               const std::vector<ZonePart>& parts) {
  const auto old = trials.zone_of(from);
  if (!old) return std::nullopt;
  const sema::Zone& moved_in = trials.spec()[*old];
  const Writer writer(trials, module, moved_in.value->range);
  ZoneExprPtr value = writer.common(parts);
  if (!value) return std::nullopt;
  return sema::Zone{
      "", moved_in.name_range, std::move(value), moved_in.frame, writer.has_height(parts), {}};
}
std::string name_of(const ir::Module& module, const std::vector<ZonePart>& parts) {
  std::string name;
  for (const ZonePart& part : parts) {
    for (const ir::ZoneIndex of : part.either) name += module[of].name + " ";
    if (part.layer) {
      name +=
          std::to_string(part.layer->floor_mm) + " to " + std::to_string(part.layer->ceiling_mm);
    }
    name += std::to_string(part.off_mm) + ";";
  }
  return name;
}

// What of `from` lies in the box. false: it is in a frame of its own, too.
bool works_in_box(Trials& trials, const Fault& fault, const SourceRange& all_of,
                  const std::string& recovery, const ir::Module& module, ir::ZoneIndex from,
                  const Box& box) {
  const auto old = trials.zone_of(from);
  auto zone = old ? made(trials, module, from, {{{from}}}) : std::nullopt;
  if (!zone || zone->frame != sema::map_frame) return false;
  const SourceRange range = zone->value->range;
  auto end = std::make_unique<ZoneExpr>(ZoneExpr{range, rectangle(box)});
  zone->value = std::make_unique<ZoneExpr>(
      ZoneExpr{range, sema::ZoneBinary{ZoneOp::intersect, std::move(zone->value), std::move(end)}});
  return works_in_zone(trials, fault, all_of, recovery, "a box in " + module[from].name, *old,
                       std::move(*zone));
}

}  // namespace

std::optional<bool> works_within(Trials& trials, const Fault& fault, const SourceRange& all_of,
                                 const std::string& recovery, const ir::Module& module,
                                 ir::ZoneIndex from, const std::vector<ZonePart>& parts) {
  const auto old = trials.zone_of(from);
  auto zone = old ? made(trials, module, from, parts) : std::nullopt;
  const bool layered =
      std::ranges::any_of(parts, [](const ZonePart& p) { return p.layer.has_value(); });
  if (!zone || (layered && zone->frame != sema::map_frame)) return std::nullopt;
  return works_in_zone(trials, fault, all_of, recovery, name_of(module, parts), *old,
                       std::move(*zone));
}

std::string with_an_end(Trials& trials, const Fault& fault, const SourceRange& all_of,
                        const ir::Module& module, const ir::Recovery& recovery,
                        const std::vector<ir::SiteTable::Place>& places) {
  constexpr std::int64_t times = 4;  // as wide around it as where control comes back
  const ir::ZoneTable& zone = module[recovery.zone];
  const Box box = box_around(zone, places, times * recovery.return_clearance_mm);
  const bool works = works_in_box(trials, fault, all_of, recovery.name, module, recovery.zone, box);
  return works ? "works, such as `" + bounded(zone, box) + "`" : "is needed";
}

std::string needed_besides(const Trials* trials, const std::string& zone) {
  const bool untried = trials != nullptr && trials->ran_out();
  if (untried) {
    return "is needed" + (zone.empty() ? "" : ", such as `" + zone + "`") +
           ", which there was no time to try";
  }
  return "is needed, and not alone: " + (zone.empty() ? "" : "in `" + zone + "` ") +
         "other errors are left";
}

std::string written_as(const Trials& trials, const ir::Module& module,
                       const std::vector<ZonePart>& parts) {
  const ZoneExprPtr value = Writer(trials, module, {}).common(parts);
  return value ? zone_text(trials.spec(), *value) : "";
}

}  // namespace rtac::analysis
