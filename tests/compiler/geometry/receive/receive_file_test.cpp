// Fences that arrive as the text of a file go the way of a file of the specification: projected,
// combined, and refused with a place and a reason, before how much work.
#include "compiler/geometry/receive/receive_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/compiler/needles.h"

namespace rtac::geometry {
namespace {

constexpr Origin here{47.3977, 8.5456};

std::string text_of(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9f", x);
  return text;
}
// A rectangle from here on, 0.001 deg (about 75 m) wide and half of that high, or larger.
std::string corner(double east, double north, bool latitude_first) {
  const std::string x = text_of(here.longitude_deg + 0.001 * east);
  const std::string y = text_of(here.latitude_deg + 0.0005 * north);
  return latitude_first ? y + "," + x : x + "," + y;
}
std::string ring(double x0, double y0, double x1, double y1, bool latitude_first = false) {
  const auto at = [&](double x, double y) { return "[" + corner(x, y, latitude_first) + "]"; };
  return at(x0, y0) + "," + at(x1, y0) + "," + at(x1, y1) + "," + at(x0, y1);
}
std::string geojson(const std::string& coordinates) {
  return R"({"type":"Polygon","coordinates":[)" + coordinates + "]}";
}
std::string closed(double x0, double y0, double x1, double y1) {
  return "[" + ring(x0, y0, x1, y1) + ",[" + corner(x0, y0, false) + "]]";
}
std::string kml(const std::string& more = "") {
  std::string line;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}) {
    line += corner(x, y, false) + ",120 ";
  }
  return "<?xml version=\"1.0\"?><kml "
         "xmlns=\"http://www.opengis.net/kml/2.2\"><Placemark><Polygon>" +
         more + "<outerBoundaryIs><LinearRing><coordinates>" + line +
         "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></kml>";
}
std::string item(const std::string& outline, bool inclusion) {
  return "{" + outline + R"(,"inclusion":)" + (inclusion ? "true" : "false") + R"(,"version":1})";
}
std::string polygon(double x0, double y0, double x1, double y1, bool inclusion = true) {
  return item(R"("polygon":[)" + ring(x0, y0, x1, y1, true) + "]", inclusion);
}
std::string plan(const std::string& polygons, const std::string& circles = "") {
  return R"({"fileType":"Plan","version":1,"geoFence":{"version":2,"circles":[)" + circles +
         R"(],"polygons":[)" + polygons + R"(]},"mission":{"items":[],"version":2}})";
}

using Received = std::variant<ReceivedRegions, RefusedZone>;

Received receive(const std::string& text, import::Format format,
                 FileAreas areas = FileAreas::unstated, std::size_t edges_most = 64) {
  return receive_file(text, {format, here, areas}, edges_most);
}
std::string refused(const Received& received) {
  const auto* why = std::get_if<RefusedZone>(&received);
  if (why == nullptr) return "taken";
  EXPECT_NE(why->help, "");
  return why->where + ": " + why->message;
}
const ReceivedRegions& taken(const Received& received) {
  static const ReceivedRegions none;
  const auto* regions = std::get_if<ReceivedRegions>(&received);
  if (regions == nullptr) ADD_FAILURE() << refused(received);
  return regions != nullptr ? *regions : none;
}
// In units of the rectangle: 0.001 deg of longitude here are 75.49 m, 0.0005 deg of latitude 55.59.
bool is_in(const Region& region, double east, double north) {
  const auto mm = [](double m) {
    return Rational(static_cast<long>(std::lround(1000 * m)), 1000L);
  };
  Point p{mm(75.49 * east), mm(55.59 * north)};
  p.x.canonicalize(), p.y.canonicalize();
  return region.contains(p);
}

constexpr auto as_geojson = import::Format::geojson;
constexpr auto as_kml = import::Format::kml;
constexpr auto as_plan = import::Format::qgc_plan;

// All three say the same rectangle; it is within and around by the error of the projection.
TEST(ReceiveFile, ReadsItsFormatsInTheirAxes) {
  for (const auto& [text, format] : {std::pair{geojson(closed(0, 0, 1, 1)), as_geojson},
                                     {kml(), as_kml},
                                     {plan(polygon(0, 0, 1, 1)), as_plan}}) {
    const Received received = receive(text, format);
    const Region &within = taken(received).within, &around = taken(received).around;
    EXPECT_TRUE(is_in(within, 0.5, 0.5));
    EXPECT_TRUE(is_in(within, 0.99, 0.99));
    EXPECT_FALSE(is_in(around, 1.01, 0.5));
    EXPECT_FALSE(is_in(around, 0.5, 1.01));
    EXPECT_FALSE(is_in(within, 0, 0));  // the corner may be as far off as the projection
    EXPECT_TRUE(is_in(around, 0, 0));
    EXPECT_TRUE(around.contains(within));
    EXPECT_FALSE(within.contains(around));
    const Rational apart = around.area() - within.area();
    EXPECT_LT(apart, 4);  // m^2: millimetres along 260 m
    const auto tables = make_zone_tables(taken(received), 64);
    EXPECT_TRUE(std::holds_alternative<ZoneTables>(tables));
  }
}

TEST(ReceiveFile, TakesHolesAndExclusionsAway) {
  const Received holed =
      receive(geojson(closed(0, 0, 1, 1) + "," + closed(0.4, 0.4, 0.6, 0.6)), as_geojson);
  EXPECT_TRUE(is_in(taken(holed).within, 0.3, 0.5));
  EXPECT_FALSE(is_in(taken(holed).around, 0.5, 0.5));
  const std::string fence = plan(polygon(0, 0, 1, 1) + "," + polygon(0.4, 0.4, 2, 0.6, false));
  const Received kept = receive(fence, as_plan);
  EXPECT_TRUE(is_in(taken(kept).within, 0.3, 0.5));
  EXPECT_FALSE(is_in(taken(kept).around, 0.9, 0.5));
  const Received out = receive(fence, as_plan, FileAreas::exclusions);
  EXPECT_TRUE(is_in(taken(out).within, 1.5, 0.5));
  EXPECT_FALSE(is_in(taken(out).around, 0.3, 0.5));
}

// A parallel is bent on the map, and looks as if it enclosed something there.
TEST(ReceiveFile, RingsOnALineOfTheFileEncloseNothing) {
  const auto on_parallel = [](double x0, double x1, double x2) {
    return "[[" + corner(x0, 0.5, false) + "],[" + corner(x1, 0.5, false) + "],[" +
           corner(x2, 0.5, false) + "],[" + corner(x0, 0.5, false) + "]]";
  };
  EXPECT_EQ(refused(receive(geojson(on_parallel(0, 30, 60)), as_geojson)),
            "coordinates[0]: encloses no area");
  EXPECT_EQ(
      refused(receive(geojson(closed(0, 0, 1, 1) + "," + on_parallel(0.2, 0.4, 0.6)), as_geojson)),
      "coordinates[1]: encloses no area");
}

TEST(ReceiveFile, AsksWhatSeveralInclusionsMean) {
  const std::string fence = plan(polygon(0, 0, 1, 1) + "," + polygon(0.5, 0, 2, 1));
  EXPECT_EQ(refused(receive(fence, as_plan)),
            "the whole text: has 2 areas to stay in, and autopilots differ in what that means");
  const Received all = receive(fence, as_plan, FileAreas::all);
  EXPECT_TRUE(is_in(taken(all).within, 0.7, 0.5));
  EXPECT_FALSE(is_in(taken(all).around, 0.3, 0.5));
  EXPECT_FALSE(is_in(taken(all).around, 1.5, 0.5));
  const Received any = receive(fence, as_plan, FileAreas::any);
  EXPECT_TRUE(is_in(taken(any).within, 0.3, 0.5));
  EXPECT_TRUE(is_in(taken(any).within, 1.5, 0.5));
  EXPECT_EQ(refused(receive(plan(polygon(0, 0, 1, 1, false)), as_plan)),
            "the whole text: says where not to be, and not where to be");
  EXPECT_EQ(refused(receive(plan(polygon(0, 0, 1, 1)), as_plan, FileAreas::exclusions)),
            "the whole text: has no area to keep out of");
  EXPECT_EQ(refused(receive(plan(polygon(0, 0, 1, 1) + "," + polygon(3, 3, 4, 4)), as_plan,
                            FileAreas::all)),
            "the zone: is empty, or nowhere wider than its places are exact");
  EXPECT_NE(refused(receive(kml(), as_kml, FileAreas::any)), "taken");
}

// Needles 60 cm wide: what moves them is the error of the map. Minutes would not be bounded time.
TEST(ReceiveFile, RefusesSharpOutlinesThatTakeMinutes) {
  const std::string text =
      R"({"type":"Polygon","coordinates":[[)" + rtac::test::needles_in_degrees() + "]]}";
  EXPECT_NE(refused(receive(text, as_geojson, FileAreas::unstated, 30'000))
                .find("the zone: has corners so sharp"),
            std::string::npos);
}

// A circle is a polygon within it, and another one around it; of an exclusion the other way round.
TEST(ReceiveFile, HasCirclesOnTheirSafeSides) {
  const std::string circle =
      R"("circle":{"center":[)" + corner(0.5, 0.5, true) + R"(],"radius":20})";
  const Received inside = receive(plan("", item(circle, true)), as_plan, FileAreas::unstated, 600);
  const double disc = 3.14159265358979 * 20 * 20;
  EXPECT_LT(taken(inside).within.area().get_d(), disc);
  EXPECT_GT(taken(inside).around.area().get_d(), disc);
  EXPECT_LT(taken(inside).around.area().get_d(), disc + 3);
  const Received outside =
      receive(plan(polygon(0, 0, 1, 1), item(circle, false)), as_plan, FileAreas::unstated, 600);
  const Received plain = receive(plan(polygon(0, 0, 1, 1)), as_plan);
  EXPECT_LT(taken(outside).within.area().get_d(), taken(plain).within.area().get_d() - disc);
  EXPECT_GT(taken(outside).around.area().get_d(), taken(plain).around.area().get_d() - disc);
  EXPECT_NE(refused(receive(plan("", item(circle, true)), as_plan)).find("64 are the most"),
            std::string::npos);
}

// What limits an area is never left out.
TEST(ReceiveFile, RefusesLimitsOfHeightAndOfTime) {
  const std::string high = kml("<extrude>1</extrude><altitudeMode>relativeToGround</altitudeMode>");
  EXPECT_NE(refused(receive(high, as_kml)).find("applies between certain heights only"),
            std::string::npos);
  EXPECT_NE(refused(receive(kml("<altitudeMode>absolute</altitudeMode>"), as_kml)), "taken");
  EXPECT_EQ(refused(receive(R"({"type":"Feature","properties":{"ceiling":9},"geometry":)" +
                                geojson(closed(0, 0, 1, 1)) + "}",
                            as_geojson)),
            "properties.ceiling: sounds like a limit of height");
  EXPECT_EQ(
      refused(receive(R"({"type":"Feature","properties":{"expires":"2024-05-01"},"geometry":)" +
                          geojson(closed(0, 0, 1, 1)) + "}",
                      as_geojson)),
      "properties.expires: sounds like a limit of time");
  const std::string aviation =
      R"({"type":"Feature","zoneAuthority":[],"properties":{},"geometry":)" +
      geojson(closed(0, 0, 1, 1)) + "}";
  EXPECT_EQ(refused(receive(aviation, as_geojson)),
            "the whole text: is ED-318, and was received as GeoJSON");
}

TEST(ReceiveFile, RefusesOtherFormatsAndBrokenTexts) {
  EXPECT_EQ(refused(receive(kml(), as_geojson)),
            "the whole text: is KML, and was received as GeoJSON");
  EXPECT_EQ(refused(receive("POLYGON ((0 0, 1 0, 0 1, 0 0))", as_kml)),
            "the whole text: is well-known text, and was received as KML");
  EXPECT_NE(refused(receive("x", import::Format::ed269)).find("cannot be received as ED-269"),
            std::string::npos);
  const std::string whole = plan(polygon(0, 0, 1, 1));
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    EXPECT_NE(refused(receive(whole.substr(0, size), as_plan)), "taken");
  }
}

TEST(ReceiveFile, NamesThePlaceOfWhatIsWrong) {
  const std::string crossing = plan(item(
      R"("polygon":[[47.3977,8.5456],[47.3987,8.5466],[47.3977,8.5466],[47.3987,8.5456]])", true));
  EXPECT_NE(refused(receive(crossing, as_plan))
                .find("polygons[0].polygon, vertex 1: starts an edge "
                      "that meets the one from vertex 3"),
            std::string::npos)
      << refused(receive(crossing, as_plan));
  const std::string swapped =
      plan(item(R"("polygon":[[8.5456,47.3977],[8.5466,47.3977],[8.5466,47.3987]])", true));
  EXPECT_NE(refused(receive(swapped, as_plan)).find("longitude and latitude swapped"),
            std::string::npos)
      << refused(receive(swapped, as_plan));
  EXPECT_NE(refused(receive(geojson("[[0,0],[1,0],[1,1],[0,0]]"), as_geojson))
                .find("vertex 1: is too far from the origin"),
            std::string::npos);
  EXPECT_NE(refused(receive(geojson("[[0,0],[1,0],[1,91],[0,0]]"), as_geojson)), "taken");
}

// A parallel is no straight line on the map: what touches it in the file touches it there as well.
TEST(ReceiveFile, MeetsWhereTheFileMeets) {
  const auto at = [](double x, double y) { return "[" + corner(x, y, false) + "]"; };
  const std::string hole =
      "[" + at(0.5, 0) + "," + at(1, 1) + "," + at(1.5, 1) + "," + at(0.5, 0) + "]";
  EXPECT_EQ(refused(receive(geojson(closed(0, 0, 2, 2) + "," + hole), as_geojson)), "taken");
  const std::string two = R"({"type":"MultiPolygon","coordinates":[[)" + closed(0, 1, 2, 2) +
                          "],[" + closed(0.5, 0, 1.5, 1) + "]]}";
  EXPECT_EQ(taken(receive(two, as_geojson)).within.polygons().size(), 1U);
}

TEST(ReceiveFile, HasAnOriginOnTheGlobe) {
  const std::string fence = geojson(closed(0, 0, 1, 1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Origin& origin : {Origin{nan, 8}, {47, nan}, {89.5, 8}, {47, 181}}) {
    EXPECT_EQ(refused(receive_file(fence, {as_geojson, origin}, 64)),
              "the origin: is no place that a map can have");
  }
  EXPECT_NE(refused(receive_file(fence, {as_geojson, {8.5456, 47.3977}}, 64))
                .find("longitude and latitude swapped"),
            std::string::npos);
}

// Bounds come before anything is computed.
TEST(ReceiveFile, RefusesWhatIsTooMuch) {
  const std::string fence = geojson(closed(0, 0, 1, 1));
  EXPECT_EQ(refused(receive(fence, as_geojson, FileAreas::unstated, 4)), "taken");
  EXPECT_EQ(refused(receive(fence, as_geojson, FileAreas::unstated, 3)),
            "the zone: has 4 vertices, 3 are the most");
  EXPECT_NE(refused(receive(std::string(70'000, ' ') + fence, as_geojson, FileAreas::unstated, 4))
                .find("bytes; at most"),
            std::string::npos);
  EXPECT_NE(refused(receive(std::string(5000, '['), as_geojson, FileAreas::unstated, 4)), "taken");
  // An edge of 50 km along a parallel is bent on the map.
  EXPECT_NE(refused(receive(geojson("[[8.2,47.4],[8.9,47.4],[8.9,47.5],[8.2,47.4]]"), as_geojson))
                .find("points on the map, 64 are the most"),
            std::string::npos);
}

}  // namespace
}  // namespace rtac::geometry
