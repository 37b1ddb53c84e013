// Verdicts that are told at a glance are those of a closer look: the entry for verdicts alone finds
// what the one with margins finds, for numbers at and around every limit, at the ends of their
// range and beyond it, on steps and between them, of samples that count and that do not. Mistakes
// in what is told at a glance are noticed by that.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <regex>
#include <utility>

#include "compiler/driver/replay.h"
#include "compiler/driver/shared_object.h"
#include "tests/differential/engines.h"

namespace rtac::differential {
namespace {

const char* const spec = R"(spec s;
period 10 ms;
input p, q, a, b, c : point in -1 m .. 1 m;
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
monitor either { "R11" always (p.x >= 0 m and p.x <= 2 mm) or (p.x > 3 mm and p.x < 6 mm); }
monitor both { "R12" always p.y > -3 mm and p.y < 4 mm and q.x >= -2 mm and q.x <= 5 mm; }
monitor edge { "R13" always p.x >= -1 m and p.x <= 3 mm; }
monitor open { "R14" always p.y >= -4 mm and p.y <= 4 mm or q.y >= 1 mm; }
monitor beyond { "R16" always p.x >= -2 m and p.x <= 3 mm; }
monitor last { "R17" always q.x >= -3 mm and q.x <= 1001 mm; }
monitor pairs { "R18" always (p.x >= 0 m and p.x <= 3 mm and q.y >= 0 m and q.y <= 3 mm) or
                             (p.x >= 4 mm and p.x <= 7 mm and q.y >= -5 mm and q.y <= -1 mm); }
monitor alone { "R19" always distance(a, b) >= 5 mm; }
monitor lone_box { "R20" always c.x >= -1 mm and c.x <= 5 mm and c.y >= -2 mm and c.y <= 6 mm; }
monitor outside { "R15" always not (q.x > -4 mm and q.x < 4 mm) and q.x >= -6 mm and q.x <= 6 mm; }
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
/* Any number but 0 says that it was. */
static int32_t received(void) { return below(16) > 0 ? (below(4) > 0 ? 1 : (int32_t)below(5) - 2) : 0; }
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
    in.a.stamp_us = stamp(now_us); in.a.valid = received(); in.a.between = (uint32_t)below(4);
    in.b.stamp_us = stamp(now_us); in.b.valid = received(); in.b.between = (uint32_t)below(4);
    in.c.stamp_us = stamp(now_us); in.c.valid = received(); in.c.between = (uint32_t)below(4);
    in.a.x = number(-1000, 1000); in.a.y = number(-1000, 1000);
    in.b.x = number(-1000, 1000); in.b.y = number(-1000, 1000);
    in.c.x = number(-1000, 1000); in.c.y = number(-1000, 1000);
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

constexpr std::size_t kinds = 4;  // of a monitor: ticks with each verdict, and with another one

using Edit = std::function<std::string(const std::string&)>;

// What the kernel finds after `edit`, by monitor and kind; empty: it was not built.
std::vector<std::int64_t> found_by(const Edit& edit, std::int64_t ticks) {
  const auto checked = check(spec, Until::kernel);
  EXPECT_EQ(checked->problem, "");
  driver::KernelCode code = driver::kernel_code(checked->compilation);
  bool is_changed = false;
  for (driver::OutputFile& file : code.files) {
    const std::string before = std::exchange(file.text, edit(file.text));
    is_changed = is_changed || before != file.text;
  }
  EXPECT_TRUE(is_changed) << "the kernel has no such text any more";
  std::string text = "#include \"" + code.interface.source + "\"\n" + glue;
  for (std::size_t at = 0; (at = text.find("P_", at)) != std::string::npos; ++at) {
    const bool is_word = at > 0 && (std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0 ||
                                    text[at - 1] == '_');
    if (is_word) continue;
    const bool is_count = text.compare(at, 10, "P_MONITORS") == 0;
    text.replace(at, 1, is_count ? "REPLAY" : code.interface.prefix);
  }
  driver::BuiltObject object = driver::build_object(code.files, text);
  EXPECT_TRUE(object.object) << object.problem;
  if (!object.object) return {};
  const auto run = object.object->function<void (*)(std::int64_t, std::int64_t*)>("run");
  std::vector<std::int64_t> found(kinds * code.interface.monitors);
  run(ticks, found.data());
  return found;
}

TEST(AtAGlance, VerdictsAreThoseOfACloserLook) {
  const auto with_comment = [](const std::string& text) { return text + "/* as it is */\n"; };
  const std::vector<std::int64_t> found = found_by(with_comment, 2'000'000);
  ASSERT_FALSE(found.empty());
  for (std::size_t m = 0; m * kinds < found.size(); ++m) {
    EXPECT_EQ(found[kinds * m + 3], 0) << "of monitor " << m;
    for (std::size_t verdict = 0; verdict < 3; ++verdict) {
      EXPECT_GT(found[kinds * m + verdict], 1000) << "verdict " << verdict << " of monitor " << m;
    }
  }
}

// ---- seeded mistakes

Edit instead(const char* pattern, const char* replacement) {
  return [=](const std::string& text) {
    return std::regex_replace(text, std::regex(pattern), replacement);
  };
}
// The number behind `pattern` is another one.
Edit limit(const char* pattern, const std::function<std::int64_t(std::int64_t)>& changed) {
  return [=](const std::string& text) {
    const std::regex comparison(std::string("(") + pattern + ")(-?[0-9]+)");
    std::string out;
    auto from = text.begin();
    for (std::sregex_iterator at(text.begin(), text.end(), comparison), end; at != end; ++at) {
      out.append(from, text.begin() + at->position()).append((*at)[1]);
      out += std::to_string(changed(std::stoll((*at)[2])));
      from = text.begin() + at->position() + at->length();
    }
    return out.append(from, text.end());
  };
}
// Of a length, the square of which is compared.
std::int64_t longer(std::int64_t square, std::int64_t by) {
  const auto length = std::lround(std::sqrt(static_cast<double>(square))) + by;
  return length * length;
}

struct Mistake {
  const char* name;
  Edit edit;
};
std::vector<Mistake> mistakes() {
  const auto less = [](std::int64_t n) { return n - 1; };
  const auto more = [](std::int64_t n) { return n + 1; };
  return {
      {"least_is_one_less", limit("in->[^<>=&|]* >= ", less)},
      {"most_is_one_more", limit("in->[^<>=&|]* <= ", more)},
      {"long_is_exact", limit("square_[0-9]+ >= ", [](auto n) { return longer(n, -2); })},
      {"short_is_exact", limit("square_[0-9]+ <= ", [](auto n) { return longer(n, 2); })},
      {"difference_is_a_sum", instead(R"((square_\w+ = in->[\w.]+) - )", "$1 + ")},
      {"sum_has_a_wrong_sign", instead(R"((\(in->[\w.]+) - (in->))", "$1 + $2")},
      {"negation_is_left_out", instead(R"((\(in->p\.x) \+ (in->q))", "$1 - $2")},
      {"one_axis_of_two", instead(R"((square_\w+ = \w+ \* \w+) \+ [^;]*;)", "$1;")},
      {"any_is_all", instead(R"(([<>]= -?[0-9]+) && (in->))", "$1 || $2")},
      {"out_of_range_is_told", instead(R"((number_inside\(in->[^)]*\)))", "($1 || 1)")},
      {"one_axis_in_range_is_enough", instead(R"(number_inside\(in->\w+\.y[^)]*\))", "1")},
      {"last_step_is_inside", instead(R"((uint64_t\)least) < (\(uint64_t))", "$1 <= $2")},
      {"missing_is_told", instead(R"(!USUALLY\(v->fresh)", "0 && !USUALLY(v->fresh")},
      {"missing_is_seen", instead(R"(v->fresh_\w+ != 0 &&(\s+number_inside))", "$1")},
      {"missing_is_surely", instead(R"(\(USUALLY\(v->fresh_\w+ != 0 && )", "(USUALLY(")},
      {"one_missing_is_all", instead(R"((USUALLY\(v->fresh_\w+ != 0) \|\| )", "$1 && ")},
      {"surely_is_out_of_range", instead(R"( && in->p.x <= 4\b)", "")},
      {"never_is_surely", instead(R"((\*verdict = \w+)_VERDICT_FALSE;)", "$1_VERDICT_TRUE;")},
      {"one_axis_in_the_middle", instead(R"(steps_above\(in->\w+\.y[^)]*\))", "0")},
      {"the_middle_is_twice_as_wide", instead(R"(\) < ([0-9]+)U)", ") < 2 * $1U")},
      {"the_middle_is_elsewhere", instead(R"((steps_above\(in->\w+\.x, )-512\))", "$1 512)")},
      {"any_arrives", instead(R"(USUALLY\(sample_arrived\([^)]*\))", "USUALLY(1")},
      {"one_flag_is_enough", instead(R"((\.valid) & )", "$1 | ")},
  };
}
class Mistakes : public ::testing::TestWithParam<std::size_t> {};
TEST_P(Mistakes, AreNoticed) {
  const Mistake mistake = mistakes()[GetParam()];
  const std::vector<std::int64_t> found = found_by(mistake.edit, 200'000);
  std::int64_t different = 0;
  for (std::size_t at = 3; at < found.size(); at += kinds) different += found[at];
  EXPECT_GT(different, 0) << mistake.name;
}
INSTANTIATE_TEST_SUITE_P(AtAGlance, Mistakes, ::testing::Range<std::size_t>(0, mistakes().size()),
                         [](const auto& made) { return mistakes()[made.param].name; });

}  // namespace
}  // namespace rtac::differential
