#include "compiler/driver/zone_layers.h"

#include <algorithm>
#include <map>
#include <set>

#include "compiler/analysis/derive.h"
#include "compiler/analysis/zones.h"
#include "compiler/driver/outline_notes.h"
#include "compiler/geometry/bake.h"

namespace rtac::driver {
namespace {

using sema::FrameId;
using sema::ZoneId;

std::string base_name(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

// `yard.rta:3: rectangle (0 m, 0 m) to (6 m, 6 m)`, on one line and not too long.
// What is written, in one line of the legend.
std::string one_line(std::string_view written) {
  constexpr std::size_t text_max = 44;
  std::string text;
  for (const char ch : written) {
    const bool blank = ch == ' ' || ch == '\n' || ch == '\t' || ch == '\r';
    if (!blank) {
      text += ch;
    } else if (!text.empty() && text.back() != ' ') {
      text += ' ';
    }
    if (text.size() > text_max) break;
  }
  if (text.size() > text_max) {
    // not within a character of several bytes
    std::size_t end = text_max - 1;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    text = text.substr(0, end) + "...";
  }
  return text;
}

std::string origin_of(const Compilation& c, const sema::Zone& zone) {
  const auto at = c.sources.position(zone.name_range.file, zone.name_range.begin);
  return base_name(c.sources.path(zone.name_range.file)) + ":" + std::to_string(at.line) + ": " +
         one_line(c.sources.text(zone.value->range));
}

// What it moves with and when it is there: `around carrier during monday 07:30 .. 16:00`. A picture
// shows it where it is written, as if it were always there.
std::string conditions_of(const Compilation& c, const sema::Zone& zone) {
  const SourceRange& value = zone.value->range;
  const std::string_view rest = c.sources.text(value.file).substr(value.end);
  const std::string_view written = rest.substr(0, rest.find(';'));
  const std::size_t from = std::min(written.find("around"), written.find("during"));
  return from == std::string_view::npos ? "" : one_line(written.substr(from));
}

std::vector<std::string> mended(const sema::Zone& zone) {
  std::vector<std::string> texts;
  for (const OutlineNote& note : outline_notes(*zone.value)) texts.push_back(note.text);
  return texts;
}

std::size_t vertices_of(const geometry::Region& region) {
  std::size_t count = 0;
  for (const geometry::PolygonWithHoles& part : region.polygons()) {
    count += part.outer.size();
    for (const geometry::Ring& hole : part.holes) count += hole.size();
  }
  return count;
}

void add_zones(const ir::Block& block, std::set<ir::ZoneIndex>& zones) {
  for (const ir::Value& value : block.values) {
    if (const auto* clearance = std::get_if<ir::Clearance>(&value.op))
      zones.insert(clearance->zone);
    if (const auto* plan = std::get_if<ir::PlanInZone>(&value.op)) zones.insert(plan->zone);
  }
}

// Distances that decisions keep from the boundary of a zone, with those who ask for them.
using Distances = std::map<std::int64_t, std::vector<std::string>>;

void add(Distances& distances, std::int64_t distance_mm, const std::string& reason) {
  if (distance_mm <= 0) return;
  std::vector<std::string>& reasons = distances[distance_mm];
  if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) {
    reasons.push_back(reason);
  }
}

std::map<std::string, Distances> distances_by_zone(const ir::Module& module) {
  std::map<std::string, Distances> all;
  for (const ir::Decision& decision : module.decisions) {
    const auto summaries = analysis::summarise(module, decision);
    for (std::size_t m = 0; m < decision.monitors.size(); ++m) {
      const ir::Monitor& monitor = decision.monitors[m];
      std::set<ir::ZoneIndex> zones;
      add_zones(monitor.property, zones);
      for (const ir::ZoneIndex zone : zones) {
        Distances& distances = all[module[zone].name];
        add(distances, decision.body.radius_mm, "body of " + decision.kind);
        if (m < summaries.size()) {
          add(distances, summaries[m].return_clearance_mm, "return of " + monitor.name);
        }
      }
      for (const ir::Recovery* step : ir::steps_of(monitor.recovery)) {
        if (!ir::moves(step->kind)) continue;
        add(all[module[step->zone].name], step->route_clearance_mm, "ways of " + step->name);
      }
    }
  }
  return all;
}

std::string joined(const std::vector<std::string>& reasons) {
  std::string text;
  for (const std::string& each : reasons) text += (text.empty() ? "" : ", ") + each;
  return text;
}

void erode(ZoneLayer& layer, const Distances& distances) {
  if (distances.empty()) return;
  const std::size_t vertices = vertices_of(layer.region);
  if (vertices > eroded_vertices_max) {
    layer.remarks.push_back("erosions not drawn: " + std::to_string(vertices) +
                            " vertices, at most " + std::to_string(eroded_vertices_max) + " are");
    return;
  }
  for (const auto& [distance_mm, reasons] : distances) {
    Rational distance_m(static_cast<long>(distance_mm), 1000);
    distance_m.canonicalize();
    layer.erosions.push_back({distance_mm, joined(reasons), layer.region.shrink(distance_m)});
  }
}

std::vector<SiteMark> site_marks(const sema::Spec& spec) {
  std::vector<SiteMark> marks;
  for (const sema::Site& site : spec.sites) {
    for (const sema::Site::Place& place : site.places) {
      const std::string of = place.robot ? "(" + spec[*place.robot].name + ")" : "";
      marks.push_back({site.name + of, place.position.x.get_d(), place.position.y.get_d()});
    }
  }
  return marks;
}

// Seen from above: what overlaps may be apart in height.
void add_slabs(const sema::Zone& zone, const std::string& origin, const std::string& conditions,
               const std::vector<std::string>& remarks,
               const std::vector<analysis::ShownSlab>& slabs, ZoneSheet& sheet) {
  for (const analysis::ShownSlab& slab : slabs) {
    const auto& [floor, ceiling] = *slab.heights;
    const std::string heights =
        " from " + to_decimal(floor) + " m to " + to_decimal(ceiling) + " m";
    sheet.layers.push_back({zone.name + heights, origin, conditions, slab.region, {}, remarks});
  }
}

}  // namespace

std::vector<ZoneSheet> zone_sheets(const Compilation& c) {
  const sema::Spec& spec = *c.spec;
  const auto distances = distances_by_zone(*c.module);
  const auto regions = analysis::exact_zones(spec);
  std::vector<ZoneSheet> sheets;
  for (const sema::Frame& frame : spec.frames) sheets.push_back({frame.name, {}, {}});
  for (std::size_t i = 0; i < spec.zones.size(); ++i) {
    const sema::Zone& zone = spec.zones[i];
    if (zone.name.empty() || regions[i].empty()) continue;
    if (zone.has_height) {
      add_slabs(zone, origin_of(c, zone), conditions_of(c, zone), mended(zone), regions[i],
                sheets[static_cast<std::size_t>(zone.frame)]);
      continue;
    }
    ZoneLayer layer{
        zone.name, origin_of(c, zone), conditions_of(c, zone), regions[i].front().region,
        {},        mended(zone)};
    const auto asked = distances.find(zone.name);
    if (asked != distances.end()) erode(layer, asked->second);
    sheets[static_cast<std::size_t>(zone.frame)].layers.push_back(std::move(layer));
  }
  sheets[static_cast<std::size_t>(sema::map_frame)].sites = site_marks(spec);
  std::erase_if(sheets, [](const ZoneSheet& s) { return s.layers.empty() && s.sites.empty(); });
  return sheets;
}

}  // namespace rtac::driver
