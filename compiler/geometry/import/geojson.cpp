// GeoJSON as of RFC 7946: longitude before latitude, WGS 84, closed rings. A Feature is an area; so
// is a bare geometry. Points and lines enclose nothing: their areas are refused when used, since
// maps of zones have labels and routes among them.
#include "compiler/geometry/import/geojson_reader.h"

#include <utility>

#include "compiler/geometry/import/property_limits.h"
#include "compiler/geometry/import/readers.h"

namespace rtac::geometry::import {

// The draft of 2008 could name another reference system; RFC 7946 has taken that away.
bool GeoJsonReader::check_crs(Json object) {
  const auto crs = object.member("crs");
  if (!crs) return true;
  const auto properties = crs->member("properties");
  const auto name = properties ? properties->member("name") : std::nullopt;
  if (name && name->string()) {
    for (const std::string_view known :
         {"urn:ogc:def:crs:OGC:1.3:CRS84", "OGC:CRS84", "CRS84", "urn:ogc:def:crs:OGC::CRS84"}) {
      if (*name->string() == known) return true;
    }
  }
  return findings_.fail(
      crs->where(),
      "the reference system is " + (name ? name->described() : crs->described()) +
          ", not longitude and latitude on WGS 84",
      "export the file as RFC 7946, which has `urn:ogc:def:crs:OGC:1.3:CRS84` alone");
}

// Without this, what limits a zone in height or makes a circle of a point would be lost.
bool GeoJsonReader::read_layer(Json geometry, Band& /*band*/) {
  for (const std::string_view name : {"layer", "extent"}) {
    if (const auto member = geometry.member(name)) {
      return findings_.fail(
          member->where(), "plain GeoJSON has no " + quote(name),
          "take it out; a file of ED-318 has `zoneAuthority` among the properties of its features");
    }
  }
  return true;
}

// Its members besides may be of any name; those that limit its area would be lost.
bool GeoJsonReader::check_object(Json object, std::initializer_list<std::string_view> known) {
  return json_.check_members(object, known,
                             "take it out: GeoJSON has no limits besides outlines, whose holes are "
                             "further rings of a polygon; ED-318 has limits of height and time");
}

// RFC 7946, 7.1
bool GeoJsonReader::check_strangers(Json object, std::string_view kind,
                                    std::initializer_list<std::string_view> strangers) {
  for (const std::string_view name : strangers) {
    const auto member = object.member(name);
    if (!member) continue;
    return findings_.fail(member->where(), "is no member of a " + std::string(kind),
                          "`coordinates` are of a geometry, `geometries` of a GeometryCollection, "
                          "`geometry` and `properties` of a Feature, `features` of a "
                          "FeatureCollection: move it there, or take it out");
  }
  return true;
}

bool GeoJsonReader::check_id(Json feature) {
  const auto id = JsonReader::optional_member(feature, "id");
  return !id || id->string() || id->number() || json_.wrong_kind(*id, "a text or a number");
}

bool GeoJsonReader::read_point(Json point, const Band& /*band*/, Area& area) {
  refuse(area, point.where(), "a Point encloses nothing", take_other_areas);
  return true;
}

bool GeoJsonReader::read_metadata(Json /*collection*/) {
  return true;
}

bool GeoJsonReader::add_polygon(Json rings, const Band& band, Area& area) {
  if (rings.kind() == JsonKind::array && rings.items().empty()) {
    refuse(area, rings.where(), "the polygon is empty", take_other_areas);
    return true;
  }
  Polygon polygon;
  if (!json_.read_polygon(rings, polygon)) return false;
  area.parts.push_back({std::move(polygon), band});
  return true;
}

bool GeoJsonReader::read_geometries(Json collection, Area& area) {
  if (!check_strangers(collection, "GeometryCollection", {"coordinates"})) return false;
  if (const auto layer = collection.member("layer")) {
    return findings_.fail(layer->where(), "a GeometryCollection has no heights of its own",
                          "give each of its members a `layer`");
  }
  const auto geometries = json_.required_items(collection, "geometries", "geometries");
  if (!geometries) return false;
  for (const Json geometry : *geometries) {
    if (!read_geometry(geometry, area)) return false;
  }
  return true;
}

bool GeoJsonReader::read_shape(Json geometry, std::string_view type, Area& area) {
  if (!check_strangers(geometry, type, {"geometries"})) return false;
  const auto coordinates = json_.required_array(geometry, "coordinates");
  Band band;
  if (!coordinates || !read_layer(geometry, band)) return false;
  if (type == "Point") return read_point(geometry, band, area);
  if (type == "Polygon") return add_polygon(*coordinates, band, area);
  if (type == "MultiPolygon") {
    if (coordinates->kind() != JsonKind::array) {
      return json_.wrong_kind(*coordinates, "an array of polygons");
    }
    for (const Json polygon : coordinates->items()) {
      if (!add_polygon(polygon, band, area)) return false;
    }
    return true;
  }
  refuse(area, geometry.where(), "a " + std::string(type) + " encloses nothing", take_other_areas);
  return true;
}

bool GeoJsonReader::read_geometry(Json geometry, Area& area) {
  if (!json_.expect_object(geometry) || !check_crs(geometry)) return false;
  const auto type = json_.required_text(geometry, "type");
  if (!type || !check_strangers(geometry, "geometry", {"geometry", "features", "properties"}) ||
      !check_object(geometry,
                    {"type", "coordinates", "geometries", "bbox", "crs", "layer", "extent"})) {
    return false;
  }
  if (*type == "GeometryCollection") return read_geometries(geometry, area);
  for (const std::string_view known :
       {"Polygon", "MultiPolygon", "Point", "MultiPoint", "LineString", "MultiLineString"}) {
    if (*type == known) return read_shape(geometry, *type, area);
  }
  return findings_.fail(geometry.member("type")->where(),
                        "GeoJSON has no geometry of the type " + quote(*type),
                        "`Polygon`, `MultiPolygon` or `GeometryCollection`, in this spelling");
}

void GeoJsonReader::note_limits(Json properties, Area& area) {
  for (const Json property : properties.items()) {
    if (!area.unread_height && is_limit_of_height(property)) {
      area.unread_height = Note{property.where(), "sounds like a limit of height"};
    } else if (!area.unread_time && is_limit_of_time(property)) {
      area.unread_time = Note{property.where(), "sounds like a limit of time"};
    }
  }
}

bool GeoJsonReader::read_properties(Json feature, Area& area) {
  std::vector<std::string> names;
  const auto add = [&](const std::optional<Json>& value, bool may_be_number) {
    if (!value) return;
    std::string name;
    if (const auto text = value->string()) name = *text;
    if (const auto number = value->number(); number && may_be_number) name = shown(*number);
    for (const std::string& known : names) {
      if (known == name) return;
    }
    if (!name.empty()) names.push_back(name);
  };
  add(feature.member("id"), true);
  const auto properties = JsonReader::optional_member(feature, "properties");
  if (properties && !json_.expect_object(*properties)) return false;
  if (properties) {
    note_limits(*properties, area);
    for (const char* key : {"name", "title", "identifier"}) add(properties->member(key), false);
  }
  if (names.empty()) return true;
  area.name = names.front();
  area.other_names.assign(names.begin() + 1, names.end());
  return true;
}

bool GeoJsonReader::read_feature(Json feature) {
  if (!json_.expect_object(feature) || !check_crs(feature)) return false;
  const auto type = json_.required_text(feature, "type");
  if (!type) return false;
  if (*type != "Feature") {
    return findings_.fail(feature.where() + ".type", "is " + quote(*type),
                          "the members of `features` are of the type `Feature`");
  }
  if (!check_strangers(feature, "Feature", {"coordinates", "geometries", "features"}) ||
      !check_object(feature, {"type", "id", "bbox", "crs", "properties", "geometry"}) ||
      !check_id(feature)) {
    return false;
  }
  Area area;
  area.where = feature.where();
  if (!read_properties(feature, area)) return false;
  const auto geometry = json_.required(feature, "geometry");
  if (!geometry) return false;
  if (geometry->kind() == JsonKind::null) {
    refuse(area, geometry->where(), "the feature has no geometry", take_other_areas);
  } else if (!read_geometry(*geometry, area)) {
    return false;
  }
  return json_.add(std::move(area), areas_);
}

bool GeoJsonReader::read_collection(Json collection) {
  const auto features = json_.required_items(collection, "features", "features");
  if (!features) return false;
  for (const Json feature : *features) {
    if (!read_feature(feature)) return false;
  }
  return true;
}

bool GeoJsonReader::read_root(Json root) {
  if (!json_.expect_object(root) || !check_crs(root) || !read_metadata(root)) return false;
  const auto type = json_.required_text(root, "type");
  if (!type) return false;
  if (*type == "FeatureCollection") {
    return check_strangers(root, "FeatureCollection",
                           {"geometry", "geometries", "coordinates", "properties"}) &&
           check_object(root, {"type", "features", "bbox", "crs", "id", "name", "title",
                               "description", "metadata"}) &&
           read_collection(root);
  }
  if (*type == "Feature") return read_feature(root);
  Area area;
  area.where = root.where();
  if (!read_geometry(root, area)) return false;
  return json_.add(std::move(area), areas_);
}

Areas GeoJsonReader::take_areas() {
  if (json_.height_at()) {
    areas_.notes.push_back({*json_.height_at(),
                            "positions have heights; GeoJSON does not say that they limit the "
                            "area, and they are left out"});
  }
  json_.unknown().add_notes_to(areas_.notes);
  for (Area& area : areas_.areas) {
    if (!area.refusal && area.parts.empty()) {
      refuse(area, area.where, "the geometry is empty", take_other_areas);
    }
  }
  return std::move(areas_);
}

Outcome read_geojson(std::string_view text, const Limits& limits) {
  return read_with<GeoJsonReader>(text, limits);
}

}  // namespace rtac::geometry::import
