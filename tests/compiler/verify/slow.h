// Tests that take turns on the integration machine (tests/turn.h): each of them takes more than ten
// seconds beside others there, and all of them half of the time of all tests of `rtac verify`. The
// longest first, so that turns take about as long.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/turn.h"

namespace rtac::driver::test {

inline const std::vector<std::string>& slow_tests() {
  static const std::vector<std::string> all = {
      "MakingRoom.RobotsThatAreNeverSoFarApartAreNotGivenBackTogether",
      "MakingRoom.OfTwoRobotsOneFindsAWay",
      "BesideWhoStands.ThoseThatCoordinateGoOnAsWell",
      "LowSlab.WithAsMuchAirAsIsAskedForTheyDo",
      "BesideWhoStands.WhoIsToldToBeSlowIsToldToStand",
      "MakingRoom.InSpaceOneFindsAWayOverTheOther",
      "Verify.WhatIsOfferedOfAPairHasBeenTried",
      "ReturnWhen.InputsLetGoAndTakeTheirTime",
      "Verify.NoWayOverCellsTakesARunToRefute",
      "BesideWhoStands.ItIsInTheWayUntilItIsToldOtherwise",
      "Recheck.ABrokenSealIsNoticed",
      "WaysOut.LeadNoNearerThanIsClaimed",
      "ComingIn.StraightWaysFromOneSideOfAnOrToAnotherAreFollowed",
      "Hanging.ASolverLeavesItUnknownAndIsAskedOnce",
      "PartingInABasin.OfTwoFerriesOneFindsAWay",
      "MakingRoom.InSpaceASwayThatIsWiderThanTheWayTakesMoreRoom",
      "MakingRoom.OfTwoRobotsBesideAPillarOneFindsAWay",
      "MakingRoom.WhoIsGivenBackNeedNoWay",
      "Hanging.AModelCheckerLeavesItUnknown",
      "Verify.ACorridorThatIsTooNarrowIsToldHowWideItHasToBe",
      "ReturnWhen.ASiteIsAsClearAsWhereARobotParks",
      "ReturnWhen.WhatIsWrittenInOtherWordsIsFoundOnceMore",
      "StaysPut.ARetreatThatIsDeepInItsZoneKeepsWhatHoldsItThere",
      "BesideWhoStands.WhatLeadsBackFromAWallIsInTheWayOfThoseThatCoordinate",
      "Repaired.ACorridorIsSoWideThatControlIsGivenBackAllAlong",
      "Verify.WhoIsSlowEnoughKeepsNoDistanceBesides",
      "ComingIn.StraightWaysIntoAPartOfAHallAreFollowed",
      "MakingRoom.WhereAnotherRecoveryMayDriveNothingIsShown",
      "ReturnWhen.WhatComesAboutIsProved",
      "Repaired.AClearanceIsSoSmallThatWaysLeadRound",
      "MakingRoom.TheOrderThatWorksIsOffered",
      "ComingIn.AWiderBerthThanIsAskedKeepsADistance",
      "MakingRoom.InSpaceAnAisleIsAsNarrow",
      "Heights.ARecoveryBetweenThemGivesBackToAll",
      "ReturnWhen.AChargeThatTheRecoveryDoesNotLeadToIsNotProved",
      "Others.WhatIsAConditionOfEachPairIsKept",
      "Heights.ANegatedLimitIsOne",
      "BesideWhoStands.WhoStandsAtAWallIsInTheWay",
      "Others.WhoCoordinatesTakesNobodyForAsGood",
      "Sides.ASlowRecoveryKeepsALimitOfSpeed",
      "Recheck.RobotsInSpaceAreProvedInAConvexHall",
      "Heights.ARecoveryThatKeepsItsHeightDoesNotLeadDown",
      "Others.NobodyKeepsAnAgentOff",
      "FastRecovery.WhatIsAcknowledgedIsNotProved",
      "RecheckCoordinated.ACircleIsNoticed",
  };
  return all;
}

// Whether it is the turn of the test that runs; of one that is not slow it always is.
inline bool comes_up() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string(info->test_suite_name()) + "." + info->name();
  const auto found = std::find(slow_tests().begin(), slow_tests().end(), name);
  return found == slow_tests().end() ||
         rtac::test::is_due(static_cast<std::size_t>(found - slow_tests().begin()));
}

}  // namespace rtac::driver::test
