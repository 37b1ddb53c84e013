// KML (OGC 07-147r2): Placemarks are areas; longitude, latitude and, of polygons that are not
// clamped to the ground, a height. A polygon with heights is a sheet in the air; only with
// `<extrude>` it is the solid from the ground up to them, with the ground as its floor. What has no
// say in areas is listed in kml_elements.cpp; an element that is in no list fails, since it may be
// a hole, or a zone of its own.
#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <utility>
#include <vector>

#include "compiler/geometry/import/kml_elements.h"
#include "compiler/geometry/import/kml_namespaces.h"
#include "compiler/geometry/import/numbers.h"
#include "compiler/geometry/import/outlines.h"
#include "compiler/geometry/import/property_limits.h"
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

std::string_view name_of(xml_node node) {
  return local_name(node.name());
}
std::string tag(xml_node node) {
  return quote("<" + std::string(node.name()) + ">");
}

constexpr const char* declare_kml = "write `http://www.opengis.net/kml/2.2` for it, if it is KML";

bool is_time(xml_node node) {
  return element_of(KmlPlace::container, name_of(node)) == KmlElement::time;
}

class KmlReader {
 public:
  KmlReader(std::string_view text, const Limits& limits, Findings& findings)
      : lines_(text), limits_(limits), findings_(findings) {}

  bool read_root(const pugi::xml_document& document);
  Areas take_areas() { return std::move(areas_); }

 private:
  // The lowest and highest of all positions of a polygon.
  struct Heights {
    double least = 0, most = 0;
    bool is_set = false;
  };
  // What a polygon says of its heights, and its rings once more.
  struct Altitudes {
    Heights heights;
    xml_node mode, extrude;
    std::vector<xml_node> of_rings;
  };

  std::string place(xml_node node) const {
    return lines_.place(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug())));
  }
  // Calls `visit(element, child)` for every child with a say in areas; fails on unknown ones.
  template <class Visit>
  bool each_child(xml_node parent, KmlPlace in, const Visit& visit);
  bool is_foreign(KmlElement element, xml_node node) const;
  void declare_namespaces(xml_node node);
  std::string help_for_unknown(xml_node child, KmlPlace in) const;
  bool fail_unknown(xml_node child, KmlPlace in);
  // All of its text: a comment in between makes two pieces.
  bool read_text(xml_node node, std::string& text);
  bool fail_second(xml_node node, const std::string& help) {
    return findings_.fail(place(node), "a second " + tag(node), help);
  }

  // `time`: what tells when an outer container is shown, if any does.
  bool read_features(xml_node container, KmlPlace in, xml_node time, std::size_t depth);
  bool read_feature(KmlElement element, xml_node node, xml_node time, std::size_t depth);
  bool read_placemark(xml_node placemark, xml_node time);
  bool read_placemark_child(KmlElement element, xml_node node, Area& area, xml_node& name,
                            xml_node& geometry);
  void note_limits(xml_node data, Area& area);
  void refuse_time(xml_node time, Area& area);
  bool read_geometry(KmlElement element, xml_node node, Area& area, std::size_t depth);
  bool read_polygon(xml_node node, Area& area);
  bool read_boundary(xml_node boundary, Polygon& polygon, Altitudes& altitudes);
  bool read_ring(xml_node node, Ring& ring, Altitudes& altitudes);
  bool read_position(std::string_view tuple, Ring& ring, Heights& heights);
  bool read_band(xml_node polygon, const Altitudes& altitudes, Area& area, Band& band);
  bool read_mode(const Altitudes& altitudes, Area& area, std::string& mode);
  bool refuse_link(xml_node link);
  bool check_control(xml_node control);
  void note_overlay(xml_node overlay);
  bool find_root(const pugi::xml_document& document, xml_node& root);
  bool check_root(xml_node root);

  Lines lines_;
  const Limits& limits_;
  Findings& findings_;
  Areas areas_;
  std::size_t positions_ = 0;
  KmlNamespaces namespaces_;  // around the element that is read
  bool has_overlay_ = false;
};

// Elements of another vocabulary may have the names of KML. Google's extensions are no geometries
// with an inside.
bool KmlReader::is_foreign(KmlElement element, xml_node node) const {
  const KmlVocabulary vocabulary = namespaces_.vocabulary_of(node.name());
  if (vocabulary != KmlVocabulary::google) return vocabulary == KmlVocabulary::other;
  return element != KmlElement::altitude_mode && element != KmlElement::time &&
         element != KmlElement::no_area;
}

void KmlReader::declare_namespaces(xml_node node) {
  for (const pugi::xml_attribute attribute : node.attributes()) {
    namespaces_.declare(attribute.name(), attribute.value());
  }
}

std::string KmlReader::help_for_unknown(xml_node child, KmlPlace in) const {
  const std::string_view spelling = other_spelling(in, name_of(child));
  if (!spelling.empty() && spelling != name_of(child)) {
    return "KML spells it `" + std::string(spelling) + "`";
  }
  const auto uri = namespaces_.uri_of(child.name());
  if (!spelling.empty() && uri && namespaces_.vocabulary_of(child.name()) == KmlVocabulary::other) {
    return "its namespace is " + quote(*uri) + ": " + declare_kml +
           ", or take it out if no zone depends on it";
  }
  return "an area or a hole may be lost with it; what is read there is " +
         std::string(read_there(in)) +
         ": take it out if no zone depends on it, and data for people into <ExtendedData>";
}

bool KmlReader::fail_unknown(xml_node child, KmlPlace in) {
  const xml_node parent = child.parent();
  if (child.type() != pugi::node_element) {
    return findings_.fail(place(child), "text within " + tag(parent) + ": " + quote(child.value()),
                          "what is read there is " + std::string(read_there(in)) +
                              ": take the text out, or make a comment of it");
  }
  return findings_.fail(place(child), tag(child) + " is no element of KML within " + tag(parent),
                        help_for_unknown(child, in));
}

template <class Visit>
bool KmlReader::each_child(xml_node parent, KmlPlace in, const Visit& visit) {
  for (const xml_node child : parent.children()) {
    if (child.type() != pugi::node_element) return fail_unknown(child, in);
    const auto element = element_of(in, name_of(child));
    if (element == KmlElement::no_matter) continue;
    const std::size_t around = namespaces_.count();
    declare_namespaces(child);
    if (!element || is_foreign(*element, child)) return fail_unknown(child, in);
    if (!visit(*element, child)) return false;
    namespaces_.keep(around);
  }
  return true;
}

bool KmlReader::read_text(xml_node node, std::string& text) {
  for (const xml_node child : node.children()) {
    if (child.type() == pugi::node_element) {
      return findings_.fail(place(child), tag(child) + " within " + tag(node),
                            "there is text alone: take it out");
    }
    text += child.value();
  }
  text = std::string(trimmed(text));
  return true;
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

bool KmlReader::read_ring(xml_node node, Ring& ring, Altitudes& altitudes) {
  ring.where = place(node);
  xml_node coordinates;
  const auto take = [&](KmlElement element, xml_node child) {
    if (element == KmlElement::altitude_mode) {
      altitudes.of_rings.push_back(child);
      return true;
    }
    if (coordinates) return fail_second(child, "write all positions of the ring into one");
    coordinates = child;
    return true;
  };
  if (!each_child(node, KmlPlace::ring, take)) return false;
  if (!coordinates) {
    return findings_.fail(ring.where, "a LinearRing without <coordinates>", "add them");
  }
  std::string all;
  if (!read_text(coordinates, all)) return false;
  for (std::string_view text = all; !text.empty(); text = trimmed(text)) {
    const auto end = std::find_if(text.begin(), text.end(), is_space);
    const auto length = static_cast<std::size_t>(end - text.begin());
    if (!read_position(text.substr(0, length), ring, altitudes.heights)) return false;
    text.remove_prefix(length);
  }
  return finish_ring(ring, Closing::required, findings_);
}

bool KmlReader::read_boundary(xml_node boundary, Polygon& polygon, Altitudes& altitudes) {
  const bool is_outer = name_of(boundary) == "outerBoundaryIs";
  bool has_ring = false;
  const auto take = [&](KmlElement /*ring*/, xml_node node) {
    if (is_outer && !polygon.outer.where.empty()) {
      return findings_.fail(place(node), "a second outline of one polygon",
                            "write a polygon for each of them");
    }
    has_ring = true;
    return read_ring(node, is_outer ? polygon.outer : polygon.holes.emplace_back(), altitudes);
  };
  if (!each_child(boundary, KmlPlace::boundary, take)) return false;
  return has_ring || findings_.fail(place(boundary), "a boundary without a LinearRing", "add it");
}

// That of the polygon counts; what a ring says besides must not differ.
bool KmlReader::read_mode(const Altitudes& altitudes, Area& area, std::string& mode) {
  if (altitudes.mode && !read_text(altitudes.mode, mode)) return false;
  if (mode.empty()) mode = "clampToGround";
  for (const xml_node node : altitudes.of_rings) {
    std::string of_ring;
    if (!read_text(node, of_ring)) return false;
    if (of_ring.empty() || of_ring == mode) continue;
    refuse(area, place(node),
           "the altitude mode of the ring is " + quote(of_ring) + ", that of the polygon " +
               quote(mode),
           "give the polygon the one that is meant, and take that of the ring out");
  }
  return true;
}

bool KmlReader::read_band(xml_node polygon, const Altitudes& altitudes, Area& area, Band& band) {
  const Heights& heights = altitudes.heights;
  std::string mode, extrude;
  if (!read_mode(altitudes, area, mode)) return false;
  if (altitudes.extrude && !read_text(altitudes.extrude, extrude)) return false;
  if (mode == "clampToGround") return true;  // whose heights mean nothing
  const bool is_above_ground = mode == "relativeToGround";
  if (!is_above_ground && mode != "absolute") {
    refuse(area, place(polygon), "the altitude mode is " + quote(mode),
           "`clampToGround`, `relativeToGround` or `absolute`");
    return true;
  }
  if (is_above_ground && heights.least == 0 && heights.most == 0) return true;
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
  Altitudes altitudes;
  const auto take = [&](KmlElement element, xml_node child) {
    if (element != KmlElement::altitude_mode && element != KmlElement::extrude) {
      return read_boundary(child, polygon, altitudes);
    }
    xml_node& first = element == KmlElement::extrude ? altitudes.extrude : altitudes.mode;
    if (first) {
      refuse(area, place(child), "a second " + tag(child) + " of the polygon",
             "keep the one that is meant");
    }
    first = child;
    return true;
  };
  if (!each_child(node, KmlPlace::polygon, take)) return false;
  if (polygon.outer.where.empty()) {
    return findings_.fail(place(node), "a Polygon without <outerBoundaryIs>", "add it");
  }
  if (!read_band(node, altitudes, area, part.band)) return false;
  area.parts.push_back(std::move(part));
  return true;
}

bool KmlReader::read_geometry(KmlElement element, xml_node node, Area& area, std::size_t depth) {
  if (element == KmlElement::polygon) return read_polygon(node, area);
  if (element == KmlElement::multi_geometry) {
    if (depth > limits_.nesting_max) {
      return findings_.fail(place(node), "nested too deeply", "flatten the collections");
    }
    return each_child(node, KmlPlace::multi_geometry, [&](KmlElement inner, xml_node child) {
      return read_geometry(inner, child, area, depth + 1);
    });
  }
  const std::string_view name = name_of(node);
  refuse(area, place(node), "a " + std::string(name) + " encloses nothing",
         name == "LinearRing" ? "make it the <outerBoundaryIs> of a Polygon" : take_other_areas);
  return true;
}

void KmlReader::refuse_time(xml_node time, Area& area) {
  refuse(area, place(time), "a " + std::string(name_of(time)) + " tells when the area is shown",
         "take it out, and say in the specification when the area applies");
}

// `<Data name="ceiling"><value>120</value></Data>`, `<SimpleData name="ceiling">120</SimpleData>`,
// `<faa:ceiling>120</faa:ceiling>`.
void KmlReader::note_limits(xml_node data, Area& area) {
  const auto look = [&](xml_node node) {
    const pugi::xml_attribute name = node.attribute("name");
    const std::string_view called = name ? name.value() : name_of(node);
    const std::string_view text =
        name_of(node) == "Data" ? node.child_value("value") : node.child_value();
    if (!area.unread_height && is_limit_of_height(called, text)) {
      area.unread_height = Note{place(node), "sounds like a limit of height"};
    } else if (!area.unread_time && is_limit_of_time(called, text)) {
      area.unread_time = Note{place(node), "sounds like a limit of time"};
    }
  };
  for (const xml_node node : data.children()) {
    if (name_of(node) != "SchemaData") look(node);
    for (const xml_node field : node.children("SimpleData")) look(field);
  }
}

bool KmlReader::read_placemark_child(KmlElement element, xml_node node, Area& area, xml_node& name,
                                     xml_node& geometry) {
  if (element == KmlElement::name) {
    if (name) return fail_second(node, "keep the one by which it is selected");
    name = node;
    return read_text(node, area.name);
  }
  if (element == KmlElement::time) {
    refuse_time(node, area);
    return true;
  }
  if (element == KmlElement::data) {
    note_limits(node, area);
    return true;
  }
  if (geometry) {
    refuse(area, place(node), "a second geometry of one Placemark, " + tag(node),
           "write a Placemark for each, or put them into a <MultiGeometry>");
  }
  geometry = node;
  return read_geometry(element, node, area, 1);
}

bool KmlReader::read_placemark(xml_node placemark, xml_node time) {
  Area area;
  area.where = place(placemark);
  xml_node name, geometry;
  const auto take = [&](KmlElement element, xml_node child) {
    return read_placemark_child(element, child, area, name, geometry);
  };
  if (!each_child(placemark, KmlPlace::placemark, take)) return false;
  const std::string id = placemark.attribute("id").value();
  if (area.name.empty()) {
    area.name = id;
  } else if (!id.empty()) {
    area.other_names.push_back(id);
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
  for (const xml_node child : link.children()) {
    if (name_of(child) == "name" && area.name.empty() && !read_text(child, area.name)) return false;
  }
  refuse(area, area.where, "a NetworkLink is not followed",
         "save what it links to as a file of its own");
  return add_area(std::move(area), limits_, areas_, findings_);
}

// It says when to look again, and may change what another file says.
bool KmlReader::check_control(xml_node control) {
  for (const xml_node child : control.children()) {
    if (name_of(child) != "Update") continue;
    return findings_.fail(place(child), "an Update changes the features of another file",
                          "save the other file with its changes, and take the "
                          "<NetworkLinkControl> out");
  }
  return true;
}

void KmlReader::note_overlay(xml_node overlay) {
  if (std::exchange(has_overlay_, true)) return;
  areas_.notes.push_back({place(overlay), "overlays are pictures, and are left out"});
}

bool KmlReader::read_feature(KmlElement element, xml_node node, xml_node time, std::size_t depth) {
  if (element == KmlElement::placemark) return read_placemark(node, time);
  if (element == KmlElement::network_link) return refuse_link(node);
  if (element == KmlElement::network_link_control) return check_control(node);
  if (element == KmlElement::container) {
    return read_features(node, KmlPlace::container, time, depth + 1);
  }
  if (element == KmlElement::overlay) note_overlay(node);
  return true;
}

bool KmlReader::read_features(xml_node container, KmlPlace in, xml_node time, std::size_t depth) {
  if (depth > limits_.nesting_max) {
    return findings_.fail(place(container), "nested too deeply", "flatten the folders");
  }
  for (const xml_node child : container.children()) {
    if (is_time(child)) time = child;  // of all features in the container
  }
  return each_child(container, in, [&](KmlElement element, xml_node child) {
    return read_feature(element, child, time, depth);
  });
}

// The parser takes fragments: what stands beside the root would be lost with the areas in it.
bool KmlReader::find_root(const pugi::xml_document& document, xml_node& root) {
  for (const xml_node node : document.children()) {
    if (node.type() == pugi::node_doctype) {
      return findings_.fail("the whole text", "has a document type, which may define entities",
                            "KML has none: take the line `<!DOCTYPE ...>` out");
    }
    if (node.type() != pugi::node_element) {
      return findings_.fail(
          place(node), "text outside of the outermost element: " + quote(trimmed(node.value())),
          "take it out, or make a comment of it");
    }
    if (root) {
      return findings_.fail(place(node), "a second outermost element, " + tag(node),
                            "files of XML have one: write what is in this one into the first, or "
                            "into a file of its own");
    }
    root = node;
  }
  return root || findings_.fail("the whole text", "this is no XML: it has no element",
                                "the file may have been cut off; export it again");
}

bool KmlReader::check_root(xml_node root) {
  if (name_of(root) != "kml") {
    return findings_.fail(place(root), "the outermost element is " + quote(name_of(root)),
                          "KML starts with `<kml>`");
  }
  if (namespaces_.vocabulary_of(root.name()) == KmlVocabulary::kml) return true;
  const auto uri = namespaces_.uri_of(root.name());
  return findings_.fail(
      place(root),
      uri ? "the namespace of the outermost element, " + tag(root) + ", is " + quote(*uri)
          : "no namespace is declared for the prefix of the outermost element, " + tag(root),
      std::string(declare_kml) +
          "; 2.3 of it can be read, too, and 2.0 to 2.2 of `http://earth.google.com/kml/`");
}

bool KmlReader::read_root(const pugi::xml_document& document) {
  xml_node root;
  if (!find_root(document, root)) return false;
  declare_namespaces(root);
  return check_root(root) && read_features(root, KmlPlace::root, {}, 1);
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
      text.data(), text.size(), pugi::parse_default | pugi::parse_doctype | pugi::parse_fragment,
      pugi::encoding_utf8);
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
