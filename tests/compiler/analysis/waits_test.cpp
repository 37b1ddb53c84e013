// What a monitor lets go after: of conditions that all have to come about the hardest one counts,
// of alternatives the easiest, and of what is denied the other way round.
#include "compiler/analysis/waits.h"

#include <gtest/gtest.h>

#include <utility>

namespace rtac::analysis {
namespace {

ir::ValueId add(ir::Block& block, ir::Op op) {
  block.values.push_back({std::move(op), std::nullopt, std::nullopt, {}});
  return block.result = ir::ValueId(block.values.size() - 1);
}
// Of an input, and of what a recovery brings about.
std::string waits_of(bool either, bool denied) {
  ir::Block block;
  const ir::ValueId told = add(block, ir::Fact{0}), led = add(block, ir::Truth{true});
  const ir::ValueId both = either ? add(block, ir::Or{told, led}) : add(block, ir::And{told, led});
  if (denied) add(block, ir::Not{both});
  EXPECT_EQ(waits_for_outsiders(block), !waits_until(block).empty());
  return waits_until(block);
}

TEST(Waits, WhatIsDeniedOfEitherIsDeniedOfBoth) {
  const std::string told = "its inputs allow it";
  EXPECT_EQ(waits_of(false, false), told);
  EXPECT_EQ(waits_of(true, false), "");
  EXPECT_EQ(waits_of(true, true), told);
  EXPECT_EQ(waits_of(false, true), "");
}

}  // namespace
}  // namespace rtac::analysis
