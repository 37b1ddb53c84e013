// `rtac verify --conservatism`: how much of what monitors keep free is needed. The targets are
// those that a look-ahead has to meet to be worth something; more than all of it is a refutation.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

using Json = nlohmann::json;

constexpr const char* drone_in_a_room = R"(spec tight;
zone room = rectangle (0 m, 0 m) to (8 m, 6 m);
robot Drone {
  body    radius 10 cm;
  motion  point { speed <= 1.5 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 0 cm   max_age 20 ms;
  sense   velocity : vector error 0 cm/s max_age 20 ms;
  output  thrust : acceleration;
  latency 2 ms;
}
fleet d1 : Drone;
controller pilot   : advanced for Drone extern;
controller inwards : safe for Drone = retreat within room speed 0.3 m/s;
monitor walls for d : Drone { "SR-1: in the room" always d inside room; ahead 100 ms; recover inwards; }
decision fly for Drone { advanced pilot; period 5 ms; priority walls; }
)";

class ConservatismTest : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  static Outcome measured(const std::string& text, const std::vector<std::string>& more = {}) {
    write("spec.rta", text);
    std::vector<std::string> words = {"verify", "spec.rta", "--conservatism", "--format", "json"};
    words.insert(words.end(), more.begin(), more.end());
    return rtac(words);
  }
  // Of the only monitor.
  static double share(const Outcome& o) {
    const Json of = Json::parse(o.out)["decisions"][0]["conservatism"][0];
    EXPECT_TRUE(of["measured"].get<bool>()) << of;
    EXPECT_EQ(of["failures"].get<int>(), 0) << of;
    EXPECT_TRUE(of["complete"].get<bool>()) << of;
    return of.value("share", 0.0);
  }
};

TEST_F(ConservatismTest, OfAPointMassWithoutNoise) {
  const Outcome o = measured(drone_in_a_room);
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_GE(share(o), 0.95) << o.out;
  EXPECT_LE(share(o), 1) << o.out;
}

TEST_F(ConservatismTest, OfAPointMassWithNoiseAndDisturbance) {
  std::string text = edited(drone_in_a_room, "error 0 cm ", "error 2 cm ");
  text = edited(text, "error 0 cm/s", "error 2 cm/s");
  text = edited(text, "brake >= 1 m/s^2;", "brake >= 1 m/s^2; disturbance <= 0.1 m/s^2;");
  const Outcome o = measured(text);
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_GE(share(o), 0.6) << o.out;
  EXPECT_LE(share(o), 1) << o.out;
}

// With noise, floors and ceilings among the walls.
TEST_F(ConservatismTest, OfAPointMassInSpace) {
  const Outcome o = measured(spec_text("tests/golden/space_fence/spec.rta"));
  EXPECT_GE(share(o), 0.6) << o.out << o.err;
  EXPECT_LE(share(o), 1) << o.out << o.err;
}

// In a room so small that an agent in the middle has a recovery drive from everywhere: what is
// asked is how far the look-ahead of the advanced controller goes. Its turn runs down for longer
// than its speed, and who only turns stands.
TEST_F(ConservatismTest, OfAUnicycleNearAnAgent) {
  const Outcome o = measured(R"(spec near;
zone room = rectangle (0 m, 0 m) to (1.7 m, 1.7 m);
robot Bot {
  body    radius 2 cm;
  motion  unicycle { speed <= 0.4 m/s; turn <= 1 rad/s; accel <= 0.8 m/s^2; brake >= 0.6 m/s^2; turn_accel <= 1 rad/s^2; }
  sense   position : point  error 1 cm   max_age 100 ms;
  sense   velocity : vector error 0 m/s  max_age 0 ms;
  sense   heading  : angle  error 2 deg  max_age 0 ms;
  output  drive : twist;
  latency 100 ms;
}
fleet b1 : Bot;
agent man : radius 30 cm, speed <= 0.4 m/s error 5 cm max_age 100 ms;
controller pilot : advanced for Bot extern;
controller stop  : safe for Bot = brake_and_hold;
monitor off for b : Bot { "SR-1: off the man" always distance(b, man) >= 20 cm; recover stop; }
decision go for Bot { advanced pilot; period 250 ms; priority off; acknowledge stop may break off "he sees it"; }
)");
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_GE(share(o), 0.6) << o.out;
  EXPECT_LE(share(o), 1) << o.out;
}

// A measure that cannot refute would say nothing.
TEST_F(ConservatismTest, UnsoundVariantsAreRefuted) {
  for (const char* mutant : {"no-radius", "no-stopping-distance"}) {
    const Outcome o = measured(drone_in_a_room, {"--mutate", mutant});
    EXPECT_EQ(o.status, exit_violation) << mutant << o.out << o.err;
    EXPECT_GT(share(o), 1) << mutant << o.out;
    EXPECT_NE(o.out.find("mm too far"), std::string::npos) << mutant << o.out;
  }
}

// Declared so: told, and not counted against it.
TEST_F(ConservatismTest, AnUnsoundLookAheadIsAcknowledged) {
  const std::string text =
      edited(drone_in_a_room, "ahead 100 ms", "ahead 1 ms unsound \"to see what happens\"");
  const Outcome o = measured(text);
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

// Without a simulator nothing is measured, and that is said.
TEST_F(ConservatismTest, WithoutASimulatorItIsNotMeasured) {
  ::setenv("RTAC_SIM", "/nowhere/rtac-sim", 1);
  const Outcome o = measured(drone_in_a_room);
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  const Json of = Json::parse(o.out)["decisions"][0]["conservatism"][0];
  EXPECT_FALSE(of["measured"].get<bool>()) << of;
  EXPECT_FALSE(of.contains("share")) << of;
}

// Turning, another robot that comes to meet it, agents, and robots that do what they are told; both
// studies' kind of robot.
class ConservatismOf : public ConservatismTest, public testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(
    All, ConservatismOf,
    testing::Values("tests/campaign/specs/templates/brake_unicycle.rta",
                    "tests/campaign/specs/templates/retreat_late.rta",
                    "tests/campaign/specs/templates/command_space.rta", "examples/gate/gate.rta",
                    "examples/one_robot/one_robot.rta", "specs/park_survey/park_survey.rta",
                    "tests/campaign/specs/templates/pair_space.rta",
                    "tests/campaign/specs/pair.rta",
                    "tests/campaign/specs/templates/agents_space.rta",
                    "tests/kernel/agents/strollers.rta", "tests/golden/ahead_command/spec.rta",
                    "tests/golden/space_command/spec.rta",
                    "specs/robot_delivery/robot_delivery.rta"),
    [](const auto& of) {
      const std::filesystem::path path = of.param;
      return (path.stem() == "spec" ? path.parent_path() : path).stem().string();
    });
TEST_P(ConservatismOf, EveryMonitorThatSpeaksOfLengths) {
  const std::string path = std::string(RTAC_SOURCE_DIR) + "/" + GetParam();
  const Outcome o = rtac({"verify", path, "--conservatism", "--format", "json"});
  EXPECT_NE(o.status, exit_violation) << o.out << o.err;
  const Json all = Json::parse(o.out)["decisions"][0]["conservatism"];
  ASSERT_FALSE(all.empty());
  for (const Json& of : all) {
    if (of["monitor"] == "battery") continue;
    ASSERT_TRUE(of["measured"].get<bool>()) << of;
    EXPECT_GE(of["share"].get<double>(), 0.6) << of;
    EXPECT_LE(of["share"].get<double>(), 1) << of;
  }
}

// What forgets the bodies lets two robots touch, and a unicycle leave its zone.
TEST_F(ConservatismTest, UnsoundVariantsOfUnicyclesAndPairsAreRefuted) {
  const std::string path =
      std::string(RTAC_SOURCE_DIR) + "/specs/robot_delivery/robot_delivery.rta";
  const Outcome o =
      rtac({"verify", path, "--conservatism", "--mutate", "no-radius", "--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.err;
  const Json all = Json::parse(o.out)["decisions"][0]["conservatism"];
  EXPECT_GT(all[0]["share"].get<double>(), 1) << all;
  EXPECT_GT(all[1]["share"].get<double>(), 1) << all;
}

// The pilot that brakes by samples that mislead it comes out of the ideal stop, and of a bound that
// forgets its tube.
TEST_F(ConservatismTest, ATubeThatIsForgottenIsRefuted) {
  const std::string path =
      std::string(RTAC_SOURCE_DIR) + "/tests/campaign/specs/templates/retreat_point.rta";
  const Outcome o =
      rtac({"verify", path, "--conservatism", "--mutate", "no-tube", "--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_GT(share(o), 1) << o.out;
}

// What the documentation tells of the gate.
TEST_F(ConservatismTest, OfTheGateIsAsDocumented) {
  const std::string path = std::string(RTAC_SOURCE_DIR) + "/examples/gate/gate.rta";
  const Outcome o = rtac({"verify", path, "--conservatism", "--format", "json"});
  const Json of = Json::parse(o.out)["decisions"][0]["conservatism"][0];
  std::array<char, 120> line{};
  std::snprintf(line.data(), line.size(),
                "conservatism fence  worst found %.3f m of %.3f m (%.2f): %s at %.2f m/s, %.2f s",
                of["found_m"].get<double>(), of["bound_m"].get<double>(), of["share"].get<double>(),
                of["by"].get<std::string>().c_str(), of["speed_mps"].get<double>(),
                of["ahead_s"].get<double>());
  EXPECT_NE(spec_text("compiler/docs/verification.md").find(line.data()), std::string::npos)
      << line.data();
}

// Agents that were thought to stand, and commands whose brake was forgotten.
TEST_F(ConservatismTest, UnsoundVariantsOfAgentsAndCommandsAreRefuted) {
  const std::array<std::pair<const char*, const char*>, 2> all = {
      {{"tests/campaign/specs/templates/agents_space.rta", "agents-stand"},
       {"tests/golden/space_command/spec.rta", "no-stopping-distance"}}};
  for (const auto& [name, mutant] : all) {
    const std::string path = std::string(RTAC_SOURCE_DIR) + "/" + name;
    const Outcome o =
        rtac({"verify", path, "--conservatism", "--mutate", mutant, "--format", "json"});
    EXPECT_EQ(o.status, exit_violation) << name << o.err;
    for (const Json& of : Json::parse(o.out)["decisions"][0]["conservatism"]) {
      EXPECT_GT(of["share"].get<double>(), 1) << of;
    }
  }
}

// Charge is no length: no number is better than a wrong one.
TEST_F(ConservatismTest, ChargeIsNotMeasured) {
  const std::string path =
      std::string(RTAC_SOURCE_DIR) + "/specs/robot_delivery/robot_delivery.rta";
  const Outcome o = rtac({"verify", path, "--conservatism", "--format", "json"});
  for (const Json& of : Json::parse(o.out)["decisions"][0]["conservatism"]) {
    EXPECT_EQ(of["measured"].get<bool>(), of["monitor"] != "battery") << of;
    EXPECT_EQ(of.contains("share"), of["measured"].get<bool>()) << of;
  }
}

TEST_F(ConservatismTest, AsksForSenseOnly) {
  write("spec.rta", drone_in_a_room);
  EXPECT_EQ(rtac({"verify", "spec.rta", "--mutate", "no-radius"}).status, exit_usage);
  EXPECT_EQ(measured(drone_in_a_room, {"--mutate", "nothing-of-the-kind"}).status, exit_usage);
  EXPECT_EQ(rtac({"verify", "--recheck", "certificates", "-o", "elsewhere"}).status, exit_usage);
  EXPECT_EQ(rtac({"verify", "--recheck", "certificates", "--conservatism"}).status, exit_usage);
}

}  // namespace
}  // namespace rtac::driver::test
