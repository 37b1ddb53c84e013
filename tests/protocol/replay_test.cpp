// The model is true to the generated code: whatever a kernel was given and has found, the rules of
// the model engage the same monitors and let the same controller drive, for the same reason.
#include <array>
#include <map>
#include <random>

#include "tests/protocol/checker.h"
#include "tests/protocol/walks.h"
// NOLINTBEGIN(misc-include-cleaner)
#include "tests/golden/drone_surveillance/expected/generated/drone_surveillance_kernel.h"
#include "tests/golden/robot_delivery/expected/generated/robot_delivery_kernel.h"
#include "tests/golden/shared_recovery/expected/generated/spec_kernel.h"
#undef SPEC_KERNEL_H  // two cases, two prefixes, one name of files
#include "tests/golden/fleet_of_three/expected/generated/spec_kernel.h"
// NOLINTEND(misc-include-cleaner)
#include "alike_kernel.h"

namespace rtac::protocol::test {
namespace {

constexpr int ticks = 300;
constexpr unsigned walks = 6;

struct Subject {
  std::string spec, decision;
  std::vector<Row> (*walk)(unsigned seed);
};

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = {
      {"specs/robot_delivery/robot_delivery.rta", "plan_executor",
       [](unsigned seed) {
         return walk(robot_delivery_plan_executor_init, robot_delivery_plan_executor_step, 100'000,
                     {4'000, 2'000, 500, 4'500, 5'000}, ticks, seed);
       }},
      {"specs/drone_surveillance/drone_surveillance.rta", "plan_executor",
       [](unsigned seed) {
         return walk(drone_surveillance_plan_executor_init, drone_surveillance_plan_executor_step,
                     50'000, {2'500, 2'500, 500, 500, 5'000}, ticks, seed);
       }},
      {"tests/golden/shared_recovery/spec.rta", "fly",
       [](unsigned seed) {
         return walk(shared_recovery_fly_init, shared_recovery_fly_step, 50'000,
                     {2'500, 2'500, 500, 500, 5'000}, ticks, seed);
       }},
      {"tests/protocol/alike.rta", "drive",
       [](unsigned seed) {
         return walk(alike_drive_init, alike_drive_step, 100'000, {3'000, 3'000, 500, 500, 10'000},
                     ticks, seed);
       }},
      {"tests/golden/fleet_of_three/spec.rta", "drive",
       [](unsigned seed) {
         return walk(fleet_of_three_drive_init, fleet_of_three_drive_step, 100'000,
                     {4'000, 4'000, 7'000, 7'000, 8'000}, ticks, seed);
       }},
  };
  return all;
}

// Compiled once.
const std::string& rules_of(const Subject& s) {
  static std::map<std::string, std::string> all;
  std::string& rules = all[s.spec];
  if (rules.empty()) {
    const ir::Decision d = decision_of(s.spec, s.decision);
    rules = model_of(d, assumed(d)).rules;
  }
  return rules;
}
std::string replayed(const std::string& rules, const std::vector<Row>& rows) {
  const Folder folder;
  folder.write("m.pml", rules + recorded(rows));
  return folder.run("spin -T -B m.pml");
}
const std::string agrees = std::to_string(ticks) + " TICKS AGREE";

TEST(Replay, TheModelDecidesAsTheKernelsDo) {
  for (const Subject& s : subjects()) {
    const std::string rules = rules_of(s);
    for (unsigned seed = 1; seed <= walks; ++seed) {
      const std::string said = replayed(rules, s.walk(seed));
      ASSERT_NE(said.find(agrees), std::string::npos) << s.spec << " " << seed << "\n" << said;
    }
  }
}

// What the walks lead through: every way to take over and to give back, else they would show
// little.
TEST(Replay, TheWalksLeadThroughEveryRule) {
  std::array<int, 12> reasons{};
  int preempted = 0, lower = 0, back = 0, promised = 0, gaps = 0, again = 0, open = 0;
  for (const Subject& s : subjects()) {
    for (unsigned seed = 1; seed <= walks; ++seed) {
      int before = 0;
      for (const Row& row : s.walk(seed)) {
        ++reasons[static_cast<std::size_t>(row.reason)];
        preempted += row.mode != 0 && row.mode < before;
        lower += before != 0 && row.mode > before;
        back += before != 0 && row.mode == 0;
        gaps += std::string(row.step) == "missed";
        again += std::string(row.step) == "again";
        const bool engaged = row.mode != 0 && row.found[std::size_t(row.mode) - 1].engaged;
        promised += row.mode != 0 && !engaged && !row.surrender;
        open += row.promised && row.mode != 0;
        before = row.mode;
      }
    }
  }
  for (const int reason : {0, 1, 3, 4, 5, 6, 7, 8, 10}) {
    EXPECT_GT(reasons[static_cast<std::size_t>(reason)], 0) << reason;
  }
  for (const int count : {preempted, lower, back, promised, gaps, again, open}) EXPECT_GT(count, 5);
}

// A model with a mistake is not the protocol of these kernels any more.
TEST(Replay, MistakesInTheModelAreFound) {
  const std::vector<std::array<std::string, 2>> mistakes = {
      {"highest < MONITORS && !engaged[highest]", "highest < MONITORS && engaged[highest]"},
      {"dwell[m] > DWELLS", "dwell[m] > DWELLS + 1"},
      {"dwell[m] > DWELLS", "dwell[m] >= DWELLS"},
      {"violated && (step == missed || !clear) ->", "violated && !clear ->"},
      {"(step == missed || !(safer && gives_back))", "!(safer && gives_back)"},
      {"(step == missed || !(safer && gives_back))", "(step == missed || !safer)"},
      {"(step == missed || !(safer && gives_back))", "(step == missed || !gives_back)"},
      {"&& step == again && safer", "&& step == starting && safer"},
      {":: first && safer -> engaged[m] = 0", ":: first && safer -> engaged[m] = 1"},
      {"highest == NOBODY && surrender -> mode = SURRENDERS_TO",
       "highest == NOBODY && surrender -> mode = 0"},
      {"before != 0 && open != NOBODY", "before != 0 && open == MONITORS + 1"},
      {"mode = (promised -> before : 0)", "mode = 0"},
      {"mode != 0 && mode == before && holding", "mode != 0 && holding"},
      {"-> promised = 1", "-> promised = 0"},
      {"!first && engaged[m] && violated -> engage(m, violation)",
       "!first && engaged[m] && violated -> engage(m, returning)"},
      {"drives[driver] = 0", "drives[mode] = 0"},
  };
  for (const auto& [from, to] : mistakes) {
    bool found = false;
    for (const Subject& s : subjects()) {
      std::string rules = planted(rules_of(s), from, to);
      for (unsigned seed = 1; seed <= walks && !found; ++seed) {
        found = replayed(rules, s.walk(seed)).find(agrees) == std::string::npos;
      }
      if (found) break;
    }
    EXPECT_TRUE(found) << from << " => " << to;
  }
}

// Nor is one that chooses otherwise the one of the kernel that coordinates.
TEST(Replay, MistakesInTheCoordinationAreFound) {
  const std::vector<std::array<std::string, 2>> mistakes = {
      {"length > longest ||", "length < longest ||"},
      {"kept = (SHOWN(i, j) == 2)", "kept = (SHOWN(i, j) != 0)"},
      {"SHOWN(i, j) != 0 -> kept = 1", "SHOWN(i, j) == 2 -> kept = 1"},
      {"FITS(row, m) = (clear && !engaged[m])", "FITS(row, m) = 0"},
      {"false_now[m] = violated", "false_now[m] = 0"},
  };
  const Subject* alike = nullptr;
  for (const Subject& s : subjects()) {
    if (s.spec == "tests/protocol/alike.rta") alike = &s;
  }
  ASSERT_NE(alike, nullptr);
  for (const auto& [from, to] : mistakes) {
    const std::string rules = planted(rules_of(*alike), from, to);
    bool found = false;
    for (unsigned seed = 1; seed <= 4 * walks && !found; ++seed) {
      found = replayed(rules, alike->walk(seed)).find(agrees) == std::string::npos;
    }
    EXPECT_TRUE(found) << from << " => " << to;
  }
}

// Of plans: the advanced planner's is taken where no monitor refuses it, and the highest that does
// is the one that decides.
TEST(Replay, PlansAreJudgedAsTheModelSays) {
  std::mt19937 random(5);
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    robot_delivery_plan plan{};
    plan.valid = random() % 10 != 0;
    plan.count = static_cast<int>(random() % 4);
    for (int k = 0; k < plan.count; ++k) {
      plan.x[k] = static_cast<int>(random() % 5'000);
      plan.y[k] = static_cast<int>(random() % 5'000);
    }
    robot_delivery_motion_planner_out out{};
    robot_delivery_motion_planner_judge(&plan, &out);
    const bool passes = out.monitors[0].now == ROBOT_DELIVERY_VERDICT_TRUE;
    ASSERT_EQ(out.mode, passes ? 0 : 1);
    ASSERT_EQ(out.monitor, passes ? -1 : 0);
    refused += !passes;
  }
  EXPECT_GT(refused, 50);
  EXPECT_LT(refused, 450);
}

// A kernel that decides otherwise is found, too: here one that is one tick late, once.
TEST(Replay, ARecordOfAnotherKernelIsRefused) {
  const Subject& s = subjects().front();
  std::vector<Row> rows = s.walk(1);
  for (std::size_t t = 1; t < rows.size(); ++t) {
    if (rows[t - 1].mode != 0 || rows[t].mode == 0) continue;
    rows[t].mode = 0;
    break;
  }
  EXPECT_NE(replayed(rules_of(s), rows).find("DIFFERS"), std::string::npos);
}

}  // namespace
}  // namespace rtac::protocol::test
