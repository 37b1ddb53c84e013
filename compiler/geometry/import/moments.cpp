#include "compiler/geometry/import/moments.h"

#include <algorithm>
#include <chrono>
#include <tuple>
#include <utility>

namespace rtac::geometry::import {
namespace {

constexpr std::int32_t day_s = 86'400;

// Reads from the front of a text; once something is not as expected, it stays failed.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  bool is_good() const { return is_good_; }
  bool is_done() const { return rest_.empty(); }
  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char c) { is_good_ = take(c) && is_good_; }
  // Exactly so many digits.
  int digits(std::size_t count) {
    int value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (rest_.empty() || rest_.front() < '0' || rest_.front() > '9') {
        is_good_ = false;
        return 0;
      }
      value = 10 * value + (rest_.front() - '0');
      rest_.remove_prefix(1);
    }
    return value;
  }
  int digits_up_to(std::size_t count, int most) {
    const int value = digits(count);
    is_good_ = is_good_ && value <= most;
    return value;
  }
  bool is_digit() const { return !rest_.empty() && rest_.front() >= '0' && rest_.front() <= '9'; }

 private:
  std::string_view rest_;
  bool is_good_ = true;
};

struct Clock {
  std::int32_t second = 0;       // of the day
  std::int32_t microsecond = 0;  // of the second, rounded down
  std::int32_t offset_s = 0;     // of the zone: local minus UTC
};

std::int32_t scan_fraction_us(Scanner& scanner) {
  std::int32_t value_us = 0, weight_us = 100'000;
  if (!scanner.is_digit()) scanner.digits(1);
  while (scanner.is_digit()) {
    value_us += weight_us * scanner.digits(1);
    weight_us /= 10;
  }
  return value_us;
}

Clock scan_clock(Scanner& scanner) {
  Clock clock;
  clock.second = 3600 * scanner.digits_up_to(2, 23);
  scanner.expect(':');
  clock.second += 60 * scanner.digits_up_to(2, 59);
  if (scanner.take(':')) {
    clock.second += scanner.digits_up_to(2, 59);
    if (scanner.take('.')) clock.microsecond = scan_fraction_us(scanner);
  }
  if (scanner.take('Z')) return clock;
  const int sign = scanner.take('-') ? -1 : 1;
  if (sign > 0) scanner.expect('+');
  clock.offset_s = 3600 * scanner.digits_up_to(2, 23);
  scanner.take(':');
  clock.offset_s = sign * (clock.offset_s + 60 * scanner.digits_up_to(2, 59));
  return clock;
}

std::uint8_t weekdays_later(std::uint8_t days, int by) {
  const int shift = ((by % 7) + 7) % 7;
  return static_cast<std::uint8_t>(((days << shift) | (days >> (7 - shift))) & 0x7f);
}

}  // namespace

std::optional<std::int64_t> parse_moment_us(std::string_view text) {
  Scanner scanner(text);
  const int year = scanner.digits(4);
  scanner.expect('-');
  const int month = scanner.digits(2);
  scanner.expect('-');
  const int day = scanner.digits(2);
  scanner.expect('T');
  const Clock clock = scan_clock(scanner);
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!scanner.is_good() || !scanner.is_done() || !date.ok()) return std::nullopt;
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  return (days * day_s + clock.second - clock.offset_s) * 1'000'000 + clock.microsecond;
}

bool has_fraction_of_second(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos) return false;
  const std::size_t other = text.find_first_not_of('0', point + 1);
  return other != std::string_view::npos && text[other] > '0' && text[other] <= '9';
}

std::optional<TimeOfDay> parse_time_of_day(std::string_view text) {
  Scanner scanner(text);
  const Clock clock = scan_clock(scanner);
  if (!scanner.is_good() || !scanner.is_done()) return std::nullopt;
  return TimeOfDay{clock.second, clock.second + (clock.microsecond > 0 ? 1 : 0), clock.offset_s};
}

std::vector<Period> daily_periods(const Period& base, TimeOfDay from, TimeOfDay until,
                                  std::int32_t longer_s) {
  std::int32_t begin_s = from.earliest_s - from.offset_s;
  std::int32_t end_s = until.latest_s - until.offset_s;
  while (end_s <= begin_s) end_s += day_s;
  while (end_s - begin_s > day_s) end_s -= day_s;
  end_s = std::min(end_s + longer_s, begin_s + day_s);
  int days_later = 0;
  while (begin_s < 0) {
    begin_s += day_s, end_s += day_s;
    --days_later;
  }
  while (begin_s >= day_s) {
    begin_s -= day_s, end_s -= day_s;
    ++days_later;
  }
  Period first = base;
  first.weekdays = weekdays_later(base.weekdays, days_later);
  first.from_s = begin_s;
  first.until_s = std::min(end_s, day_s);
  std::vector<Period> result{first};
  if (end_s > day_s) {
    Period second = base;
    second.weekdays = weekdays_later(base.weekdays, days_later + 1);
    second.from_s = 0;
    second.until_s = end_s - day_s;
    result.push_back(second);
  }
  return result;
}

std::vector<Period> joined(std::vector<Period> schedule) {
  const auto days = [](const Period& p) {
    return std::tie(p.weekdays, p.from_us, p.until_us, p.rounded);
  };
  std::stable_sort(schedule.begin(), schedule.end(), [&](const Period& a, const Period& b) {
    return days(a) != days(b) ? days(a) < days(b) : a.from_s < b.from_s;
  });
  std::vector<Period> all;
  for (Period& next : schedule) {
    if (all.empty() || days(all.back()) != days(next) || next.from_s > all.back().until_s) {
      all.push_back(std::move(next));
    } else {
      all.back().until_s = std::max(all.back().until_s, next.until_s);
    }
  }
  return all;
}

}  // namespace rtac::geometry::import
