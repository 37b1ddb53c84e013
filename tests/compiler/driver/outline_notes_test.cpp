// Outlines that are mended: vertices in line with their neighbours and the way round make no
// difference, and `rtac explain` and `rtac zones` tell of them.
#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

class OutlineNotes : public InFolder {
 protected:
  static void write_spec(const std::string& zone) {
    write("s.rta", "spec s;\nperiod 1 s;\norigin 47 deg, 8 deg;\nzone z =\n  " + zone +
                       ";\ninput p : point in -900 .. 900 m;\n"
                       "monitor m { \"R1: in\" always p inside z; }\n");
  }
  static std::string explained() { return rtac({"explain", "s.rta:5"}).out; }
  static std::string drawn() { return rtac({"zones", "s.rta", "-o", "-"}).out; }
  static void expect_in(const std::string& all, const std::string& text) {
    EXPECT_NE(all.find(text), std::string::npos) << text << " is not in\n" << all;
  }
};

TEST_F(OutlineNotes, OfAnOutlineThatIsWritten) {
  write_spec(
      "polygon [(0 m, 0 m), (0 m, 9 m), (9 m, 9 m), (9 m, 5 m), (9 m, 0 m), (4 m, 0 m)] "
      "hole [(1 m, 1 m), (2 m, 1 m), (2 m, 2 m)]");
  const std::string straight = "2 vertices lie on a line with their neighbours and are left out";
  expect_in(explained(), "\noutline\n  " + straight +
                             "; see vertex 4\n  the outline runs clockwise and is turned\n");
  expect_in(drawn(), ">" + straight + "<");
  expect_in(drawn(), ">the outline runs clockwise and is turned<");
}

TEST_F(OutlineNotes, NothingIsSaidOfOneThatIsTakenAsItIs) {
  write_spec(
      "rectangle (9 m, 9 m) to (0 m, 0 m) | "
      "polygon [(0 m, 0 m), (9 m, 0 m), (9 m, 9 m)] hole [(4 m, 1 m), (5 m, 1 m), (5 m, 2 m)]");
  EXPECT_EQ(explained().find("outline"), std::string::npos) << explained();
  EXPECT_EQ(drawn().find("turned"), std::string::npos);
}

// Of long edges that are straight in degrees, the points within them are none of the file.
TEST_F(OutlineNotes, OfAFile) {
  write("a.kml",
        "<kml><Placemark><Polygon><outerBoundaryIs><LinearRing><coordinates>"
        "8,47 8,47.002 8,47.004 8.004,47.004 8.004,47 8,47"
        "</coordinates></LinearRing></outerBoundaryIs><innerBoundaryIs><LinearRing><coordinates>"
        "8.001,47.001 8.002,47.001 8.002,47.002 8.001,47.001"
        "</coordinates></LinearRing></innerBoundaryIs></Polygon></Placemark></kml>");
  write_spec("import \"a.kml\"");
  expect_in(explained(),
            "  1 vertex lies on a line with its neighbours and is left out; "
            "see vertex 2 (8, 47.002) of a.kml: ");
  expect_in(explained(), "  the outline runs clockwise and is turned; see a.kml: ");
  expect_in(explained(), "  1 hole runs counter-clockwise and is turned; see a.kml: ");
  expect_in(drawn(), ">the outline runs clockwise and is turned<");
}

}  // namespace
}  // namespace rtac::driver::test
