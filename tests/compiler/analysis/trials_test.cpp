// How many numbers are tried hangs on what each of them takes by its size, and on no clock.
#include "compiler/analysis/trials.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "compiler/analysis/effort.h"

namespace rtac::analysis {
namespace {

using diag::Code;

constexpr std::int64_t works_from = 700'000;

struct Searched {
  std::optional<std::int64_t> found;
  int runs = 0;
  std::string leaves;  // what is said beside it
};
// A number that has to be `works_from` at least, each trial as dear as that.
Searched searched(std::int64_t effort) {
  Searched s;
  sema::Spec spec;
  std::int64_t number = 1;
  const Fault fault{Code::return_set_empty, {}, 0};
  Trials trials(spec, [&](const Trials::Ask&) {
    ++s.runs;
    Faults faults;
    faults.complete = false;
    faults.effort = effort;
    if (number < works_from) faults.all.insert(fault);
    return faults;
  });
  trials.go_by_reports_alone();
  const Dial dial{"a number", 1, 1'000'000,
                  [&](std::int64_t steps) {
                    number = steps;
                    return true;
                  },
                  [&] { number = 1; }};
  s.found = trials.nearest(dial, 900'000, fault);
  if (s.found) s.leaves = trials.leaves(dial.name, *s.found, fault);
  return s;
}

TEST(Trials, FindTheNearestNumberWhereEachIsCheap) {
  const Searched cheap = searched(1'000);
  EXPECT_EQ(cheap.found, works_from);
  EXPECT_EQ(cheap.leaves, "");
}
TEST(Trials, FindOneThatWorksWhereEachIsDear) {
  const Searched dear = searched(1'500'000);
  EXPECT_EQ(dear.runs, 4);  // as it is written, and three more
  ASSERT_TRUE(dear.found);
  EXPECT_GE(*dear.found, works_from);
  EXPECT_EQ(dear.leaves, " (there was no time to try nearer ones)");
}
TEST(Trials, StopWhereNoneIsInReach) {
  EXPECT_EQ(searched(5'000'000).runs, 2);
}

ir::Module of_a_zone(std::size_t cells, std::size_t edges, bool in_space) {
  ir::Module module;
  module.zones.emplace_back();
  module.zones[0].cells.clearance_mm_lo.resize(cells);
  module.zones[0].edges.resize(edges);
  module.decisions.emplace_back();
  module.decisions[0].body.in_space = in_space;
  module.decisions[0].monitors.emplace_back();
  module.decisions[0].monitors[0].recovery.kind = ir::RecoveryKind::retreat;
  return module;
}
TEST(Effort, IsOfCellsThatRecoveriesDriveOver) {
  const std::int64_t none = effort_of(of_a_zone(0, 4, false), true);
  EXPECT_EQ(effort_of(of_a_zone(20'000, 4, false), true), none + 20'000);
  EXPECT_EQ(effort_of(of_a_zone(20'000, 4, true), true), none);
}
TEST(Effort, IsOfEdgesWhereZonesAreEvaluatedAnew) {
  const auto of = [](std::size_t edges) {
    return effort_of(of_a_zone(20'000, edges, false), false);
  };
  EXPECT_GT(of(400), 10 * of(4) / 9);
  EXPECT_EQ(effort_of(of_a_zone(20'000, 400, false), true),
            effort_of(of_a_zone(20'000, 4, false), true));
}

}  // namespace
}  // namespace rtac::analysis
