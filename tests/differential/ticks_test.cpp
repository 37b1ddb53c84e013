// Which tick a time belongs to: generated monitors find it quickly, a plain model from the words of
// the rule. Clocks jitter, stop, jump, go back, and come near to both ends of 64 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compiler/driver/replay.h"
#include "compiler/driver/shared_object.h"
#include "tests/differential/engines.h"

namespace rtac::differential {
namespace {

__extension__ using Wide = __int128;

constexpr std::int64_t first = INT64_MIN, last = INT64_MAX;

// Rule 1: ticks are counted from the first step, to the nearest, of two the earlier one. A step
// that brings no new tick, or goes back, judges nothing. Nothing is farther from the first step
// than 2^63 - 1 us: those are 292,000 years.
class Model {
 public:
  explicit Model(std::int64_t period_us) : period_us_(period_us) {}
  struct Answer {
    std::int64_t tick;
    bool is_new;
  };
  Answer at(std::int64_t now_us) {
    const Wide now = now_us;
    if (!started_) {
      started_ = true;
      origin_us_ = last_us_ = now;
      return {0, true};
    }
    if (now < last_us_) return {tick_, false};
    last_us_ = now;
    const Wide since = std::min<Wide>(now - origin_us_, last);
    // of two ticks that are as near, the earlier one
    const auto tick = static_cast<std::int64_t>((2 * since + period_us_ - 1) / (2 * period_us_));
    const bool is_new = tick > tick_;
    tick_ = tick;
    return {tick_, is_new};
  }

 private:
  const Wide period_us_;
  bool started_ = false;
  Wide origin_us_ = 0, last_us_ = 0;
  std::int64_t tick_ = 0;
};

// Steps both entries; `new_tick`: 2 bits, whether each has judged; then, of an input that has to
// arrive every tick, whether they disagree about it, and whether its sample has arrived.
using StepAll = void (*)(const std::int64_t* now_us, std::int32_t count, std::int64_t* tick,
                         std::int32_t* new_tick);

// Every tick comes when it is due, up to the last one that there can be; then the clock wraps
// around. What is not as it should be: 1 one of them was not judged, 2 that of the other side of
// time was.
using ToTheEnd = std::int32_t (*)(std::int64_t now_us);
constexpr const char* to_the_end = R"(
int32_t to_the_end(int64_t now_us) {
  P_monitors_verdicts_state alone;
  P_monitors_in in = {{0, 1, 0, 1}, {0, 1, 0, 1}};
  int32_t verdict[2], wrong = 0;
  P_monitors_verdicts_init(&alone);
  for (;; now_us += PERIOD) {
    in.p.stamp_us = in.q.stamp_us = now_us;
    P_monitors_verdicts(&alone, &in, now_us, verdict);
    wrong |= verdict[0] != 2 || verdict[1] != 2;
    if (now_us > INT64_MAX - PERIOD) break;
  }
  now_us = (int64_t)((uint64_t)now_us + PERIOD);
  in.p.stamp_us = in.q.stamp_us = now_us;
  P_monitors_verdicts(&alone, &in, now_us, verdict);
  return wrong | 2 * (verdict[0] == 2 || verdict[1] == 2);
}
)";

// `each_tick`: another input has to arrive every tick, so that the time of the last one is kept.
driver::BuiltObject built(const std::string& period, std::int64_t period_us, bool each_tick) {
  const std::string another = each_tick ? "input q : bool;\n"
                                          "monitor n { \"R2: q\" always q; }\n"
                                        : "";
  const auto checked = check("spec s;\nperiod " + period +
                                 ";\ninput p : bool max_age inf;\n"
                                 "monitor m { \"R1: p\" always p; }\n" +
                                 another,
                             Until::kernel);
  EXPECT_EQ(checked->problem, "");
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  const std::string& p = code.interface.prefix;
  // Its stamps are at both ends of the period, just within and just beyond.
  const std::string arrives = R"(
    const uint64_t ends[] = {now, now - PERIOD, k > 0 ? (uint64_t)now_us[k - 1] : 0};
    in.q.stamp_us = (int64_t)(ends[k * 5 % 3] + (uint64_t)(k * 7 % 4) - 1);
    in.q.valid = 1;
    in.q.value = 1;
)";
  const std::string compared =
      "    new_tick[k] += 4 * (out.monitors[1].verdict != verdict[1]) + 8 "
      "* (verdict[1] == 2);\n";
  std::string glue = "#include \"" + code.interface.source + "\"\n#define PERIOD " +
                     std::to_string(period_us) + R"(
void run(const int64_t *now_us, int32_t count, int64_t *tick, int32_t *new_tick) {
  P_monitors_state s;
  P_monitors_verdicts_state alone;
  P_monitors_in in = {{INT64_MIN, 1, 0, 1}};
  P_monitors_out out;
  int32_t k, verdict[2];
  P_monitors_init(&s);
  P_monitors_verdicts_init(&alone);
  for (k = 0; k < count; ++k) {
    const uint64_t now = (uint64_t)now_us[k];
    (void)now;)" + (each_tick ? arrives : "") +
                     R"(
    P_monitors_step(&s, &in, now_us[k], &out);
    P_monitors_verdicts(&alone, &in, now_us[k], verdict);
    tick[k] = out.tick;
    new_tick[k] = (out.monitors[0].verdict == 2) + 2 * (verdict[0] == 2);
)" + (each_tick ? compared : "") +
                     "  }\n}\n";
  if (each_tick) glue += to_the_end;
  for (std::size_t at = 0; (at = glue.find("P_monitors", at)) != std::string::npos;) {
    glue.replace(at, 1, p);
  }
  return driver::build_object(code.files, glue);
}

// Times as they come: mostly the next tick, or as far from it as still counts, or just not.
std::vector<std::int64_t> times(std::mt19937_64& random, std::int64_t period_us,
                                std::int64_t start_us, std::size_t count) {
  std::vector<std::int64_t> all;
  Wide now = start_us;
  const auto below = [&](std::int64_t bound) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(bound));
  };
  while (all.size() < count) {
    now = std::clamp<Wide>(now, first, last);
    all.push_back(static_cast<std::int64_t>(now));
    const std::int64_t half = period_us / 2;
    const Wide tick = (now - all.front()) / period_us;
    switch (below(12)) {
      case 0:  // around the end of the tick, or of one of the next
        now = all.front() + (tick + below(3)) * Wide{period_us} + half + below(5) - 2;
        break;
      case 1:
        now += below(8) * Wide{period_us} + below(3) - 1;
        break;
      case 2:
        now -= below(3 * period_us);
        break;
      case 3:
        now += random() >> below(64);
        break;
      case 4:
        break;  // stands still
      case 5:
      case 6:
        now += period_us;  // does not jitter
        break;
      default:
        now += period_us + below(std::max<std::int64_t>(1, half)) - half / 2;
    }
  }
  return all;
}

struct Period {
  const char* text;
  std::int64_t us;
};
class Ticks : public ::testing::TestWithParam<Period> {};

void are_those_of_the_plain_model(const Period& period, bool each_tick) {
  const std::int64_t period_us = period.us;
  driver::BuiltObject object = built(period.text, period_us, each_tick);
  ASSERT_TRUE(object.object) << object.problem;
  const StepAll run = object.object->function<StepAll>("run");
  ASSERT_NE(run, nullptr);
  std::mt19937_64 random(static_cast<std::uint64_t>(period_us));
  const std::int64_t starts[] = {0,
                                 -1,
                                 first,
                                 first + period_us / 2,
                                 -period_us,
                                 last / 2 - 20 * period_us,
                                 last,
                                 last - period_us,
                                 last - 40 * period_us,
                                 last - period_us / 2};
  std::size_t judged = 0, skipped = 0, arrived = 0;
  for (int round = 0; round < 600; ++round) {
    const std::int64_t start_us = round % 2 == 0
                                      ? starts[std::size_t(round / 2) % std::size(starts)]
                                      : static_cast<std::int64_t>(random());
    const std::vector<std::int64_t> now = times(random, period_us, start_us, 60);
    std::vector<std::int64_t> tick(now.size());
    std::vector<std::int32_t> new_tick(now.size());
    run(now.data(), static_cast<std::int32_t>(now.size()), tick.data(), new_tick.data());
    Model model(period_us);
    for (std::size_t k = 0; k < now.size(); ++k) {
      const Model::Answer exact = model.at(now[k]);
      ASSERT_EQ(tick[k], exact.tick) << "round " << round << ", step " << k << " at " << now[k]
                                     << ", the first at " << now.front();
      ASSERT_EQ(new_tick[k] & 7, exact.is_new ? 3 : 0)
          << "round " << round << ", step " << k << " at " << now[k];
      arrived += new_tick[k] >= 8 ? 1U : 0U;
      ++(exact.is_new ? judged : skipped);
    }
  }
  EXPECT_GT(judged, 1000u);
  EXPECT_GT(skipped, 1000u);
  if (each_tick) {
    EXPECT_GT(arrived, 1000u);
    EXPECT_LT(arrived + 1000u, judged);
  }
}

TEST_P(Ticks, AreThoseOfThePlainModel) {
  are_those_of_the_plain_model(GetParam(), false);
}
TEST_P(Ticks, AreThoseOfThePlainModelWhereSamplesMustArriveEveryTick) {
  are_those_of_the_plain_model(GetParam(), true);
}

// From where 2^62 us are left: 146,000 years of days.
TEST(TicksOfDays, AreDueUpToTheEndOfTime) {
  constexpr std::int64_t day_us = 86'400'000'000;
  driver::BuiltObject object = built("86400 s", day_us, true);
  ASSERT_TRUE(object.object) << object.problem;
  const ToTheEnd run = object.object->function<ToTheEnd>("to_the_end");
  ASSERT_NE(run, nullptr);
  EXPECT_EQ(run(last / 2 - day_us), 0);
  EXPECT_EQ(run(last - 10 * day_us), 0);
}

INSTANTIATE_TEST_SUITE_P(Periods, Ticks,
                         ::testing::Values(Period{"1 us", 1}, Period{"2 us", 2}, Period{"3 us", 3},
                                           Period{"10 ms", 10'000}, Period{"33333 us", 33'333},
                                           Period{"1 s", 1'000'000},
                                           Period{"86400 s", 86'400'000'000}),
                         [](const auto& param) { return std::to_string(param.param.us) + "_us"; });

}  // namespace
}  // namespace rtac::differential
