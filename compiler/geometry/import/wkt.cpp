// Well-known text (OGC 06-103r4, 7.2), also with the SRID of PostGIS in front. The grammar is tiny,
// and a reader of our own is strict where libraries are not: GEOS nests without a limit and says
// neither line nor column. Each text of a file, one after the other, is an area.
//
// The format says nothing about the order of axes, and of the unit only what an SRID says. 4326 are
// degrees, but programs write longitude first where EPSG has latitude first: the order stays open.
#include <algorithm>
#include <array>
#include <cctype>

#include "compiler/geometry/import/numbers.h"
#include "compiler/geometry/import/outlines.h"
#include "compiler/geometry/import/readers.h"
#include "compiler/geometry/import/words.h"

namespace rtac::geometry::import {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}
bool is_numeric(char c) {
  return is_digit(c) || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E';
}

class WktReader {
 public:
  WktReader(std::string_view text, const Limits& limits, Findings& findings)
      : text_(text), lines_(text), limits_(limits), findings_(findings) {
    areas_.unit = Unit::unstated;
    areas_.axes = Axes::unstated;
  }

  bool read();
  Areas take_areas() { return std::move(areas_); }

 private:
  void skip_spaces() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }
  bool is_next(char c) {
    skip_spaces();
    return at_ < text_.size() && text_[at_] == c;
  }
  bool take(char c);
  std::string take_word();
  std::string_view take_number();
  std::string here() {
    skip_spaces();
    return lines_.place(at_);
  }
  bool unexpected(const std::string& expected);

  bool read_srid();
  bool read_geometry(Area& area, std::size_t depth);
  bool read_tag(std::string& type);
  bool read_members(Area& area, std::size_t depth);
  bool read_polygons(Area& area);
  bool read_polygon(Area& area);
  bool read_ring(Ring& ring);
  bool read_position(Position& position);
  bool skip_body();
  // Calls `item` for each of the items between parentheses.
  template <class Item>
  bool read_list(const Item& item);

  std::string_view text_;
  Lines lines_;
  const Limits& limits_;
  Findings& findings_;
  Areas areas_;
  std::size_t at_ = 0, positions_ = 0;
  std::size_t dimensions_ = 0;  // of the geometry that is being read; 0: not known yet
  std::string extra_at_;        // the first position with more than two numbers
};

bool WktReader::unexpected(const std::string& expected) {
  const std::string place = here();
  if (at_ >= text_.size()) {
    return findings_.fail(place, "the text ends before it is complete",
                          "the file was cut off; " + expected + " comes next");
  }
  return findings_.fail(place, "unexpected " + quote(text_.substr(at_, 20)),
                        expected + " comes next");
}

bool WktReader::take(char c) {
  if (!is_next(c)) return false;
  ++at_;
  return true;
}

std::string WktReader::take_word() {
  skip_spaces();
  constexpr std::size_t longest = 32;
  std::string word;
  while (at_ < text_.size() && is_letter(text_[at_]) && word.size() < longest) {
    word += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
  }
  return word;
}

std::string_view WktReader::take_number() {
  skip_spaces();
  const std::size_t begin = at_;
  while (at_ < text_.size() && is_numeric(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

template <class Item>
bool WktReader::read_list(const Item& item) {
  if (!take('(')) return unexpected("`(`");
  do {
    if (!item()) return false;
  } while (take(','));
  return take(')') || unexpected("`,` or `)`");
}

bool WktReader::read_position(Position& position) {
  const std::string_view where = text_.substr(at_);
  std::array<double, 4> values{};
  std::size_t count = 0;
  skip_spaces();
  while (count < values.size() && at_ < text_.size() && is_numeric(text_[at_])) {
    const std::size_t begin = at_;
    const std::string_view number = take_number();
    const auto value = parse_number(number);
    if (!value) {
      return findings_.fail(lines_.place(begin), quote(number) + " is no number",
                            "a decimal number within the range of doubles");
    }
    values[count++] = *value;
    skip_spaces();
  }
  if (count < 2) return unexpected("a number");
  if (dimensions_ == 0 && count <= 3) dimensions_ = count;
  if (count != dimensions_) {
    return findings_.fail(lines_.place(text_.size() - where.size()),
                          "a position of " + std::to_string(count) + " numbers, among those of " +
                              std::to_string(dimensions_ == 0 ? 2 : dimensions_),
                          "two numbers, one more with `Z` or `M`, two more with `ZM`");
  }
  if (count > 2 && extra_at_.empty()) extra_at_ = lines_.place(text_.size() - where.size());
  if (++positions_ > limits_.positions_max) {
    return findings_.fail(here(),
                          "more than " + std::to_string(limits_.positions_max) + " positions",
                          "simplify the outlines, or split the file");
  }
  position = {values[0], values[1]};
  return true;
}

bool WktReader::read_ring(Ring& ring) {
  ring.where = here();
  return read_list([&] { return read_position(ring.positions.emplace_back()); }) &&
         finish_ring(ring, Closing::required, findings_);
}

bool WktReader::read_polygon(Area& area) {
  Polygon polygon;
  bool is_outer = true;
  const bool is_read = read_list([&] {
    const bool is_good = read_ring(is_outer ? polygon.outer : polygon.holes.emplace_back());
    is_outer = false;
    return is_good;
  });
  if (is_read) area.parts.push_back({std::move(polygon), {}});
  return is_read;
}

bool WktReader::read_polygons(Area& area) {
  return read_list([&] {
    const std::size_t begin = at_;
    if (take_word() == "EMPTY") {
      refuse(area, lines_.place(begin), "a part is empty", "take it out");
      return true;
    }
    at_ = begin;
    return read_polygon(area);
  });
}

// Balanced parentheses, whatever is between them.
bool WktReader::skip_body() {
  if (!is_next('(')) return unexpected("`(`");
  std::size_t depth = 0;
  do {
    const std::size_t next = text_.find_first_of("()", at_);
    if (next == std::string_view::npos) {
      at_ = text_.size();
      return unexpected("`)`");
    }
    text_[next] == '(' ? ++depth : --depth;
    at_ = next + 1;
  } while (depth > 0);
  return true;
}

// The type without its dimensions, which are a word of their own or hang at its end.
bool WktReader::read_tag(std::string& type) {
  type = take_word();
  if (type.empty()) return unexpected("the word `POLYGON`");
  std::string dimension;
  const std::size_t after = at_;
  if (const std::string word = take_word(); word == "Z" || word == "M" || word == "ZM") {
    dimension = word;
  } else {
    at_ = after;
    for (const std::string_view suffix : {"ZM", "Z", "M"}) {
      if (!type.ends_with(suffix) || type.size() < 5) continue;
      dimension = suffix;
      type.resize(type.size() - suffix.size());
      break;
    }
  }
  if (!dimension.empty()) dimensions_ = 2 + dimension.size();
  return true;
}

bool WktReader::read_members(Area& area, std::size_t depth) {
  return read_list([&] { return read_geometry(area, depth + 1); });
}

bool WktReader::read_geometry(Area& area, std::size_t depth) {
  const std::string place = here();
  if (depth > limits_.nesting_max) {
    return findings_.fail(place,
                          "nested deeper than " + std::to_string(limits_.nesting_max) + " levels",
                          "flatten the collections");
  }
  dimensions_ = 0;
  std::string type;
  if (!read_tag(type)) return false;
  const std::size_t body = at_;
  if (take_word() == "EMPTY") {
    refuse(area, place, "the geometry is empty", "take it out");
    return true;
  }
  at_ = body;
  if (type == "POLYGON") return read_polygon(area);
  if (type == "MULTIPOLYGON") return read_polygons(area);
  if (type == "GEOMETRYCOLLECTION") return read_members(area, depth);
  for (const std::string_view flat : {"POINT", "MULTIPOINT", "LINESTRING", "MULTILINESTRING",
                                      "CIRCULARSTRING", "COMPOUNDCURVE", "MULTICURVE"}) {
    if (type != flat) continue;
    refuse(area, place, "a " + type + " encloses nothing", "take it out");
    return skip_body();
  }
  for (const std::string_view other :
       {"CURVEPOLYGON", "MULTISURFACE", "SURFACE", "TRIANGLE", "TIN", "POLYHEDRALSURFACE"}) {
    if (type != other) continue;
    refuse(area, place, "a " + type + " has no outline of straight edges that can be read",
           "write it as a POLYGON");
    return skip_body();
  }
  return findings_.fail(place, "there is no geometry of the type " + quote(type),
                        "`POLYGON`, `MULTIPOLYGON` or `GEOMETRYCOLLECTION`");
}

// `SRID=4326;` of PostGIS.
bool WktReader::read_srid() {
  const std::size_t begin = at_;
  Unit unit = Unit::unstated;
  if (take_word() == "SRID") {
    if (!take('=')) return unexpected("`=`");
    const std::string_view number = take_number();
    if (number != "4326" && number != "0") {
      return findings_.fail(lines_.place(begin), "the reference system is SRID " + quote(number),
                            "4326, or none where positions are metres of the map");
    }
    if (!take(';')) return unexpected("`;`");
    if (number == "4326") unit = Unit::degrees;
  } else {
    at_ = begin;
  }
  if (!areas_.areas.empty() && unit != areas_.unit) {
    return findings_.fail(lines_.place(begin), "an area with an SRID beside one without",
                          "give all of them the same");
  }
  areas_.unit = unit;
  return true;
}

bool WktReader::read() {
  while (skip_spaces(), at_ < text_.size()) {
    Area area;
    area.where = here();
    if (!read_srid() || !read_geometry(area, 1)) return false;
    if (!add_area(std::move(area), limits_, areas_, findings_)) return false;
    take(';');
  }
  if (!extra_at_.empty()) {
    areas_.notes.push_back({extra_at_,
                            "positions have heights or measures; well-known text does not say that "
                            "they limit the area, and they are left out"});
  }
  return true;
}

}  // namespace

Outcome read_wkt(std::string_view text, const Limits& limits) {
  Findings findings;
  WktReader reader(text, limits, findings);
  if (!reader.read()) return *findings.failure();
  return reader.take_areas();
}

}  // namespace rtac::geometry::import
