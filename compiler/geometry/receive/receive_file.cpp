#include "compiler/geometry/receive/receive_file.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/geometry/problem_text.h"
#include "compiler/geometry/receive/names.h"
#include "compiler/geometry/receive/refusals.h"
#include "compiler/geometry/united.h"

namespace rtac::geometry {
namespace {

using import::Area;
using import::Format;
using import::Role;

std::string name_of(Format format) {
  switch (format) {
    case Format::geojson:
      return "GeoJSON";
    case Format::wkt:
      return "well-known text";
    case Format::kml:
      return "KML";
    case Format::qgc_plan:
      return "a QGroundControl plan";
    case Format::waypoints:
      return "a file of way-points";
    case Format::ed269:
      return "ED-269";
    case Format::ed318:
      return "ED-318";
  }
  return "";
}

// The same area, a little smaller and a little larger than it is.
struct TwoSided {
  Region inner, outer;
};

std::optional<TwoSided> united_of(std::vector<TwoSided> all) {
  std::vector<Region> inner, outer;
  for (TwoSided& each : all) {
    inner.push_back(std::move(each.inner));
    outer.push_back(std::move(each.outer));
  }
  auto within = united(std::move(inner)), around = united(std::move(outer));
  if (!within || !around) return std::nullopt;
  return TwoSided{std::move(*within), std::move(*around)};
}
bool cross_too_often(const TwoSided& a, const TwoSided& b) {
  return geometry::cross_too_often({a.inner, b.outer}) ||
         geometry::cross_too_often({a.outer, b.inner});
}

class FileReceiver {
 public:
  FileReceiver(const ReceivedFile& as, std::size_t edges_most)
      : as_(as),
        edges_most_(edges_most),
        placer_({true, false, as.format == Format::geojson}, as.origin) {}

  std::variant<ReceivedRegions, RefusedZone> run(const std::string& text) {
    if (is_sound(text)) {
      if (auto regions = combined()) {
        regions->notes = std::move(areas_.notes);
        return std::move(*regions);
      }
    }
    return std::move(*refused_);
  }

 private:
  bool refuse(std::string where, std::string message, std::string help) {
    refused_ = RefusedZone{std::move(where), std::move(message), std::move(help)};
    return false;
  }

  // ---- what the file says

  bool is_sound(const std::string& text) {
    return is_format(text) && read(text) && has_no_limits() && settle() && is_small_enough();
  }
  // A file of another format would lose what only that one says, such as heights and times.
  bool is_format(const std::string& text) {
    const std::string whole = "the whole text";
    const Origin& origin = as_.origin;
    // Not-a-number is not within them.
    if (!(std::abs(origin.latitude_deg) <= latitude_deg_max) ||
        !(std::abs(origin.longitude_deg) <= 180)) {
      return refuse("the origin", "is no place that a map can have",
                    "latitudes of -89 to 89 deg and longitudes of -180 to 180 deg work, as the "
                    "specification declares them");
    }
    if (as_.format != Format::geojson && as_.format != Format::kml &&
        as_.format != Format::qgc_plan) {
      return refuse(whole, "cannot be received as " + name_of(as_.format),
                    "GeoJSON, KML and QGroundControl plans can; other files are imported by the "
                    "specification");
    }
    if (text.size() > file_bytes_most(edges_most_)) {
      return refuse(whole,
                    "has " + std::to_string(text.size()) + " bytes; at most " +
                        std::to_string(file_bytes_most(edges_most_)) + " are read",
                    "simplify the outline, or leave out what is no area");
    }
    const auto found = import::format_of("", text);
    if (!found || *found == as_.format) return true;
    return refuse(
        whole, "is " + name_of(*found) + ", and was received as " + name_of(as_.format),
        "say which format it is; of ED-269 and ED-318, limits of height and schedules are "
        "taken by the specification only");
  }
  bool read(const std::string& text) {
    import::Limits limits;
    limits.areas_max = edges_most_ + 16;
    limits.positions_max = 2 * edges_most_ + 16;  // rings repeat a vertex
    limits.values_max = 16 * edges_most_ + 1024;
    limits.bytes_max = file_bytes_most(edges_most_);
    auto read = import::read(as_.format, text, limits);
    if (const auto* failure = std::get_if<import::Failure>(&read)) return refuse(*failure);
    areas_ = std::get<import::Areas>(std::move(read));
    if (areas_.only_turned) return refuse(*areas_.only_turned);
    for (const Area& area : areas_.areas) {
      if (area.refusal) return refuse(*area.refusal);
    }
    return true;
  }
  bool refuse(RefusedZone why) {
    refused_ = std::move(why);
    return false;
  }
  bool refuse(const import::Failure& why) { return refuse(why.where, why.message, why.help); }

  bool has_no_limits() {
    for (const Area& area : areas_.areas) {
      if (area.unread_height) {
        return refuse(area.unread_height->where, area.unread_height->message,
                      "a zone that is received has no height: send an area without limits");
      }
      if (area.unread_time) {
        return refuse(area.unread_time->where, area.unread_time->message,
                      "a zone that is received has no times: send it when it applies, without "
                      "the property");
      }
      for (const import::Part& part : area.parts) {
        if (!part.band.floor && !part.band.ceiling) continue;
        return refuse(area.where, "applies between certain heights only",
                      "a zone that is received has no height: send an area without limits");
      }
      if (!area.schedule.empty()) {
        return refuse(area.where, "applies at certain times only",
                      "a zone that is received has no times: send it when it applies, and another "
                      "one when it does not");
      }
    }
    return true;
  }

  // ---- which of its areas are meant, and how they combine

  bool settle() {
    std::vector<const Area*> open;
    for (const Area& area : areas_.areas) {
      (area.role == Role::keep_in    ? inclusions_
       : area.role == Role::keep_out ? exclusions_
                                     : open)
          .push_back(&area);
    }
    const std::string whole = "the whole text";
    if (!open.empty()) {  // of a geometry, which has no roles
      if (as_.areas != FileAreas::unstated) {
        return refuse(whole, "has areas that are neither to stay in nor to keep out of",
                      "do not say which areas are meant: the zone is all of them");
      }
      inclusions_ = std::move(open);
      return true;
    }
    if (as_.areas == FileAreas::exclusions) {
      inclusions_ = std::exchange(exclusions_, {});
      return !inclusions_.empty() ||
             refuse(whole, "has no area to keep out of", "send one with an exclusion");
    }
    if (inclusions_.empty()) {
      return refuse(whole, "says where not to be, and not where to be",
                    "take it as the zone to keep out of, with `exclusions`");
    }
    inside_all_ = as_.areas == FileAreas::all;
    if (inclusions_.size() == 1 || as_.areas != FileAreas::unstated) return true;
    return refuse(whole,
                  "has " + std::to_string(inclusions_.size()) +
                      " areas to stay in, and autopilots differ in what that means",
                  "say whether inside `all` or `any` of them");
  }

  // ---- how much it is

  bool is_small_enough() {
    std::size_t vertices = 0;
    for (const Area& area : areas_.areas) {
      for (const import::Part& part : area.parts) vertices += vertices_of(part);
    }
    return vertices <= edges_most_ || too_many(vertices, "vertices");
  }
  static std::size_t vertices_of(const import::Part& part) {
    if (const auto* circle = std::get_if<import::Circle>(&part.shape)) {
      return circle_edges(Rational(circle->radius_m));
    }
    const auto& polygon = std::get<import::Polygon>(part.shape);
    std::size_t vertices = polygon.outer.positions.size();
    for (const import::Ring& hole : polygon.holes) vertices += hole.positions.size();
    return vertices;
  }
  bool too_many(std::size_t count, const std::string& of) {
    return refuse("the zone",
                  "has " + std::to_string(count) + " " + of + ", " + std::to_string(edges_most_) +
                      " are the most",
                  "circles take 32 to 256 edges, long edges of GeoJSON several: leave out what "
                  "changes the outline by little, or declare `zone[" +
                      std::to_string(count) + "]`");
  }

  // ---- where it is on the map

  std::optional<ReceivedRegions> combined() {
    std::vector<const import::Ring*> rings;
    import::add_rings(inclusions_, rings);
    import::add_rings(exclusions_, rings);
    placer_.meet(rings);
    auto zone = inside_all_ ? common() : union_of(inclusions_);
    if (!zone) return std::nullopt;
    if (!exclusions_.empty()) {
      const auto taken = union_of(exclusions_);
      if (!taken) return std::nullopt;
      if (cross_too_often(*zone, *taken)) return too_intricate();
      zone->inner = zone->inner.subtract(taken->outer);
      zone->outer = zone->outer.subtract(taken->inner);
    }
    // Its areas lie to each other as in the file, so that they are combined before.
    auto within = zone->inner.widened(Rational(-placer_.error()));
    auto around = zone->outer.widened(placer_.error());
    if (!within || !around) {
      refuse(too_sharp(placer_.error()));
      return std::nullopt;
    }
    ReceivedRegions regions{std::move(*within), std::move(*around)};
    if (!regions.within.empty()) return regions;
    refuse("the zone", "is empty, or nowhere wider than its places are exact",
           "an area that is a centimetre wide somewhere works");
    return std::nullopt;
  }
  std::optional<TwoSided> common() {
    std::optional<TwoSided> all;
    for (const Area* area : inclusions_) {
      auto one = union_of({area});
      if (!one) return std::nullopt;
      if (all && cross_too_often(*all, *one)) return too_intricate();
      if (all) *one = {all->inner.intersect(one->inner), all->outer.intersect(one->outer)};
      all = std::move(one);
    }
    return all;
  }
  std::optional<TwoSided> union_of(const std::vector<const Area*>& areas) {
    std::vector<TwoSided> parts;
    for (const Area* area : areas) {
      for (const import::Part& part : area->parts) {
        auto one = std::visit([&](const auto& shape) { return region_of(shape); }, part.shape);
        if (!one) return std::nullopt;
        parts.push_back(std::move(*one));
      }
    }
    auto all = united_of(std::move(parts));
    return all ? std::move(all) : too_intricate();
  }
  std::nullopt_t too_intricate() {
    refuse("the zone", "has areas that cross one another too often",
           "unite them in the program that drew them");
    return std::nullopt;
  }

  std::optional<TwoSided> region_of(const import::Circle& from) {
    const auto placed = placer_.place(from);
    if (const auto* fault = std::get_if<NoPlace>(&placed)) {
      no_place(from.where, *fault);
      return std::nullopt;
    }
    const auto& circle = std::get<PlacedCircle>(placed);
    return TwoSided{Region::circle({circle.x, circle.y}, circle.radius, true),
                    Region::circle({circle.x, circle.y}, circle.radius, false)};
  }
  std::optional<TwoSided> region_of(const import::Polygon& from) {
    std::vector<const import::Ring*> written = {&from.outer};
    for (const import::Ring& hole : from.holes) written.push_back(&hole);
    std::vector<Ring> rings;
    std::vector<std::vector<std::uint32_t>> vertices;
    for (const import::Ring* each : written) {
      if (!place(*each, rings.emplace_back(), vertices.emplace_back())) return std::nullopt;
    }
    const Ring outer = std::move(rings.front());
    rings.erase(rings.begin());
    auto made = Region::polygon(outer, rings);
    if (const auto* problem = std::get_if<Problem>(&made)) {
      report(*problem, written, vertices);
      return std::nullopt;
    }
    const auto& region = std::get<Region>(made);
    return TwoSided{region, region};
  }
  bool place(const import::Ring& from, Ring& to, std::vector<std::uint32_t>& vertices) {
    auto placed = placer_.place(from);
    if (const auto* fault = std::get_if<NoPlace>(&placed)) {
      return no_place(from.where + ", " + vertex_text(fault->vertex), *fault);
    }
    if (encloses_nothing(from)) {
      constexpr auto no_area = Problem::Kind::no_area;
      return refuse(from.where, message_of({no_area, 0, 0, 0, {}}, {}), help_of(no_area));
    }
    for (const PlacedPoint& p : std::get<PlacedRing>(placed).points) {
      to.push_back({p.x, p.y});
      vertices.push_back(p.vertex);
    }
    // Long edges are bent on the map: known before anything is computed of them.
    return placer_.points() <= edges_most_ || too_many(placer_.points(), "points on the map");
  }
  // Of points within long edges, the vertices of the file where those begin.
  void report(const Problem& found, const std::vector<const import::Ring*>& written,
              const std::vector<std::vector<std::uint32_t>>& vertices) {
    const Problem problem = in_file(found, vertices[found.ring]);
    const auto ring = [&](std::size_t i) { return written[i]->where; };
    const auto vertex = [&](std::size_t point) {
      const auto& in_file = vertices[problem.ring];
      return vertex_text(point < in_file.size() ? in_file[point] : 0);
    };
    const bool of_vertex = is_said_of_vertex(problem.kind);
    refuse(ring(problem.ring) + (of_vertex ? ", " + vertex(problem.vertex) : ""),
           message_of(problem, {ring, vertex}), help_of(problem.kind));
  }
  bool no_place(const std::string& where, const NoPlace& fault) {
    using Kind = NoPlace::Kind;
    if (fault.near_swapped) {
      return refuse(where, "lies far away, and near with longitude and latitude swapped",
                    "send the axes in the order of the format");
    }
    switch (fault.kind) {
      case Kind::off_globe:
        return refuse(where, "is not on the globe",
                      "latitudes are -90 to 90 deg, longitudes -180 to 180 deg");
      case Kind::near_pole:
        return refuse(where, "is too near to a pole", "latitudes of up to 89 deg work");
      case Kind::across_the_map:
        return refuse(where, "starts an edge over more than 180 deg of longitude",
                      "cut the area in two at 180 deg of longitude");
      case Kind::far_away:
        return refuse(where, "is too far from the origin", "zones within 100 km of it work");
      case Kind::too_many:
        return refuse(where, "makes it too many points", "send shorter edges");
    }
    return false;
  }

  const ReceivedFile& as_;
  const std::size_t edges_most_;
  Placer placer_;
  import::Areas areas_;
  std::vector<const Area*> inclusions_, exclusions_;
  bool inside_all_ = false;
  std::optional<RefusedZone> refused_;
};

}  // namespace

std::variant<ReceivedRegions, RefusedZone> receive_file(const std::string& text,
                                                        const ReceivedFile& as,
                                                        std::size_t edges_most) {
  return FileReceiver(as, edges_most).run(text);
}

}  // namespace rtac::geometry
