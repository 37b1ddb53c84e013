// Fence items among the lines of a QGC WPL 110 text: index, current, frame, command, param1 to
// param4, latitude, longitude, altitude, autocontinue ("File Formats" of the MAVLink guide).
// Commands and parameters from common.xml of MAVLink: 5001 and 5002 are the vertices of an
// inclusion or exclusion polygon, one after the other, each with the number of vertices in param1;
// 5003 and 5004 are circles with the radius in metres in param1; of inclusions, param2 is the
// group. The other parameters are reserved.
#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/import/numbers.h"
#include "compiler/geometry/import/outlines.h"
#include "compiler/geometry/import/readers.h"

namespace rtac::geometry::import {
namespace {

enum Command {
  fence_return_point = 5000,
  polygon_inclusion = 5001,
  polygon_exclusion = 5002,
  circle_inclusion = 5003,
  circle_exclusion = 5004,
};

struct Item {
  std::string where;  // `line 3`
  int frame = 0, command = 0;
  std::array<double, 4> params{};
  double latitude = 0, longitude = 0, altitude_m = 0;
};

bool is_unset(double value) {
  return value == 0 || std::isnan(value);
}

constexpr std::size_t columns = 12;
constexpr std::array<const char*, columns> column_names{
    "index",  "current", "frame",    "command",   "param1",   "param2",
    "param3", "param4",  "latitude", "longitude", "altitude", "autocontinue"};

// At most one more field than there are columns.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> result;
  while (result.size() <= columns) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) break;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    result.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return result;
}

class WaypointReader {
 public:
  WaypointReader(Findings& findings, const Limits& limits) : findings_(findings), limits_(limits) {
    areas_.axes = Axes::latitude_first;  // of the columns, by their names
  }

  bool read(std::string_view text);
  Areas take_areas() { return std::move(areas_); }

 private:
  bool read_header(std::string_view line);
  bool read_line(std::string_view line);
  bool read_item(const Item& item);
  bool read_vertex(const Item& item);
  bool start_polygon(const Item& item);
  bool read_circle(const Item& item);
  bool check_place(const Item& item);
  bool check_complete();
  bool set_group(const Item& item, Area& area);
  void check_reserved(const Item& item, Area& area);
  bool count_position(const Item& item);
  static void note_once(Note& note, const std::string& where) {
    if (note.where.empty()) note.where = where;
  }
  bool check_index(double index);
  std::optional<int> whole(double value, int least) const;

  Findings& findings_;
  const Limits& limits_;
  Areas areas_;
  std::size_t line_ = 0, positions_ = 0;
  std::optional<double> index_;  // of the item before
  Note altitude_{{}, "altitudes of fence items are reserved, and are left out"};
  Note return_point_{{}, "the return point of a fence is no area, and is left out"};
  Note other_item_{{}, "items besides those of fences are left out"};
  Item first_;                     // of the polygon that is being read
  std::size_t vertices_left_ = 0;  // of it
};

std::optional<int> WaypointReader::whole(double value, int least) const {
  constexpr double most = 1'000'000;
  if (value < least || value > most || value != std::floor(value)) return std::nullopt;
  return static_cast<int>(value);
}

bool WaypointReader::read_header(std::string_view line) {
  const auto fields = fields_of(line);
  if (fields.size() == 3 && fields[0] == "QGC" && fields[1] == "WPL" && fields[2] == "110") {
    return true;
  }
  return findings_.fail("line " + std::to_string(line_), "is " + quote(line),
                        line.find('\r') == std::string_view::npos
                            ? "the first line of such a file is `QGC WPL 110`"
                            : "lines end with a line feed: save the file with line ends of Unix or "
                              "of Windows");
}

// Vehicles take items by their index, this reader by their line: where the two differ, the outline
// is another one, and where a number is missing, an item may be.
bool WaypointReader::check_index(double index) {
  const std::string where = "line " + std::to_string(line_) + ", index";
  const bool is_first = !index_;
  if (is_first ? whole(index, 0).has_value() : index == *index_ + 1) {
    index_ = index;
    return true;
  }
  return findings_.fail(where,
                        "is " + (std::isnan(index) ? std::string("not set") : shown(index)) +
                            (is_first ? "" : ", and " + shown(*index_) + " in the item before"),
                        is_first ? "a whole number from 0"
                                 : "items stand in the order of their indices, without a gap: "
                                   "here " +
                                       shown(*index_ + 1) + " is next");
}

bool WaypointReader::read_line(std::string_view line) {
  const auto fields = fields_of(line);
  if (fields.empty()) return true;
  Item item{.where = "line " + std::to_string(line_)};
  if (fields.size() != columns) {
    return findings_.fail(
        item.where,
        (fields.size() > columns ? "has more than twelve columns"
                                 : "has " + std::to_string(fields.size()) +
                                       (fields.size() == 1 ? " column" : " columns")),
        "an item has twelve; the file may have been cut off");
  }
  std::array<double, columns> values{};
  for (std::size_t i = 0; i < columns; ++i) {
    const bool is_unset = fields[i] == "nan" || fields[i] == "NaN";  // MAVLink: no value
    const auto value = is_unset ? std::optional(std::nan("")) : parse_number(fields[i]);
    if (!value) {
      return findings_.fail(item.where + ", " + column_names[i], "is " + quote(fields[i]),
                            "a finite number");
    }
    values[i] = *value;
  }
  if (!check_index(values[0])) return false;
  const auto frame = whole(values[2], 0), command = whole(values[3], 0);
  if (!frame || !command) {
    return findings_.fail(item.where, "the frame or the command is no whole number",
                          "fence items have the commands 5000 to 5004");
  }
  item.frame = *frame;
  item.command = *command;
  std::copy_n(values.begin() + 4, 4, item.params.begin());
  item.latitude = values[8];
  item.longitude = values[9];
  item.altitude_m = values[10];
  return read_item(item);
}

bool WaypointReader::check_complete() {
  if (vertices_left_ == 0) return true;
  const auto count = static_cast<std::size_t>(first_.params[0]);
  return findings_.fail(first_.where,
                        "the polygon announces " + std::to_string(count) +
                            " vertices in param1, and " + std::to_string(count - vertices_left_) +
                            " follow one another",
                        "all vertices of a polygon stand together and have their number in param1");
}

bool WaypointReader::check_place(const Item& item) {
  if (std::isnan(item.latitude) || std::isnan(item.longitude)) {
    return findings_.fail(item.where, "the latitude or the longitude is not set",
                          "fence items need both");
  }
  // MAV_FRAME: with altitudes above the sea, home or terrain; latitude and longitude alike.
  constexpr std::array global{0, 3, 5, 6, 10, 11};
  if (std::find(global.begin(), global.end(), item.frame) != global.end()) return true;
  return findings_.fail(item.where, "has the frame " + std::to_string(item.frame),
                        "fence items are in a global frame: 0 or 3");
}

bool WaypointReader::set_group(const Item& item, Area& area) {
  if (area.role == Role::keep_out) {
    if (!is_unset(item.params[1])) {
      refuse(area, item.where,
             "param2 of an exclusion is reserved, and is " + shown(item.params[1]), "write 0");
    }
    return true;
  }
  area.group = whole(item.params[1], 0);
  return area.group ||
         findings_.fail(item.where, "the inclusion group, param2, is " + shown(item.params[1]),
                        "a whole number from 0");
}

// A proposal to MAVLink makes them the lowest altitude; dropping that would widen the area.
void WaypointReader::check_reserved(const Item& item, Area& area) {
  if (!is_unset(item.params[2]) || !is_unset(item.params[3])) {
    refuse(area, item.where,
           "param3 and param4 are reserved, and are " + shown(item.params[2]) + " and " +
               shown(item.params[3]),
           "write 0, and say heights in the specification");
  }
  if (!is_unset(item.altitude_m)) note_once(altitude_, item.where);
}

bool WaypointReader::count_position(const Item& item) {
  return ++positions_ <= limits_.positions_max ||
         findings_.fail(item.where,
                        "more than " + std::to_string(limits_.positions_max) + " positions",
                        "simplify the outlines, or split the file");
}

bool WaypointReader::start_polygon(const Item& item) {
  const auto count = whole(item.params[0], 3);
  if (!count) {
    return findings_.fail(item.where, "the number of vertices, param1, is " + shown(item.params[0]),
                          "a whole number from 3");
  }
  first_ = item;
  vertices_left_ = static_cast<std::size_t>(*count);
  Area area;
  area.where = item.where;
  area.role = item.command == polygon_inclusion ? Role::keep_in : Role::keep_out;
  if (!set_group(item, area)) return false;
  Polygon polygon;
  polygon.outer.where = item.where;
  area.parts.push_back({std::move(polygon), {}});
  return add_area(std::move(area), limits_, areas_, findings_);
}

bool WaypointReader::read_vertex(const Item& item) {
  if (vertices_left_ == 0 && !start_polygon(item)) return false;
  if (item.command != first_.command || item.params[0] != first_.params[0]) {
    return check_complete();
  }
  if (item.command == polygon_inclusion && item.params[1] != first_.params[1]) {
    return findings_.fail(item.where,
                          "the inclusion group, param2, is " + shown(item.params[1]) + ", and " +
                              shown(first_.params[1]) + " in " + first_.where,
                          "all vertices of a polygon are of one group");
  }
  if (!count_position(item)) return false;
  Area& area = areas_.areas.back();
  check_reserved(item, area);
  Ring& ring = std::get<Polygon>(area.parts.back().shape).outer;
  ring.positions.push_back({item.longitude, item.latitude});
  return --vertices_left_ > 0 || finish_ring(ring, Closing::implied, findings_);
}

bool WaypointReader::read_circle(const Item& item) {
  if (!check_radius(item.params[0], item.where, findings_) || !count_position(item)) return false;
  Area area;
  area.where = item.where;
  area.role = item.command == circle_inclusion ? Role::keep_in : Role::keep_out;
  if (!set_group(item, area)) return false;
  check_reserved(item, area);
  area.parts.push_back({Circle{.centre = {item.longitude, item.latitude},
                               .radius_m = item.params[0],
                               .where = item.where},
                        {}});
  return add_area(std::move(area), limits_, areas_, findings_);
}

bool WaypointReader::read_item(const Item& item) {
  switch (item.command) {
    case polygon_inclusion:
    case polygon_exclusion:
      return check_place(item) && read_vertex(item);
    case circle_inclusion:
    case circle_exclusion:
      return check_complete() && check_place(item) && read_circle(item);
    case fence_return_point:
      note_once(return_point_, item.where);
      return check_complete();
    default:
      note_once(other_item_, item.where);
      return check_complete();
  }
}

bool WaypointReader::read(std::string_view text) {
  bool is_header = true;
  while (!text.empty()) {
    ++line_;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (is_header ? !read_header(line) : !read_line(line)) return false;
    is_header = false;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!check_complete()) return false;
  if (areas_.areas.empty()) {
    return findings_.fail("the whole text", "has no fence items",
                          "fence items have the commands 5001 to 5004; missions have none");
  }
  for (Note* note : {&altitude_, &return_point_, &other_item_}) {
    if (!note->where.empty()) areas_.notes.push_back(std::move(*note));
  }
  return true;
}

}  // namespace

Outcome read_waypoints(std::string_view text, const Limits& limits) {
  Findings findings;
  WaypointReader reader(findings, limits);
  if (!reader.read(text)) return *findings.failure();
  return reader.take_areas();
}

}  // namespace rtac::geometry::import
