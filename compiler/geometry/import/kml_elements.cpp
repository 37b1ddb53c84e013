#include "compiler/geometry/import/kml_elements.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

namespace rtac::geometry::import {
namespace {

using Kind = KmlElement;

struct Row {
  std::string_view name;
  Kind kind = Kind::no_matter;
};
using Rows = std::span<const Row>;

// What a feature is called, how it is drawn and from where it is looked at, and data for people.
// `visibility` and `Region` tell whether a viewer draws it at first, or from afar: it is there
// nevertheless. Google Earth writes styles as CascadingStyle.
constexpr std::array of_features{
    Row{"visibility"},
    Row{"open"},
    Row{"author"},
    Row{"link"},
    Row{"address"},
    Row{"phoneNumber"},
    Row{"AddressDetails"},
    Row{"Snippet"},
    Row{"snippet"},
    Row{"description"},
    Row{"Camera"},
    Row{"LookAt"},
    Row{"styleUrl"},
    Row{"Style"},
    Row{"StyleMap"},
    Row{"CascadingStyle"},
    Row{"Region"},
    Row{"Metadata"},
    Row{"balloonVisibility"},
};
constexpr std::array about_containers{Row{"name"}, Row{"ExtendedData"}};
constexpr std::array about_placemarks{Row{"name", Kind::name}, Row{"ExtendedData", Kind::data}};
constexpr std::array times{Row{"TimeSpan", Kind::time}, Row{"TimeStamp", Kind::time}};

// A tour is a film. A Schema declares the fields of tables; an old one also elements of other
// names, and those are unknown.
constexpr std::array in_containers{
    Row{"Document", Kind::container},
    Row{"Folder", Kind::container},
    Row{"Placemark", Kind::placemark},
    Row{"NetworkLink", Kind::network_link},
    Row{"GroundOverlay", Kind::overlay},
    Row{"ScreenOverlay", Kind::overlay},
    Row{"PhotoOverlay", Kind::overlay},
    Row{"Schema"},
    Row{"Tour"},
};
constexpr std::array in_root{Row{"NetworkLinkControl", Kind::network_link_control}};

constexpr std::array geometries{
    Row{"Polygon", Kind::polygon},    Row{"MultiGeometry", Kind::multi_geometry},
    Row{"Point", Kind::no_area},      Row{"LineString", Kind::no_area},
    Row{"LinearRing", Kind::no_area}, Row{"Model", Kind::no_area},
    Row{"Track", Kind::no_area},      Row{"MultiTrack", Kind::no_area},
};

// Edges follow the terrain or do not (`tessellate`), and are the same on the map. Whether a polygon
// is extruded it says itself, and the rings of its boundary do not.
constexpr std::array in_polygons{
    Row{"outerBoundaryIs", Kind::outer_boundary},
    Row{"innerBoundaryIs", Kind::inner_boundary},
    Row{"extrude", Kind::extrude},
    Row{"altitudeMode", Kind::altitude_mode},
    Row{"tessellate"},
    Row{"drawOrder"},
};
constexpr std::array in_boundaries{Row{"LinearRing", Kind::ring}};
constexpr std::array in_rings{
    Row{"coordinates", Kind::coordinates},
    Row{"altitudeMode", Kind::altitude_mode},
    Row{"tessellate"},
    Row{"extrude"},
};

std::array<Rows, 4> rows_of(KmlPlace place) {
  switch (place) {
    case KmlPlace::root:
      return {in_containers, in_root};
    case KmlPlace::container:
      return {in_containers, about_containers, of_features, times};
    case KmlPlace::placemark:
      return {geometries, about_placemarks, of_features, times};
    case KmlPlace::multi_geometry:
      return {geometries};
    case KmlPlace::polygon:
      return {in_polygons};
    case KmlPlace::boundary:
      return {in_boundaries};
    case KmlPlace::ring:
      return {in_rings};
  }
  return {};
}

template <class Same>
const Row* find(KmlPlace place, const Same& same) {
  for (const Rows rows : rows_of(place)) {
    for (const Row& row : rows) {
      if (same(row.name)) return &row;
    }
  }
  return nullptr;
}

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

std::optional<KmlElement> element_of(KmlPlace place, std::string_view local_name) {
  const Row* const row = find(place, [&](std::string_view name) { return name == local_name; });
  return row == nullptr ? std::nullopt : std::optional(row->kind);
}

std::string_view other_spelling(KmlPlace place, std::string_view local_name) {
  const Row* const row = find(place, [&](std::string_view name) {
    return std::equal(name.begin(), name.end(), local_name.begin(), local_name.end(), same_letter);
  });
  return row == nullptr ? std::string_view{} : row->name;
}

std::string_view read_there(KmlPlace place) {
  switch (place) {
    case KmlPlace::root:
    case KmlPlace::container:
      return "`Document`, `Folder` and `Placemark`";
    case KmlPlace::placemark:
    case KmlPlace::multi_geometry:
      return "`Polygon` and `MultiGeometry`";
    case KmlPlace::polygon:
      return "`outerBoundaryIs`, `innerBoundaryIs`, `altitudeMode` and `extrude`";
    case KmlPlace::boundary:
      return "`LinearRing`";
    case KmlPlace::ring:
      return "`coordinates`";
  }
  return "";
}

}  // namespace rtac::geometry::import
