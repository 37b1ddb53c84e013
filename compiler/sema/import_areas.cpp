#include "compiler/sema/import_areas.h"

#include <algorithm>
#include <cmath>

#include "compiler/sema/dimension.h"
#include "compiler/sema/in_file.h"
#include "compiler/sema/origin.h"

namespace rtac::sema {

using geometry::NoPlace;
using geometry::import::Area;
using geometry::import::Circle;
using geometry::import::Format;
using geometry::import::Polygon;

namespace {

std::string kilometres(double metres) {
  return to_decimal(Rational(static_cast<long>(std::min(std::ceil(metres / 1000), 1e12)))) + " km";
}

class AreaPlacer {
 public:
  AreaPlacer(Context& context, const ImportJob& job)
      : context_(context), job_(job), placer_(job.reading, job.origin) {}

  std::optional<ZoneImport> run() {
    result_.path = job_.written.path.text;
    result_.degrees = job_.reading.degrees;
    result_.remarks = job_.remarks;
    result_.openings = job_.openings;
    meet();
    for (const auto& group : job_.inclusions) {
      if (!add(group, result_.inclusions.emplace_back())) return std::nullopt;
    }
    if (!add(job_.exclusions, result_.exclusions)) return std::nullopt;
    note_turned();
    suspect_degrees();
    result_.error = placer_.error();
    result_.points = placer_.points();
    result_.farthest = Rational(static_cast<long>(std::ceil(placer_.farthest_m())));
    return std::move(result_);
  }

 private:
  void meet() {
    std::vector<const geometry::import::Ring*> rings;
    for (const auto& group : job_.inclusions) geometry::import::add_rings(group, rings);
    geometry::import::add_rings(job_.exclusions, rings);
    placer_.meet(rings);
  }
  bool add(const std::vector<const Area*>& areas, std::vector<ZoneImport::Area>& to) {
    for (const Area* area : areas) {
      ZoneImport::Area& added = to.emplace_back();
      for (const auto& part : area->parts) {
        const auto one = [&](const auto& shape) { return place(shape, added); };
        if (!std::visit(one, part.shape)) return false;
        if (job_.with_heights && !band(part.band, area->where, added)) return false;
      }
    }
    return true;
  }

  // On a grid of 1 um, as places are.
  [[nodiscard]] std::optional<Rational> height(
      const std::optional<geometry::import::Altitude>& from) const {
    if (!from) return std::nullopt;
    constexpr long per_metre = 1'000'000;
    Rational height(static_cast<long>(std::llround(from->value_m * per_metre)), per_metre);
    height.canonicalize();
    return height + job_.levels.at(from->reference);
  }
  bool band(const geometry::import::Band& from, const std::string& where, ZoneImport::Area& to) {
    const ZoneImport::Band band{height(from.floor), height(from.ceiling)};
    to.bands.push_back(band);
    if (!band.floor || !band.ceiling || *band.floor < *band.ceiling) return true;
    // Readers refuse a floor above a ceiling of the same reference: those two are equal.
    const bool sheet = from.floor->reference == from.ceiling->reference;
    context_.report(
        Finding(Code::band_inverted, job_.written.path.range,
                "`" + job_.path + "`, " + where + ": the floor is at " +
                    show(*band.floor, dims::length) + " of the map, the ceiling at " +
                    show(*band.ceiling, dims::length))
            .label(sheet ? "a sheet without height" : "no height, or upside down")
            .help(sheet ? "its lower and its upper limit are the same: give the file the heights "
                          "that are meant, or select other areas by `feature \"name\"`"
                        : "floor and ceiling have different references: look at where `heights` "
                          "puts them"));
    return false;
  }

  bool place(const Polygon& from, ZoneImport::Area& to) {
    ZonePolygon polygon;
    if (!ring(from.outer, true, polygon.outer)) return false;
    for (const auto& hole : from.holes) {
      if (!ring(hole, false, polygon.holes.emplace_back())) return false;
    }
    to.parts.emplace_back(std::move(polygon));
    return true;
  }
  bool place(const Circle& from, ZoneImport::Area& to) {
    const auto placed = placer_.place(from);
    result_.vertices += 1;
    if (const auto* fault = std::get_if<NoPlace>(&placed)) {
      return report(*fault, from.where + ", the circle about " + shown(from.centre));
    }
    const auto& circle = std::get<geometry::PlacedCircle>(placed);
    to.parts.emplace_back(ZoneCircle{{circle.x, circle.y}, circle.radius});
    return true;
  }

  bool ring(const geometry::import::Ring& from, bool outer, ZonePolygon::Ring& to) {
    auto placed = placer_.place(from);
    result_.vertices += from.positions.size();
    if (const auto* fault = std::get_if<NoPlace>(&placed)) {
      return report(*fault, from.where + ", vertex " + std::to_string(fault->vertex + 1) + " " +
                                shown(from.positions[fault->vertex]));
    }
    if (job_.reading.degrees && geometry::encloses_nothing(from)) return no_area(from);
    to.range = job_.written.path.range;
    to.in_file.emplace();
    to.in_file->where = job_.path + ": " + from.where;
    for (auto& point : std::get<geometry::PlacedRing>(placed).points) {
      to.points.push_back({std::move(point.x), std::move(point.y)});
      to.in_file->vertices.push_back(point.vertex);
    }
    to.in_file->positions.reserve(from.positions.size());
    for (const auto& position : from.positions) to.in_file->positions.push_back(pair(position));
    look_at_direction(from, outer);
    return true;
  }

  // Of metres the checks of zones see it on the map.
  bool no_area(const geometry::import::Ring& ring) {
    context_.report(Finding(Code::ring_has_no_area, job_.written.path.range,
                            job_.path + ": " + ring.where + " encloses no area")
                        .label("all vertices of a ring lie on one line")
                        .help("move at least one vertex off the line through the others, or take "
                              "the ring out of the file"));
    return false;
  }

  // In the order of the file, so that it is found there.
  [[nodiscard]] std::array<double, 2> pair(const geometry::import::Position& p) const {
    const bool turn = job_.reading.degrees && job_.latitude_first != job_.reading.latitude_first;
    return turn ? std::array{p.y, p.x} : std::array{p.x, p.y};
  }
  [[nodiscard]] std::string shown(const geometry::import::Position& p) const {
    return position_text(pair(p));
  }

  // ---- which way round: RFC 7946, 3.1.6

  void look_at_direction(const geometry::import::Ring& from, bool outer) {
    const bool stated = job_.format == Format::geojson || job_.format == Format::ed318;
    if (!stated || job_.axes_written || geometry::counter_clockwise(from) == outer) return;
    if (turned_++ == 0) first_turned_ = from.where;
  }
  void note_turned() {
    if (turned_ == 0) return;
    const std::size_t others = turned_ - 1;
    const std::string more =
        others == 0 ? ""
                    : " and " + std::to_string(others) + " more ring" + (others == 1 ? "" : "s");
    const std::string go = turned_ == 1 ? " goes" : " go";
    context_.report(Finding(Code::ring_turned, job_.written.path.range,
                            "`" + job_.path + "`: " + first_turned_ + more + go +
                                " the other way round than GeoJSON asks for, and " +
                                (turned_ == 1 ? "is" : "are") + " turned")
                        .label("outer rings go counter-clockwise, holes clockwise")
                        .help("nothing is wrong with the zone"));
  }

  // ---- metres that would make sense as degrees

  void suspect_degrees() {
    if (job_.reading.degrees || !context_.spec.origin) return;
    const geometry::Origin origin = in_degrees(*context_.spec.origin);
    if (!fits_in_degrees(origin, false) && !fits_in_degrees(origin, true)) return;
    context_.report(
        Finding(
            Code::unit_suspicious, job_.written.path.range,
            "`" + job_.path + "` is read in metres, and in degrees it would lie near the origin")
            .label("degrees?")
            .help("write `in deg axes longitude latitude`, or `latitude longitude`, if it is in "
                  "degrees"));
  }
  [[nodiscard]] bool fits_in_degrees(const geometry::Origin& origin, bool latitude_first) const {
    geometry::Placer placer({true, latitude_first, false}, origin);
    const auto fits = [&](const Area* area) {
      return std::all_of(area->parts.begin(), area->parts.end(), [&](const auto& part) {
        const auto* polygon = std::get_if<Polygon>(&part.shape);
        return polygon != nullptr &&
               std::holds_alternative<geometry::PlacedRing>(placer.place(polygon->outer));
      });
    };
    return std::all_of(job_.inclusions.begin(), job_.inclusions.end(), [&](const auto& group) {
      return std::all_of(group.begin(), group.end(), fits);
    });
  }

  // ---- positions without a place

  bool report(const NoPlace& fault, const std::string& where) {
    const bool globe = fault.kind == NoPlace::Kind::off_globe ||
                       fault.kind == NoPlace::Kind::near_pole ||
                       fault.kind == NoPlace::Kind::across_the_map;
    const bool many = fault.kind == NoPlace::Kind::too_many;
    Finding finding(many    ? Code::too_many_vertices
                    : globe ? Code::no_place_on_map
                            : Code::zone_far_away,
                    job_.written.path.range, "`" + job_.path + "`, " + where + " " + what(fault));
    finding.label(fault.near_swapped ? "longitude and latitude swapped?"
                  : many             ? "too many vertices"
                                     : "has no place");
    finding.help(fault.near_swapped ? swapped_help() : help(fault));
    context_.report(finding);
    return false;
  }
  [[nodiscard]] std::string what(const NoPlace& fault) const {
    switch (fault.kind) {
      case NoPlace::Kind::off_globe:
        return "is not on the globe";
      case NoPlace::Kind::near_pole:
        return "is too near to a pole";
      case NoPlace::Kind::across_the_map:
        return "starts an edge over more than 180 deg of longitude";
      case NoPlace::Kind::far_away:
        return "is " + kilometres(fault.distance_m) + " from " +
               (job_.reading.degrees ? "the origin" : "(0 m, 0 m)");
      case NoPlace::Kind::too_many:
        return "makes it more than " + std::to_string(geometry::points_max) + " vertices";
    }
    return "";
  }
  [[nodiscard]] std::string help(const NoPlace& fault) const {
    switch (fault.kind) {
      case NoPlace::Kind::off_globe:
        return "latitudes are -90 to 90 deg, longitudes -180 to 180 deg";
      case NoPlace::Kind::near_pole:
        return "latitudes of up to 89 deg work";
      case NoPlace::Kind::across_the_map:
        return "cut an area that crosses 180 deg of longitude in two there; other edges are short";
      case NoPlace::Kind::far_away:
        return "zones within " +
               kilometres(job_.reading.degrees ? geometry::reach_m_max : geometry::metres_max) +
               (job_.reading.degrees ? " of `origin`" : "") + " work";
      case NoPlace::Kind::too_many:
        return "simplify the outlines, or select areas by `feature \"name\"`";
    }
    return "";
  }
  [[nodiscard]] std::string swapped_help() const {
    const std::string other = axes_text(!job_.latitude_first);
    return "with the two exchanged it would be near the origin: if the file has them so, write `" +
           other +
           (job_.axes_written ? "` in the place of `" + axes_text(job_.latitude_first) + "`"
                              : "` behind it") +
           "; else look at the `origin`, where the latitude comes first";
  }

  Context& context_;
  const ImportJob& job_;
  geometry::Placer placer_;
  ZoneImport result_;
  std::size_t turned_ = 0;
  std::string first_turned_;
};

}  // namespace

std::string axes_text(bool latitude_first) {
  return latitude_first ? "axes latitude longitude" : "axes longitude latitude";
}

std::optional<ZoneImport> place_areas(Context& context, const ImportJob& job) {
  return AreaPlacer(context, job).run();
}

}  // namespace rtac::sema
