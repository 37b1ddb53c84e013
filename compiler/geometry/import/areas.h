// What a file of zones says, before it is placed in a frame: areas with their rings, circles, bands
// of altitude and schedules, as plain data. Readers add nothing and guess nothing: what a format
// leaves open stays open here, and the specification must say it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rtac::geometry::import {

// One position as the file has it. Of a file in degrees: x is the longitude, y the latitude; of one
// in metres: east and north. Doubles, since that is what every format means by its numbers.
struct Position {
  double x = 0, y = 0;
};

// Closed implicitly: a last position that repeats the first one is left out, `closed` tells that it
// was there.
struct Ring {
  std::vector<Position> positions;
  bool closed = false;
  std::string where;  // in the file, for messages: `features[3].geometry.coordinates[0]`, `line 12`
};

struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

struct Circle {
  Position centre;
  double radius_m = 0;
  std::string where;
};

enum class AltitudeReference { unstated, mean_sea_level, ellipsoid, ground };

struct Altitude {
  double value_m = 0;
  AltitudeReference reference = AltitudeReference::unstated;
};

// Missing ends are open: nothing is said there.
struct Band {
  std::optional<Altitude> floor, ceiling;
};

// Applies in [from, until) of every day of `weekdays` (bit 0: Monday), in UTC, between two moments.
struct Period {
  std::optional<std::int64_t> from_us, until_us;  // since 1970-01-01T00:00Z; nullopt: for ever
  std::uint8_t weekdays = 0x7f;
  std::int32_t from_s = 0, until_s = 86'400;  // of the day
  std::string where{};                        // in the file, for messages
  std::string rounded{};  // the moment or time that is no whole second, as the file has it, if any
};
// Hours of the same days and dates that meet are one: a day from midnight to midnight elsewhere is
// two parts of days in UTC.
std::vector<Period> joined(std::vector<Period> schedule);

enum class Role { unstated, keep_in, keep_out };

// Why a file cannot be read, or an area not be used. `where` is a place within the file.
struct Failure {
  std::string where, message, help;
};

// What the file says besides, and no reader turns into areas: a return point, heights of vertices.
struct Note {
  std::string where, message;
};

// One solid of an area: stacked solids are parts of their own.
struct Part {
  std::variant<Polygon, Circle> shape;
  Band band;
};

struct Area {
  std::string name;                      // as the file calls it; may be empty
  std::vector<std::string> other_names;  // that it also goes by, e.g. a title beside the identifier
  Role role = Role::unstated;            // fences say it, geometries do not
  std::string restriction;   // in the words of the file, e.g. `REQ_AUTHORISATION`; may be empty
  std::optional<int> group;  // of MAVLink inclusions: inside all of a group, inside any group
  std::vector<Part> parts;
  std::vector<Period> schedule;  // empty: always
  // Set: the file is sound, but this area cannot be honoured (a line encloses nothing, a schedule
  // follows the sun). It has no parts, and whoever selects it reports this: an area of a file
  // never vanishes silently, and one that nobody selects does no harm.
  std::optional<Failure> refusal;
  // Set: the file says of a height what its format does not define, such as the property
  // `upperLimit` in plain GeoJSON. Nobody can read it: the area holds for all heights, or not at
  // all.
  std::optional<Note> unread_height{};
  // The same of a time, such as the property `valid_until`.
  std::optional<Note> unread_time{};
  std::string where;
};

// Outlines and holes of all polygons of these areas.
void add_rings(const std::vector<const Area*>& areas, std::vector<const Ring*>& rings);

enum class Axes { unstated, longitude_first, latitude_first };
enum class Unit { unstated, degrees, metres };

struct Areas {
  std::vector<Area> areas;
  Unit unit = Unit::degrees;
  // The order of the format. Where it states one, positions are turned to longitude first;
  // `unstated`: the format leaves it open, they are in file order.
  Axes axes = Axes::longitude_first;
  // Set: all positions are on the globe, but only with latitude and longitude the other way round.
  // Whoever has no reason to turn them reports this.
  std::optional<Failure> only_turned;
  std::vector<Note> notes;
};

// What the formats say, and how rings end in them:
//   geojson    longitude first, closed; names from `id`, `name`, `title` and `identifier`
//   wkt        neither axes nor, without an SRID, a unit; closed; several texts: several areas
//   kml        longitude first, closed; a band where a polygon is extruded
//   qgc_plan   latitude first (turned here), not closed; keep-in and keep-out, without groups
//   waypoints  latitude first (turned here), not closed; keep-in and keep-out, with groups
//   ed269      longitude first, closed; a band for each part, restrictions, schedules
//   ed318      the same in GeoJSON
enum class Format { geojson, wkt, kml, qgc_plan, waypoints, ed269, ed318 };

// By its extension and content; nullopt: none of them.
std::optional<Format> format_of(const std::string& path, const std::string& text);

struct Limits {
  std::size_t areas_max = 200'000;  // the zones of a large State are tens of thousands
  std::size_t positions_max = 2'000'000;
  std::size_t values_max = 8'000'000;  // objects, arrays, texts and so on, whatever they are for
  std::size_t bytes_max = std::size_t{256} << 20;
  std::size_t nesting_max = 64;
};

// Bounded time and memory for any text; every number is finite.
std::variant<Areas, Failure> read(Format format, const std::string& text, const Limits& limits);
// Why a text can be of no format: it is none, or has too many bytes.
std::optional<Failure> no_text(const std::string& text, const Limits& limits);

}  // namespace rtac::geometry::import
