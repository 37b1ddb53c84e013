// Random formulas on random runs: the margins of the generated kernel contain those of the
// reference, and are wider by no more than the bound that the compiler derives. So truth values and
// the past are equal, arithmetic is never more certain than it may be, and tight.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/differential/batch.h"

namespace rtac::differential {
namespace {

constexpr std::size_t formulas_min = 200;  // of a kernel
constexpr std::size_t formulas = 260;
constexpr std::size_t steps = 120;

// In some monitor of every kernel, so that none of it is refused wherever it occurs.
constexpr const char* words[] = {
    "forall",  "exists",      "count(bot", "min(bot",     "max(bot",    "!= two",  "one.",
    "bots[1]", "bot",         "param h",   "margin full", "1100 s",     "rotate(", "transform(",
    "inside",  "clearance",   "shrink(",   "t[0]",        "max(t)",     "== park", "far(",
    "twice(",  "let ",        "then",      " since[",     " within ",   " for ",   "historically",
    "once[",   "previously ", "mean[",     "sum[",        "count[",     "rate[",   "age(",
    "sqrt(",   "cross(",      "dot(",      "clamp(",      "complement("};

class RandomFormulas : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomFormulas, AreJudgedConservativelyAndTightly) {
  const Batch batch(GetParam(), formulas, steps);
  ASSERT_EQ(batch.problem(), "");
  ASSERT_GE(batch.size(), formulas_min) << batch.refused();
  // the first one as it is built for robots
  const Speed speed = GetParam() == 1 ? Speed::of_steps : Speed::of_building;
  const driver::LoadedKernel loaded = load(batch.code(), {}, speed);
  ASSERT_NE(loaded.engine, nullptr) << loaded.problem;
  const Batch::Result result = batch.compare(*loaded.engine);
  for (const char* const word : words) {
    const bool has_some =
        std::any_of(batch.monitors().begin(), batch.monitors().end(),
                    [&](const std::string& line) { return line.find(word) != std::string::npos; });
    EXPECT_TRUE(has_some) << "no monitor with " << word << "\n" << batch.refused();
  }
  EXPECT_EQ(result.different, 0u) << result.first;
  // Neither the formulas nor the run are trivial.
  for (const std::size_t count : {result.yes, result.no, result.unknown}) {
    EXPECT_GT(count, formulas * steps / 10);
  }
  EXPECT_GT(result.margins, formulas * steps / 10);
  EXPECT_GT(result.rounded, result.margins / 10);
  // The bounds are no excuse: many of them are reached.
  EXPECT_GT(result.sharp, formulas / 10);
  // The entry that tells verdicts alone computes them in another way, without margins: it finds the
  // same at every step.
  const driver::LoadedKernel alone = load_verdicts(batch.code(), {}, Speed::of_building);
  ASSERT_NE(alone.engine, nullptr) << alone.problem;
  EXPECT_EQ(batch.disagreement(*loaded.engine, *alone.engine), "");
}

// What the reference is given is what the rules of inputs and ticks are about.
TEST(RandomRuns, HaveEveryKindOfTrouble) {
  std::mt19937 random(1);
  Troubles troubles;
  sema::Param param;
  param.most.value = 1;
  param.tightens = 1;
  random_run(random, steps, signals(), {param, param, param}, troubles);
  for (const std::size_t count :
       {troubles.not_a_number, troubles.missing, troubles.old, troubles.future, troubles.backwards,
        troubles.out_of_range, troubles.at_limit, troubles.missed_ticks, troubles.forgotten,
        troubles.twice, troubles.tightened, troubles.loosened, troubles.beyond_range}) {
    EXPECT_GT(count, 0u);
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
INSTANTIATE_TEST_SUITE_P(Seeds, RandomFormulas, ::testing::ValuesIn(seeds()));

}  // namespace
}  // namespace rtac::differential
