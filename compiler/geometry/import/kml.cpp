// KML (OGC 07-147r2): Placemarks are areas; longitude, latitude and, of polygons that are not
// clamped to the ground, a height. A polygon with heights is a sheet in the air; only with
// `<extrude>` it is the solid from the ground up to them, with the ground as its floor. Styles,
// views and overlays of pictures are no zones.
#include <algorithm>
#include <array>
#include <pugixml.hpp>

#include "compiler/geometry/import/numbers.h"
#include "compiler/geometry/import/outlines.h"
#include "compiler/geometry/import/readers.h"

namespace rtac::geometry::import {
namespace {

using pugi::xml_node;

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

// Without the prefix of a namespace: programs write `kml:Polygon` and `gx:altitudeMode`, too.
std::string_view name_of(xml_node node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_time(xml_node node) {
  return is_one_of(name_of(node), {"TimeSpan", "TimeStamp"});
}

class KmlReader {
 public:
  KmlReader(std::string_view text, const Limits& limits, Findings& findings)
      : lines_(text), limits_(limits), findings_(findings) {}

  bool read_root(const pugi::xml_document& document);
  Areas take_areas() { return std::move(areas_); }

 private:
  // A ring with the lowest and highest of its heights.
  struct Heights {
    double least = 0, most = 0;
    bool is_set = false;
  };

  std::string place(xml_node node) const {
    return lines_.place(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug())));
  }
  // `time`: what tells when an outer container is shown, if any does.
  bool read_features(xml_node container, xml_node time, std::size_t depth);
  bool read_placemark(xml_node placemark, xml_node time);
  void refuse_time(xml_node time, Area& area);
  bool read_geometry(xml_node geometry, Area& area, std::size_t depth);
  bool read_polygon(xml_node node, Area& area);
  bool read_boundary(xml_node boundary, Polygon& polygon, Heights& heights);
  bool read_ring(xml_node node, Ring& ring, Heights& heights);
  bool read_position(std::string_view tuple, Ring& ring, Heights& heights);
  bool read_band(xml_node polygon, const Heights& heights, Area& area, Band& band);
  bool refuse_link(xml_node link);

  Lines lines_;
  const Limits& limits_;
  Findings& findings_;
  Areas areas_;
  std::size_t positions_ = 0;
};

xml_node child_of(xml_node node, std::string_view name) {
  for (const xml_node child : node.children()) {
    if (name_of(child) == name) return child;
  }
  return {};
}

// All of it: a comment in between makes two pieces.
std::string text_of(xml_node node) {
  std::string result;
  for (const xml_node child : node.children()) result += child.value();
  return std::string(trimmed(result));
}

bool KmlReader::read_position(std::string_view tuple, Ring& ring, Heights& heights) {
  const std::string where = place_of_position(ring, ring.positions.size());
  std::array<double, 3> values{};
  std::size_t count = 0;
  std::string_view rest = tuple;
  for (bool is_more = true; is_more; ++count) {
    const std::size_t comma = rest.find(',');
    is_more = comma != std::string_view::npos;
    const auto value = parse_number(rest.substr(0, comma));
    if (!value || count == values.size()) break;
    values[count] = *value;
    rest.remove_prefix(is_more ? comma + 1 : rest.size());
  }
  if (!rest.empty() || count < 2 || tuple.ends_with(',')) {
    return findings_.fail(where, "is " + quote(tuple),
                          "`longitude,latitude` or `longitude,latitude,height`, without spaces");
  }
  if (++positions_ > limits_.positions_max) {
    return findings_.fail(where,
                          "more than " + std::to_string(limits_.positions_max) + " positions",
                          "simplify the outlines, or split the file");
  }
  ring.positions.push_back({values[0], values[1]});
  heights.least = heights.is_set ? std::min(heights.least, values[2]) : values[2];
  heights.most = heights.is_set ? std::max(heights.most, values[2]) : values[2];
  heights.is_set = true;
  return true;
}

bool KmlReader::read_ring(xml_node node, Ring& ring, Heights& heights) {
  ring.where = place(node);
  const xml_node coordinates = child_of(node, "coordinates");
  if (!coordinates) {
    return findings_.fail(ring.where, "a LinearRing without <coordinates>", "add them");
  }
  const std::string all = text_of(coordinates);
  for (std::string_view text = all; !text.empty(); text = trimmed(text)) {
    const auto end = std::find_if(text.begin(), text.end(), is_space);
    const auto length = static_cast<std::size_t>(end - text.begin());
    if (!read_position(text.substr(0, length), ring, heights)) return false;
    text.remove_prefix(length);
  }
  return finish_ring(ring, Closing::required, findings_);
}

bool KmlReader::read_boundary(xml_node boundary, Polygon& polygon, Heights& heights) {
  const bool is_outer = name_of(boundary) == "outerBoundaryIs";
  bool has_ring = false;
  for (const xml_node node : boundary.children()) {
    if (name_of(node) != "LinearRing") continue;
    if (is_outer && !polygon.outer.where.empty()) {
      return findings_.fail(place(node), "a second outline of one polygon",
                            "write a polygon for each of them");
    }
    has_ring = true;
    if (!read_ring(node, is_outer ? polygon.outer : polygon.holes.emplace_back(), heights)) {
      return false;
    }
  }
  return has_ring || findings_.fail(place(boundary), "a boundary without a LinearRing", "add it");
}

bool KmlReader::read_band(xml_node polygon, const Heights& heights, Area& area, Band& band) {
  const std::string mode = text_of(child_of(polygon, "altitudeMode"));
  if (mode.empty() || mode == "clampToGround") return true;  // whose heights mean nothing
  const bool is_above_ground = mode == "relativeToGround";
  if (!is_above_ground && mode != "absolute") {
    refuse(area, place(polygon), "the altitude mode is " + quote(mode),
           "`clampToGround`, `relativeToGround` or `absolute`");
    return true;
  }
  if (is_above_ground && heights.least == 0 && heights.most == 0) return true;
  const std::string extrude = text_of(child_of(polygon, "extrude"));
  if (extrude != "1" && extrude != "true") {
    refuse(area, place(polygon),
           "a sheet at a height of " + shown(heights.most) + " m, which is no solid",
           "`<extrude>1</extrude>`, if the area reaches from the ground up to this height; "
           "`<altitudeMode>clampToGround</altitudeMode>`, if it has no limits of height");
  } else if (heights.least != heights.most) {
    refuse(area, place(polygon),
           "heights from " + shown(heights.least) + " to " + shown(heights.most) + " m",
           "a ceiling is level: give all positions one height");
  } else {
    band.floor = Altitude{0, AltitudeReference::ground};
    band.ceiling = Altitude{heights.most, is_above_ground ? AltitudeReference::ground
                                                          : AltitudeReference::mean_sea_level};
  }
  return check_band(band, place(polygon), findings_);
}

bool KmlReader::read_polygon(xml_node node, Area& area) {
  Part part;
  auto& polygon = part.shape.emplace<Polygon>();
  Heights heights;
  for (const xml_node child : node.children()) {
    if (!is_one_of(name_of(child), {"outerBoundaryIs", "innerBoundaryIs"})) continue;
    if (!read_boundary(child, polygon, heights)) return false;
  }
  if (polygon.outer.where.empty()) {
    return findings_.fail(place(node), "a Polygon without <outerBoundaryIs>", "add it");
  }
  if (!read_band(node, heights, area, part.band)) return false;
  area.parts.push_back(std::move(part));
  return true;
}

bool KmlReader::read_geometry(xml_node geometry, Area& area, std::size_t depth) {
  const std::string_view name = name_of(geometry);
  if (name == "Polygon") return read_polygon(geometry, area);
  if (name == "MultiGeometry") {
    if (depth > limits_.nesting_max) {
      return findings_.fail(place(geometry), "nested too deeply", "flatten the collections");
    }
    for (const xml_node child : geometry.children()) {
      if (!read_geometry(child, area, depth + 1)) return false;
    }
  } else if (is_one_of(name,
                       {"Point", "LineString", "LinearRing", "Model", "Track", "MultiTrack"})) {
    refuse(area, place(geometry), "a " + std::string(name) + " encloses nothing",
           name == "LinearRing" ? "make it the <outerBoundaryIs> of a Polygon" : take_other_areas);
  } else if (is_time(geometry)) {
    refuse_time(geometry, area);
  }
  return true;
}

void KmlReader::refuse_time(xml_node time, Area& area) {
  refuse(area, place(time), "a " + std::string(name_of(time)) + " tells when the area is shown",
         "take it out, and say in the specification when the area applies");
}

bool KmlReader::read_placemark(xml_node placemark, xml_node time) {
  Area area;
  area.where = place(placemark);
  area.name = text_of(child_of(placemark, "name"));
  const std::string id = placemark.attribute("id").value();
  if (area.name.empty()) {
    area.name = id;
  } else if (!id.empty()) {
    area.other_names.push_back(id);
  }
  for (const xml_node child : placemark.children()) {
    if (!read_geometry(child, area, 1)) return false;
  }
  if (time) refuse_time(time, area);
  if (area.parts.empty()) {
    refuse(area, area.where, "the Placemark has no Polygon", take_other_areas);
  }
  return add_area(std::move(area), limits_, areas_, findings_);
}

// What it links to may be another zone of the same map.
bool KmlReader::refuse_link(xml_node link) {
  Area area;
  area.where = place(link);
  area.name = text_of(child_of(link, "name"));
  refuse(area, area.where, "a NetworkLink is not followed",
         "save what it links to as a file of its own");
  return add_area(std::move(area), limits_, areas_, findings_);
}

bool KmlReader::read_features(xml_node container, xml_node time, std::size_t depth) {
  if (depth > limits_.nesting_max) {
    return findings_.fail(place(container), "nested too deeply", "flatten the folders");
  }
  for (const xml_node child : container.children()) {
    if (is_time(child)) time = child;  // of all features in the container
  }
  for (const xml_node child : container.children()) {
    const std::string_view name = name_of(child);
    if (name == "Placemark" && !read_placemark(child, time)) return false;
    if (name == "NetworkLink" && !refuse_link(child)) return false;
    if (is_one_of(name, {"Document", "Folder"}) && !read_features(child, time, depth + 1)) {
      return false;
    }
  }
  return true;
}

bool KmlReader::read_root(const pugi::xml_document& document) {
  for (const xml_node node : document.children()) {
    if (node.type() == pugi::node_doctype) {
      return findings_.fail("the whole text", "has a document type, which may define entities",
                            "KML has none: take the line `<!DOCTYPE ...>` out");
    }
  }
  const xml_node root = document.document_element();
  if (name_of(root) != "kml") {
    return findings_.fail(place(root), "the outermost element is " + quote(name_of(root)),
                          "KML starts with `<kml>`");
  }
  return read_features(root, {}, 1);
}

}  // namespace

Outcome read_kml(std::string_view text, const Limits& limits) {
  // An element or attribute costs far more memory than its letters.
  const auto elements = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return c == '<' || c == '='; }));
  if (elements > limits.values_max) {
    return Failure{"the whole text", "more than " + std::to_string(limits.values_max) + " elements",
                   "split the file, or leave out what is no zone"};
  }
  pugi::xml_document document;
  // Only the five entities of XML itself are expanded, whatever a document type says.
  const auto result = document.load_buffer(
      text.data(), text.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
  if (!result) {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, result.offset));
    return Failure{line_and_column(text, offset),
                   std::string("this is no XML: ") + result.description(),
                   "the file may have been cut off; export it again"};
  }
  Findings findings;
  KmlReader reader(text, limits, findings);
  if (!reader.read_root(document)) return *findings.failure();
  return reader.take_areas();
}

}  // namespace rtac::geometry::import
