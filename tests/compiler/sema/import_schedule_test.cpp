// The schedule of a file as windows of time: exactly its moments, or the reason why there are none
// such.
#include "compiler/sema/import_schedule.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "compiler/sema/openings.h"
#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

namespace fs = std::filesystem;
using diag::Code;
using geometry::import::Failure;
using geometry::import::Period;

constexpr std::int64_t us_per_s = 1'000'000, day_s = 86'400;

// What the comment of Period says, of one moment.
bool applies(const Period& period, std::int64_t now_us) {
  if (period.from_us && now_us < *period.from_us) return false;
  if (period.until_us && now_us >= *period.until_us) return false;
  const std::int64_t day_us = day_s * us_per_s;
  const std::int64_t of_day_us = (now_us % day_us + day_us) % day_us;
  const std::int64_t day = (now_us - of_day_us) / day_us;
  const auto weekday = static_cast<unsigned>(((day + 3) % 7 + 7) % 7);  // 1970: a Thursday
  return (period.weekdays >> weekday & 1U) != 0 && of_day_us >= period.from_s * us_per_s &&
         of_day_us < period.until_s * us_per_s;
}
// What rule 7.4 says, of the same moment.
bool is_open(const Opening& opening, std::int64_t now_us) {
  const Period same{std::nullopt, std::nullopt, opening.days,
                    static_cast<std::int32_t>(opening.from_s),
                    static_cast<std::int32_t>(opening.until_s)};
  return opening.days != 0
             ? applies(same, now_us)
             : now_us >= opening.from_s * us_per_s && now_us < opening.until_s * us_per_s;
}
std::vector<Opening> windows(const std::vector<Period>& schedule) {
  auto found = openings_of(schedule);
  if (auto* failure = std::get_if<Failure>(&found)) {
    ADD_FAILURE() << failure->message;
    return {};
  }
  return std::get<std::vector<Opening>>(std::move(found));
}
Failure failure_of(const std::vector<Period>& schedule) {
  auto found = openings_of(schedule);
  const auto* failure = std::get_if<Failure>(&found);
  return failure != nullptr ? *failure : Failure{"", "none", ""};
}
Period between(std::int64_t from_s, std::int64_t until_s) {
  return {from_s * us_per_s, until_s * us_per_s};
}

constexpr std::int64_t thursday_s = 20'006 * day_s;  // 2024-10-10
constexpr std::uint8_t every_day = 0x7f, thursday = 0x08;

TEST(ImportSchedule, OfEveryWeekIsOneWindow) {
  const Period office{std::nullopt, std::nullopt, 0x1f, 8 * 3600, 17 * 3600};
  EXPECT_EQ(windows({office}), (std::vector<Opening>{{0x1f, 8 * 3600, 17 * 3600}}));
  EXPECT_EQ(summary_of(windows({office})),
            "monday, tuesday, wednesday, thursday, friday 08:00:00 .. 17:00:00");
}

// A date may be missing, or lie before the clock begins.
TEST(ImportSchedule, BetweenDatesMayHaveOneEnd) {
  Period since;
  since.from_us = thursday_s * us_per_s;
  EXPECT_EQ(windows({since}), (std::vector<Opening>{{0, thursday_s, for_ever_s}}));
  EXPECT_EQ(summary_of(windows({since})), "2024-10-10T00:00:00Z ..");
  EXPECT_TRUE(is_open(windows({since})[0], std::int64_t{9'000'000'000'000'000'000}));
  Period until;
  until.until_us = -us_per_s;
  EXPECT_EQ(summary_of(windows({until})), ".. 1969-12-31T23:59:59Z");
  EXPECT_TRUE(is_open(windows({until})[0], std::int64_t{-9'000'000'000'000'000'000}));
}

// A day from midnight to midnight, two hours to the east: the whole day all the same.
TEST(ImportSchedule, PartsOfDaysThatMeetAreOne) {
  Period late, early;
  late.from_us = early.from_us = thursday_s * us_per_s;
  late.from_s = 22 * 3600;
  early.until_s = 22 * 3600;
  EXPECT_EQ(windows({late, early}), (std::vector<Opening>{{0, thursday_s, for_ever_s}}));
  late.until_us = early.until_us = (thursday_s + 4000 * day_s) * us_per_s;
  EXPECT_EQ(windows({late, early}),
            (std::vector<Opening>{{0, thursday_s, thursday_s + 4000 * day_s}}));
  // Of other days or dates they stay apart.
  late.until_us = *late.until_us + us_per_s;
  EXPECT_EQ(failure_of({late, early}).message.substr(0, 21), "is more than the 512 ");
  Period monday{std::nullopt, std::nullopt, 1, 0, 3600},
      tuesday{std::nullopt, std::nullopt, 2, 3600, 7200};
  EXPECT_EQ(windows({monday, tuesday}), (std::vector<Opening>{{1, 0, 3600}, {2, 3600, 7200}}));
}

// Days between two dates count one by one, and what lasts over midnight is one window.
TEST(ImportSchedule, DaysBetweenDatesAreWindowsOfTheirOwn) {
  Period mornings = between(thursday_s + 9 * 3600, thursday_s + 8 * day_s);
  mornings.weekdays = thursday;
  mornings.from_s = 8 * 3600, mornings.until_s = 12 * 3600;
  EXPECT_EQ(windows({mornings}),
            (std::vector<Opening>{
                {0, thursday_s + 9 * 3600, thursday_s + 12 * 3600},
                {0, thursday_s + 7 * day_s + 8 * 3600, thursday_s + 7 * day_s + 12 * 3600}}));
  Period weekend = between(thursday_s, thursday_s + 7 * day_s);
  weekend.weekdays = 0x60;
  EXPECT_EQ(windows({weekend}),
            (std::vector<Opening>{{0, thursday_s + 2 * day_s, thursday_s + 4 * day_s}}));
}

// Exactly the moments of the schedule, a microsecond before and after each border included.
TEST(ImportSchedule, AgreesWithItsMeaningAroundEachBorder) {
  std::mt19937 random(7);
  const auto below = [&](std::int64_t n) { return static_cast<std::int64_t>(random()) % n; };
  for (int round = 0; round < 300; ++round) {
    std::vector<Period> schedule;
    for (int k = 0; k < 1 + round % 3; ++k) {
      const std::int64_t from_s = thursday_s - 30 * day_s + below(40 * day_s);
      Period period = between(from_s, from_s + 1 + below(30 * day_s));
      if (round % 4 == 0) period.from_us = period.until_us = std::nullopt;
      period.weekdays = static_cast<std::uint8_t>(1 + below(every_day));
      period.from_s = static_cast<std::int32_t>(below(day_s));
      period.until_s = static_cast<std::int32_t>(period.from_s + 1 + below(day_s - period.from_s));
      if (round % 5 == 0) period.from_s = 0, period.until_s = day_s;
      schedule.push_back(period);
    }
    const auto found = openings_of(schedule);
    const auto* openings = std::get_if<std::vector<Opening>>(&found);
    std::vector<std::int64_t> moments_us;
    for (const Period& period : schedule) {
      if (period.from_us) moments_us.insert(moments_us.end(), {*period.from_us, *period.until_us});
      for (std::int64_t day = 19'970; day < 20'060; ++day) {
        moments_us.push_back((day * day_s + period.from_s) * us_per_s);
        moments_us.push_back((day * day_s + period.until_s) * us_per_s);
      }
    }
    for (const std::int64_t border_us : moments_us) {
      for (const std::int64_t now_us : {border_us - 1, border_us, border_us + 1}) {
        const bool due = std::any_of(schedule.begin(), schedule.end(),
                                     [&](const Period& each) { return applies(each, now_us); });
        const bool is = openings != nullptr &&
                        std::any_of(openings->begin(), openings->end(),
                                    [&](const Opening& each) { return is_open(each, now_us); });
        ASSERT_EQ(is, due) << "round " << round << " at " << now_us;
      }
    }
  }
}

TEST(ImportSchedule, NamesThePeriodThatNoWindowsHold) {
  Period weekly{std::nullopt, std::nullopt, thursday, 0, 3600, "schedule[0]"};
  weekly.from_us = 0;
  EXPECT_EQ(failure_of({weekly}).message,
            "applies every week from a date, without a date at the other end");
  EXPECT_EQ(failure_of({weekly}).where, "schedule[0]");
  EXPECT_NE(failure_of({weekly}).help.find("`endDateTime`"), std::string::npos);
  weekly.from_us.reset(), weekly.until_us = 0;
  EXPECT_NE(failure_of({weekly}).help.find("`startDateTime`"), std::string::npos);

  Period fraction;
  fraction.from_us = 500'000, fraction.rounded = "\"1970-01-01T00:00:00.5Z\"";
  EXPECT_EQ(failure_of({fraction}).message,
            "has \"1970-01-01T00:00:00.5Z\", which is no whole second");

  Period never = between(thursday_s, thursday_s + day_s);
  never.weekdays = 0x01;
  EXPECT_EQ(failure_of({never}).message, "applies at no time");
  never.weekdays = 0;
  EXPECT_EQ(failure_of({never}).message, "applies at no time");
}

// The table is small, however long the dates reach.
TEST(ImportSchedule, HasAsManyWindowsAsATableHolds) {
  Period daily = between(thursday_s, thursday_s + 512 * day_s);
  daily.from_s = 3600, daily.until_s = 7200;
  EXPECT_EQ(windows({daily}).size(), 512U);
  EXPECT_EQ(summary_of(windows({daily})).substr(44),
            " or 2024-10-11T01:00:00Z .. 2024-10-11T02:00:00Z "
            "or 2024-10-12T01:00:00Z .. 2024-10-12T02:00:00Z or 2024-10-13T01:00:00Z .. "
            "2024-10-13T02:00:00Z, and 508 more windows");
  daily.until_us = *daily.until_us + day_s * us_per_s;
  EXPECT_NE(failure_of({daily}).message.find("more than the 512 windows"), std::string::npos);
  daily.until_us = 250'000'000'000 * us_per_s;  // the year 9892
  EXPECT_NE(failure_of({daily}).message.find("more than the 512 windows"), std::string::npos);
  std::vector<Period> weekly;
  for (std::int32_t k = 0; k < 74; ++k) {
    weekly.push_back({std::nullopt, std::nullopt, every_day, 2 * k, 2 * k + 1});
  }
  EXPECT_NE(failure_of(weekly).message.find("more than the 512 windows"), std::string::npos);
  weekly.pop_back();
  EXPECT_EQ(windows(weekly).size(), 73U);
}

// ---- what the specification says about it

class Scheduled : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) /
              ("rtac_schedules_" + std::string(info->name()) + "_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    const std::string monday = daily(R"("MON")");
    write("uas.json",
          zone("ONE", monday) + "," + zone("TWO", monday) + "," + zone("THREE", daily(R"("TUE")")) +
              "," + zone("ALWAYS", R"({"permanent":"YES"})") + "," +
              zone("ODD", R"({"permanent":"NO","endDateTime":"2026-05-01T00:00:00.5Z"})"));
    write("same.json", zone("ONE", monday) + "," + zone("TWO", monday));
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string daily(const std::string& day) {
    return R"({"permanent":"NO","schedule":[{"day":[)" + day +
           R"(],"startTime":"08:00:00Z","endTime":"12:00:00Z"}]})";
  }
  static std::string zone(const std::string& name, const std::string& applies) {
    return R"({"identifier":")" + name +
           R"(","country":"CHE","type":"COMMON","restriction":"PROHIBITED","zoneAuthority":[],)"
           R"("applicability":[)" +
           applies +
           R"(],"geometry":[{"uomDimensions":"M","horizontalProjection":)"
           R"({"type":"Circle","center":[8.546,47.398],"radius":300}}]})";
  }
  void write(const std::string& name, const std::string& zones) const {
    std::ofstream(folder_ / name, std::ios::binary)
        << R"({"title":"t","features":[)" << zones << "]}";
  }
  [[nodiscard]] std::unique_ptr<Checked> check(const std::string& items,
                                               const std::string& clock = "clock utc;\n") const {
    Checked start;
    const FileId root = start.sources.add(
        (folder_ / "s.rta").string(),
        "spec s;\nperiod 1 s;\norigin 47.3977 deg, 8.5456 deg;\n" + clock + items);
    return check_file(std::move(start), root);
  }
  void expect(const std::unique_ptr<Checked>& checked, Code code, const std::string& place,
              const std::string& says, const std::string& helps) const {
    SCOPED_TRACE(checked->reports());
    ASSERT_EQ(checked->engine.all().size(), 1U);
    const diag::Diagnostic& found = checked->engine.all().front();
    EXPECT_EQ(found.code, code);
    EXPECT_EQ(checked->sources.text(*found.range), place);
    EXPECT_NE(found.message.find(says), std::string::npos);
    EXPECT_NE(found.help.find(helps), std::string::npos);
  }

  static constexpr const char* judged =
      "input p : point in -900 .. 900 m;\nmonitor m { \"R1\" always not p inside z; }\n";
  fs::path folder_;
};

TEST_F(Scheduled, ZonesAreThereAtTheTimesOfTheirAreas) {
  for (const std::string file : {"\"uas.json\" feature \"THREE\"", "\"same.json\""}) {
    const auto checked = check("zone z = import " + file + " exclusions scheduled;\n" + judged);
    ASSERT_TRUE(checked->spec) << checked->reports();
    const Zone& zone = checked->spec->zones.front();
    const std::uint8_t day = file == "\"same.json\"" ? 0x01 : 0x02;
    EXPECT_EQ(zone.openings, (std::vector<Opening>{{day, 8 * 3600, 12 * 3600}}));
    EXPECT_EQ(std::get<ZoneImport>(zone.value->node).remarks.back(),
              std::string("scheduled: there ") + (day == 1 ? "monday" : "tuesday") +
                  " 08:00:00 .. 12:00:00");
  }
}
TEST_F(Scheduled, ZonesMoveAsOthersDo) {
  const auto checked = check(
      "zone z = import \"same.json\" exclusions scheduled around c;\n"
      "input c : point in -9 .. 9 m;\n" +
      std::string(judged));
  EXPECT_TRUE(checked->spec) << checked->reports();
}

TEST_F(Scheduled, AreasApplyAtTheSameTimes) {
  expect(check("zone z = import \"uas.json\" feature \"ONE\" exclusions;"), Code::import_ambiguous,
         "\"uas.json\"", "at certain times", "or `scheduled`");
  write("two.json", zone("ONE", daily(R"("MON")")) + "," + zone("TWO", daily(R"("TUE")")));
  expect(check("zone z = import \"two.json\" exclusions scheduled;"), Code::import_ambiguous,
         "\"two.json\"", "features[0] and features[1] apply at different times",
         "`feature \"name\"`");
  write("two.json", zone("ONE", R"({"permanent":"YES"})") + "," + zone("TWO", daily(R"("TUE")")));
  expect(check("zone z = import \"two.json\" exclusions scheduled;"), Code::import_ambiguous,
         "\"two.json\"", "apply at different times", "`feature \"name\"`");
}

TEST_F(Scheduled, NeedsAScheduleThatWindowsHold) {
  const std::string zones = "zone z = import \"uas.json\" exclusions feature ";
  expect(check(zones + "\"ALWAYS\" scheduled;"), Code::clause_without_effect, "scheduled",
         "limits when it applies", "leave it out");
  expect(check(zones + "\"ODD\" scheduled;"), Code::zone_file_unusable, "\"uas.json\"",
         "no whole second", "begin and end with a second");
  expect(check(zones + "\"ONE\" scheduled timeless \"why\";"), Code::clause_without_effect,
         "timeless \"why\"", "`scheduled`", "leave out");
  expect(check(zones + "\"ONE\" scheduled scheduled;"), Code::duplicate_clause, "scheduled", "",
         "");
  expect(check(zones + "\"ONE\" scheduled during 07:30 .. 08:00;"), Code::duplicate_clause,
         "07:30 .. 08:00", "the schedule of the file", "keep `scheduled`");
  expect(check(zones + "\"ONE\" scheduled;\n" + judged, ""), Code::clock_missing, "scheduled",
         "clock in UTC", "`clock utc;`");
}

// As of other zones that are there at certain times only.
TEST_F(Scheduled, NothingIsMadeOfSuchZones) {
  const std::string import = "import \"same.json\" exclusions scheduled";
  const std::string base = "zone base = rectangle (0 m, 0 m) to (9 m, 9 m);\n";
  expect(check(base + "zone z = base - " + import + ";"), Code::zone_not_fixed, "scheduled",
         "at certain times", "by itself");
  expect(check("zone z = grow(" + import + ", 1 m);"), Code::zone_not_fixed, "scheduled",
         "at certain times", "by itself");
  expect(check("input p : point in 0 .. 9 m;\nmonitor m { \"R1\" always not p inside " + import +
               "; }"),
         Code::zone_not_fixed, "scheduled", "at certain times", "by itself");
  expect(check(base + "zone closed = " + import + ";\nzone z = base - closed;"),
         Code::zone_not_fixed, "closed", "`closed` is there at certain times", "by its name");
}

}  // namespace
}  // namespace rtac::sema::test
