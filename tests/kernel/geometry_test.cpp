// The distances of the kernel, against exact fractions: never above the true distance, and close
// below it. Inputs are random and adversarial, from millimetres up to the extent of 537 km.
#include <gtest/gtest.h>

#include "tests/kernel/exact.h"

namespace rtac::kernel_test {
namespace {

// At most this far below, in mm, for sizes up to the extent: one unit each from the root, from the
// direction in Q30 and from rounding down.
constexpr std::int64_t slack_mm = 3;
constexpr std::int64_t slack_near_mm = 2;
constexpr std::int64_t near_mm = 1 << 20;  // 1 km

std::int64_t slack_for(std::int64_t size) {
  return size <= near_mm ? slack_near_mm : slack_mm;
}
std::int64_t random_size(Random& random) {
  return std::int64_t{1} << random.in(1, 29);
}

TEST(PointSegment, IsBelowTheDistanceAndClose) {
  Random random(11);
  for (int i = 0; i < 100'000; ++i) {
    const std::int64_t size = random_size(random);
    const probe_vec p = random.point(size), a = random.point(size), b = random.point(size);
    const std::int64_t lower = probe_point_segment_lo(p, a, b);
    ASSERT_TRUE(bounds_from_below(lower, slack_for(size), {point_segment(p, a, b)}));
  }
}

TEST(PointSegment, IsCloseForShortSegmentsSeenFromAfar) {
  // The length of a segment of a few mm is rounded up: relative to it that is a large error.
  Random random(12);
  for (int i = 0; i < 50'000; ++i) {
    const probe_vec a = random.point(1'000'000), d = random.point(5);
    const probe_vec b = {a.x + d.x, a.y + d.y}, p = random.point(near_mm);
    const std::int64_t lower = probe_point_segment_lo(p, a, b);
    ASSERT_TRUE(bounds_from_below(lower, slack_near_mm, {point_segment(p, a, b)}));
  }
}

TEST(PointSegment, OfASinglePointIsTheDistanceOfPoints) {
  Random random(13);
  for (int i = 0; i < 20'000; ++i) {
    const probe_vec a = random.point(random_size(random)), p = random.point(random_size(random));
    ASSERT_TRUE(bounds_from_below(probe_point_segment_lo(p, a, a), 1, {point_segment(p, a, a)}));
  }
}

TEST(PointSegment, IsZeroOnTheSegmentAndNotBeyondOneUnitOff) {
  Random random(14);
  for (int i = 0; i < 20'000; ++i) {
    const probe_vec a = random.point(1'000), d = random.point(1'000);
    const std::int64_t k = random.in(0, 7);
    const probe_vec b = {a.x + 7 * d.x, a.y + 7 * d.y}, p = {a.x + k * d.x, a.y + k * d.y};
    ASSERT_EQ(probe_point_segment_lo(p, a, b), 0);
    ASSERT_LE(probe_point_segment_lo({p.x + 1, p.y}, a, b), 1);
  }
}

TEST(SegmentGap, IsBelowTheDistanceAndClose) {
  Random random(15);
  for (int i = 0; i < 100'000; ++i) {
    const std::int64_t size = random_size(random);
    const probe_vec a = random.point(size), b = random.point(size);
    const probe_vec c = random.point(size), d = random.point(size);
    ASSERT_TRUE(bounds_from_below(probe_segment_gap_lo(a, b, c, d), slack_for(size),
                                  segment_gaps(a, b, c, d)));
  }
}

TEST(SegmentGap, IsRightForTouchingCollinearAndDegenerateSegments) {
  // Small coordinates make shared end points, overlaps on a line and single points frequent.
  Random random(16);
  for (int i = 0; i < 100'000; ++i) {
    const std::int64_t size = random.in(1, 4);
    const probe_vec a = random.point(size), b = random.point(size);
    const probe_vec c = random.point(size), d = random.point(size);
    ASSERT_TRUE(bounds_from_below(probe_segment_gap_lo(a, b, c, d), 1, segment_gaps(a, b, c, d)));
  }
}

// Where the answers are delicate: at vertices, on edges, one unit beside them, level with vertices.
probe_vec delicate_point(Random& random, const probe_zone& z, std::int64_t size) {
  const probe_edge& e = z.edges[random.in(0, z.count - 1)];
  const probe_edge& f = z.edges[random.in(0, z.count - 1)];
  switch (random.in(0, 4)) {
    case 0:
      return {e.ax + random.in(-1, 1), e.ay + random.in(-1, 1)};
    case 1: {
      const std::int64_t k = random.in(0, 16);
      return {e.ax + (e.bx - e.ax) * k / 16 + random.in(-1, 1),
              e.ay + (e.by - e.ay) * k / 16 + random.in(-1, 1)};
    }
    case 2:
      return {e.ax, f.ay};
    case 3:
      return {random.in(-size, size), e.ay};
    default:
      return random.point(size);
  }
}

TEST(InsideZone, IsExactOffTheBoundary) {
  Random random(17);
  for (int i = 0; i < 2'000; ++i) {
    const std::int64_t size = std::int64_t{1} << random.in(7, 28);
    const probe_zone z = random_zone(random, static_cast<double>(size));
    for (int k = 0; k < 50; ++k) {
      const probe_vec p = delicate_point(random, z, 2 * size - 1);
      if (on_boundary(z, p)) continue;
      ASSERT_EQ(probe_inside(&z, p) != 0, inside(z, p));
    }
  }
}

std::vector<Square> boundary_gaps(const probe_zone& z, probe_vec p, probe_vec e) {
  std::vector<Square> all;
  for (std::int32_t i = 0; i < z.count; ++i) {
    for (const Square& s : segment_gaps(p, e, begin_of(z.edges[i]), end_of(z.edges[i]))) {
      all.push_back(s);
    }
  }
  return all;
}

TEST(BoundaryGap, IsBelowTheDistanceAndClose) {
  Random random(18);
  for (int i = 0; i < 3'000; ++i) {
    const std::int64_t size = std::int64_t{1} << random.in(7, 28);
    const probe_zone z = random_zone(random, static_cast<double>(size));
    for (int k = 0; k < 20; ++k) {
      const probe_vec p = delicate_point(random, z, 2 * size - 1);
      const std::int64_t lower = probe_boundary_gap_lo(&z, p);
      ASSERT_TRUE(bounds_from_below(lower, slack_for(2 * size), boundary_gaps(z, p, p)));
    }
  }
}

TEST(SegmentBoundary, IsBelowTheDistanceCloseAndNegativeOnlyWhenTheSegmentLeaves) {
  Random random(19);
  for (int i = 0; i < 3'000; ++i) {
    const std::int64_t size = std::int64_t{1} << random.in(7, 28);
    const probe_zone z = random_zone(random, static_cast<double>(size));
    for (int k = 0; k < 20; ++k) {
      const probe_vec p = delicate_point(random, z, 2 * size - 1);
      const probe_vec e = delicate_point(random, z, 2 * size - 1);
      const std::int64_t lower = probe_segment_boundary_lo(&z, p, e);
      const std::vector<Square> exact = boundary_gaps(z, p, e);
      if (lower < 0) {
        ASSERT_TRUE(bounds_from_below(0, 0, exact));
      } else {
        ASSERT_TRUE(bounds_from_below(lower, slack_for(2 * size), exact));
      }
    }
  }
}

TEST(SegmentBoundary, AtTheExtentNothingOverflows) {
  // The largest differences: products of two of them must fit 62 bits.
  probe_zone z{};
  const std::int64_t m = extent_mm;
  add_ring(z, {{-m, -m}, {m, -m}, {m, m}, {-m, m}});
  for (const probe_vec p :
       {probe_vec{-m, -m}, probe_vec{m, m}, probe_vec{m, -m}, probe_vec{0, 0}}) {
    for (const probe_vec e : {probe_vec{m, m}, probe_vec{-m, m}, probe_vec{1, 0}}) {
      ASSERT_TRUE(
          bounds_from_below(probe_segment_boundary_lo(&z, p, e), slack_mm, boundary_gaps(z, p, e)));
    }
  }
}

}  // namespace
}  // namespace rtac::kernel_test
