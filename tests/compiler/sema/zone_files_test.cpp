// Zones of files: what the author and the file say together, and what is missing.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

namespace fs = std::filesystem;
using diag::Code;

// A square of about 150 m, 100 m east of the origin of the tests.
std::string square(const std::string& name, double east_deg = 0) {
  const auto at = [&](double longitude, const char* latitude) {
    return "[" + std::to_string(longitude + east_deg) + "," + latitude + "]";
  };
  const std::string first = at(8.547, "47.397");
  return R"({"type":"Feature","properties":{"name":")" + name +
         R"("},"geometry":{"type":"Polygon","coordinates":[[)" + first + "," + at(8.549, "47.397") +
         "," + at(8.549, "47.3983") + "," + at(8.547, "47.3983") + "," + first + "]]}}";
}
std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

class ZoneFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) /
              ("rtac_zones_" + std::string(info->name()) + "_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    write("city.geojson", collection(square("park") + "," + square("hospital", 0.01)));
    write("hall.wkt", "POLYGON ((0 0, 20 0, 20 10, 0 10, 0 0), (5 2, 5 3, 6 3, 6 2, 5 2))");
    write("degrees.wkt", "POLYGON ((47.397 8.547, 47.397 8.549, 47.398 8.549, 47.397 8.547))");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  // The plan of an autopilot: polygons and circles, each `in` or out.
  void write_plan(const std::vector<bool>& polygons, const std::vector<bool>& circles) const {
    const auto item = [](const std::string& shape, bool in) {
      return "{" + shape + R"(,"inclusion":)" + (in ? "true" : "false") + R"(,"version":1})";
    };
    std::string all, round;
    for (const bool in : polygons) {
      all += (all.empty() ? "" : ",") +
             item(R"("polygon":[[47.397,8.544],[47.397,8.547],[47.399,8.547],[47.399,8.544]])", in);
    }
    for (const bool in : circles) {
      round += (round.empty() ? "" : ",") +
               item(R"("circle":{"center":[47.398,8.5456],"radius":30})", in);
    }
    write("m.plan", R"({"fileType":"Plan","version":1,"geoFence":{"version":2,"circles":[)" +
                        round + R"(],"polygons":[)" + all +
                        R"(]},"mission":{"items":[],"version":2}})");
  }
  [[nodiscard]] std::unique_ptr<Checked> check(const std::string& items) const {
    Checked start;
    const FileId root = start.sources.add((folder_ / "s.rta").string(), "spec s;\n" + items);
    return check_file(std::move(start), root);
  }
  static constexpr const char* origin = "origin 47.3977 deg, 8.5456 deg;\n";

  // One error of that code, at that text, that says this.
  void expect(const std::string& items, Code code, const std::string& place,
              const std::string& says, const std::string& helps) const {
    const auto checked = check(items);
    SCOPED_TRACE(items + checked->reports());
    ASSERT_EQ(checked->engine.all().size(), 1U);
    const diag::Diagnostic& found = checked->engine.all().front();
    EXPECT_EQ(found.code, code);
    EXPECT_EQ(checked->sources.text(*found.range), place);
    EXPECT_NE(found.message.find(says), std::string::npos);
    EXPECT_NE(found.help.find(helps), std::string::npos);
    EXPECT_FALSE(checked->spec);
  }
  [[nodiscard]] ZoneImport imported(const std::string& items) const {
    const auto checked = check(items);
    EXPECT_TRUE(checked->spec) << checked->reports();
    if (!checked->spec) return {};
    auto* found = std::get_if<ZoneImport>(&checked->spec->zones.back().value->node);
    EXPECT_NE(found, nullptr);
    return found != nullptr ? std::move(*found) : ZoneImport{};
  }

  fs::path folder_;
};

TEST_F(ZoneFiles, AllAreasOfAFileAreItsZone) {
  const ZoneImport zone = imported(std::string(origin) + "zone z = import \"city.geojson\";");
  EXPECT_EQ(zone.path, "city.geojson");
  ASSERT_EQ(zone.inclusions.size(), 2U);  // inside any of them
  EXPECT_EQ(zone.vertices, 8U);
  EXPECT_TRUE(zone.degrees);
  EXPECT_GT(zone.error, 0);
  EXPECT_LT(zone.error, Rational(2, 1000));
  const auto& park = std::get<ZonePolygon>(zone.inclusions[0][0].parts[0]);
  EXPECT_EQ(floor_to_int(park.outer.points[0].x), 105);  // 0.0014 deg to the east
  EXPECT_EQ(floor_to_int(park.outer.points[0].y), -78);  // 0.0007 deg to the south
  ASSERT_TRUE(park.outer.in_file);
  EXPECT_NE(park.outer.in_file->where.find("city.geojson: features[0]"), std::string::npos);
}

TEST_F(ZoneFiles, AFeatureIsOneAreaOfIt) {
  const ZoneImport zone =
      imported(std::string(origin) + "zone z = import \"city.geojson\" feature \"hospital\";");
  ASSERT_EQ(zone.inclusions.size(), 1U);
  EXPECT_EQ(zone.vertices, 4U);
}

TEST_F(ZoneFiles, MetresAreTakenAsTheyAre) {
  const ZoneImport zone = imported("zone z = import \"hall.wkt\" in m;");
  const auto& hall = std::get<ZonePolygon>(zone.inclusions[0][0].parts[0]);
  EXPECT_EQ(hall.outer.points[1].x, 20);
  EXPECT_EQ(hall.holes.size(), 1U);
  EXPECT_EQ(zone.error, 0);
  EXPECT_FALSE(zone.degrees);
}

// What is in metres may be in any frame; degrees are of the map.
TEST_F(ZoneFiles, OnlyMetresAreInOtherFrames) {
  EXPECT_TRUE(check("frame base;\nzone z @ base = import \"hall.wkt\" in m;")->spec);
  expect(std::string(origin) + "frame base;\nzone z @ base = import \"city.geojson\";",
         Code::frames_differ, "\"city.geojson\"", "a file in degrees", "");
}

TEST_F(ZoneFiles, AxesAreTakenAsTheyAreSaid) {
  const ZoneImport zone = imported(
      std::string(origin) + "zone z = import \"degrees.wkt\" in deg axes latitude longitude;");
  const auto& polygon = std::get<ZonePolygon>(zone.inclusions[0][0].parts[0]);
  EXPECT_EQ(floor_to_int(polygon.outer.points[0].x), 105);
}

TEST_F(ZoneFiles, OfAPlanTheExclusionsAreTakenAway) {
  write_plan({true}, {false});
  const ZoneImport zone = imported(std::string(origin) + "zone z = import \"m.plan\";");
  EXPECT_EQ(zone.inclusions.size(), 1U);
  ASSERT_EQ(zone.exclusions.size(), 1U);
  EXPECT_EQ(std::get<ZoneCircle>(zone.exclusions[0].parts[0]).radius, 30);
}

TEST_F(ZoneFiles, SeveralInclusionsAreAllOrAny) {
  write_plan({true, true}, {});
  const std::string zone = std::string(origin) + "zone z = import \"m.plan\"";
  EXPECT_EQ(imported(zone + " inclusions any;").inclusions.size(), 2U);
  const ZoneImport all = imported(zone + " inclusions all;");
  ASSERT_EQ(all.inclusions.size(), 1U);
  EXPECT_EQ(all.inclusions[0].size(), 2U);
  expect(zone + ";", Code::import_ambiguous, "\"m.plan\"", "has 2 inclusions", "`inclusions all`");
  expect(zone + " inclusions some;", Code::unknown_word, "some", "", "");
}

TEST_F(ZoneFiles, ExclusionsAloneAreAZoneWhenThatIsSaid) {
  write_plan({false}, {false});
  const std::string zone = std::string(origin) + "zone z = import \"m.plan\"";
  const ZoneImport out = imported(zone + " exclusions;");
  EXPECT_EQ(out.inclusions.size(), 2U);
  EXPECT_TRUE(out.exclusions.empty());
  expect(zone + ";", Code::import_ambiguous, "\"m.plan\"", "where not to be", "exclusions");
}

// Zones of unmanned aviation have bands, schedules and restrictions: each is asked about.
TEST_F(ZoneFiles, OfAviationAskAboutHeightsTimesAndPermissions) {
  const auto zone = [](const std::string& name, const std::string& restriction,
                       const std::string& applies, const std::string& circle) {
    return R"({"identifier":")" + name + R"(","country":"CHE","name":")" + name +
           R"(","type":"COMMON","restriction":")" + restriction +
           R"(","reason":["SENSITIVE"],"applicability":[)" + applies +
           R"(],"zoneAuthority":[],"geometry":[{"uomDimensions":"M","lowerLimit":0,)"
           R"("lowerVerticalReference":"AGL","upperLimit":120,"upperVerticalReference":"AGL",)"
           R"("horizontalProjection":{"type":"Circle","center":)" +
           circle + R"(,"radius":300}}]})";
  };
  const std::string always = R"({"permanent":"YES"})";
  const std::string daily =
      R"({"permanent":"NO","schedule":[{"day":["MON"],"startTime":"08:00:00Z",)"
      R"("endTime":"12:00:00Z"}]})";
  write("uas.json", R"({"title":"t","features":[)" +
                        zone("JAIL", "PROHIBITED", always, "[8.546,47.398]") + "," +
                        zone("SCHOOL", "REQ_AUTHORISATION", daily, "[8.55,47.398]") + "]}");
  const std::string zones = std::string(origin) + "zone z = import \"uas.json\" ";
  expect(zones + ";", Code::import_ambiguous, "\"uas.json\"", "where not to be", "exclusions");
  expect(zones + "exclusions;", Code::import_ambiguous, "\"uas.json\"", "between certain heights",
         "flat \"why\"");
  expect(zones + "exclusions flat \"all heights\";", Code::import_ambiguous, "\"uas.json\"",
         "at certain times", "timeless \"why\"");
  const ZoneImport all =
      imported(zones + "exclusions flat \"all heights\" timeless \"at any time\";");
  EXPECT_EQ(all.inclusions.size(), 2U);
  ASSERT_GE(all.remarks.size(), 3U);
  const auto end = all.remarks.end();
  EXPECT_EQ(*(end - 3), "SCHOOL, REQ_AUTHORISATION, counts as an exclusion");
  EXPECT_EQ(*(end - 2), "flat: all heights");
  EXPECT_EQ(*(end - 1), "timeless: at any time");
  EXPECT_EQ(imported(zones + "feature \"JAIL\" exclusions flat \"all\";").inclusions.size(), 1U);
}

// Heights that plain GeoJSON does not have: the author says that the area counts for all of them.
TEST_F(ZoneFiles, HeightsThatNobodyCanReadAreAskedFor) {
  write("tall.geojson",
        R"({"type":"Feature","properties":{"upperLimit":120},"geometry":{"type":"Polygon",)"
        R"("coordinates":[[[8.545,47.397],[8.547,47.397],[8.547,47.399],[8.545,47.397]]]}})");
  const std::string zone = std::string(origin) + "zone z = import \"tall.geojson\" ";
  expect(zone + ";", Code::import_ambiguous, "\"tall.geojson\"",
         "properties.upperLimit sounds like a limit of height", "flat \"why\"");
  expect(zone + "heights agl at 0 m;", Code::import_ambiguous, "\"tall.geojson\"",
         "properties.upperLimit sounds like a limit of height", "flat \"why\"");
  EXPECT_EQ(imported(zone + "flat \"one level\";").remarks.back(), "flat: one level");
}

// Times that plain GeoJSON does not have: the author says that the area counts at all of them.
TEST_F(ZoneFiles, TimesThatNobodyCanReadAreAskedFor) {
  write("timed.geojson",
        R"({"type":"Feature","properties":{"valid_until":"2024-05-01"},"geometry":{"type":)"
        R"("Polygon","coordinates":[[[8.545,47.397],[8.547,47.397],[8.547,47.399],)"
        R"([8.545,47.397]]]}})");
  const std::string zone = std::string(origin) + "zone z = import \"timed.geojson\" ";
  expect(zone + ";", Code::import_ambiguous, "\"timed.geojson\"",
         "properties.valid_until sounds like a limit of time", "timeless \"why\"");
  // no schedule that could be taken, whatever else is written
  expect(zone + "scheduled;", Code::import_ambiguous, "\"timed.geojson\"",
         "properties.valid_until sounds like a limit of time", "timeless \"why\"");
  expect(zone + "scheduled timeless \"ever\";", Code::clause_without_effect, "scheduled",
         "no schedule", "leave it out");
  EXPECT_EQ(imported(zone + "timeless \"until further notice\";").remarks.back(),
            "timeless: until further notice");
}

// Heights count from where the author says that their references lie; nothing else is known of
// them.
TEST_F(ZoneFiles, HeightsCountFromTheLevelsOfTheirReferences) {
  const auto volume = [](const std::string& lower, const std::string& upper) {
    return R"({"uomDimensions":"M",)" + lower + "," + upper +
           R"(,"horizontalProjection":{"type":"Circle","center":[8.546,47.398],"radius":300}})";
  };
  const auto file = [&](const std::string& volumes) {
    write("uas.json",
          R"({"title":"t","features":[{"identifier":"JAIL","country":"CHE","type":"COMMON",)"
          R"("restriction":"PROHIBITED","zoneAuthority":[],"applicability":[{"permanent":"YES"}],)"
          R"("geometry":[)" +
              volumes + "]}]}");
  };
  const std::string ground = R"("lowerLimit":10.5,"lowerVerticalReference":"AGL")";
  const std::string sea = R"("upperLimit":500,"upperVerticalReference":"AMSL")";
  const std::string zones = std::string(origin) + "zone z = import \"uas.json\" exclusions ";
  file(volume(ground, sea));
  const ZoneImport both = imported(zones + "heights agl at -1.5 m heights amsl at -432 m;");
  ASSERT_EQ(both.inclusions.at(0).at(0).bands.size(), 1U);
  EXPECT_EQ(both.inclusions[0][0].bands[0].floor, Rational(9));
  EXPECT_EQ(both.inclusions[0][0].bands[0].ceiling, Rational(68));
  EXPECT_EQ(both.remarks.back(), "heights agl count from z = -1.5 m");

  expect(zones + "heights agl at 0 m;", Code::import_ambiguous, "\"uas.json\"",
         "limits of height from amsl", "`heights amsl at 0 m`");
  expect(zones + "heights agl at 0 m heights amsl at 0 m heights wgs84 at 1 m;",
         Code::clause_without_effect, "heights wgs84 at 1 m", "no area", "leave it out");
  expect(zones + "flat \"all\" heights agl at 0 m heights amsl at 0 m;",
         Code::clause_without_effect, "flat \"all\"", "`heights` says", "leave out");
  expect(zones + "heights sea at 0 m;", Code::unknown_word, "sea", "reference of heights", "agl");
  expect(zones + "heights agl at 0 s;", Code::wrong_dimension, "0 s", "a length", "in m");
  expect(zones + "heights agl at 0 m heights agl at 1 m;", Code::duplicate_clause,
         "heights agl at 1 m", "", "");
  expect(zones + "heights agl at 0 m heights amsl at -490 m;", Code::band_inverted, "\"uas.json\"",
         "the floor is at 10.5 m of the map, the ceiling at 10 m", "different references");
  file(volume(ground, R"("upperLimit":10.5,"upperVerticalReference":"AGL")"));
  expect(zones + "heights agl at 0 m;", Code::band_inverted, "\"uas.json\"",
         "the floor is at 10.5 m of the map, the ceiling at 10.5 m",
         "its lower and its upper limit are the same");
}

// A way from vertex to vertex that a format does not describe is covered by the error, one that is
// straight in degrees is divided.
TEST_F(ZoneFiles, EdgesThatMayRunEitherWayWidenTheError) {
  const std::string positions = "[47.39,8.52],[47.39,8.57],[47.41,8.57],[47.41,8.52]";
  write("m.plan", R"({"fileType":"Plan","version":1,"geoFence":{"version":2,"circles":[],)"
                  R"("polygons":[{"inclusion":true,"version":1,"polygon":[)" +
                      positions + R"(]}]},"mission":{"items":[],"version":2}})");
  write("g.geojson", R"({"type":"Polygon","coordinates":[[[8.52,47.39],[8.57,47.39],[8.57,47.41],)"
                     R"([8.52,47.41],[8.52,47.39]]]})");
  const ZoneImport plan = imported(std::string(origin) + "zone z = import \"m.plan\";");
  const ZoneImport straight = imported(std::string(origin) + "zone z = import \"g.geojson\";");
  EXPECT_EQ(plan.points, 4U);
  EXPECT_GT(plan.error, Rational(3, 10));
  EXPECT_GT(straight.points, 40U);
  EXPECT_LT(straight.error, Rational(3, 1000));
}

TEST_F(ZoneFiles, MoreThan250000VerticesAreTooMany) {
  const auto ring = [](int count) {
    std::string text;
    for (int i = 1; i < count; ++i) text += std::to_string(i) + " 0,";
    return "POLYGON((0 9," + text + "0 9))";
  };
  write("a.wkt", ring(250'000));
  EXPECT_EQ(imported("zone z = import \"a.wkt\" in m;").points, 250'000U);
  write("a.wkt", ring(250'001));
  expect("zone z = import \"a.wkt\" in m;", Code::too_many_vertices, "\"a.wkt\"",
         "a.wkt`, line 1, column 9, vertex 1 (0, 9) makes it more than 250000 vertices",
         "simplify the outlines");
}

TEST_F(ZoneFiles, MetresThatLookLikeDegreesAreSuspicious) {
  const auto checked = check(std::string(origin) + "zone z = import \"degrees.wkt\" in m;");
  ASSERT_EQ(checked->engine.all().size(), 1U) << checked->reports();
  EXPECT_EQ(checked->engine.all().front().code, Code::unit_suspicious);
  EXPECT_TRUE(checked->spec);
  const auto hall = check(std::string(origin) + "zone z = import \"hall.wkt\" in m;");
  EXPECT_TRUE(hall->engine.all().empty());
}

TEST_F(ZoneFiles, WhatHasNoEffectIsRefused) {
  const std::string city = std::string(origin) + "zone z = import \"city.geojson\" ";
  expect(city + "in m;", Code::clause_without_effect, "in m", "is in degrees", "leave it out");
  expect(city + "inclusions all;", Code::clause_without_effect, "inclusions all",
         "has no inclusions", "leave it out");
  expect(city + "exclusions;", Code::clause_without_effect, "exclusions", "has no exclusions",
         "all of its areas");
  expect(city + "flat \"one floor\";", Code::clause_without_effect, "flat \"one floor\"",
         "limits of height", "leave it out");
  expect(city + "timeless \"open\";", Code::clause_without_effect, "timeless \"open\"",
         "has a schedule", "leave it out");
  expect("zone z = import \"hall.wkt\" in m axes latitude longitude;", Code::clause_without_effect,
         "axes latitude longitude", "east and north", "leave it out");
}

TEST_F(ZoneFiles, WhatIsLeftOpenIsAskedFor) {
  expect("zone z = import \"hall.wkt\";", Code::import_ambiguous, "\"hall.wkt\"",
         "metres or degrees", "in m");
  expect(std::string(origin) + "zone z = import \"degrees.wkt\" in deg;", Code::import_ambiguous,
         "\"degrees.wkt\"", "which of its axes is the latitude", "axes latitude longitude");
  expect(std::string(origin) + "zone z = import \"degrees.wkt\" in deg axes latitude latitude;",
         Code::import_ambiguous, "axes latitude latitude", "both axes", "axes longitude latitude");
  expect("zone z = import \"city.geojson\";", Code::origin_missing, "\"city.geojson\"",
         "has no origin", "origin 47.3977 deg");
}

TEST_F(ZoneFiles, WordsThatAreNotKnownAreReported) {
  expect("zone z = import \"hall.wkt\" in ft;", Code::unknown_word, "ft", "ft", "");
  expect(std::string(origin) + "zone z = import \"degrees.wkt\" in deg axes lat longitude;",
         Code::unknown_word, "lat", "lat", "latitude");
  expect("zone z = import \"hall.wkt\" in m in m;", Code::duplicate_clause, "in m", "`in`", "");
  expect(std::string(origin) + "zone z = import \"city.geojson\" feature \"hospitl\";",
         Code::unknown_feature, "\"hospitl\"", "has no feature `hospitl`", "hospital");
  // Areas without a name are not meant by an empty one.
  write_plan({true}, {false});
  expect(std::string(origin) + "zone z = import \"m.plan\" feature \"\";", Code::unknown_feature,
         "\"\"", "has no feature ``", "leave `feature` out");
}

TEST_F(ZoneFiles, SwappedAxesAreSuspected) {
  const auto swapped = [&](const std::string& origin_is, const std::string& axes,
                           const std::string& mend) {
    expect("origin " + origin_is + ";\nzone z = import \"city.geojson\"" + axes + ";",
           Code::zone_far_away, "\"city.geojson\"", "vertex 1 (", mend);
  };
  swapped("8.5456 deg, 47.3977 deg", "", "axes latitude longitude");
  swapped("47.3977 deg, 8.5456 deg", " axes latitude longitude", "axes longitude latitude");
  swapped("47.3977 deg, 11 deg", "", "within 100 km");
}

// Plans and fence items have the latitude first: to say so changes nothing, and only the other
// order turns them.
TEST_F(ZoneFiles, AxesAreThoseOfTheFileWhateverItsFormatHas) {
  const auto first = [&](const std::string& file, const std::string& axes) {
    const ZoneImport zone =
        imported(std::string(origin) + "zone z = import \"" + file + "\"" + axes + ";");
    if (zone.inclusions.empty()) return std::string("none");
    const auto& ring = std::get<ZonePolygon>(zone.inclusions[0][0].parts[0]).outer;
    return to_decimal(ring.points[0].x) + " " + to_decimal(ring.points[0].y);
  };
  const auto fence = [&](const std::string& name, const char* vertices) {
    write(name + ".plan",
          R"({"fileType":"Plan","version":1,"geoFence":{"version":2,"circles":[],"polygons":[)"
          R"({"inclusion":true,"version":1,"polygon":)" +
              std::string(vertices) + "}]}}");
  };
  fence("north", "[[47.397,8.544],[47.397,8.547],[47.399,8.547]]");
  fence("east", "[[8.544,47.397],[8.547,47.397],[8.547,47.399]]");
  const std::string item = "\t0\t0\t5001\t3\t0\t0\t0\t";
  write("north.waypoints", "QGC WPL 110\n0" + item + "47.397\t8.544\t0\t1\n1" + item +
                               "47.397\t8.547\t0\t1\n2" + item + "47.399\t8.547\t0\t1\n");
  const std::string place = first("north.plan", "");
  EXPECT_EQ(first("north.plan", " axes latitude longitude"), place);
  EXPECT_EQ(first("east.plan", " axes longitude latitude"), place);
  EXPECT_EQ(first("north.waypoints", ""), place);
  EXPECT_EQ(first("north.waypoints", " axes latitude longitude"), place);
  const auto swapped = [&](const std::string& import, const std::string& mend) {
    expect(std::string(origin) + "zone z = import " + import + ";", Code::zone_far_away,
           import.substr(0, import.find(' ')), "vertex 1 (", mend);
  };
  swapped("\"east.plan\"", "write `axes longitude latitude` behind it");
  swapped("\"north.plan\" axes longitude latitude",
          "write `axes latitude longitude` in the place of `axes longitude");
}

// Where the longitude is more than 90 degrees, the wrong order is off the globe.
TEST_F(ZoneFiles, AxesCountBeforeAFileIsOffTheGlobe) {
  write("tokyo.geojson",
        R"({"type":"Polygon","coordinates":[[[35.6,139.7],[35.6,139.71],[35.61,139.7],)"
        R"([35.6,139.7]]]})");
  const std::string tokyo = "origin 35.6 deg, 139.7 deg;\nzone z = import \"tokyo.geojson\"";
  expect(tokyo + ";", Code::zone_file_unusable, "\"tokyo.geojson\"", "is off the globe",
         "or `axes latitude longitude` behind it");
  expect(tokyo + " axes longitude latitude;", Code::zone_file_unusable, "\"tokyo.geojson\"",
         "is off the globe", "or `axes latitude longitude` behind it");
  const ZoneImport zone = imported(tokyo + " axes latitude longitude;");
  ASSERT_EQ(zone.inclusions.size(), 1U);
  const auto& ring = std::get<ZonePolygon>(zone.inclusions[0][0].parts[0]).outer;
  EXPECT_EQ(ring.points[0].x, 0);
  EXPECT_EQ(ring.points[0].y, 0);
  EXPECT_GT(ring.points[1].x, 100);  // on the edge of 0.01 deg to the east
  EXPECT_LT(abs(ring.points[1].y), 1);
}

// A hole that touches a parallel, which is no straight line on the map.
TEST_F(ZoneFiles, RingsThatTouchInDegreesTouchOnTheMap) {
  write("touch.geojson",
        R"({"type":"Polygon","coordinates":[[[8.54,47.39],[8.55,47.39],[8.55,47.4],[8.54,47.4],)"
        R"([8.54,47.39]],[[8.5443,47.39],[8.545,47.395],[8.546,47.393],[8.5443,47.39]]]})");
  const ZoneImport zone = imported(std::string(origin) + "zone z = import \"touch.geojson\";");
  ASSERT_EQ(zone.inclusions.size(), 1U);
  const auto& polygon = std::get<ZonePolygon>(zone.inclusions[0][0].parts[0]);
  const auto& touches = polygon.holes.at(0).points.at(0);
  std::size_t count = 0;
  for (const auto& point : polygon.outer.points) {
    count += point.x == touches.x && point.y == touches.y ? 1 : 0;
  }
  EXPECT_EQ(count, 1U);
}

// A parallel is bent on the map, and would enclose something there: 4026 or 4007 instead.
TEST_F(ZoneFiles, RingsOnALineOfTheFileEncloseNothing) {
  const auto flat = [&](const std::string& rings) {
    write("flat.geojson", R"({"type":"Polygon","coordinates":[)" + rings + "]}");
    return std::string(origin) + "zone z = import \"flat.geojson\";";
  };
  const std::string outline =
      "[[8.545,47.397],[8.547,47.397],[8.547,47.399],[8.545,47.399],[8.545,47.397]]";
  expect(flat("[[8.548,47.397],[8.549,47.397],[8.550,47.397],[8.548,47.397]]"),
         Code::ring_has_no_area, "\"flat.geojson\"", "coordinates[0] encloses no area", "move");
  expect(flat(outline + ",[[8.5452,47.398],[8.5455,47.398],[8.546,47.398],[8.5452,47.398]]"),
         Code::ring_has_no_area, "\"flat.geojson\"", "coordinates[1] encloses no area", "move");
  write("flat.kml",
        "<kml><Placemark><Polygon><outerBoundaryIs><LinearRing><coordinates>8.548,47.397 "
        "8.549,47.398 8.550,47.399 8.548,47.397</coordinates></LinearRing>"
        "</outerBoundaryIs></Polygon></Placemark></kml>");
  expect(std::string(origin) + "zone z = import \"flat.kml\";", Code::ring_has_no_area,
         "\"flat.kml\"", "line 1, column ", "move");
}

TEST_F(ZoneFiles, AtThePolesNothingHasAPlace) {
  write("pole.geojson",
        R"({"type":"Polygon","coordinates":[[[10,88.9],[10.2,88.9],[10.2,89.01],[10,88.9]]]})");
  expect("origin 88.9 deg, 10 deg;\nzone z = import \"pole.geojson\";", Code::no_place_on_map,
         "\"pole.geojson\"", "vertex 3 (10.2, 89.01) is too near to a pole", "up to 89 deg");
}

TEST_F(ZoneFiles, RingsThatGoTheOtherWayRoundAreNoted) {
  write("turned.geojson",
        R"({"type":"Polygon","coordinates":[[[8.547,47.397],[8.547,47.398],[8.549,47.398],)"
        R"([8.547,47.397]]]})");
  const auto checked = check(std::string(origin) + "zone z = import \"turned.geojson\";");
  ASSERT_TRUE(checked->spec) << checked->reports();
  ASSERT_EQ(checked->engine.all().size(), 1U);
  EXPECT_EQ(checked->engine.all().front().code, Code::ring_turned);
  write("turned.geojson",
        R"({"type":"Polygon","coordinates":[[[8.547,47.397],[8.547,47.398],[8.549,47.398],)"
        R"([8.547,47.397]],[[8.5472,47.3975],[8.5475,47.3976],[8.5474,47.3978],)"
        R"([8.5472,47.3975]]]})");
  const auto both = check(std::string(origin) + "zone z = import \"turned.geojson\";");
  ASSERT_EQ(both->engine.all().size(), 1U) << both->reports();
  EXPECT_NE(both->engine.all().front().message.find("coordinates[0] and 1 more ring go the other"),
            std::string::npos)
      << both->reports();
}

TEST_F(ZoneFiles, UnusableFilesAreReportedWithThePlace) {
  write("cut.geojson", R"({"type":"Polygon","coordinates":[[[8.5,47)");
  expect(std::string(origin) + "zone z = import \"cut.geojson\";", Code::zone_file_unusable,
         "\"cut.geojson\"", "cut.geojson`", "");
  write("line.geojson", R"({"type":"LineString","coordinates":[[8.5,47],[8.6,47]]})");
  expect(std::string(origin) + "zone z = import \"line.geojson\";", Code::zone_file_unusable,
         "\"line.geojson\"", "line.geojson`", "");
  write("notes.txt", "buy milk");
  expect(std::string(origin) + "zone z = import \"notes.txt\";", Code::zone_file_unusable,
         "\"notes.txt\"", "the format", "GeoJSON");
}

TEST_F(ZoneFiles, TheOriginIsOneLatitudeAndOneLongitude) {
  expect("origin 47.3977 deg;", Code::wrong_argument_count, "origin 47.3977 deg;", "`origin` takes",
         "432 m");
  expect("origin 91 deg, 8 deg;", Code::quantity_out_of_range, "91 deg", "cannot be 91 deg",
         "the latitude comes first");
  expect("origin 47.3977, 8 deg;", Code::unit_missing, "47.3977", "", "");
  expect("origin 47 deg, 8 deg, 12 km;", Code::quantity_out_of_range, "12 km", "cannot be 12000 m",
         "-500 m to 10000 m");
  expect("origin 47 deg, 8 deg, -501 m;", Code::quantity_out_of_range, "-501 m", "cannot be -501 m",
         "-500 m to 10000 m");
  expect("origin 47 deg, 8 deg;\norigin 47 deg, 8 deg;", Code::duplicate_clause,
         "origin 47 deg, 8 deg;", "`origin`", "");
  const auto checked = check("origin 47.3977 deg, -8.5456 deg, 432 m;");
  ASSERT_TRUE(checked->spec && checked->spec->origin) << checked->reports();
  EXPECT_EQ(checked->spec->origin->altitude->value, 432);
}

// A faulty origin is one mistake, not one for each zone.
TEST_F(ZoneFiles, AreSilentAboutAFaultyOrigin) {
  expect("origin 47.3977 deg, 200 deg;\nzone z = import \"city.geojson\";",
         Code::quantity_out_of_range, "200 deg", "cannot be 200 deg", "");
}

}  // namespace
}  // namespace rtac::sema::test
