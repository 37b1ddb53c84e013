// What spin says of the models: the claims hold of what the compiler generates, and a planted bug
// of each kind is found and told in the names of the specification.
#include "tests/protocol/checker.h"

namespace rtac::protocol::test {
namespace {

ir::Decision delivery() {
  return decision_of("specs/robot_delivery/robot_delivery.rta", "plan_executor");
}
// A model with some of its claims: fewer of them are compiled sooner.
std::string with_claims(const Model& model, const std::vector<std::string>& names) {
  std::string text = model.rules + model.environment;
  for (const std::string& name : names) {
    const std::size_t at = model.claims.find("ltl " + name + " {");
    EXPECT_NE(at, std::string::npos) << name;
    text += "\n" + model.claims.substr(at, model.claims.find("\n\n", at) - at) + "\n";
  }
  return text;
}
// The story of a claim on the text of the delivery with a planted bug.
std::string story_of(const std::string& claim, const std::string& from, const std::string& to) {
  const ir::Decision d = delivery();
  const std::string text = with_claims(model_of(d, assumed(d)), {claim});
  return Checker(planted(text, from, to)).ask(claim);
}
void expect_all_hold(const ir::Decision& d) {
  const Model model = model_of(d, assumed(d));
  Checker checker(model.text());
  for (const std::string& claim : model.claim_names) {
    EXPECT_EQ(checker.ask(claim), "holds") << d.name << " " << claim;
  }
}

TEST(Model, ClaimsHoldOfTheDelivery) {
  expect_all_hold(delivery());
}
TEST(Model, ClaimsHoldOfTheSurveillance) {
  expect_all_hold(decision_of("specs/drone_surveillance/drone_surveillance.rta", "plan_executor"));
}
TEST(Model, ClaimsHoldOfFourMonitorsByPriority) {
  expect_all_hold(decision_of("tests/golden/shared_recovery/spec.rta", "fly"));
}

// The delivery, coordinated: nothing is shown of `give_way` and the battery.
ir::Decision coordinated_delivery() {
  ir::Decision d = delivery();
  using ir::Kept;
  d.acknowledgements.clear();
  d.coordinated = true;
  d.keeps = {{Kept::own, Kept::proved, Kept::unproved},
             {Kept::proved, Kept::own, Kept::proved},
             {Kept::proved, Kept::proved, Kept::own}};
  return d;
}
void expect_holds(const ir::Decision& d, const std::vector<std::string>& claims) {
  const Model model = model_of(d, assumed(d));
  Checker checker(with_claims(model, claims));
  for (const std::string& claim : claims) {
    EXPECT_EQ(checker.ask(claim), "holds") << d.name << " " << claim;
  }
}
TEST(Model, ClaimsHoldOfTheDeliveryCoordinated) {
  expect_holds(coordinated_delivery(), {"kept_by_driver", "no_livelock", "control_returns"});
}
TEST(Model, ClaimsHoldOfTwoSidesCoordinated) {
  expect_holds(decision_of("tests/protocol/alike.rta", "drive"),
               {"one_controller", "kept_by_driver", "given_back"});
}
// Planted: the other robot is still in the way when this one has charged, so that it makes way,
// charges, and makes way again.
TEST(Model, CoordinatedRecoveriesThatStartEachOtherAreFound) {
  const ir::Decision d = coordinated_delivery();
  Arbitration arbitration = assumed(d);
  constexpr std::size_t collision = 0, battery = 2;
  arbitration.keeps[collision][battery] = false;
  arbitration.settles[battery][collision] = false;
  const Model model = model_of(d, arbitration);
  const std::string story = Checker(with_claims(model, {"no_livelock"})).ask("no_livelock");
  const std::size_t cycle = story.find("START OF CYCLE");
  ASSERT_NE(cycle, std::string::npos) << story;
  EXPECT_NE(story.find("`go_charge` drives", cycle), std::string::npos) << story;
  EXPECT_NE(story.find("`give_way` drives", cycle), std::string::npos) << story;
}
// Two recoveries of which nothing is shown may each be chosen, and break the other one's monitor.
TEST(Model, AMonitorThatACircleLeadsToIsNotKept) {
  const ir::Decision d = decision_of("tests/protocol/alike.rta", "drive");
  const Model model = model_of(d, assumed(d));
  const std::string text = with_claims(model, {"kept_by_driver"});
  EXPECT_NE(text.find("covered[MONITORS] = { 1, 1, 0 }"), std::string::npos);
  EXPECT_NE(
      Checker(planted(text, "covered[MONITORS] = { 1, 1, 0 }", "covered[MONITORS] = { 1, 1, 1 }"))
          .ask("kept_by_driver"),
      "holds");
}
// Planted: the recovery of the highest engaged monitor drives, whatever it keeps.
TEST(Model, AChoiceThatDoesNotKeepWhatItCouldIsFound) {
  const ir::Decision d = coordinated_delivery();
  const std::string text = with_claims(model_of(d, assumed(d)), {"kept_by_driver"});
  const std::string story = Checker(planted(text, "highest != NOBODY -> choose()",
                                            "highest != NOBODY -> mode = highest + 1"))
                                .ask("kept_by_driver");
  EXPECT_NE(story.find("`battery` engages"), std::string::npos) << story;
}

TEST(Model, ClaimsHoldOfPlanners) {
  expect_all_hold(decision_of("specs/robot_delivery/robot_delivery.rta", "motion_planner"));
}

// The claims would hold of a model in which nothing happens.
TEST(Model, EveryControllerDrivesInSomeRun) {
  const ir::Decision d = delivery();
  const Model model = model_of(d, assumed(d));
  std::string text = model.rules + model.environment;
  for (const int mode : {0, 1, 2, 3}) {
    text += "ltl never_" + std::to_string(mode) +
            " { [] (decided -> driver != " + std::to_string(mode) + ") }\n";
  }
  text += "ltl never_back { [] (decided && changed -> driver != 0) }\n";
  Checker checker(text);
  for (const int mode : {0, 1, 2, 3}) {
    EXPECT_NE(checker.ask("never_" + std::to_string(mode)).find("drives"), std::string::npos);
  }
  EXPECT_NE(checker.ask("never_back").find("`follow_plan` drives"), std::string::npos);
}

// Planted: who is preempted stops, and nobody begins.
TEST(Model, AStateWithoutAnActiveControllerIsFound) {
  const std::string story =
      story_of("one_controller", "drives[mode] = 1;", "drives[mode] = (driver == 0 || mode == 0);");
  EXPECT_NE(story.find("NOBODY drives"), std::string::npos) << story;
  EXPECT_NE(story.find(" engages: "), std::string::npos) << story;
}
// Planted: the executor keeps the recovery that drives, whatever else engages.
TEST(Model, AnEngagedRecoveryThatNeverDrivesIsFound) {
  const std::string story = story_of("scheduled", "!goes_on -> mode = highest + 1",
                                     "!goes_on -> mode = (before == 0 -> highest + 1 : before)");
  EXPECT_NE(story.find("has not driven for 2 ticks: its look-ahead has passed"), std::string::npos)
      << story;
  EXPECT_NE(story.find("` is engaged, and `"), std::string::npos) << story;
}
// Planted: a recovery drives on that is not shown to keep what ranks higher; or though that is
// false.
TEST(Model, ARecoveryThatDrivesOnWithoutBeingShownToIsFound) {
  for (const auto& [from, to] :
       {std::array{"shown[(before - 1) * MONITORS + column] == 1 && !false_now",
                   "shown[(before - 1) * MONITORS + column] == 0 && !false_now"},
        std::array{"column] == 1 && !false_now[column]))", "column] == 1))"}}) {
    const std::string story = story_of("scheduled", from, to);
    EXPECT_NE(story.find("has not driven for 2 ticks: its look-ahead has passed"),
              std::string::npos)
        << story;
  }
}
// Planted: control is given back although a monitor is engaged.
TEST(Model, ControlThatIsGivenBackTooSoonIsFound) {
  const std::string story = story_of("given_back", "!surrender && before != 0 && open != NOBODY",
                                     "!surrender && before != 0 && open == MONITORS + 1");
  EXPECT_NE(story.find("before control may be given back"), std::string::npos) << story;
}
// Planted: two recoveries drive the robot out of each other's return sets.
TEST(Model, RecoveriesThatPreemptEachOtherForEverAreFound) {
  const ir::Decision d = delivery();
  Arbitration arbitration = assumed(d);
  constexpr std::size_t collision = 0, geofence = 1;
  arbitration.settles[collision][geofence] = false;
  arbitration.keeps[geofence][collision] = false;
  const Model model = model_of(d, arbitration);
  Checker checker(with_claims(model, {"one_controller", "no_livelock", "control_returns"}));
  for (const char* const claim : {"no_livelock", "control_returns"}) {
    const std::string story = checker.ask(claim);
    const std::size_t cycle = story.find("START OF CYCLE");
    ASSERT_NE(cycle, std::string::npos) << story;
    EXPECT_NE(story.find("`turn_back` drives", cycle), std::string::npos) << story;
    EXPECT_NE(story.find("`give_way` drives", cycle), std::string::npos) << story;
    EXPECT_EQ(story.find("`follow_plan` drives", cycle), std::string::npos) << story;
  }
  EXPECT_EQ(checker.ask("one_controller"), "holds");
}
// Of the pair only one is left: there is no cycle.
TEST(Model, ARecoveryThatIsBrokenInOneDirectionOnlyIsFine) {
  const ir::Decision d = delivery();
  Arbitration arbitration = assumed(d);
  arbitration.settles[0][1] = false;
  const Model model = model_of(d, arbitration);
  Checker checker(with_claims(model, {"no_livelock", "control_returns"}));
  EXPECT_EQ(checker.ask("no_livelock"), "holds");
  EXPECT_EQ(checker.ask("control_returns"), "holds");
}

// Planted: a plan is delivered whatever the decision says of it.
TEST(Model, APlanThatIsRefusedAndDeliveredIsFound) {
  const ir::Decision d = decision_of("specs/robot_delivery/robot_delivery.rta", "motion_planner");
  const std::string text = planted(model_of(d, assumed(d)).text(),
                                   "found && admissible -> delivered", "found -> delivered");
  const std::string story = Checker(text).ask("admissible_only");
  EXPECT_NE(story.find("`certified_planner` has a plan that `plan_valid` refuses"),
            std::string::npos)
      << story;
}

// A recovery that leads back to where the other one took over: with a `return when` of its own its
// monitor is still engaged then. Without one it gave control back meanwhile.
TEST(Model, AGuardedPairIsALivelockWhereTheLowerMonitorStaysEngaged) {
  const ir::Decision d = delivery();
  constexpr std::size_t geofence = 1, battery = 2;
  Arbitration arbitration = assumed(d);
  arbitration.keeps[battery][geofence] = false;
  const auto asked = [&](bool asks) {
    Subject subject = verify::protocol_subject(d);
    subject.monitors[battery].asks = asks;
    Checker checker(with_claims(protocol_model(subject, arbitration, "test.rta"), {"no_livelock"}));
    return checker.ask("no_livelock");
  };
  EXPECT_NE(asked(true).find("START OF CYCLE"), std::string::npos);
  EXPECT_EQ(asked(false), "holds");
}

TEST(Model, TablesAreTextAndBack) {
  const Table table = {{true, false}, {false, true}};
  EXPECT_EQ(text_of(table), "10 01");
  EXPECT_EQ(table_of("10 01"), table);
  EXPECT_TRUE(table_of("").empty());
  for (const char* const none : {"10 0", "1 0", "10 0x", "10  01"}) {
    EXPECT_TRUE(table_of(none).empty()) << none;
  }
}

}  // namespace
}  // namespace rtac::protocol::test
