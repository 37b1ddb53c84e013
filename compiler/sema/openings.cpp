#include "compiler/sema/openings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>

#include "compiler/sema/visit.h"

namespace rtac::sema {
namespace {

constexpr std::int64_t minute_s = 60, hour_s = 60 * minute_s, day_s = 24 * hour_s;
constexpr std::array<const char*, 7> day_names = {"monday", "tuesday",  "wednesday", "thursday",
                                                  "friday", "saturday", "sunday"};
constexpr std::uint8_t every_day = 0x7F;

// A moment of history, or a time of every day.
struct Moment {
  bool has_date;
  std::int64_t s;  // since 1970-01-01T00:00Z, or since midnight
};

// Reads digits and signs from the left.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}
  // A number of so many digits.
  std::optional<int> number(std::size_t digits) {
    int value = 0;
    if (rest_.size() < digits) return std::nullopt;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + digits, value);
    if (error != std::errc{} || end != rest_.data() + digits) return std::nullopt;
    rest_.remove_prefix(digits);
    return value;
  }
  bool sign(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

class OpeningChecker {
 public:
  explicit OpeningChecker(Context& context) : context_(context) {}

  std::optional<Opening> check(const syntax::Opening& written) {
    const auto from = moment(written.from, false);
    const auto until = moment(written.until, true);
    const auto days = days_of(written.days);
    if (!from || !until || !days || !ends_agree(written, *from, *until)) return std::nullopt;
    if (from->s >= until->s) {
      report_reversed(written, *from);
      return std::nullopt;
    }
    return Opening{from->has_date ? std::uint8_t{0} : *days, from->s, until->s};
  }

 private:
  std::optional<Moment> moment(const syntax::Text& written, bool is_end) {
    const bool has_date = written.text.find('T') != std::string::npos;
    Scanner scanner(written.text);
    std::optional<std::int64_t> midnight = 0;
    if (has_date) {
      midnight = date(scanner, written);
      if (!midnight) return std::nullopt;
    }
    const auto of_day = time(scanner, written, is_end && !has_date);
    if (!of_day) return std::nullopt;
    const bool in_utc = !has_date || scanner.sign('Z');
    if (!in_utc || !scanner.at_end()) {
      report(written, "the moment `" + written.text + "` is not written in UTC",
             has_date ? "moments end in `Z`, as in `2026-05-01T08:00Z`: bring it to UTC"
                      : "times of day are in UTC, and written as `07:30` or `07:30:15`");
      return std::nullopt;
    }
    return Moment{has_date, *midnight + *of_day};
  }

  // The first second of the day.
  std::optional<std::int64_t> date(Scanner& scanner, const syntax::Text& written) {
    const auto year = scanner.number(4);
    if (!year || !scanner.sign('-')) return malformed(written);
    const auto month = scanner.number(2);
    if (!month || !scanner.sign('-')) return malformed(written);
    const auto day = scanner.number(2);
    if (!day || !scanner.sign('T')) return malformed(written);
    const std::chrono::year_month_day date{std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    constexpr int first_year = 1970;
    if (!date.ok() || *year < first_year) {
      const std::string shown = written.text.substr(0, written.text.find('T'));
      report(written,
             date.ok() ? "`" + shown + "` is before the clock begins" : "there is no day " + shown,
             date.ok() ? "moments from 1970-01-01T00:00Z on work" : help_of(date));
      return std::nullopt;
    }
    return std::chrono::sys_days(date).time_since_epoch().count() * day_s;
  }
  static std::string help_of(const std::chrono::year_month_day& date) {
    if (!date.month().ok()) return "months are 01 to 12";
    const auto last = (date.year() / date.month() / std::chrono::last).day();
    return "days of that month are 01 to " + std::to_string(static_cast<unsigned>(last));
  }

  std::optional<std::int64_t> time(Scanner& scanner, const syntax::Text& written,
                                   bool may_be_midnight) {
    const auto hour = scanner.number(2);
    if (!hour || !scanner.sign(':')) return malformed(written);
    const auto minute = scanner.number(2);
    if (!minute) return malformed(written);
    std::optional<int> second = 0;
    if (scanner.sign(':')) second = scanner.number(2);
    if (!second) return malformed(written);
    const std::int64_t of_day = *hour * hour_s + *minute * minute_s + *second;
    const bool is_midnight = may_be_midnight && of_day == day_s;
    if ((*hour < 24 || is_midnight) && *minute < 60 && *second < 60) return of_day;
    report(written, "there is no time of day `" + written.text + "`",
           "hours are 00 to 23, minutes and seconds 00 to 59; a time of every day may end at "
           "`24:00`");
    return std::nullopt;
  }

  std::optional<std::int64_t> malformed(const syntax::Text& written) {
    report(written, "`" + written.text + "` is not a moment",
           "write `2026-05-01T08:00Z`, or a time of day such as `07:30`, seconds behind another "
           "`:`");
    return std::nullopt;
  }
  void report(const syntax::Text& written, const std::string& message, const std::string& help) {
    context_.report(Finding(Code::moment_invalid, written.range, message)
                        .label("not a moment in UTC")
                        .help(help));
  }

  std::optional<std::uint8_t> days_of(const std::vector<syntax::Name>& names) {
    std::uint8_t days = names.empty() ? every_day : 0;
    bool good = true;
    for (const syntax::Name& name : names) {
      const auto* const found = std::find(day_names.begin(), day_names.end(), name.text);
      if (found == day_names.end()) {
        context_.unknown_word(name, "a day of the week", {day_names.begin(), day_names.end()});
        good = false;
        continue;
      }
      days = static_cast<std::uint8_t>(days | 1U << (found - day_names.begin()));
    }
    return good ? std::optional(days) : std::nullopt;
  }

  bool ends_agree(const syntax::Opening& written, const Moment& from, const Moment& until) {
    const bool has_days = !written.days.empty();
    if (from.has_date == until.has_date && !(from.has_date && has_days)) return true;
    context_.report(
        Finding(Code::moment_invalid, written.range,
                from.has_date == until.has_date ? "the day of the week of a date is known"
                                                : "one end has a date, the other has none")
            .label("once, or every week?")
            .help("write two dates, `2026-05-01T08:00Z .. 2026-05-01T18:00Z`, or two times of "
                  "day, `monday, friday 07:30 .. 16:00`"));
    return false;
  }

  void report_reversed(const syntax::Opening& written, const Moment& from) {
    const std::string &first = written.from.text, &last = written.until.text;
    context_.report(
        Finding(Code::opening_reversed, written.range, "nothing is from " + first + " to " + last)
            .label("ends before it begins")
            .help(from.has_date ? "swap the two moments"
                                : "what lasts over midnight is two windows: `" + first +
                                      " .. 24:00 or 00:00 .. " + last + "`"));
  }

  Context& context_;
};

std::string time_text(std::int64_t of_day_s) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%02d:%02d:%02d", static_cast<int>(of_day_s / hour_s),
                static_cast<int>(of_day_s % hour_s / minute_s),
                static_cast<int>(of_day_s % minute_s));
  return text.data();
}
std::string moment_text(std::int64_t s) {
  const std::int64_t of_day_s = (s % day_s + day_s) % day_s;
  const std::chrono::year_month_day date{
      std::chrono::sys_days(std::chrono::days((s - of_day_s) / day_s))};
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
  return text.data() + time_text(of_day_s) + "Z";
}

}  // namespace

std::vector<Opening> check_openings(Context& context, const std::vector<syntax::Opening>& written) {
  std::vector<Opening> openings;
  if (written.size() > max_openings) {
    const std::string most = std::to_string(max_openings);
    context.report(Finding(Code::limit_exceeded, written[max_openings].range,
                           "a zone has more than " + most + " windows of time")
                       .label("one too many")
                       .help("up to " + most + " work; use two zones"));
    return openings;
  }
  for (const syntax::Opening& each : written) {
    const auto opening = OpeningChecker(context).check(each);
    if (opening) openings.push_back(*opening);
  }
  return openings;
}

namespace {

constexpr std::int64_t week_s = 7 * day_s;

// The Monday at whose midnight the week of a moment begins.
std::int64_t week_of(std::int64_t s) {
  constexpr std::int64_t first_monday_s = 4 * day_s;  // 1970-01-05
  const std::int64_t since = s - first_monday_s;
  return s - (since % week_s + week_s) % week_s;
}
// Whether a window begins before `s + lasting_s`, and ends after `s`.
bool is_within(const Opening& opening, std::int64_t s, std::int64_t lasting_s) {
  const auto meets = [&](std::int64_t midnight_s) {
    return midnight_s + opening.from_s < s + lasting_s && midnight_s + opening.until_s > s;
  };
  if (opening.days == 0) return meets(0);
  for (std::int64_t day = -7; day < 14; ++day) {
    const auto of_week = static_cast<unsigned>((day + 7) % 7);
    if ((opening.days >> of_week & 1U) != 0 && meets(week_of(s) + day * day_s)) return true;
  }
  return false;
}

}  // namespace

bool are_ever_gone(const Spec& spec, const std::vector<const Expr*>& speaking,
                   std::int64_t lasting_s) {
  std::vector<Opening> all;
  const auto add = [&](ZoneId id) {
    all.insert(all.end(), spec[id].openings.begin(), spec[id].openings.end());
  };
  for (const Expr* each : speaking) {
    for_each_expr(*each, [&](const Expr& part) {
      if (const auto* v = std::get_if<ZoneOpen>(&part.node)) add(v->zone);
      const auto* v = std::get_if<WhileOpen>(&part.node);
      const auto* zone = v != nullptr ? std::get_if<ZoneId>(&v->what) : nullptr;
      if (zone != nullptr) add(*zone);
    });
  }
  std::int64_t first_s = 0, last_s = 0;
  std::vector<std::int64_t> moments;
  for (const Opening& opening : all) {
    if (opening.days != 0) continue;
    if (opening.from_s > since_ever_s) first_s = std::min(first_s, opening.from_s);
    if (opening.until_s == for_ever_s) continue;
    last_s = std::max(last_s, opening.until_s);
    moments.push_back(opening.until_s);
  }
  for (const std::int64_t week : {week_of(first_s) - 2 * week_s, week_of(last_s) + 2 * week_s}) {
    moments.push_back(week);
    for (const Opening& opening : all) {
      for (std::int64_t day = 0; opening.days != 0 && day < 7; ++day) {
        if ((opening.days >> static_cast<unsigned>(day) & 1U) == 0) continue;
        moments.push_back(week + day * day_s + opening.until_s);
      }
    }
  }
  return std::ranges::any_of(moments, [&](std::int64_t s) {
    return std::ranges::none_of(
        all, [&](const Opening& opening) { return is_within(opening, s, lasting_s); });
  });
}

std::string text_of(const Opening& opening) {
  if (opening.days == 0) {
    const bool begins = opening.from_s > since_ever_s, ends = opening.until_s < for_ever_s;
    return (begins ? moment_text(opening.from_s) + " .." : "..") +
           (ends ? " " + moment_text(opening.until_s) : "");
  }
  std::string text;
  for (std::size_t day = 0; day < day_names.size(); ++day) {
    if ((opening.days >> day & 1U) != 0)
      text += (text.empty() ? "" : ", ") + std::string(day_names[day]);
  }
  return text + " " + time_text(opening.from_s) + " .. " + time_text(opening.until_s);
}

}  // namespace rtac::sema
