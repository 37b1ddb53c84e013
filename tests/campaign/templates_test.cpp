// Every template with every model of motion: 2,000 attacks each, and no property fails. Where tests
// take turns (tests/turn.h), an eighth of those for the ones whose turn it is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "kills.h"
#include "tests/turn.h"

namespace rtac::campaign {
namespace {

// Each specification of the folder; what they share has no decision.
std::vector<std::string> specs() {
  std::vector<std::string> names;
  for (const auto& file :
       std::filesystem::directory_iterator(std::string(RTAC_CAMPAIGN_SPECS) + "/templates")) {
    const std::string stem = file.path().stem().string();
    if (file.path().extension() == ".rta" && stem.find('_') != std::string::npos) {
      names.push_back(stem);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Templates : public ::testing::TestWithParam<std::string> {};

TEST_P(Templates, SurviveTwoThousandAttacks) {
  const std::string spec = "templates/" + GetParam();
  const std::string motion = GetParam().substr(GetParam().rfind('_') + 1);
  std::string scenario = spec + ".json";  // its own, or else that of its motion
  if (!std::filesystem::exists(std::string(RTAC_CAMPAIGN_SPECS) + "/" + scenario)) {
    scenario = "templates/" + motion + ".json";
  }
  const Row row{"template", spec.c_str(), "", 0, scenario.c_str()};
  const std::vector<std::string> all = specs();
  const auto number = std::find(all.begin(), all.end(), GetParam()) - all.begin();
  const Attack a = attack(row, "", test::is_due(static_cast<std::size_t>(number)) ? 2000 : 250);
  EXPECT_EQ(a.status, 0) << a.said;
  EXPECT_NE(a.said.find("\nall "), std::string::npos) << a.said;
}

// Nothing about them is unknown. By turns (tests/turn.h).
TEST(TemplatesAtOnce, AreProvedOrAcknowledged) {
  std::size_t number = 0;
  for (const std::string& name : specs()) {
    if (!test::is_due(number++)) continue;
    const std::string path = std::string(RTAC_CAMPAIGN_SPECS) + "/templates/" + name + ".rta";
    const std::string command =
        std::string("'") + RTAC_PROGRAM + "' verify '" + path + "' >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << name;
  }
  EXPECT_GT(number, 40U);
}

INSTANTIATE_TEST_SUITE_P(All, Templates, ::testing::ValuesIn(specs()),
                         [](const auto& named) { return named.param; });

}  // namespace
}  // namespace rtac::campaign
