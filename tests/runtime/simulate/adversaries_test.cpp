// The list of adversaries is the one that is documented, and each has something to aim at.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "scenario.h"

namespace rtac::simulate {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream in(std::string(RTAC_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Adversaries, AreAllDocumented) {
  const std::string page = text_of("compiler/docs/simulation.md");
  const std::string help = text_of("compiler/driver/help.cpp");
  for (const Adversary& a : adversaries()) {
    EXPECT_NE(page.find("| `" + std::string(a.name) + "` |"), std::string::npos) << a.name;
    EXPECT_NE(help.find("`" + std::string(a.name) + "`"), std::string::npos) << a.name;
  }
}

TEST(Adversaries, AimAtWhatPropertiesSay) {
  DecisionCase fence;
  sim::Property inside;
  inside.op = sim::PropertyOp::inside;
  fence.properties.push_back(inside);
  std::set<std::string> names;
  for (const Adversary* a : applicable(fence)) names.insert(a->name);
  EXPECT_EQ(names.count("chase-fence"), 1u);
  EXPECT_EQ(names.count("push-at-fence"), 0u);  // it takes no turn
  EXPECT_NE(find_adversary("push-at-fence"), nullptr);
  EXPECT_EQ(names.count("chase-robot"), 0u);
  EXPECT_EQ(names.count("drain"), 0u);
}

}  // namespace
}  // namespace rtac::simulate
