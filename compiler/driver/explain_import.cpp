// What became of zones that are not taken as they are: files, and how they were placed on the map;
// circles; and how exactly; outlines that are mended.
#include <algorithm>

#include "compiler/driver/explain_line.h"
#include "compiler/driver/explain_text.h"
#include "compiler/driver/outline_notes.h"
#include "compiler/geometry/region.h"
#include "compiler/geometry/united.h"
#include "compiler/sema/dimension.h"
#include "compiler/support/overloaded.h"

namespace rtac::driver {
namespace {

namespace dims = sema::dims;

geometry::Ring ring_of(const sema::ZonePolygon::Ring& from) {
  geometry::Ring to;
  for (const sema::Point& p : from.points) to.push_back({p.x, p.y});
  return to;
}

// Not shorter than the outline is.
Rational length_most(const geometry::Ring& ring) {
  Rational all = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const geometry::Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    all += abs(b.x - a.x) + abs(b.y - a.y);
  }
  return all;
}

// Do polygons of the area lie over one another, by more than what touches in the file may on the
// map? Formats ask that they do not, or say nothing; the union is what is taken.
bool parts_overlap(const sema::ZoneImport::Area& area, const Rational& error) {
  std::vector<geometry::Region> parts;
  Rational sum = 0, length = 0;
  for (const auto& part : area.parts) {
    const auto* polygon = std::get_if<sema::ZonePolygon>(&part);
    if (polygon == nullptr) continue;
    const geometry::Ring outer = ring_of(polygon->outer);
    std::vector<geometry::Ring> holes;
    for (const auto& hole : polygon->holes) holes.push_back(ring_of(hole));
    auto region = geometry::Region::polygon(outer, holes);
    if (!std::holds_alternative<geometry::Region>(region)) return false;  // reported
    parts.push_back(std::get<geometry::Region>(std::move(region)));
    sum += parts.back().area();
    length += length_most(outer);
    for (const geometry::Ring& hole : holes) length += length_most(hole);
  }
  if (parts.size() < 2) return false;
  const auto all = geometry::united(std::move(parts));
  return all && sum - all->area() > error * length;
}

class ImportRemarks {
 public:
  std::vector<Remark> run(const sema::Spec& spec) {
    if (spec.origin) origin(*spec.origin);
    for (const sema::Zone& zone : spec.zones) look(*zone.value);
    return std::move(out_);
  }

 private:
  void origin(const sema::Origin& origin) {
    std::vector<std::string> details = {
        "(0 m, 0 m) of the map; x to the east, y to the north",
        "azimuthal equidistant on WGS 84: distances from here are exact"};
    if (origin.altitude) {
      details.push_back("altitude " + sema::show(origin.altitude->value, dims::length) +
                        " above mean sea level");
    }
    const SourceRange& first = origin.latitude.range;
    out_.push_back({{first.file, first.begin, origin.longitude.range.end},
                    "origin of the map",
                    std::move(details)});
  }

  void look(const sema::ZoneExpr& expr) {
    std::visit(Overloaded{
                   [&](const sema::ZonePolygon& node) { polygon(expr.range, node); },
                   [&](const sema::ZoneCircle& node) { circle(expr.range, node); },
                   [](const sema::ZoneRef&) {},
                   [&](const sema::ZonePrism& node) { look(*node.base); },
                   [](const sema::ZoneComplement&) {},  // of a zone of its own
                   [&](const sema::ZoneBinary& node) {
                     look(*node.left);
                     look(*node.right);
                   },
                   [&](const sema::ZoneOffset& node) { look(*node.operand); },
                   [&](const sema::ZoneImport& node) { imported(expr.range, node); },
                   [](const sema::ZoneReceived&) {},
               },
               expr.node);
  }

  // An outline that is taken as it is written says nothing.
  void polygon(const SourceRange& source, const sema::ZonePolygon& node) {
    std::vector<std::string> details;
    add_notes(outline_notes(node), details);
    if (!details.empty()) out_.push_back({source, "outline", std::move(details)});
  }
  static void add_notes(const std::vector<OutlineNote>& notes, std::vector<std::string>& details) {
    for (const OutlineNote& note : notes) {
      details.push_back(note.text + (note.first.empty() ? "" : "; see " + note.first));
    }
  }
  void circle(const SourceRange& source, const sema::ZoneCircle& node) {
    const std::size_t edges = geometry::circle_edges(node.radius);
    const Rational tenths_mm = geometry::circle_error(node.radius, edges) * 10'000;
    const Rational error_mm(ceil_to_int(tenths_mm), 10);
    out_.push_back({source,
                    "circle of radius " + sema::show(node.radius, dims::length),
                    {"a polygon of " + std::to_string(edges) +
                         " edges: in the circle where robots may be, around it where it is taken "
                         "away",
                     "at most " + to_decimal(error_mm) + " mm off"}});
  }
  static std::string parts(const sema::ZoneImport& node) {
    std::size_t areas = 0;
    for (const auto& group : node.inclusions) areas += group.size();
    std::string text = count(areas, "area");
    if (!node.exclusions.empty()) {
      text += " less " + count(node.exclusions.size(), "exclusion");
    }
    return text;
  }
  // Stacked volumes have heights, and lie over one another as they should.
  static void note_overlaps(const sema::ZoneImport& node, std::vector<std::string>& details) {
    std::size_t areas = 0;
    const auto look_at = [&](const sema::ZoneImport::Area& area) {
      if (area.bands.empty() && parts_overlap(area, node.error)) ++areas;
    };
    for (const auto& group : node.inclusions) std::ranges::for_each(group, look_at);
    std::ranges::for_each(node.exclusions, look_at);
    if (areas == 0) return;
    details.push_back(
        "polygons of " + count(areas, "area") +
        " overlap: their union is taken, and a hole of one that another covers is filled");
  }
  void imported(const SourceRange& source, const sema::ZoneImport& node) {
    std::string positions = count(node.vertices, "position");
    if (node.points > node.vertices) {
      positions +=
          ", placed as " + std::to_string(node.points) + " points: outlines meet or cross" +
          (node.degrees ? ", or long edges, straight in degrees, are bent on the map" : "");
    }
    std::vector<std::string> details = {
        parts(node) + ", up to " + sema::show(node.farthest, dims::length) + " from (0 m, 0 m)",
        std::move(positions),
        node.degrees ? "projected from degrees: azimuthal equidistant on WGS 84, about the origin"
                     : "in metres, as the file has it"};
    if (node.error > 0) {
      details.push_back(
          "boundary and distances are off by at most " + to_decimal(Rational(node.error * 1000)) +
          " mm: moved in by that for who has to be inside, out for who has to be outside");
    } else {
      details.emplace_back("exact");
    }
    note_overlaps(node, details);
    add_notes(outline_notes(node), details);
    details.insert(details.end(), node.remarks.begin(), node.remarks.end());
    out_.push_back({source, "import \"" + node.path + "\"", std::move(details)});
  }

  std::vector<Remark> out_;
};

}  // namespace

std::vector<Remark> import_remarks(const Compilation& c) {
  return ImportRemarks().run(*c.spec);
}

}  // namespace rtac::driver
