// Which elements of KML 2.2 (OGC 07-147r2) and of Google's extensions may stand where, and which of
// them have nothing to say about areas. What is in neither list might have: it is KML in another
// spelling, or of a program that means something by it. Internal to this folder.
#pragma once

#include <optional>
#include <string_view>

namespace rtac::geometry::import {

// Elements whose children are looked at.
enum class KmlPlace { root, container, placemark, multi_geometry, polygon, boundary, ring };

enum class KmlElement {
  no_matter,  // to areas
  container,  // Document, Folder
  placemark,
  network_link,
  network_link_control,
  overlay,  // a picture
  time,     // tells when something is shown
  data,     // of other programs
  polygon,
  multi_geometry,
  no_area,  // geometries that enclose nothing
  outer_boundary,
  inner_boundary,
  ring,
  coordinates,
  name,
  extrude,
  altitude_mode,
};

// What an element of this local name is there; nullopt: unknown.
std::optional<KmlElement> element_of(KmlPlace place, std::string_view local_name);
// The one that is meant by the same name in capitals and small letters; empty: none.
std::string_view other_spelling(KmlPlace place, std::string_view local_name);
// What is read there, for messages: names of elements between back-ticks.
std::string_view read_there(KmlPlace place);

}  // namespace rtac::geometry::import
