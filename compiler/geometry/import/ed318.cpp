// UAS zones in GeoJSON as of EUROCAE ED-318. Members of the properties as in the schema of its
// appendix (schema/ of UASGeoZones/ED-318) and in eurocae_ed318.py of interuss/uas_standards; those
// of geometries as in the LayeredGeoJSON of EUROCONTROL: `layer` are the limits of height of a
// geometry, `extent` makes a circle of a point, with its radius in metres.
#include <algorithm>

#include "compiler/geometry/import/geojson_reader.h"
#include "compiler/geometry/import/readers.h"
#include "compiler/geometry/import/uas_zones.h"

namespace rtac::geometry::import {
namespace {

class Ed318Reader : public GeoJsonReader {
 public:
  using GeoJsonReader::GeoJsonReader;

 private:
  bool read_properties(Json feature, Area& area) override;
  bool read_layer(Json geometry, Band& band) override;
  bool read_point(Json point, const Band& band, Area& area) override;
  bool read_metadata(Json collection) override;
};

// [{"text": "...", "lang": "en-GB"}, ...]
void add_texts(Json texts, Area& area) {
  for (const Json item : texts.items()) {
    const auto text = item.member("text");
    if (!text || !text->string() || text->string()->empty()) continue;
    if (*text->string() != area.name) area.other_names.emplace_back(*text->string());
  }
}

bool Ed318Reader::read_properties(Json feature, Area& area) {
  const auto properties = json_.required(feature, "properties");
  if (!properties || !json_.expect_object(*properties)) return false;
  if (!json_.check_members(
          *properties,
          {"identifier", "country", "name", "type", "variant", "restrictionConditions", "region",
           "reason", "otherReasonInfo", "regulationExemption", "message", "zoneAuthority",
           "limitedApplicability", "extendedProperties", "dataSource"})) {
    return false;
  }
  const auto identifier = json_.required_text(*properties, "identifier");
  if (!identifier || !set_restriction(json_, *properties, "type", area)) return false;
  area.name = *identifier;
  if (const auto names = JsonReader::optional_member(*properties, "name")) add_texts(*names, area);
  const auto periods = JsonReader::optional_member(*properties, "limitedApplicability");
  if (!periods) return true;
  if (periods->kind() != JsonKind::array) return json_.wrong_kind(*periods, "an array of periods");
  const auto items = periods->items();
  return std::all_of(items.begin(), items.end(),
                     [&](Json period) { return add_periods(json_, period, area); });
}

bool Ed318Reader::read_layer(Json geometry, Band& band) {
  const auto extent = JsonReader::optional_member(geometry, "extent");
  if (extent && geometry.member("type")->string() != "Point") {
    return findings_.fail(extent->where(), "only points have an extent", "take it out");
  }
  const auto layer = JsonReader::optional_member(geometry, "layer");
  if (!layer) return true;
  if (!json_.expect_object(*layer)) return false;
  const auto metres = metres_of_unit(json_, *layer, "uom");
  return metres &&
         read_limits(json_, *layer, {"lower", "lowerReference"}, {"upper", "upperReference"},
                     *metres, band) &&
         json_.check_members(*layer, {"lower", "lowerReference", "upper", "upperReference", "uom"});
}

bool Ed318Reader::read_point(Json point, const Band& band, Area& area) {
  const auto extent = JsonReader::optional_member(point, "extent");
  if (!extent) return GeoJsonReader::read_point(point, band, area);
  if (!json_.expect_object(*extent) || !json_.check_members(*extent, {"subType", "radius"})) {
    return false;
  }
  const auto type = json_.required_text(*extent, "subType");
  if (!type) return false;
  if (*type != "Circle") {
    return findings_.fail(extent->where() + ".subType", "is " + quote(*type), "`Circle`");
  }
  Circle circle;
  circle.where = point.where();
  const auto radius_m = json_.required_number(*extent, "radius");
  if (!radius_m || !check_radius(*radius_m, circle.where, findings_)) return false;
  if (!json_.read_position(*point.member("coordinates"), circle.centre)) return false;
  circle.radius_m = *radius_m;
  area.parts.push_back({std::move(circle), band});
  return true;
}

bool Ed318Reader::read_metadata(Json collection) {
  const auto metadata = JsonReader::optional_member(collection, "metadata");
  if (!metadata) return true;
  for (const char* name : {"validFrom", "validTo", "otherGeoid", "technicalLimitations"}) {
    const auto member = JsonReader::optional_member(*metadata, name);
    if (member) areas_.notes.push_back({member->where(), "holds for all areas, and is left out"});
  }
  return true;
}

}  // namespace

Outcome read_ed318(std::string_view text, const Limits& limits) {
  return read_with<Ed318Reader>(text, limits);
}

}  // namespace rtac::geometry::import
