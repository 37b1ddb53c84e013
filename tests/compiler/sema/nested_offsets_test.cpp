// How many of `shrink` and `grow` lie within one another.
#include "compiler/sema/nested_offsets.h"

#include <gtest/gtest.h>

#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

// Of the zones whose value is an offset, in order.
std::vector<std::size_t> nested(const std::string& zones) {
  const auto checked =
      check_text("spec s;\nperiod 1 s;\nzone z = circle (0 m, 0 m) radius 9 m;\n" + zones +
                 "input p : point;\n" + "monitor m { \"R1: in\" always p inside z; }\n");
  std::vector<std::size_t> found;
  if (!checked->spec) ADD_FAILURE() << checked->reports();
  if (!checked->spec) return found;
  const NestedOffsets offsets(*checked->spec);
  for (const Zone& zone : checked->spec->zones) {
    const auto* offset = std::get_if<ZoneOffset>(&zone.value->node);
    if (offset != nullptr) found.push_back(offsets.with(*offset));
  }
  return found;
}
using Counts = std::vector<std::size_t>;

TEST(NestedOffsets, OneIsAlone) {
  EXPECT_EQ(nested("zone a = grow(z, 1 m);\nzone b = shrink(z | z, 1 m);\n"), (Counts{1, 1}));
}
TEST(NestedOffsets, CountInsideAndAround) {
  EXPECT_EQ(nested("zone a = grow(shrink(grow(z, 1 m), 1 m) - shrink(z, 1 m), 1 m);\n"),
            (Counts{3}));
  // by name: a lies in b, b lies in c; d is in none of them
  EXPECT_EQ(nested("zone a = grow(z, 1 m);\nzone b = grow(z - a, 1 m);\n"
                   "zone c = grow(b & a, 1 m);\nzone d = grow(z, 1 m);\n"),
            (Counts{3, 3, 3, 1}));
}
TEST(NestedOffsets, CountThroughComplementsAndInAnyOrder) {
  EXPECT_EQ(nested("zone b = grow(complement(a), 1 m);\nzone a = grow(z, 1 m);\n"), (Counts{2, 2}));
}

}  // namespace
}  // namespace rtac::sema::test
