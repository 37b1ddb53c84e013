// The predicted share of the advanced controller: cells that are clear enough, of those that the
// body fits into.
#include "compiler/analysis/share.h"

#include <gtest/gtest.h>

namespace rtac::analysis {
namespace {

ir::ZoneTable with_cells(std::vector<std::int32_t> clearance_mm) {
  ir::ZoneTable zone;
  zone.cells.clearance_mm_lo = std::move(clearance_mm);
  return zone;
}

TEST(Share, IsOfThePlacesWhereTheBodyFits) {
  const auto share = share_of(with_cells({-1, 0, 100, 200, 300, 400}), 100, 200, 400);
  ASSERT_TRUE(share);
  EXPECT_EQ(share->any_speed, 75);
  EXPECT_EQ(share->returns, 25);
}
TEST(Share, IsRoundedDown) {
  EXPECT_EQ(share_of(with_cells({100, 200, 300}), 100, 200, 300)->any_speed, 66);
}
TEST(Share, OfAZoneThatNoBodyFitsIntoThereIsNone) {
  EXPECT_FALSE(share_of(with_cells({-1, 0, 50}), 100, 200, 300));
  EXPECT_FALSE(share_of(with_cells({-1, 0}), 0, 0, 0));
}

}  // namespace
}  // namespace rtac::analysis
