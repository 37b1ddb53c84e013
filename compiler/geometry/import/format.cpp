// Which format a file is in. The extension decides where it names one; JSON and texts without a
// telling extension are told apart by words that the format cannot do without.
#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "compiler/geometry/import/areas.h"

namespace rtac::geometry::import {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string extension_of(std::string_view path) {
  const std::string_view name = path.substr(path.find_last_of("/\\") + 1);
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos ? "" : lower(name.substr(dot + 1));
}

std::string_view without_mark_and_space(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin == std::string_view::npos ? std::string_view{} : text.substr(begin);
}

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

// What only ED-269 has, also when no zone of the file has a volume.
bool is_ed269(std::string_view text) {
  return has(text, "\"horizontalProjection\"") || has(text, "\"UASZoneList\"") ||
         (has(text, "\"restriction\"") && has(text, "\"applicability\""));
}

// What ED-318 has beyond GeoJSON; ED-269 has an authority, too.
bool has_member_of_ed318(std::string_view text) {
  constexpr std::array members{"\"zoneAuthority\"", "\"limitedApplicability\"",
                               "\"lowerReference\"", "\"upperReference\""};
  return std::any_of(members.begin(), members.end(),
                     [&](const char* member) { return has(text, member); });
}

// ED-318 is GeoJSON with more members, of which plain GeoJSON would lose the heights and times; it
// may have words of ED-269 among its names and its data.
std::optional<Format> format_of_json(std::string_view text) {
  const bool has_features = has(text, "\"Feature\"") || has(text, "\"FeatureCollection\"");
  if (has_features && has_member_of_ed318(text)) return Format::ed318;
  if (is_ed269(text)) return Format::ed269;
  if (has_member_of_ed318(text)) return Format::ed318;
  if (has(text, "\"fileType\"")) return Format::qgc_plan;
  if (has(text, "\"type\"")) return Format::geojson;
  return std::nullopt;
}

bool starts_like_wkt(std::string_view text) {
  const std::string start = lower(text.substr(0, 32));
  constexpr std::array words{"srid",         "polygon", "multipolygon",     "geometrycollection",
                             "linestring",   "point",   "multipoint",       "multilinestring",
                             "curvepolygon", "tin",     "polyhedralsurface"};
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return start.starts_with(word); });
}

std::optional<Format> format_of_content(std::string_view text) {
  if (text.starts_with('{')) return format_of_json(text);
  if (text.starts_with("QGC WPL")) return Format::waypoints;
  if (text.starts_with('<')) {
    return has(text.substr(0, 4096), "<kml") ? std::optional(Format::kml) : std::nullopt;
  }
  if (starts_like_wkt(text)) return Format::wkt;
  return std::nullopt;
}

}  // namespace

std::optional<Format> format_of(const std::string& path, const std::string& text) {
  const std::string extension = extension_of(path);
  if (extension == "wkt") return Format::wkt;
  if (extension == "kml" || extension == "kmz") return Format::kml;
  if (extension == "plan") return Format::qgc_plan;
  if (extension == "waypoints") return Format::waypoints;
  const auto format = format_of_content(without_mark_and_space(text));
  // Properties of GeoJSON may be called like members of ED-269, and its geometries not.
  const bool is_other = format == Format::ed318 || has(text, "\"horizontalProjection\"");
  return extension == "geojson" && !is_other ? Format::geojson : format;
}

}  // namespace rtac::geometry::import
