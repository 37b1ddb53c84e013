// What is known of other robots takes as much room as there are robots.
#include <gtest/gtest.h>

#include <cstddef>

#include "rtac/types.h"

namespace rtac {
namespace {

// A hundred of them fit where one had the room of a full fleet.
TEST(Announcements, AnObservationOfOneRobotIsSmall) {
  EXPECT_LT(sizeof(Observation), 4 * sizeof(Path));
}

TEST(Announcements, OfARobotThatWasNeverWrittenToNothingWasHeard) {
  const Observation seen;
  EXPECT_EQ(seen.others.size(), 0u);
  EXPECT_EQ(seen.others[max_robots - 1].position.stamp_us, never_us);
  EXPECT_EQ(seen.others[max_robots - 1].lease_end_us, never_us);
  EXPECT_EQ(seen.others.size(), 0u);
}

TEST(Announcements, WritingMakesRoomAndKeepsReferences) {
  Observation seen;
  Announcement& first = seen.others[0];
  first.urgency = 3;
  seen.others[max_robots - 1].urgency = 5;
  EXPECT_EQ(seen.others.size(), max_robots);
  EXPECT_EQ(&first, &seen.others[0]);
  EXPECT_EQ(seen.others[0].urgency, 3);
  EXPECT_EQ(seen.others[1].position.stamp_us, never_us);
}

TEST(Announcements, ReservingLosesNothing) {
  Announcements heard;
  heard[1].urgency = 7;
  heard.reserve(4);
  heard.reserve(1);
  EXPECT_EQ(heard.size(), 4u);
  EXPECT_EQ(heard[1].urgency, 7);
}

TEST(Announcements, CopiesAreTheirOwn) {
  Observation seen;
  seen.others[1].urgency = 1;
  Observation later = seen;
  later.others[1].urgency = 2;
  EXPECT_EQ(seen.others[1].urgency, 1);
}

}  // namespace
}  // namespace rtac
