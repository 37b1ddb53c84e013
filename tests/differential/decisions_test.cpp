// Random decisions on random traces: what the kernel finds of properties and return conditions
// against what they are on exact numbers. So the facts of decisions, which it judges in a way of
// their own, mean what they mean in monitors without a robot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>

#include "tests/compiler/driver/testing.h"
#include "tests/differential/decisions.h"
#include "tests/differential/fleet_trace.h"

namespace rtac::differential {
namespace {

using driver::test::Outcome;
using driver::test::rtac;

constexpr std::size_t monitors = 16, monitors_min = 10;  // of a decision
constexpr int rows = 400;

class RandomDecisions : public driver::test::InFolder,
                        public ::testing::WithParamInterface<std::uint32_t> {
 protected:
  // Leaves out what the compiler refuses, such as a property that is the same whatever happens.
  void choose() {
    DecisionGenerator generator(GetParam());
    for (std::size_t k = 0; k < monitors; ++k) kept_.push_back(generator.monitor(k));
    for (std::string refused = "-"; !refused.empty();) {
      const DecisionPage page = decision_page(kept_);
      driver::test::write("flock.rta", page.text);
      refused = rtac({"build", "flock.rta", "-o", "generated"}).err;
      if (!remove(refused, page)) refused.clear();
    }
  }
  // False: no monitor has an error.
  bool remove(const std::string& errors, const DecisionPage& page) {
    static const std::regex place("flock\\.rta:([0-9]+):[0-9]+: error");
    std::set<std::size_t> lines;
    for (auto at = std::sregex_iterator(errors.begin(), errors.end(), place);
         at != std::sregex_iterator(); ++at) {
      lines.insert(std::stoul((*at)[1]));
    }
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
      if (*line < page.first_line || *line - page.first_line >= kept_.size()) {
        ADD_FAILURE() << errors;
        return false;
      }
      refused_ += errors;
      kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(*line - page.first_line));
    }
    return !lines.empty();
  }

  void compare(const std::string& column, FindingRow& exact, FindingRow& found) {
    for (const char* const field : {".verdict", ".return"}) {
      const std::string& is = exact[column + field];
      const std::string& verdict = found[column + field];
      ++of_exact_[field + is];
      if (verdict == "unknown") continue;
      ++decided_[field + verdict];
      EXPECT_EQ(is, verdict) << field;
    }
    if (exact[column + ".unit"] != found[column + ".unit"]) return;
    const double margin = std::stod(exact[column + ".margin"]);
    const double below = margin - std::stod(found[column + ".margin"]);
    if (!std::isnan(below)) {
      EXPECT_GT(below, -1e-5 * std::max(1.0, std::abs(margin)));  // six digits are shown
    }
  }
  // Of plain inputs the kernel leaves open only what its rounding leaves open.
  void compare_facts(const std::string& column, FindingRow& exact, FindingRow& found) {
    if (found[column + ".verdict"] == exact[column + ".verdict"]) return;
    EXPECT_LT(std::abs(std::stod(exact[column + ".margin"])), 0.01);
  }
  static bool is_plain(const std::string& line) {
    return std::stoul(line.substr(9)) % 2 == 0;  // of `monitor mK`
  }
  void compare(FindingTable& exact, FindingTable& found) {
    for (std::size_t row = 0; row < exact.size(); ++row) {
      for (const std::string& line : kept_) {
        for (const char* const robot : {"q1.", "q2.", "q3."}) {
          const std::string column = robot + line.substr(8, line.find(' ', 8) - 8);
          SCOPED_TRACE(column + " in row " + std::to_string(row) + ": " + line + "exact " +
                       exact[row][column + ".margin"] + ", found " +
                       found[row][column + ".margin"]);
          compare(column, exact[row], found[row]);
          if (is_plain(line)) compare_facts(column, exact[row], found[row]);
          if (HasFailure()) return;
        }
      }
    }
  }

  std::vector<std::string> kept_;
  std::string refused_;
  std::map<std::string, int> of_exact_, decided_;  // by field and verdict
};

TEST_P(RandomDecisions, AreJudgedConservativelyAndTightly) {
  choose();
  ASSERT_GE(kept_.size(), monitors_min) << refused_;
  driver::test::write("trace.csv", FleetTracer(GetParam()).trace(rows).text);
  const Outcome kernel = rtac({"replay", "flock.rta", "trace.csv"});
  const Outcome reference = rtac({"replay", "flock.rta", "trace.csv", "--engine", "interp"});
  FindingTable found = finding_table(kernel.out), exact = finding_table(reference.out);
  ASSERT_EQ(found.size(), static_cast<std::size_t>(rows)) << kernel.err;
  ASSERT_EQ(exact.size(), found.size()) << reference.err;
  compare(exact, found);
  for (const char* const field : {".verdict", ".return"}) {
    for (const char* const verdict : {"true", "false"}) {
      const std::string key = std::string(field) + verdict;
      EXPECT_GT(of_exact_[key], rows) << key;
      // that robots may have moved since they were seen leaves some open
      EXPECT_GT(decided_[key] * 2, of_exact_[key]) << key;
    }
  }
}

// RTAC_SEEDS=100 tries a hundred others.
std::vector<std::uint32_t> seeds() {
  const char* const more = std::getenv("RTAC_SEEDS");
  if (more == nullptr) return {1, 2, 3, 4};
  std::vector<std::uint32_t> all;
  for (int i = 0; i < std::atoi(more); ++i) all.push_back(1000 + static_cast<std::uint32_t>(i));
  return all;
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomDecisions, ::testing::ValuesIn(seeds()));

}  // namespace
}  // namespace rtac::differential
