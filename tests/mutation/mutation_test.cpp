// The comparison of kernel and reference notices mistakes of the compiler: every seeded one.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/differential/batch.h"
#include "tests/mutation/mutants.h"

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
}

class Mutants : public ::testing::TestWithParam<Mutant> {};

TEST_P(Mutants, AreNoticed) {
  ASSERT_EQ(batch().problem(), "");
  bool matches = false;
  const driver::LoadedKernel kernel = load(
      batch().code(),
      [&](const std::string& text) {
        std::string result = mutated(GetParam(), text);
        matches = result != text;
        return result;
      },
      Speed::of_building);
  ASSERT_TRUE(matches) << "the kernel has no such text any more";
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const std::size_t noticed = batch().compare(*kernel.engine).different;
  EXPECT_GT(noticed, 0u);
  std::cout << GetParam().name << ": noticed by " << noticed << " of " << batch().size()
            << " monitors\n";
}

class VerdictMutants : public ::testing::TestWithParam<Mutant> {};

TEST_P(VerdictMutants, AreNoticed) {
  ASSERT_EQ(batch().problem(), "");
  bool matches = false;
  const driver::LoadedKernel kernel = load_verdicts(
      batch().code(),
      [&](const std::string& text) {
        std::string result = mutated(GetParam(), text);
        matches = result != text;
        return result;
      },
      Speed::of_building);
  ASSERT_TRUE(matches) << "the kernel has no such text any more";
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  EXPECT_GT(batch().compare(*kernel.engine).different, 0u);
}

INSTANTIATE_TEST_SUITE_P(Compiler, VerdictMutants, ::testing::ValuesIn(verdict_mutants()),
                         [](const auto& param) { return std::string(param.param.name); });

INSTANTIATE_TEST_SUITE_P(Compiler, Mutants, ::testing::ValuesIn(mutants()),
                         [](const auto& param) { return std::string(param.param.name); });

}  // namespace
}  // namespace rtac::mutation
