#include "compiler/sema/import_schedule.h"

#include <algorithm>
#include <bit>
#include <set>
#include <utility>

#include "compiler/sema/openings.h"

namespace rtac::sema {

using geometry::import::Failure;
using geometry::import::Period;

namespace {

constexpr std::int64_t us_per_s = 1'000'000, day_s = 86'400;
constexpr std::uint8_t every_day = 0x7F;

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}
// 0: Monday; 1970 began on a Thursday.
unsigned weekday(std::int64_t day) {
  return static_cast<unsigned>(((day + 3) % 7 + 7) % 7);
}

std::size_t windows_of(const Opening& opening) {
  return opening.days == 0 ? 1 : static_cast<std::size_t>(std::popcount(opening.days));
}

class WindowMaker {
 public:
  std::variant<std::vector<Opening>, Failure> run(const std::vector<Period>& schedule) {
    for (const Period& period : schedule) {
      if (!add(period)) return *failure_;
    }
    if (all_.empty()) {
      fail(schedule.front(), "applies at no time",
           "no day of its dates is one of its days of the week: look at both");
      return *failure_;
    }
    return std::vector<Opening>(all_.begin(), all_.end());
  }

 private:
  bool add(const Period& period) {
    if (!period.rounded.empty()) {
      return fail(period, "has " + period.rounded + ", which is no whole second",
                  "windows of time begin and end with a second: write the file so");
    }
    const bool whole_days = period.from_s == 0 && period.until_s == day_s;
    if (whole_days && period.weekdays == every_day) {
      const std::int64_t from_s = period.from_us ? *period.from_us / us_per_s : since_ever_s;
      const std::int64_t until_s = period.until_us ? *period.until_us / us_per_s : for_ever_s;
      return put(period, {0, from_s, until_s});
    }
    if (!period.from_us && !period.until_us) {
      return put(period, {period.weekdays, period.from_s, period.until_s});
    }
    if (period.from_us && period.until_us) return add_days(period);
    return fail(
        period,
        std::string("applies every week ") + (period.from_us ? "from" : "until") +
            " a date, without a date at the other end",
        "windows of time are of every week, or between two dates: write `" +
            std::string(period.from_us ? "endDateTime" : "startDateTime") +
            "` in the file; or `timeless \"why\"`, and windows of your own behind `during`");
  }

  // On each of its days by itself; what goes on over midnight is one window.
  bool add_days(const Period& period) {
    const std::int64_t first_s = *period.from_us / us_per_s, last_s = *period.until_us / us_per_s;
    std::optional<Opening> open;
    for (std::int64_t day = floor_div(first_s, day_s); day * day_s < last_s; ++day) {
      if ((period.weekdays >> weekday(day) & 1U) == 0) continue;
      const Opening next{0, std::max(day * day_s + period.from_s, first_s),
                         std::min(day * day_s + period.until_s, last_s)};
      if (next.from_s >= next.until_s) continue;
      if (open && open->until_s == next.from_s) {
        open->until_s = next.until_s;
        continue;
      }
      if (open && !put(period, *open)) return false;
      open = next;
    }
    return !open || put(period, *open);
  }

  // Every week of dates has a window at least, so that this ends after as many weeks.
  bool put(const Period& period, const Opening& opening) {
    if (!all_.insert(opening).second) return true;
    count_ += windows_of(opening);
    if (count_ <= max_scheduled) return true;
    const std::string most = std::to_string(max_scheduled);
    return fail(period, "is more than the " + most + " windows of time that a zone may have",
                "days between two dates count one by one: give the period less of them, or write "
                "`timeless \"why\"` and windows of every week behind `during`");
  }
  bool fail(const Period& period, std::string message, std::string help) {
    failure_ = Failure{period.where, std::move(message), std::move(help)};
    return false;
  }

  std::set<Opening> all_;
  std::size_t count_ = 0;
  std::optional<Failure> failure_;
};

}  // namespace

std::variant<std::vector<Opening>, Failure> openings_of(const std::vector<Period>& schedule) {
  if (schedule.empty()) return std::vector<Opening>{};
  return WindowMaker().run(geometry::import::joined(schedule));
}

std::string summary_of(const std::vector<Opening>& openings) {
  constexpr std::size_t shown_most = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(openings.size(), shown_most); ++i) {
    text += (i == 0 ? "" : " or ") + text_of(openings[i]);
  }
  if (openings.size() <= shown_most) return text;
  const std::size_t more = openings.size() - shown_most;
  return text + ", and " + std::to_string(more) + " more window" + (more == 1 ? "" : "s");
}

const syntax::ImportOption* scheduled_in(const syntax::Expr& expr) {
  const auto* const import = std::get_if<syntax::ImportLit>(&expr.node);
  if (import == nullptr) return nullptr;
  for (const syntax::ImportOption& option : import->options) {
    if (option.word == syntax::ImportWord::scheduled) return &option;
  }
  return nullptr;
}

}  // namespace rtac::sema
