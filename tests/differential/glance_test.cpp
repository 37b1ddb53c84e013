// Verdicts that are told at a glance are those of a closer look: the entry for verdicts alone finds
// what the one with margins finds, for numbers at and around every limit, at the ends of their
// range and beyond it, on steps and between them, of samples that count and that do not.
#include <gtest/gtest.h>

#include "compiler/driver/replay.h"
#include "compiler/driver/shared_object.h"
#include "tests/differential/engines.h"

namespace rtac::differential {
namespace {

const char* const spec = R"(spec s;
period 10 ms;
input p, q : point in -1 m .. 1 m;
input x : real [m] in -0.1 m .. 0.2 m error 2 mm max_age 1 s;
param gap : length in 0.1 m .. 0.3 m = 0.2 m;
monitor box { "R1" always p.x >= 0 m and p.x <= 5 mm and p.y > -3 mm and p.y < 4 mm; }
monitor some { "R2" always p.x < -2 mm or not (q.y <= 1 mm); }
monitor apart { "R3" always distance(p, q) >= 5 mm; }
monitor strictly { "R4" always distance(p, q) > 5 mm; }
monitor near { "R5" always distance(p, q) <= 6 mm; }
monitor nearer { "R6" always distance(p, q) < 6 mm; }
monitor sums { "R7" always p.x - q.y + x <= 4 mm; }
monitor moved { "R8" always 3 mm - p.x > q.x - 2 mm; }
monitor wide { "R9" always x > 3 mm or p.x - q.x >= gap; }
monitor mixed { "R10" always p.x >= 0 m and (distance(p, q) >= 5 mm or x >= 1 mm); }
)";

// A pseudo-random number below `count`; numbers near to 0 or `edges`, now and then anything.
const char* const glue = R"(
static uint64_t seed;
static int64_t below(int64_t count) {
  seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (int64_t)((seed >> 33) % (uint64_t)count);
}
static int64_t number(int64_t least, int64_t most) {
  switch (below(24)) {
    case 0: return least + below(3) - 1;
    case 1: return most + below(4) - 2;
    case 2: return INT64_MIN + below(2);
    case 3: return INT64_MAX - below(2);
    case 4: return (int64_t)(seed ^ seed << 31);
    default: return below(15) - 7;
  }
}
static int64_t stamp(int64_t now_us) {
  switch (below(24)) {
    case 0: return now_us + 1;
    case 1: return now_us - 10000 - below(2);
    case 2: return now_us - 1000000 - below(3) + 1;
    default: return now_us - below(10000);
  }
}
void run(int64_t ticks, int64_t *found) {
  static P_monitors_state s;
  static P_monitors_verdicts_state alone;
  static P_monitors_in in;
  P_monitors_out out;
  int32_t verdicts[P_MONITORS], m;
  int64_t k, now_us = 0;
  P_monitors_init(&s);
  P_monitors_verdicts_init(&alone);
  in.gap = 200;
  for (k = 0; k < ticks; ++k) {
    now_us += 10000 + (below(4) == 0 ? below(2000) - 1000 : 0);
    in.p.stamp_us = stamp(now_us); in.p.valid = below(16) > 0; in.p.between = (uint32_t)below(4);
    in.q.stamp_us = stamp(now_us); in.q.valid = below(16) > 0; in.q.between = (uint32_t)below(4);
    in.x.stamp_us = stamp(now_us); in.x.valid = below(16) > 0; in.x.between = (uint32_t)below(2);
    in.p.x = number(-1000, 1000); in.p.y = number(-1000, 1000);
    in.q.x = number(-1000, 1000); in.q.y = number(-1000, 1000);
    in.x.value = number(-100, 200);
    if (below(1000) == 0) in.gap = 100 + below(300);
    P_monitors_step(&s, &in, now_us, &out);
    P_monitors_verdicts(&alone, &in, now_us, verdicts);
    for (m = 0; m < P_MONITORS; ++m) {
      found[4 * m + out.monitors[m].verdict] += 1;
      found[4 * m + 3] += out.monitors[m].verdict != verdicts[m];
    }
  }
}
)";

TEST(AtAGlance, VerdictsAreThoseOfACloserLook) {
  const auto checked = check(spec, Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  std::string text = "#include \"" + code.interface.source + "\"\n" + glue;
  for (std::size_t at = 0; (at = text.find("P_", at)) != std::string::npos; ++at) {
    const bool is_word = at > 0 && (std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0 ||
                                    text[at - 1] == '_');
    if (is_word) continue;
    const bool is_count = text.compare(at, 10, "P_MONITORS") == 0;
    text.replace(at, 1, is_count ? "REPLAY" : code.interface.prefix);
  }
  driver::BuiltObject object = driver::build_object(code.files, text);
  ASSERT_TRUE(object.object) << object.problem;
  const auto run = object.object->function<void (*)(std::int64_t, std::int64_t*)>("run");
  ASSERT_NE(run, nullptr);
  std::vector<std::int64_t> found(4 * code.interface.monitors);
  run(2'000'000, found.data());
  for (std::size_t m = 0; m < code.interface.monitors; ++m) {
    EXPECT_EQ(found[4 * m + 3], 0) << "of monitor " << m;
    for (std::size_t verdict = 0; verdict < 3; ++verdict) {
      EXPECT_GT(found[4 * m + verdict], 1000) << "verdict " << verdict << " of monitor " << m;
    }
  }
}

}  // namespace
}  // namespace rtac::differential
