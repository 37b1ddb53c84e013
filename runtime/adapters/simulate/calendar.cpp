#include "calendar.h"

#include <algorithm>
#include <cstdio>

namespace rtac::simulate {
namespace {

using sim::Property;
using sim::PropertyOp;

constexpr TimeUs second_us = 1'000'000, day_s = 86'400;
constexpr TimeUs day_us = second_us * day_s, week_us = 7 * day_us;
constexpr TimeUs first_monday_us = 4 * day_us;  // 1970-01-05
// Of a zone that comes every week any week shows it: one of 2026, so that times look familiar.
constexpr TimeUs week_of_runs = 2922;
// What has no first or no last moment ends 292,000 years away.
constexpr TimeUs year_9999_us = 253'402'300'800 * second_us;

TimeUs monday_us(TimeUs week) {
  return first_monday_us + week * week_us;
}
TimeUs week_of(TimeUs utc_us) {
  const TimeUs since_us = utc_us - first_monday_us;
  return since_us / week_us - (since_us % week_us < 0 ? 1 : 0);
}

bool is_in(const std::vector<Openings::Span>& spans, TimeUs at_us) {
  return std::any_of(spans.begin(), spans.end(), [at_us](const Openings::Span& span) {
    return span.from_us <= at_us && at_us < span.until_us;
  });
}
bool is_open(const Openings& zone, TimeUs utc_us) {
  return is_in(zone.once, utc_us) || is_in(zone.weekly, utc_us - monday_us(week_of(utc_us)));
}
// What lasts over midnight is two spans that touch: nothing changes there.
bool comes_or_goes(const Openings& zone, TimeUs utc_us) {
  return is_open(zone, utc_us - 1) != is_open(zone, utc_us);
}

// When it comes or goes, once, and in the week.
std::vector<TimeUs> changes(const Openings& zone, TimeUs week) {
  std::vector<TimeUs> moments;
  const auto note = [&](TimeUs utc_us) {
    if (utc_us > 0 && utc_us < year_9999_us && comes_or_goes(zone, utc_us)) {
      moments.push_back(utc_us);
    }
  };
  for (const Openings::Span& span : zone.once) {
    note(span.from_us);
    note(span.until_us);
  }
  for (const Openings::Span& span : zone.weekly) {
    note(monday_us(week) + span.from_us);
    note(monday_us(week) + span.until_us);
  }
  return moments;
}
std::vector<TimeUs> changes_between(const Openings& zone, TimeUs from_us, TimeUs until_us) {
  std::vector<TimeUs> moments;
  for (TimeUs week = week_of(from_us); week <= week_of(until_us); ++week) {
    for (const TimeUs at_us : changes(zone, week)) {
      if (at_us > from_us && at_us <= until_us) moments.push_back(at_us);
    }
  }
  return moments;
}

// `better`: the property holds rather where the part does; of a quantity: where it is greater.
void at_worst(Property& p, const std::vector<Openings>& calendar, TimeUs from_us, TimeUs until_us,
              bool better) {
  if (p.op == PropertyOp::open) {
    const Openings& zone = calendar[static_cast<std::size_t>(p.index)];
    const bool changes = !changes_between(zone, from_us, until_us).empty();
    const bool there = changes ? !better : is_open(zone, from_us);
    p.op = PropertyOp::truth;
    p.value = there ? 1 : 0;
    return;
  }
  const bool turns = p.op == PropertyOp::logical_not || p.op == PropertyOp::negate;
  const bool last_turns = p.op == PropertyOp::at_least || p.op == PropertyOp::subtract;
  for (std::size_t k = 0; k < p.of.size(); ++k) {
    const bool other_way = turns || (last_turns && k == 1);
    at_worst(p.of[k], calendar, from_us, until_us, better != other_way);
  }
}

// Days since 1970-01-01 of a date of the Gregorian calendar, by counting from a March on.
TimeUs days_of(int year, int month, int day) {
  const TimeUs y = month <= 2 ? year - 1 : year;
  const TimeUs since_march = (month + 9) % 12;
  return 365 * y + y / 4 - y / 100 + y / 400 + (153 * since_march + 2) / 5 + day - 719'469;
}

}  // namespace

std::vector<bool> open_at(const std::vector<Openings>& calendar, TimeUs utc_us) {
  std::vector<bool> open;
  for (const Openings& zone : calendar) open.push_back(is_open(zone, utc_us));
  return open;
}

std::vector<TimeUs> changes_between(const std::vector<Openings>& calendar, TimeUs from_us,
                                    TimeUs until_us) {
  std::vector<TimeUs> moments;
  for (const Openings& zone : calendar) {
    const std::vector<TimeUs> own = changes_between(zone, from_us, until_us);
    moments.insert(moments.end(), own.begin(), own.end());
  }
  std::sort(moments.begin(), moments.end());
  return moments;
}

Property at_its_worst(const Property& property, const std::vector<Openings>& calendar,
                      TimeUs from_us, TimeUs until_us) {
  Property p = property;
  at_worst(p, calendar, from_us, until_us, true);
  return p;
}

TimeUs longest_lead_us(const std::vector<Openings>& calendar) {
  TimeUs most_us = 0;
  for (const Openings& zone : calendar) most_us = std::max(most_us, zone.lead_us);
  return most_us;
}

TimeUs draw_begin(const std::vector<Openings>& calendar, TimeUs span_us, sim::Random& random) {
  std::vector<TimeUs> moments;
  for (const Openings& zone : calendar) {
    const std::vector<TimeUs> own = changes(zone, week_of_runs);
    moments.insert(moments.end(), own.begin(), own.end());
  }
  if (moments.empty()) return monday_us(week_of_runs);
  const auto which = static_cast<std::size_t>(random.below(std::int64_t(moments.size())));
  const TimeUs begin_us = moments[which] - longest_lead_us(calendar) - random.below(span_us);
  return std::max<TimeUs>(begin_us, 0);
}

std::string utc_text(TimeUs utc_us) {
  const TimeUs days = utc_us / day_us, s = utc_us % day_us / second_us;
  constexpr TimeUs days_per_year = 366;
  int year = 1970 + static_cast<int>(days / days_per_year), month = 12;
  while (days_of(year + 1, 1, 1) <= days) ++year;
  while (days_of(year, month, 1) > days) --month;
  const int day = static_cast<int>(days - days_of(year, month, 1)) + 1;
  constexpr std::size_t widest = 64;
  char text[widest];
  std::snprintf(text, widest, "%04d-%02d-%02dT%02d:%02d:%02dZ", year, month, day,
                static_cast<int>(s / 3600), static_cast<int>(s / 60 % 60),
                static_cast<int>(s % 60));
  return text;
}

std::optional<TimeUs> utc_of(const std::string& written) {
  constexpr std::size_t without_seconds = 17;  // as specifications may have it
  const bool whole = written.size() == without_seconds && written.back() == 'Z';
  const std::string text = whole ? written.substr(0, without_seconds - 1) + ":00Z" : written;
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
  if (std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2d:%2dZ", &year, &month, &day, &hour, &minute,
                  &second) != 6) {
    return std::nullopt;
  }
  if (year < 1970 || month < 1 || month > 12 || day < 1 || hour < 0 || hour > 23 || minute < 0 ||
      minute > 59 || second < 0 || second > 59) {
    return std::nullopt;
  }
  const TimeUs at_us =
      (days_of(year, month, day) * day_s + hour * 3600 + minute * 60 + second) * second_us;
  // a 30th of February, or what follows behind
  return utc_text(at_us) == text ? std::optional<TimeUs>(at_us) : std::nullopt;
}

}  // namespace rtac::simulate
