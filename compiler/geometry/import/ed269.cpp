// UAS zones in JSON as of EUROCAE ED-269, chapter 8. Members as in the public model of the
// standard, eurocae_ed269.py of interuss/uas_standards (UASZoneVersion, UASZoneAirspaceVolume,
// ApplicableTimePeriod, DailyPeriod); the zones stand in `features` or, in the Swiss data, in
// `UASZoneList`. Positions are longitude and latitude, as States publish them. Each volume is a
// part of its zone with a band of its own: stacks are several of them.
#include <algorithm>

#include "compiler/geometry/import/readers.h"
#include "compiler/geometry/import/uas_zones.h"

namespace rtac::geometry::import {
namespace {

class Ed269Reader {
 public:
  Ed269Reader(Findings& findings, const Limits& limits)
      : findings_(findings), json_(findings, limits) {}

  bool read_root(Json root);
  Areas take_areas();

 private:
  bool check_zone(Json zone);
  bool read_zone(Json zone);
  bool read_names(Json zone, Area& area);
  bool read_applicability(Json zone, Area& area);
  bool read_period(Json period, Area& area);
  bool read_volume(Json volume, Area& area);
  bool read_circle(Json projection, std::string_view unit, Area& area, Circle& circle);

  Findings& findings_;
  JsonReader json_;
  Areas areas_;
};

bool Ed269Reader::read_names(Json zone, Area& area) {
  const auto identifier = json_.required_text(zone, "identifier");
  if (!identifier) return false;
  area.name = *identifier;
  const auto name = zone.member("name");
  if (name && name->string() && *name->string() != *identifier && !name->string()->empty()) {
    area.other_names.emplace_back(*name->string());
  }
  return true;
}

bool Ed269Reader::read_period(Json period, Area& area) {
  if (!json_.expect_object(period)) return false;
  const auto permanent = json_.required_text(period, "permanent");
  if (!permanent) return false;
  if (*permanent != "YES" && *permanent != "NO") {
    return findings_.fail(period.where() + ".permanent", "is " + quote(*permanent),
                          "`YES` or `NO`");
  }
  if (!json_.check_letters(period, {"startDateTime", "endDateTime", "schedule"})) return false;
  const bool is_permanent = *permanent == "YES";
  const auto limits_time = [&](std::string_view name) {
    const auto member = JsonReader::optional_member(period, name);
    return member && (!member->is_array() || !member->items().empty());
  };
  const bool is_limited =
      limits_time("startDateTime") || limits_time("endDateTime") || limits_time("schedule");
  if (is_permanent == is_limited) {
    refuse(
        area, period.where(),
        is_permanent ? "is permanent, and limited in time" : "is not permanent, and says no time",
        "`permanent` is `YES` without further members, or `NO` with a start, an end or a "
        "schedule");
    return true;
  }
  return add_periods(json_, period, area);
}

bool Ed269Reader::read_applicability(Json zone, Area& area) {
  const auto items = json_.required_items(zone, "applicability", "periods");
  if (!items) return false;
  if (items->empty()) {
    return json_.wrong_kind(*zone.member("applicability"), "at least one period");
  }
  return std::all_of(items->begin(), items->end(),
                     [&](Json period) { return read_period(period, area); });
}

bool Ed269Reader::read_circle(Json projection, std::string_view unit, Area& area, Circle& circle) {
  circle.where = projection.where();
  const auto centre = json_.required(projection, "center");
  if (!centre || !json_.read_position(*centre, circle.centre)) return false;
  const auto radius = json_.required_number(projection, "radius");
  if (!radius || !check_radius(*radius, circle.where, findings_)) return false;
  if (unit != "M" && unit != "m") {
    // Some take the unit of the volume for that of the heights alone, others for the radius, too.
    refuse(area, circle.where,
           "a circle in a volume in feet: readers disagree on the unit of its "
           "radius",
           "give the volume in metres");
  }
  circle.radius_m = *radius;
  return true;
}

bool Ed269Reader::read_volume(Json volume, Area& area) {
  if (!json_.expect_object(volume)) return false;
  Part part;
  const auto metres = metres_of_unit(json_, volume, "uomDimensions");
  if (!metres ||
      !read_limits(json_, volume, {"lowerLimit", "lowerVerticalReference"},
                   {"upperLimit", "upperVerticalReference"}, *metres, part.band) ||
      !json_.check_members(volume,
                           {"uomDimensions", "lowerLimit", "lowerVerticalReference", "upperLimit",
                            "upperVerticalReference", "horizontalProjection"})) {
    return false;
  }
  const auto projection = json_.required(volume, "horizontalProjection");
  if (!projection || !json_.expect_object(*projection) ||
      !json_.check_members(*projection, {"type", "coordinates", "center", "radius"})) {
    return false;
  }
  const auto type = json_.required_text(*projection, "type");
  if (!type) return false;
  if (*type == "Circle") {
    const auto unit = *json_.required_text(volume, "uomDimensions");
    if (!read_circle(*projection, unit, area, part.shape.emplace<Circle>())) return false;
  } else if (*type == "Polygon") {
    const auto rings = json_.required_array(*projection, "coordinates");
    if (!rings || !json_.read_polygon(*rings, part.shape.emplace<Polygon>())) return false;
    if (const auto radius = JsonReader::optional_member(*projection, "radius")) {
      refuse(area, radius->where(), "a polygon has no radius",
             "draw the polygon as far out as it reaches, or make it a `Circle`");
    }
  } else {
    return findings_.fail(projection->where() + ".type", "is " + quote(*type),
                          "`Polygon` or `Circle`");
  }
  area.parts.push_back(std::move(part));
  return true;
}

bool Ed269Reader::check_zone(Json zone) {
  return json_.check_members(
      zone,
      {"identifier", "country", "name", "type", "restriction", "restrictionConditions", "region",
       "reason", "otherReasonInfo", "regulationExemption", "uSpaceClass", "message",
       "applicability", "zoneAuthority", "geometry", "additionalProperties", "extendedProperties"});
}

bool Ed269Reader::read_zone(Json zone) {
  if (!json_.expect_object(zone)) return false;
  if (!check_zone(zone)) return false;
  Area area;
  area.where = zone.where();
  if (!read_names(zone, area) || !set_restriction(json_, zone, "restriction", area) ||
      !read_applicability(zone, area)) {
    return false;
  }
  const auto items = json_.required_items(zone, "geometry", "volumes");
  if (!items) return false;
  if (items->empty()) return json_.wrong_kind(*zone.member("geometry"), "at least one volume");
  for (const Json volume : *items) {
    if (!read_volume(volume, area)) return false;
  }
  return json_.add(std::move(area), areas_);
}

bool Ed269Reader::read_root(Json root) {
  if (!json_.expect_object(root)) return false;
  if (!json_.check_members(root, {"title", "description", "features", "UASZoneList"})) return false;
  const bool is_list = root.member("UASZoneList").has_value();
  if (is_list && root.member("features")) {
    return findings_.fail("features", "stands beside `UASZoneList`, which has zones as well",
                          "write all zones into one of the two");
  }
  const auto zones = json_.required_items(root, is_list ? "UASZoneList" : "features", "zones");
  return zones &&
         std::all_of(zones->begin(), zones->end(), [&](Json zone) { return read_zone(zone); });
}

Areas Ed269Reader::take_areas() {
  if (json_.height_at()) {
    areas_.notes.push_back({*json_.height_at(),
                            "positions have heights; in ED-269 the limits of a volume count, and "
                            "they are left out"});
  }
  json_.unknown().add_notes_to(areas_.notes);
  return std::move(areas_);
}

}  // namespace

Outcome read_ed269(std::string_view text, const Limits& limits) {
  return read_with<Ed269Reader>(text, limits);
}

}  // namespace rtac::geometry::import
