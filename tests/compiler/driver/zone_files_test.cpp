// Zones of files on the command line: dependencies, mistakes by their place in the file, what is
// derived, and that nothing depends on where the files lie.
#include <sstream>

#include "tests/compiler/driver/testing.h"
#include "tests/compiler/needles.h"
#include "tests/slow.h"

namespace rtac::driver::test {
namespace {

const char* const origin = "origin 47.3977 deg, 8.5456 deg;\n";

class ZoneFiles : public InFolder {
 protected:
  // GeoJSON of one polygon: rings of positions in degrees.
  static void write_polygon(const fs::path& path, const std::string& rings) {
    write(path, R"({"type":"Polygon","coordinates":[)" + rings + "]}");
  }
  static constexpr const char* square =
      "[[8.545,47.397],[8.547,47.397],[8.547,47.399],[8.545,47.399],[8.545,47.397]]";
  static constexpr const char* inner =
      "[[8.5455,47.3975],[8.5455,47.398],[8.546,47.398],[8.546,47.3975],[8.5455,47.3975]]";

  // A monitor of a point in that zone.
  static std::string spec(const std::string& zone, const std::string& items = origin) {
    return "spec s;\nperiod 1 s;\n" + items + "zone z = " + zone +
           ";\ninput p : point in -900 .. 900 m;\n"
           "monitor m { \"R1: in\" always p inside z; }\n";
  }
  static std::string said(const std::string& zone) {
    write("s.rta", spec(zone));
    const Outcome o = rtac({"check", "s.rta"});
    EXPECT_EQ(o.status, 1) << o.err;
    return o.err;
  }
  static void expect_said(const std::string& zone, const std::string& text) {
    const std::string all = said(zone);
    EXPECT_NE(all.find(text), std::string::npos) << all;
  }
};

TEST_F(ZoneFiles, AreInTheDependencyFile) {
  write_polygon("sites/a b.geojson", square);
  write("s.rta", spec("import \"sites/a b.geojson\" | import \"./sites/a b.geojson\""));
  const Outcome o = rtac({"build", "s.rta", "-o", "out", "--depfile", "out/d"});
  ASSERT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(read("out/d"), "out/s_kernel.h: \\\n  s.rta \\\n  sites/a\\ b.geojson\n");
}

// A parallel is no straight line on the map, and formats that do not say how an edge runs are no
// exception: a hole may touch it in a place, and share no part of it.
TEST_F(ZoneFiles, HolesTouchAParallelInEveryFormat) {
  const auto kml = [](const std::string& hole) {
    const auto ring = [](const char* sort, const std::string& positions) {
      return "<" + std::string(sort) + "><LinearRing><coordinates>" + positions +
             "</coordinates></LinearRing></" + sort + ">";
    };
    return "<kml><Placemark><Polygon>" +
           ring("outerBoundaryIs", "8.54,47.39 8.55,47.39 8.55,47.4 8.54,47.4 8.54,47.39") +
           ring("innerBoundaryIs", hole) + "</Polygon></Placemark></kml>";
  };
  write("s.rta", spec("import \"z.kml\""));
  for (const std::string latitude : {"47.39", "47.4"}) {
    const std::string at = "8.5443," + latitude;
    write("z.kml", kml(at + " 8.545,47.395 8.546,47.393 " + at));
    EXPECT_EQ(rtac({"check", "s.rta"}).err, "") << latitude;
    write("z.kml", kml(at + " 8.546," + latitude + " 8.545,47.395 " + at));
    const Outcome o = rtac({"check", "s.rta"});
    EXPECT_NE(o.err.find("error[4005]"), std::string::npos) << o.err;
  }
}

// The same files give the same text wherever they lie, and no path is in it.
TEST_F(ZoneFiles, GiveTheSameCodeEverywhere) {
  std::string first;
  for (const std::string folder : {"one", "another/place"}) {
    write_polygon(fs::path(folder) / "a.geojson", square);
    write(fs::path(folder) / "s.rta", spec("import \"a.geojson\""));
    const Outcome o = rtac({"build", (folder_ / folder / "s.rta").string(), "-o", folder + "/out"});
    ASSERT_EQ(o.status, 0) << o.err;
    std::string all;
    for (const char* file : {"s.cpp", "s.h", "s_kernel.c", "s_kernel.h", "s_manifest.json"}) {
      all += read(fs::path(folder) / "out" / file);
    }
    EXPECT_EQ(all.find(folder_.string()), std::string::npos);
    if (first.empty()) first = all;
    EXPECT_EQ(all, first);
  }
}

TEST_F(ZoneFiles, FaultsOfRingsAreNamedByTheirPlace) {
  write_polygon("a.geojson",
                "[[8.545,47.397],[8.547,47.399],[8.547,47.397],[8.545,47.399],"
                "[8.545,47.397]]");
  expect_said("import \"a.geojson\"",
              "error[4001]: vertex 1 (8.545, 47.397) of a.geojson: coordinates[0] starts an edge "
              "that meets "
              "the one from vertex 3 (8.547, 47.397) at (");
  // where edges are divided for the map: nothing that could be removed is there twice
  write_polygon("a.geojson",
                "[[8.5443,47.3968],[8.5469,47.3986],[8.5469,47.3968],[8.5443,47.3986],"
                "[8.5443,47.3968]]");
  expect_said("import \"a.geojson\"",
              "error[4001]: vertex 3 (8.5469, 47.3968) of a.geojson: coordinates[0] starts an edge "
              "that meets the one from vertex 1 (8.5443, 47.3968) at (");
  write_polygon("a.geojson",
                "[[8.545,47.397],[8.547,47.397],[8.547,47.397],[8.547,47.399],"
                "[8.545,47.397]]");
  expect_said("import \"a.geojson\"",
              "vertex 3 (8.547, 47.397) of a.geojson: coordinates[0] repeats vertex 2");
  write_polygon("a.geojson",
                std::string(square) + ",[[8.55,47.4],[8.55,47.401],[8.551,47.401],[8.55,47.4]]");
  expect_said(
      "import \"a.geojson\"",
      "error[4005]: a.geojson: coordinates[1] does not lie inside a.geojson: coordinates[0]");
  write_polygon("a.geojson", std::string(square) + "," + inner + "," + inner);
  expect_said("import \"a.geojson\"",
              "error[4006]: a.geojson: coordinates[1] overlaps a.geojson: coordinates[2] at (");
}

// 251 squares of 1,000 edges; each is sound by itself.
TEST_F(ZoneFiles, VerticesOfAllPartsCountTogether) {
  std::string squares;
  for (int k = 0; k < 251; ++k) {
    std::string outline;
    for (int i = 0; i < 1000; ++i) {
      const int at = i % 250, side = i / 250;
      const int x = side == 0 ? at : side == 1 ? 250 : side == 2 ? 250 - at : 0;
      const int y = side == 0 ? 0 : side == 1 ? at : side == 2 ? 250 : 250 - at;
      outline += std::to_string(x + 300 * k) + " " + std::to_string(y) + ",";
    }
    squares += "POLYGON((" + outline + std::to_string(300 * k) + " 0))\n";
  }
  write("a.wkt", squares);
  expect_said("import \"a.wkt\" in m", "error[4030]: `a.wkt`, line 251, column 9, vertex 1");
}

// Teeth 1 m wide and apart: grown or shrunk by 10 cm, corners become round.
TEST_F(ZoneFiles, OffsetsOfMoreThan20000VerticesAreRefused) {
  const auto comb = [](int teeth) {
    std::string text;
    for (int i = 0; i < teeth; ++i) {
      const std::string from = std::to_string(2 * i), to = std::to_string(2 * i + 1);
      text += from + " 0," + from + " 5," + to + " 5," + to + " 0,";
    }
    return "POLYGON((" + text + std::to_string(2 * teeth) + " -1,-1 -1," + "0 0))\n";
  };
  write("a.wkt", comb(5001));
  const std::string text = "error[4030]: the zone that is to be moved has 20006 vertices";
  expect_said("shrink(import \"a.wkt\" in m, 60 cm)", text);
  expect_said("grow(import \"a.wkt\" in m, 60 cm)", text);
  // all edges last
  write("s.rta", spec("shrink(import \"a.wkt\" in m, 10 cm)"));
  EXPECT_EQ(rtac({"check", "s.rta"}).status, 0);
}

// Needles 60 cm wide and 110 m long: what moves them is the error of the map, not the author.
TEST_F(ZoneFiles, OutlinesInDegreesAreMovedByTheErrorOfTheMap) {
  write_polygon("a.geojson", "[" + rtac::test::needles_in_degrees() + "]");
  expect_said("import \"a.geojson\"", "error[4030]: the areas of the file have 20059 ");
  expect_said("import \"a.geojson\"", "by the 2.701 mm that their places may be off");
}

// A circle of 10 km is a polygon of 256 edges: 977 of them have 250,112.
TEST_F(ZoneFiles, CirclesCountAsTheirPolygons) {
  const auto plan = [](int circles) {
    std::string text;
    for (int i = 0; i < circles; ++i) {
      text +=
          std::string(i == 0 ? "" : ",") +
          R"({"circle":{"center":[47.398,8.5456],"radius":10000},"inclusion":true,"version":1})";
    }
    write("a.plan", R"({"fileType":"Plan","version":1,"geoFence":{"version":2,"circles":[)" + text +
                        R"(],"polygons":[]},"mission":{"items":[],"version":2}})");
  };
  plan(977);
  expect_said("import \"a.plan\" inclusions any", "have 250112 vertices");
  plan(976);  // all the same
  write("s.rta", spec("import \"a.plan\" inclusions any"));
  EXPECT_EQ(rtac({"check", "s.rta"}).status, 0);
}

// Strips that cross one another `count` squared times, at four places each.
std::string crossing_strips(int count) {
  std::string text;
  const std::string end = std::to_string(2 * count + 1);
  for (int i = 0; i < count; ++i) {
    const std::string from = std::to_string(2 * i + 1), to = std::to_string(2 * i + 2);
    text += "POLYGON((0 " + from + "," + end + " " + from + "," + end + " " + to + ",0 " + to +
            ",0 " + from + "))\n";
    text += "POLYGON((" + from + " 0," + to + " 0," + to + " " + end + "," + from + " " + end +
            "," + from + " 0))\n";
  }
  return text;
}

TEST_F(ZoneFiles, CrossingTooOftenIsRefusedInBoundedTime) {
  write("a.wkt", crossing_strips(200));
  const std::string text = "error[4020]: boundaries cross one another at more than 30000 places";
  expect_said("import \"a.wkt\" in m", text);
  // Zones of two files that are simple by themselves.
  std::string level, upright;
  std::istringstream lines(crossing_strips(100));
  for (std::string line; std::getline(lines, line);) {
    level += line + "\n";
    if (std::getline(lines, line)) upright += line + "\n";
  }
  write("level.wkt", level);
  write("upright.wkt", upright);
  for (const std::string op : {" | ", " & ", " - "}) {
    expect_said("import \"level.wkt\" in m" + op + "import \"upright.wkt\" in m", text);
  }
}

TEST_F(ZoneFiles, ThinnerThanTheirErrorAreEmpty) {
  write_polygon("a.geojson", "[[8.545,47.397],[8.547,47.397],[8.547,47.39700001],[8.545,47.397]]");
  expect_said("import \"a.geojson\"", "error[4007]: zone `z` is empty");
}

TEST_F(ZoneFiles, ARingAroundTheFirstOneIsNoHole) {
  write_polygon("a.geojson", std::string(inner) + "," + square);
  expect_said("import \"a.geojson\"", "the outline comes first, around all holes");
}

TEST_F(ZoneFiles, TheHelpOfAMissingClockIsOneLine) {
  const std::string all = said("circle (1 m, 1 m) radius 1 m during 07:30 .. 16:00");
  EXPECT_NE(all.find("write `clock utc;`"), std::string::npos) << all;
  EXPECT_EQ(all.find("insert"), std::string::npos) << all;
}

TEST_F(ZoneFiles, WhyTheyAreEmptyIsSaid) {
  const auto circle = [](const char* latitude) {
    return std::string(R"({"inclusion":true,"version":1,"circle":{"center":[)") + latitude +
           R"(,8.5456],"radius":50}})";
  };
  write("a.plan", R"({"fileType":"Plan","version":1,"geoFence":{"version":2,"circles":[)" +
                      circle("47.3977") + "," + circle("47.3997") + R"(],"polygons":[]}})");
  expect_said("import \"a.plan\" inclusions all",
              "must overlap: in a plan all of them, but with `inclusions any`");
  expect_said("complement(all);\nzone all = rectangle (-536 km, -536 km) to (536 km, 536 km)",
              "nothing is outside it");
}

TEST_F(ZoneFiles, AreExplained) {
  write_polygon("a.geojson", std::string(square) + "," + inner);
  write("s.rta", spec("import \"a.geojson\""));
  const Outcome zone = rtac({"explain", "s.rta:4"});
  ASSERT_EQ(zone.status, 0) << zone.err;
  for (const char* line : {"import \"a.geojson\"\n", "  1 area, up to 1", "  8 positions\n",
                           "azimuthal equidistant on WGS 84", "off by at most 1.3"}) {
    EXPECT_NE(zone.out.find(line), std::string::npos) << line << "\n" << zone.out;
  }
  const Outcome place = rtac({"explain", "s.rta:3"});
  EXPECT_NE(place.out.find("(0 m, 0 m) of the map"), std::string::npos) << place.out;
}

// Heights of vertices limit nothing in GeoJSON; who thinks they do is told that they are left out.
TEST_F(ZoneFiles, WhatTheirReadersLeaveOutIsExplained) {
  write_polygon("a.geojson",
                "[[8.545,47.397,9],[8.547,47.397,9],[8.547,47.399,9],[8.545,47.397,9]]");
  write("s.rta", spec("import \"a.geojson\""));
  const Outcome o = rtac({"explain", "s.rta:4"});
  EXPECT_NE(o.out.find("  coordinates[0][0]: positions have heights"), std::string::npos)
      << o.out << o.err;
}

// Others take such polygons for a mistake, or what lies in both for outside.
TEST_F(ZoneFiles, PolygonsOfAnAreaThatOverlapAreExplained) {
  const auto explained = [](const std::string& second) {
    write("a.geojson", R"({"type":"MultiPolygon","coordinates":[[)" + std::string(square) + "," +
                           inner + "],[" + second + "]]}");
    write("s.rta", spec("import \"a.geojson\""));
    const Outcome o = rtac({"explain", "s.rta:4"});
    EXPECT_EQ(o.status, 0) << o.err;
    return o.out.find("  polygons of 1 area overlap: their union is taken") != std::string::npos;
  };
  EXPECT_TRUE(
      explained("[[8.546,47.398],[8.548,47.398],[8.548,47.4],[8.546,47.4],[8.546,47.398]]"));
  EXPECT_FALSE(explained(inner));  // an island in a hole
  // beside it, with a vertex on the common border
  EXPECT_FALSE(explained("[[8.547,47.3977],[8.549,47.397],[8.549,47.399],[8.547,47.3977]]"));
  // on an oblique one what touches in the file may be a hair off on the map
  write("b.geojson", R"({"type":"MultiPolygon","coordinates":[)"
                     R"([[[8.545,47.397],[8.547,47.397],[8.546,47.399],[8.545,47.397]]],)"
                     R"([[[8.5465,47.398],[8.549,47.397],[8.549,47.399],[8.5465,47.398]]]]})");
  write("s.rta", spec("import \"b.geojson\""));
  EXPECT_EQ(rtac({"explain", "s.rta:4"}).out.find("overlap"), std::string::npos);
}

// A point nearer to the boundary than the error is in the zone and out of it, as far as anybody
// knows; both engines say so, and agree on everything else.
TEST_F(ZoneFiles, TheirErrorMakesPointsUnknown) {
  write_polygon("a.geojson", square);
  write("s.rta", spec("import \"a.geojson\""));
  // the western border is at x = -45.294482 m in the south and -45.292768 m in the north
  write("t.csv", "time,p.x,p.y\n0,-45.293,0\n1,-45.280,0\n2,-45.320,0\n3,0,0\n");
  for (const std::string engine : {"interp", "kernel"}) {
    const Outcome o = rtac({"replay", "--engine", engine, "s.rta", "t.csv"});
    std::vector<std::string> found;
    std::istringstream lines(o.out);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t begin = line.find(',', line.find(',') + 1) + 1;  // behind tick and time
      found.push_back(line.substr(begin, line.find(',', begin) - begin));
    }
    ASSERT_EQ(found.size(), 5U) << o.out;
    EXPECT_EQ(found[1], "unknown") << engine << o.out;
    EXPECT_EQ(found[2], "true") << engine << o.out;
    EXPECT_EQ(found[3], "false") << engine << o.out;
    EXPECT_EQ(found[4], "true") << engine << o.out;
  }
}

// A file of many polygons is united in one sweep; what neighbours share leaves no gap.
TEST_F(ZoneFiles, NeighboursWithACommonBorderStayJoined) {
  std::string text = R"({"type":"MultiPolygon","coordinates":[)";
  for (int i = 0; i < 8; ++i) {
    const std::string west = std::to_string(8.54 + 0.002 * i),
                      east = std::to_string(8.542 + 0.002 * i);
    text += (i > 0 ? ",[[[" : "[[[") + west + ",47.397],[" + east + ",47.397],[" + east +
            ",47.399],[" + west + ",47.399],[" + west + ",47.397]]]";
  }
  write("a.geojson", text + "]}");
  write("s.rta", spec("shrink(import \"a.geojson\", 1 m)"));
  write("t.csv", "time,p.x,p.y\n0,-120.786,0\n1,30.195,10\n");
  const Outcome o = rtac({"replay", "--engine", "kernel", "s.rta", "t.csv"});
  EXPECT_EQ(o.out.find("false"), std::string::npos) << o.out << o.err;
  EXPECT_EQ(o.out.find("unknown"), std::string::npos) << o.out << o.err;
}

// A picture shows zones that move, or come and go, where they are written: it says so.
TEST_F(ZoneFiles, PicturesSayWhenZonesAreThere) {
  write("s.rta",
        "spec s;\nclock utc;\nperiod 1 s;\ninput p : point in -9 .. 9 m;\n"
        "zone a = circle (0 m, 0 m) radius 3 m\n  around p during monday  07:30 .. 16:00;\n"
        "zone b = rectangle (0 m, 0 m) to (1 m, 1 m);\n"
        "monitor m { \"R1: out\" always not p inside b; }\n");
  const Outcome o = rtac({"zones", "s.rta", "-o", "-"});
  ASSERT_EQ(o.status, 0) << o.err;
  EXPECT_NE(o.out.find(">around p during monday 07:30 .. 16:00<"), std::string::npos) << o.out;
  EXPECT_EQ(o.out.find("around"), o.out.rfind("around"));
}

// A schedule without a beginning, or with one before 1970, is one that has always been there.
TEST_F(ZoneFiles, SchedulesMayHaveBegunLongAgo) {
  for (const std::string from : {"", R"("startDateTime":"1969-12-31T23:00:00Z",)"}) {
    write("z.json", R"({"features":[{"identifier":"Z","country":"CHE","type":"COMMON",)"
                    R"("restriction":"PROHIBITED","applicability":[{"permanent":"NO",)" +
                        from +
                        R"("endDateTime":"2026-05-23T08:33:17Z"}],"zoneAuthority":[],"geometry":[{)"
                        R"("uomDimensions":"M","horizontalProjection":{"type":"Circle",)"
                        R"("center":[8.5456,47.3977],"radius":60}}]}]})");
    write("s.rta",
          spec("import \"z.json\" exclusions scheduled", "clock utc;\n" + std::string(origin)));
    write("t.csv", "time,p.x,p.y\n1779525195,0,0\n1779525196,0,0\n1779525197,0,0\n");
    for (const std::string engine : {"interp", "kernel"}) {
      const Outcome o = rtac({"replay", "s.rta", "t.csv", "--engine", engine});
      ASSERT_EQ(o.status, 3) << o.err;  // a monitor is violated
      std::string verdicts;
      std::istringstream rows(o.out);
      for (std::string row; std::getline(rows, row);) {
        for (const char* const word : {"true", "false", "unknown"}) {
          if (row.find(std::string(",") + word) != std::string::npos) verdicts += word[0];
        }
      }
      EXPECT_EQ(verdicts, "ttf") << engine << "\n" << o.out;
    }
  }
}

TEST(SlowTests, AreThere) {
  EXPECT_EQ(rtac::test::slow_tests_gone("compiler_driver"), std::set<std::string>{});
}

}  // namespace
}  // namespace rtac::driver::test
