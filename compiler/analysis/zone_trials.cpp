#include "compiler/analysis/zone_trials.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "compiler/analysis/boundless.h"
#include "compiler/analysis/dials.h"

namespace rtac::analysis {
namespace {

using sema::ZoneExpr;
using sema::ZoneOp;

ZoneOf zone_of(const Trials& trials) {
  return [&](ir::ZoneIndex table) { return trials.zone_of(table); };
}
// nullopt: a part is a slab, or cannot be as high as others.
std::optional<sema::Zone> made(const Trials& trials, ir::ZoneIndex from,
                               const std::vector<ZonePart>& parts) {
  const auto old = trials.zone_of(from);
  const auto all = declared(parts, zone_of(trials));
  if (!old || !all) return std::nullopt;
  auto zone = common_zone(trials.spec(), *old, *all);
  return zone.value ? std::optional(std::move(zone)) : std::nullopt;
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
  auto zone = old ? made(trials, from, {{{from}}}) : std::nullopt;
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
  auto zone = old ? made(trials, from, parts) : std::nullopt;
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
  const std::string left = trials != nullptr ? trials->left_last() : "";
  return "is needed, and not alone: " + (zone.empty() ? "" : "in `" + zone + "` ") +
         "other errors are left" + (left.empty() ? "" : " (" + left + ")");
}

std::string written_as(const Trials& trials, const std::vector<ZonePart>& parts) {
  const auto all = declared(parts, zone_of(trials));
  return all ? common_text(trials.spec(), *all) : "";
}

}  // namespace rtac::analysis
