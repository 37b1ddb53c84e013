// The delivery study with `coordinate collision > geofence > battery` in the place of its priority:
// no recovery breaks what another monitor says, and attacks from where robots start violate
// nothing.
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <utility>

#include "study.h"

namespace {

using nlohmann::json;

constexpr int seeds = 4;

std::string said_by(const std::string& command, int& status) {
  std::string said;
  std::FILE* const pipe = popen((command + " 2>/dev/null").c_str(), "r");
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
    said.append(part.data(), n);
  }
  status = pclose(pipe);
  return said;
}
std::string rtac(const std::string& command, const std::string& spec, const std::string& flags,
                 int& status) {
  return said_by("\"" RTAC_PROGRAM "\" " + command + " \"" + spec + "\" " + flags, status);
}
std::string text_of(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}
std::size_t acknowledgements(const json& report) {
  std::size_t count = 0;
  for (const json& d : report["decisions"]) {
    for (const json& o : d["obligations"]) {
      count += o["obligation"] == "C" && o["method"] == "acknowledged";
    }
  }
  return count;
}

// Exit code and report.
const std::pair<int, json>& coordinated() {
  static const std::pair<int, json> once = [] {
    int status = -1;
    json report = json::parse(rtac("verify", SPEC, "--format json", status));
    return std::pair(WEXITSTATUS(status), std::move(report));
  }();
  return once;
}

// One pair by priority, none coordinated; and what is proved instead is proved by coordination.
TEST(Coordinated, NeedsFewerAcknowledgementsOfPairsThanAPriority) {
  int status = -1;
  const json fixed = json::parse(rtac("verify", PRIORITY_SPEC, "--format json", status));
  EXPECT_EQ(status, 0);
  EXPECT_EQ(acknowledgements(fixed), 1u);
  EXPECT_EQ(acknowledgements(coordinated().second), 0u);
  bool found = false;
  for (const json& o : coordinated().second["decisions"][0]["obligations"]) {
    if (o["obligation"] != "C" || o["monitor"] != "battery" || o["recovery"] != "give_way")
      continue;
    found = true;
    EXPECT_EQ(o["status"], "proved");
    EXPECT_EQ(o["method"], "coordination");
  }
  EXPECT_TRUE(found);
}

// What two robots on their ways to their docks cost each other no order of the monitors settles:
// the report says so, with a run.
TEST(Coordinated, IsToldWhatStillHasToBeAcknowledged) {
  EXPECT_EQ(coordinated().first, 3);
  int refuted = 0;
  for (const json& o : coordinated().second["decisions"][0]["obligations"]) {
    if (o["status"] != "refuted") continue;
    ++refuted;
    EXPECT_EQ(o["obligation"], "P2a") << o;
    EXPECT_EQ(o["monitor"], "battery") << o;
    EXPECT_TRUE(o.contains("trace")) << o;
    std::remove(o.value("trace", "").c_str());
  }
  EXPECT_EQ(refuted, 1);
  const std::string text = text_of(SPEC), order = "coordinate collision > geofence > battery;";
  const std::size_t at = text.find(order);
  ASSERT_NE(at, std::string::npos);
  const std::string accepted = std::string(SPEC) + ".accepted.rta";
  std::ofstream(accepted) << text.substr(0, at + order.size())
                          << " acknowledge go_charge may break battery \"staff part them\";"
                          << text.substr(at + order.size());
  int status = -1;
  rtac("verify", accepted, "", status);
  EXPECT_EQ(status, 0);
}

// Whoever drives them, and however they measure.
TEST(Coordinated, IsAttackedInVain) {
  int status = -1;
  const std::string said = rtac("sim", SPEC, "--runs 40 --seed 1", status);
  EXPECT_EQ(status, 0) << said;
}

class CoordinatedShifts : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shifts_ = study::run("--seeds " + std::to_string(seeds), "coordinated");
  }
  static void TearDownTestSuite() { shifts_ = json(); }
  template <class Check>
  static void for_robots(const Check& check) {
    ASSERT_EQ(shifts_.size(), static_cast<std::size_t>(seeds));
    for (const json& shift : shifts_) {
      for (const json& robot : shift["robots"]) {
        SCOPED_TRACE("seed " + shift["seed"].dump() + ": " + robot.dump());
        check(robot);
      }
    }
  }
  static json shifts_;
};
json CoordinatedShifts::shifts_;

TEST_F(CoordinatedShifts, ViolateNothing) {
  for_robots([](const json& robot) {
    EXPECT_GE(robot["clearance_m"].get<double>(), 0.0);
    EXPECT_GE(robot["gap_m"].get<double>(), 0.08);
    EXPECT_GE(robot["battery_margin"].get<double>(), 0.0);
  });
}

TEST_F(CoordinatedShifts, DeliverTenParcelsPerRobot) {
  for_robots([](const json& robot) { EXPECT_GE(robot["deliveries"].get<int>(), 10); });
}

TEST_F(CoordinatedShifts, NeverStandStillForAMinute) {
  for_robots([](const json& robot) { EXPECT_LE(robot["longest_idle_s"].get<double>(), 60.0); });
}

// The case that the two orders differ in: the battery engages while another monitor is engaged.
TEST_F(CoordinatedShifts, TheBatteryIsCaredForInCompany) {
  int meanwhile = 0;
  for_robots([&](const json& robot) { meanwhile += robot["engaged_meanwhile"][2].get<int>(); });
  EXPECT_GT(meanwhile, 0);
}

}  // namespace
