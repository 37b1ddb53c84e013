// The library of specifications checks clean; only the paper's mode gives warnings, the unsound
// ones that it declares.
#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

std::unique_ptr<Checked> check_spec(const std::string& path) {
  Checked start;
  std::string why;
  const auto root = start.sources.load(std::string(RTAC_SOURCE_DIR) + "/specs/" + path, why);
  EXPECT_TRUE(root) << path << ": " << why;
  return root ? check_file(std::move(start), *root) : nullptr;
}

TEST(Specs, CheckCleanInTheSoundMode) {
  for (const char* path :
       {"robot_delivery/robot_delivery.rta", "drone_surveillance/drone_surveillance.rta",
        "drone_surveillance/drone_sound_1.rta", "park_survey/park_survey.rta"}) {
    const auto checked = check_spec(path);
    ASSERT_TRUE(checked);
    EXPECT_TRUE(checked->engine.all().empty()) << path << "\n" << checked->reports();
    EXPECT_TRUE(checked->spec);
  }
}

TEST(Specs, WarnInThePapersMode) {
  for (const char* path :
       {"drone_surveillance/drone_paper_1.rta", "drone_surveillance/drone_paper_2.rta"}) {
    const auto checked = check_spec(path);
    ASSERT_TRUE(checked);
    ASSERT_TRUE(checked->spec) << checked->reports();
    EXPECT_EQ(checked->engine.all().size(), 2u) << checked->reports();
    for (const diag::Diagnostic& each : checked->engine.all()) {
      EXPECT_EQ(each.code, diag::Code::unsound_lookahead) << checked->reports();
    }
    const Ahead& ahead = checked->spec->monitors.front().ahead;
    EXPECT_TRUE(ahead.waypoints_only && ahead.points_only);
    EXPECT_FALSE(ahead.duration);
    EXPECT_EQ(ahead.unsound_reason, "the paper's decision module");
  }
}

TEST(Specs, DeliveryMeansWhatItSays) {
  const auto checked = check_spec("robot_delivery/robot_delivery.rta");
  ASSERT_TRUE(checked && checked->spec);
  const std::string text = dump(*checked->spec);
  for (const char* line : {
           "robot r1 : TurtleBot3\n",
           "site dock(r2) = (2, 2)\n",
           "  always (forall other : (distance(self, other) >= 0.08 m))\n",
           "  always (self.battery >= (energy_to(dock(self)) + 5 %))\n",
           "  always (self.plan inside shrink(free, 0.26))\n",
           "  return when ((clearance(self, free) >= 0.05 m) for 1 s)\n",
           "  priority collision > geofence > battery\n",
           "  on plan\n",
       }) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
}

}  // namespace
}  // namespace rtac::sema::test
