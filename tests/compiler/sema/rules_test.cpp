// Each rule of the checker: one mistake in a good specification gives exactly that report, at its
// place, with what would work; and every code of names and types has a rule here.
#include <set>

#include "tests/compiler/sema/rules_frames.h"
#include "tests/compiler/sema/rules_heights.h"
#include "tests/compiler/sema/rules_mistakes.h"
#include "tests/compiler/sema/rules_monitors.h"
#include "tests/compiler/sema/rules_names.h"
#include "tests/compiler/sema/rules_openings.h"
#include "tests/compiler/sema/rules_properties.h"
#include "tests/compiler/sema/rules_quantities.h"
#include "tests/compiler/sema/rules_robots.h"
#include "tests/compiler/sema/rules_signals.h"
#include "tests/compiler/sema/rules_values.h"
#include "tests/compiler/sema/rules_windows.h"
#include "tests/compiler/sema/rules_zones.h"

namespace rtac::sema::test {
namespace {

std::vector<Rule> all_rules() {
  std::vector<Rule> all;
  for (auto& part :
       {rules_of_names(), rules_of_quantities(), rules_of_zones(), rules_of_clauses(),
        rules_of_controllers(), rules_of_properties(), rules_of_monitors(), rules_of_decisions(),
        rules_of_signals(), rules_of_watches(), rules_of_values(), rules_of_functions(),
        rules_of_windows(), rules_of_robots_and_time(), rules_of_habits(), rules_of_limits(),
        rules_of_frames(), rules_of_openings(), rules_of_heights()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

// The reports of the severity that the rule is about: an unsound look-ahead that is wrong in
// another way still gives its warning.
std::vector<diag::Diagnostic> reports_of(const Checked& checked, const Rule& rule) {
  std::vector<diag::Diagnostic> found;
  for (const diag::Diagnostic& each : checked.engine.all()) {
    if (diag::info(each.code).severity == diag::info(rule.code).severity) found.push_back(each);
  }
  return found;
}

class SemaRule : public testing::TestWithParam<Rule> {};

TEST_P(SemaRule, ReportsOneMistakeOnce) {
  const Rule& rule = GetParam();
  const std::string text = edited(rule.base(), rule.changes);
  const auto checked = check_text(text);
  const auto reports = reports_of(*checked, rule);
  ASSERT_EQ(reports.size(), 1u) << checked->reports();
  const diag::Diagnostic& report = reports.front();
  EXPECT_EQ(report.code, rule.code) << checked->reports();
  ASSERT_TRUE(report.range.has_value());
  EXPECT_EQ(checked->sources.text(*report.range), rule.at) << checked->reports();
  EXPECT_NE(report.message.find(rule.message), std::string::npos) << report.message;
  EXPECT_NE(report.help.find(rule.help), std::string::npos) << report.help;
  EXPECT_FALSE(report.label.empty());
  const bool error = diag::info(rule.code).severity == diag::Severity::error;
  EXPECT_EQ(checked->spec.has_value(), !error);
}

TEST_P(SemaRule, FixesGiveAGoodSpecification) {
  const Rule& rule = GetParam();
  const std::string text = edited(rule.base(), rule.changes);
  const auto checked = check_text(text);
  const auto reports = reports_of(*checked, rule);
  ASSERT_EQ(reports.size(), 1u) << checked->reports();
  if (!rule.fix) return;
  ASSERT_FALSE(reports.front().fixits.empty());
  const std::string repaired = fixed(text, reports.front());
  const auto again = check_text(repaired);
  EXPECT_FALSE(again->engine.has_errors()) << again->reports() << repaired;
}

INSTANTIATE_TEST_SUITE_P(All, SemaRule, testing::ValuesIn(all_rules()),
                         [](const auto& rule) { return rule.param.name; });

// A code without a rule is a code that nobody tests.
TEST(SemaRules, CoverEveryCodeOfNamesAndTypes) {
  std::set<diag::Code> covered;
  for (const Rule& rule : all_rules()) covered.insert(rule.code);
  for (const diag::CodeInfo& code : diag::all_codes()) {
    const int number = static_cast<int>(code.code);
    if (number < 2000 || number >= 4000) continue;
    EXPECT_EQ(covered.count(code.code), 1u) << number << " " << code.name;
  }
}

}  // namespace
}  // namespace rtac::sema::test
