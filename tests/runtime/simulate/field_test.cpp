// Robots start where they can do wrong: also around holes, and in fields that nobody crosses.
#include "field.h"

#include <gtest/gtest.h>

namespace rtac::simulate {
namespace {

using sim::Property;
using sim::PropertyOp;

Property zone_of(PropertyOp op, int zone) {
  Property p;
  p.op = op;
  p.index = zone;
  return p;
}
Property far_from(int outside, double least_m) {
  Property least, all;
  least.op = PropertyOp::constant;
  least.value = least_m;
  all.op = PropertyOp::at_least;
  all.of = {zone_of(PropertyOp::clearance, outside), least};
  return all;
}

class Fields : public ::testing::Test {
 protected:
  Fields() {
    d_.robots = {"r1"};
    d_.period_us = 50'000;
    d_.limits.speed_mps = d_.limits.accel_mps2 = d_.limits.brake_mps2 = 1;
    d_.limits.radius_m = 0.1;
  }
  // The number of a rectangle; what is left of the plane outside of it, where it is a hole.
  int rectangle(int x_mm, int y_mm, int to_x_mm, int to_y_mm, bool hole = false) {
    constexpr int sky_mm = 536'000'000;
    tables_.emplace_back();
    if (hole) add(-sky_mm, -sky_mm, sky_mm, sky_mm);
    add(x_mm, y_mm, to_x_mm, to_y_mm);
    ZoneView zone;
    zone.edges_mm = tables_.back().data();
    zone.edge_count = tables_.back().size() / 4;
    d_.surroundings.zones.push_back(zone);
    return static_cast<int>(d_.surroundings.zones.size()) - 1;
  }
  void add(int x, int y, int to_x, int to_y) {
    for (const int mm : {x, y, to_x, y, to_x, y, to_x, to_y, to_x, to_y, x, to_y, x, to_y, x, y}) {
      tables_.back().push_back(mm);
    }
  }
  void expect_box(const Field& field, double x, double y, double to_x, double to_y) {
    EXPECT_DOUBLE_EQ(field.box().lo.x, x);
    EXPECT_DOUBLE_EQ(field.box().lo.y, y);
    EXPECT_DOUBLE_EQ(field.box().hi.x, to_x);
    EXPECT_DOUBLE_EQ(field.box().hi.y, to_y);
  }

  DecisionCase d_;
  std::deque<std::vector<std::int32_t>> tables_;
};

TEST_F(Fields, AHoleHasRoomAroundItToGetFastAndStop) {
  d_.properties = {zone_of(PropertyOp::inside, rectangle(2000, 2000, 3000, 3000, true))};
  // A second each to get fast and to stop, 50 ms of being late, and a robot.
  const double room_m = 0.5 + 0.5 + 0.05 + 0.2;
  Field field(d_);
  expect_box(field, 2 - room_m, 2 - room_m, 3 + room_m, 3 + room_m);
  ASSERT_TRUE(field.widen());
  expect_box(field, 2 - 2 * room_m, 2 - 2 * room_m, 3 + 2 * room_m, 3 + 2 * room_m);
}

TEST_F(Fields, WhatIsAskedForIsPartOfTheRoom) {
  d_.properties = {far_from(rectangle(0, 0, 1000, 1000, true), 5)};
  expect_box(Field(d_), -6.05, -6.05, 7.05, 7.05);
}

TEST_F(Fields, ZonesThatMustHoldAreCut) {
  const int hall = rectangle(0, 0, 8000, 8000), east = rectangle(5000, -1000, 12000, 9000);
  const int outside = rectangle(2000, 2000, 3000, 3000, true);
  d_.properties = {zone_of(PropertyOp::inside, hall), far_from(outside, 0.5),
                   zone_of(PropertyOp::inside, east)};
  Field field(d_);
  expect_box(field, 5, 0, 8, 8);
  EXPECT_FALSE(field.widen());
}

TEST_F(Fields, AndBindsOrAllows) {
  const int west = rectangle(0, 0, 4000, 4000), east = rectangle(3000, 0, 9000, 4000);
  Property p;
  p.of = {zone_of(PropertyOp::inside, west), zone_of(PropertyOp::inside, east)};
  p.op = PropertyOp::logical_and;
  d_.properties = {p};
  expect_box(Field(d_), 3, 0, 4, 4);
  d_.properties.front().op = PropertyOp::logical_or;
  expect_box(Field(d_), 0, 0, 9, 4);
}

// Beyond the walls by what is allowed.
TEST_F(Fields, ANegativeClearanceMayBeUsedUp) {
  d_.properties = {far_from(rectangle(0, 0, 4000, 4000), -0.5)};
  expect_box(Field(d_), -0.5, -0.5, 4.5, 4.5);
}

TEST_F(Fields, HeightsAreBoundedLikePlaces) {
  Property height, limit, above;
  height.op = PropertyOp::altitude;
  limit.op = PropertyOp::constant;
  limit.value = 3;
  above.op = PropertyOp::at_least;
  above.of = {height, limit};
  d_.limits.in_space = true;
  d_.properties = {zone_of(PropertyOp::inside, rectangle(0, 0, 4000, 4000)), above};
  const Field open(d_);
  EXPECT_DOUBLE_EQ(open.box().bottom, 3);
  EXPECT_DOUBLE_EQ(open.box().top, 3 + 1.25);
  // What is not above a slab is beside it, below it or above it.
  const int base = rectangle(1000, 1000, 2000, 2000), all = rectangle(0, 0, 1, 1, true);
  const auto view = [&](int zone) {
    return &d_.surroundings.zones[static_cast<std::size_t>(zone)];
  };
  const SlabView slabs[] = {{view(all), -536'000, 0}, {view(base), 0, 5}, {view(all), 5, 536'000}};
  d_.surroundings.solids.resize(d_.surroundings.zones.size());
  d_.surroundings.solids[static_cast<std::size_t>(all)] = {"", slabs, 3};
  d_.properties = {zone_of(PropertyOp::inside, all)};
  const Field around(d_);
  EXPECT_DOUBLE_EQ(around.box().bottom, -1.25);
  EXPECT_DOUBLE_EQ(around.box().top, 6.25);
  EXPECT_DOUBLE_EQ(around.box().hi.x, 3.25);
}

TEST_F(Fields, InAWideFieldHalfOfThePlacesAreNearABoundary) {
  const int site = rectangle(0, 0, 500'000, 500'000);
  const int outside = rectangle(200'000, 200'000, 210'000, 210'000, true);
  d_.properties = {zone_of(PropertyOp::inside, site), far_from(outside, 0.1)};
  const Field field(d_);
  sim::Random random = sim::Random::stream(1, 2, 3);
  constexpr int places = 1000;
  int near = 0;
  for (int k = 0; k < places; ++k) {
    const Vec2 at = field.draw(random);
    for (const ZoneView& zone : d_.surroundings.zones) {
      if (std::abs(signed_clearance(zone, at)) < 2) {
        ++near;
        break;
      }
    }
  }
  EXPECT_GT(near, places * 4 / 10);
  EXPECT_LT(near, places * 6 / 10);
}

}  // namespace
}  // namespace rtac::simulate
