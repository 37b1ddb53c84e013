// tests/slow.txt: the slowest tests, by their names in ctest, which take turns on the integration
// machine (.ci/run).
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

namespace rtac::test {

// Which look for theirs.
inline constexpr const char* programs[] = {"compiler_verify", "compiler_analysis",
                                           "compiler_driver", "compiler_geometry",
                                           "differential",    "temporal"};

// What it names of the tests of a program, and the program does not have: a test that has another
// name now would run every time. And what no program looks for. `label`: what the names of the
// program's tests begin with in ctest.
inline std::set<std::string> slow_tests_gone(const std::string& label) {
  std::set<std::string> gone;
  std::ifstream list(std::string(RTAC_SOURCE_DIR) + "/tests/slow.txt");
  for (std::string name; std::getline(list, name);) {
    const bool is_looked_for = std::ranges::any_of(
        programs, [&](const char* of) { return name.starts_with(std::string(of) + "."); });
    if (name.starts_with(label + ".") || !is_looked_for) gone.insert(name);
  }
  if (gone.empty()) gone.insert(label + ": none is named");
  const auto& unit = *::testing::UnitTest::GetInstance();
  for (int i = 0; i < unit.total_test_suite_count(); ++i) {
    const ::testing::TestSuite& suite = *unit.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k) {
      gone.erase(label + "." + suite.name() + "." + suite.GetTestInfo(k)->name());
    }
  }
  return gone;
}

}  // namespace rtac::test
