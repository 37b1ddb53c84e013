// Each deliberately unsound decision is violated by the attack that is named for it, and the sound
// one is not, in ten times as many runs.
#include "kills.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <string>
#include <vector>

namespace rtac::campaign {

// Found by its argument: tests are listed with what their parameter prints.
static void PrintTo(const Row& row, std::ostream* out) {
  *out << row.spec;
}

namespace {

constexpr int clean = 0, violation = 3, as_many = 10;

// Where several mutants of one decision die of the same attack, it survives that attack once.
std::vector<Row> sound_rows() {
  std::vector<Row> rows;
  for (const Row& row : kill_table()) {
    const bool again = std::any_of(rows.begin(), rows.end(), [&](const Row& other) {
      return row.runs <= other.runs && std::string(row.spec) == other.spec &&
             std::string(row.adversary) == other.adversary &&
             std::string(row.scenario) == other.scenario;
    });
    if (!again) rows.push_back(row);
  }
  return rows;
}

class Kills : public ::testing::TestWithParam<Row> {};
class Sound : public ::testing::TestWithParam<Row> {};

TEST_P(Kills, TheUnsoundOne) {
  const Row& row = GetParam();
  const Attack a = attack(row, row.mutant, row.runs);
  EXPECT_EQ(a.status, violation) << a.said;
  EXPECT_EQ(a.depth.rfind('-', 0), 0u) << a.depth;
}

TEST_P(Sound, SurvivesWhatKillsItsMutants) {
  const Row& row = GetParam();
  const Attack a = attack(row, "", as_many * row.runs);
  EXPECT_EQ(a.status, clean) << a.said;
}

std::string name_of(const std::string& first, const char* second) {
  std::string name = first + "_" + second;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Table, Kills, ::testing::ValuesIn(kill_table()), [](const auto& info) {
  return name_of(info.param.mutant, info.param.spec);
});
INSTANTIATE_TEST_SUITE_P(Table, Sound, ::testing::ValuesIn(sound_rows()), [](const auto& info) {
  return name_of(info.param.spec, info.param.adversary);
});

}  // namespace
}  // namespace rtac::campaign
