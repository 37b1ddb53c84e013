// Fence items of a QGC WPL 110 text: vertices that must add up, groups, circles.
#include <sstream>

#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

// The lines as a file, their first column numbered.
std::string file(const std::string& lines) {
  std::string result = "QGC WPL 110\n";
  std::istringstream in(lines);
  int index = 0;
  for (std::string line; std::getline(in, line);) {
    result += std::to_string(index++) + line.substr(line.find_first_of(" \t")) + "\n";
  }
  return result;
}

// An item with the given command, param1, param2 and place.
std::string line(int command, const std::string& param1, const std::string& param2,
                 const std::string& place, const std::string& end = "0\t1\n") {
  return "0\t0\t3\t" + std::to_string(command) + "\t" + param1 + "\t" + param2 + "\t0\t0\t" +
         place + "\t" + end;
}
std::string triangle(int command, const std::string& group = "0") {
  return line(command, "3", group, "47.1\t8.5") + line(command, "3.0", group, "47.2\t8.5") +
         line(command, "3", group, "47.2\t8.6");
}
std::string failure(const std::string& text) {
  return failure_of(Format::waypoints, text);
}

TEST(Waypoints, VerticesOfAPolygonFollowOneAnother) {
  const Areas areas =
      areas_of(Format::waypoints, file(triangle(5001, "2") + triangle(5001) + triangle(5002)));
  ASSERT_EQ(areas.areas.size(), 3U);
  EXPECT_EQ(areas.areas[0].role, Role::keep_in);
  EXPECT_EQ(areas.areas[0].group, 2);
  EXPECT_EQ(areas.areas[1].group, 0);
  EXPECT_EQ(areas.areas[2].role, Role::keep_out);
  EXPECT_EQ(areas.areas[2].group, std::nullopt);
  EXPECT_EQ(areas.areas[1].where, "line 5");
  EXPECT_EQ(polygon_of(areas.areas[0]).outer.positions.at(0), (Position{8.5, 47.1}));
  EXPECT_TRUE(areas.notes.empty());
}

TEST(Waypoints, CirclesHaveRadiusAndGroup) {
  const Areas areas = areas_of(Format::waypoints, file(line(5003, "250.5", "1", "47.1\t8.5") +
                                                       line(5004, "10", "0", "47.1\t8.5")));
  ASSERT_EQ(areas.areas.size(), 2U);
  EXPECT_EQ(circle_of(areas.areas[0]).radius_m, 250.5);
  EXPECT_EQ(areas.areas[0].group, 1);
  EXPECT_EQ(areas.areas[1].role, Role::keep_out);
}

TEST(Waypoints, OtherItemsAltitudesAndTheReturnPointAreNoted) {
  const Areas areas =
      areas_of(Format::waypoints, file(line(16, "0", "0", "47\t8") + line(16, "nan", "0", "47\t8") +
                                       line(5000, "0", "0", "47\t8") +
                                       line(5003, "250", "0", "47.1\t8.5", "60\t1\n")));
  ASSERT_EQ(areas.notes.size(), 3U);
  EXPECT_EQ(areas.notes[0].where, "line 5");
  EXPECT_EQ(areas.notes[1].where, "line 4");
  EXPECT_EQ(areas.notes[2].where, "line 2");
}

TEST(Waypoints, NumberOfVerticesMustAgree) {
  const std::string two = line(5001, "3", "0", "47.1\t8.5") + line(5001, "3", "0", "47.2\t8.5");
  const std::string expected = "line 2: the polygon announces 3 vertices in param1, and 2 follow";
  EXPECT_TRUE(contains(failure(file(two)), expected));
  EXPECT_TRUE(contains(failure(file(two + triangle(5002))), expected));
  EXPECT_TRUE(contains(failure(file(two + line(16, "0", "0", "1\t1"))), expected));
  EXPECT_TRUE(contains(failure(file(two + line(5001, "4", "0", "1\t1"))), expected));
  EXPECT_TRUE(contains(failure(file(line(5001, "2", "0", "1\t1"))), "param1, is 2"));
  EXPECT_TRUE(contains(failure(file(line(5001, "3.5", "0", "1\t1"))), "param1, is 3.5"));
}

TEST(Waypoints, GroupsMustAgree) {
  EXPECT_TRUE(contains(failure(file(line(5001, "3", "0", "1\t1") + line(5001, "3", "1", "1\t2"))),
                       "line 3: the inclusion group, param2, is 1, and 0 in line 2"));
  EXPECT_TRUE(contains(failure(file(line(5003, "9", "-1", "1\t1"))), "param2, is -1"));
}

TEST(Waypoints, ReservedParametersRefuseTheArea) {
  const Area area = only_area(Format::waypoints, file("0 0 3 5003 99 0 30 0 47 8 0 1\n"));
  EXPECT_TRUE(contains(refusal_of(area), "param3 and param4 are reserved, and are 30 and 0"));
  const Area exclusion = only_area(Format::waypoints, file(line(5004, "9", "1", "47\t8")));
  EXPECT_TRUE(contains(refusal_of(exclusion), "param2 of an exclusion is reserved"));
}

TEST(Waypoints, LocalFramesAreRefused) {
  EXPECT_TRUE(contains(failure(file("0 0 1 5003 99 0 0 0 47 8 0 1\n")), "line 2: has the frame 1"));
}

TEST(Waypoints, LinesAreToldWithTheirColumn) {
  EXPECT_TRUE(contains(failure("QGC WPL 120\n"), "line 1: is `QGC WPL 120`"));
  EXPECT_TRUE(contains(failure(file("0 0 3 5003 99 0 0 0 47 8")), "line 2: has 10 columns"));
  EXPECT_TRUE(
      contains(failure(file("0 0 3 5003 99 0 0 0 47 8 0 1 1")), "more than twelve columns"));
  EXPECT_TRUE(contains(failure(file("0 0 3 5003 99 0 0 0 nan 8 0 1")),
                       "line 2: the latitude or the longitude is not set"));
  EXPECT_TRUE(
      contains(failure(file("0 0 3 5003 1e999 0 0 0 4 8 0 1")), "line 2, param1: is `1e999`"));
  EXPECT_TRUE(contains(failure(file("0 0 3 5003 inf 0 0 0 4 8 0 1")), "param1: is `inf`"));
  EXPECT_TRUE(contains(failure(file("0 0 3 5003 nan 0 0 0 4 8 0 1")), "a radius of nan m"));
  EXPECT_TRUE(contains(failure(file("0 0 3 5003 9 nan 0 0 4 8 0 1")), "param2, is nan"));
  EXPECT_EQ(failure(file("0 0 3 5004 9 nan nan nan 4 8 nan 1")), "");
  EXPECT_TRUE(contains(failure(file("0 0 3 5003.5 9 0 0 0 4 8 0 1")), "no whole number"));
}

TEST(Waypoints, ItemsStandInTheOrderOfTheirIndices) {
  const auto with = [](const std::vector<std::string>& indices) {
    std::string text = "QGC WPL 110\n";
    for (const std::string& index : indices) text += index + " 0 3 5003 99 0 0 0 47 8 0 1\n";
    return failure(text);
  };
  EXPECT_EQ(with({"0", "1", "2"}), "");
  EXPECT_EQ(with({"7", "8.0"}), "");  // of a part of the items of a vehicle
  EXPECT_TRUE(contains(with({"0", "2", "1"}),
                       "line 3, index: is 2, and 0 in the item before (items stand in the order of "
                       "their indices, without a gap: here 1 is next)"));
  EXPECT_TRUE(contains(with({"1", "0"}), "line 3, index: is 0, and 1 in the item before"));
  EXPECT_TRUE(contains(with({"4", "4"}), "line 3, index: is 4, and 4 in the item before"));
  EXPECT_TRUE(contains(with({"0", "nan"}), "line 3, index: is not set, and 0 in the item before"));
  EXPECT_TRUE(contains(with({"nan"}), "line 2, index: is not set (a whole number from 0)"));
  EXPECT_TRUE(contains(with({"-1"}), "line 2, index: is -1 (a whole number from 0)"));
  EXPECT_TRUE(contains(with({"0.5"}), "line 2, index: is 0.5"));
}

TEST(Waypoints, MissionsWithoutAFenceHaveNoAreas) {
  EXPECT_TRUE(contains(failure(file(line(16, "0", "0", "47\t8"))), "has no fence items"));
}

TEST(Waypoints, CarriageReturnsAndEmptyLinesAreNoMatter) {
  EXPECT_EQ(failure("QGC WPL 110\r\n\r\n0 0 3 5003 99 0 0 0 47 8 0 1\r\n\r\n"), "");
}

TEST(Waypoints, PositionsAreLimited) {
  EXPECT_TRUE(contains(failure_of(Format::waypoints, file(triangle(5001)), {.positions_max = 2}),
                       "line 4: more than 2 positions"));
}

}  // namespace
}  // namespace rtac::geometry::import
