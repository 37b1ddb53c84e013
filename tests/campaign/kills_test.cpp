// Each deliberately unsound decision is violated by the attack that is named for it, and the sound
// one is not, in ten times as many runs.
#include "kills.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

namespace rtac::campaign {
namespace {

constexpr int clean = 0, violation = 3, as_many = 10;

class Kills : public ::testing::TestWithParam<Row> {};

TEST_P(Kills, TheUnsoundOne) {
  const Row& row = GetParam();
  const Attack a = attack(row, row.mutant, row.runs);
  EXPECT_EQ(a.status, violation) << a.said;
  EXPECT_EQ(a.depth.rfind('-', 0), 0u) << a.depth;
}

TEST_P(Kills, NotTheSoundOne) {
  const Row& row = GetParam();
  const Attack a = attack(row, "", as_many * row.runs);
  EXPECT_EQ(a.status, clean) << a.said;
}

std::string name_of(const ::testing::TestParamInfo<Row>& info) {
  std::string name = std::string(info.param.mutant) + "_" + info.param.spec;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Table, Kills, ::testing::ValuesIn(kill_table()), name_of);

}  // namespace
}  // namespace rtac::campaign
