// The fence of a QGroundControl plan. Members as in "Plan File Format" of the QGroundControl
// developer guide (docs/en/qgc-dev-guide/file_formats/plan.md of mavlink/qgroundcontrol): version 1
// of the plan, 2 of `geoFence`, 1 of each polygon and circle; positions are [latitude, longitude],
// rings are not closed. The guide calls `inclusion` "enabled"; the program (QGCFencePolygon.cpp)
// keeps the vehicle in where it is true and out where it is false. What it reads and writes besides
// is nothing: GeoFenceController.cc has `version`, `polygons`, `circles` and `breachReturn`, each
// shape `inclusion` and `version`, and QGCMapCircle.cc the `center` and `radius` of a circle.
#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>

#include "compiler/geometry/import/json_reader.h"
#include "compiler/geometry/import/readers.h"

namespace rtac::geometry::import {
namespace {

class PlanReader {
 public:
  PlanReader(Findings& findings, const Limits& limits)
      : findings_(findings), json_(findings, limits) {
    areas_.axes = Axes::latitude_first;
  }

  bool read_root(Json root);
  Areas take_areas();

 private:
  bool read_fence(Json fence);
  bool read_each(Json fence, std::string_view list, std::string_view shape);
  bool read_item(Json item, std::string_view shape);
  bool read_polygon(Json positions, Area& area);
  bool read_circle(Json circle, Area& area);
  bool check_root(Json root);
  bool check_fence(Json fence);

  Findings& findings_;
  JsonReader json_;
  Areas areas_;
};

Position swapped(Position position) {
  return {position.y, position.x};
}

using Names = std::initializer_list<std::string_view>;

// The first member that is none of these.
std::optional<Json> first_unknown(Json object, Names known) {
  for (const Json member : object.items()) {
    if (std::find(known.begin(), known.end(), member.name()) == known.end()) return member;
  }
  return std::nullopt;
}

std::string no_such_member(Json member) {
  return "QGroundControl has no member " + quote(member.name()) + " here";
}

// Programs that build on QGroundControl add heights and actions: what limits the area must not be
// dropped.
void refuse_unknown(Json object, Names known, Area& area) {
  if (const auto unknown = first_unknown(object, known)) {
    refuse(area, unknown->where(), no_such_member(*unknown),
           "take it out, and say in the specification what it is for");
  }
}

bool mentions_fence(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower.find("fence") != std::string::npos;
}

// Another list of the fence would be lost, and so would a switch that turns it off.
bool PlanReader::check_fence(Json fence) {
  const auto unknown = first_unknown(fence, {"version", "polygons", "circles", "breachReturn"});
  if (!unknown) return true;
  return findings_.fail(unknown->where(), no_such_member(*unknown),
                        "areas stand in `polygons` and `circles`; take the member out, and say in "
                        "the specification what it is for");
}

// Other members of the plan are no part of the fence, unless they sound like one.
bool PlanReader::check_root(Json root) {
  const Names known{"fileType", "version", "groundStation", "mission", "geoFence", "rallyPoints"};
  for (const Json member : root.items()) {
    if (std::find(known.begin(), known.end(), member.name()) != known.end()) continue;
    if (mentions_fence(member.name())) {
      return findings_.fail(member.where(), no_such_member(member),
                            "the fence of a plan is `geoFence`: take the other one out");
    }
    areas_.notes.push_back({member.where(), no_such_member(member) + ", and it is left out"});
  }
  return true;
}

bool PlanReader::read_polygon(Json positions, Area& area) {
  Polygon polygon;
  if (!json_.read_ring(positions, Closing::implied, polygon.outer)) return false;
  for (Position& position : polygon.outer.positions) position = swapped(position);
  area.parts.push_back({std::move(polygon), {}});
  return true;
}

bool PlanReader::read_circle(Json circle, Area& area) {
  if (!json_.expect_object(circle)) return false;
  Circle result;
  result.where = circle.where();
  const auto centre = json_.required(circle, "center");
  if (!centre || !json_.read_position(*centre, result.centre)) return false;
  const auto radius_m = json_.required_number(circle, "radius");
  if (!radius_m || !check_radius(*radius_m, result.where, findings_)) return false;
  refuse_unknown(circle, {"center", "radius"}, area);
  result.centre = swapped(result.centre);
  result.radius_m = *radius_m;
  area.parts.push_back({std::move(result), {}});
  return true;
}

bool PlanReader::read_item(Json item, std::string_view shape) {
  if (!json_.expect_object(item) || !json_.expect_version(item, 1)) return false;
  const auto is_inclusion = json_.required_boolean(item, "inclusion");
  const auto outline = is_inclusion ? json_.required(item, shape) : std::nullopt;
  if (!outline) return false;
  Area area;
  area.where = item.where();
  area.role = *is_inclusion ? Role::keep_in : Role::keep_out;
  if (!(shape == "polygon" ? read_polygon(*outline, area) : read_circle(*outline, area))) {
    return false;
  }
  refuse_unknown(item, {shape, "inclusion", "version"}, area);
  return json_.add(std::move(area), areas_);
}

bool PlanReader::read_each(Json fence, std::string_view list, std::string_view shape) {
  const auto items = json_.required_items(fence, list, "objects");
  return items && std::all_of(items->begin(), items->end(),
                              [&](Json item) { return read_item(item, shape); });
}

bool PlanReader::read_fence(Json fence) {
  if (!json_.expect_object(fence) || !json_.expect_version(fence, 2)) return false;
  if (const auto point = fence.member("breachReturn")) {
    areas_.notes.push_back({point->where(), "the breach return point is no area and is left out"});
  }
  return check_fence(fence) && read_each(fence, "polygons", "polygon") &&
         read_each(fence, "circles", "circle");
}

bool PlanReader::read_root(Json root) {
  if (!json_.expect_object(root)) return false;
  const auto type = json_.required_text(root, "fileType");
  if (!type) return false;
  if (*type != "Plan") {
    return findings_.fail("fileType", "is " + quote(*type),
                          "save the whole plan from QGroundControl, which writes `Plan`");
  }
  if (!json_.expect_version(root, 1) || !check_root(root)) return false;
  const auto fence = json_.required(root, "geoFence");
  return fence && read_fence(*fence);
}

Areas PlanReader::take_areas() {
  if (json_.height_at()) {
    areas_.notes.push_back({*json_.height_at(),
                            "positions have heights; the fence of a plan does not say that they "
                            "limit the area, and they are left out"});
  }
  return std::move(areas_);
}

}  // namespace

Outcome read_qgc_plan(std::string_view text, const Limits& limits) {
  return read_with<PlanReader>(text, limits);
}

}  // namespace rtac::geometry::import
