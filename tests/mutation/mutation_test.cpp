// The comparison of kernel and reference notices mistakes of the compiler: every seeded one.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/differential/batch.h"
#include "tests/mutation/mutants.h"
#include "tests/turn.h"

namespace rtac::mutation {
namespace {

using differential::Batch;
using differential::load;
using differential::load_verdicts;
using differential::Speed;

// One batch for all mutants of a process: what is found does not depend on them.
const Batch& batch() {
  constexpr std::uint32_t seed = 13;
  constexpr std::size_t formulas = 40, steps = 400;
  static const Batch made(seed, formulas, steps, witnesses());
  return made;
}

TEST(Mutation, NothingIsNoticedInTheKernelItself) {
  ASSERT_EQ(batch().problem(), "");
  const driver::LoadedKernel kernel = load(batch().code());
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const Batch::Result result = batch().compare(*kernel.engine);
  EXPECT_EQ(result.different, 0u) << result.first;
  const driver::LoadedKernel alone = load_verdicts(batch().code());
  ASSERT_NE(alone.engine, nullptr) << alone.problem;
  EXPECT_EQ(batch().disagreement(*kernel.engine, *alone.engine), "");
}

// How many monitors of the batch notice a mistake in the kernel that `load_kernel` loads.
template <class LoadKernel>
void is_noticed(const Mutant& mutant, const LoadKernel& load_kernel) {
  ASSERT_EQ(batch().problem(), "");
  bool matches = false;
  const auto edit = [&](const std::string& text) {
    std::string result = mutated(mutant, text);
    matches = result != text;
    return result;
  };
  const driver::LoadedKernel kernel = load_kernel(batch().code(), edit, Speed::of_building);
  ASSERT_TRUE(matches) << "the kernel has no such text any more";
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const std::size_t noticed = batch().compare(*kernel.engine).different;
  EXPECT_GT(noticed, 0u);
  std::cout << mutant.name << ": noticed by " << noticed << " of " << batch().size()
            << " monitors\n";
}

// Those whose turn it is.
std::vector<Mutant> due(const std::vector<Mutant>& all) {
  std::vector<Mutant> those;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (test::is_due(i)) those.push_back(all[i]);
  }
  return those;
}

class Mutants : public ::testing::TestWithParam<Mutant> {};
TEST_P(Mutants, AreNoticed) {
  is_noticed(GetParam(), load);
}

class VerdictMutants : public ::testing::TestWithParam<Mutant> {};
TEST_P(VerdictMutants, AreNoticed) {
  is_noticed(GetParam(), load_verdicts);
}

INSTANTIATE_TEST_SUITE_P(Compiler, VerdictMutants, ::testing::ValuesIn(due(verdict_mutants())),
                         [](const auto& param) { return std::string(param.param.name); });

INSTANTIATE_TEST_SUITE_P(Compiler, Mutants, ::testing::ValuesIn(due(mutants())),
                         [](const auto& param) { return std::string(param.param.name); });

}  // namespace
}  // namespace rtac::mutation
