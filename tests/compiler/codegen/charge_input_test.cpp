// The battery is an input wherever a property or a return condition asks for it, also where it
// stands beside what is said of other robots: otherwise the charge would count as known, and as 0.
#include <gtest/gtest.h>

#include "compiler/codegen/generate.h"
#include "tests/compiler/analysis/testing.h"

namespace rtac::codegen {
namespace {

using namespace analysis::test;

// The delivery robots, without the monitor of the battery; `handed_back` is their return condition.
bool reads_battery(const std::string& handed_back) {
  std::string text = edited(spec_text("specs/robot_delivery/robot_delivery.rta"),
                            "collision > geofence > battery", "collision > geofence");
  text = edited(text, "acknowledge give_way may break battery", "// ");
  text = edited(text, "return  when clearance(r, free) >= 5 cm for 1 s;", handed_back);
  const auto c = compiled(text);
  if (!c->module) {
    ADD_FAILURE() << reports(*c);
    return false;
  }
  bool found = false;
  for (const GeneratedFile& file : generate(std::move(*c->module), *c->spec, {})) {
    found = found || file.text.find("v->charge = charge_now(") != std::string::npos;
  }
  return found;
}

TEST(ChargeInput, IsReadForWhatIsSaidOfTheRobotItself) {
  EXPECT_TRUE(reads_battery("return when r.battery >= 40 %;"));
}
TEST(ChargeInput, IsReadForWhatIsSaidBesideOtherRobots) {
  EXPECT_TRUE(reads_battery("return when forall q : TurtleBot3, q != r : r.battery < 40 %;"));
}
TEST(ChargeInput, IsNotReadWhenNothingAsksForIt) {
  EXPECT_FALSE(reads_battery("return when clearance(r, free) >= 5 cm;"));
}

}  // namespace
}  // namespace rtac::codegen
