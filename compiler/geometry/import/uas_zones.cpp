#include "compiler/geometry/import/uas_zones.h"

#include <algorithm>
#include <array>

#include "compiler/geometry/import/moments.h"

namespace rtac::geometry::import {
namespace {

constexpr double foot_m = 0.3048;  // the international foot, exactly

// What is no whole second is kept as it is written: who needs it exactly can tell.
void note_fraction(Json value, Period& of) {
  if (value.string() && has_fraction_of_second(*value.string())) of.rounded = value.described();
}

bool read_moment(JsonReader& json, Json period, std::string_view name, Period& of,
                 std::optional<std::int64_t>& moment_us) {
  const auto value = JsonReader::optional_member(period, name);
  if (!value) return true;
  if (value->string()) moment_us = parse_moment_us(*value->string());
  note_fraction(*value, of);
  return moment_us || json.findings().fail(value->where(), "is " + value->described(),
                                           "a date and time with its zone, such as "
                                           "\"2026-03-31T22:00:00Z\"");
}

bool read_days(JsonReader& json, Json daily, std::uint8_t& days) {
  constexpr std::array<std::string_view, 7> names{"MON", "TUE", "WED", "THU", "FRI", "SAT", "SUN"};
  const auto list = json.required_array(daily, "day");
  if (!list) return false;
  days = 0;
  for (const Json item : list->items()) {
    const std::string_view name = item.string().value_or("");
    const auto* const found = std::find(names.begin(), names.end(), name);
    if (found == names.end() && name != "ANY") {
      return json.wrong_kind(item, "`MON` to `SUN` or `ANY`");
    }
    days = static_cast<std::uint8_t>(days | (name == "ANY" ? 0x7f : 1U << (found - names.begin())));
  }
  return days != 0 || json.wrong_kind(*list, "at least one day");
}

bool read_time(JsonReader& json, Json daily, std::string_view name, Period& of,
               std::optional<TimeOfDay>& time) {
  const auto value = JsonReader::optional_member(daily, name);
  if (!value) return true;
  if (value->string()) time = parse_time_of_day(*value->string());
  note_fraction(*value, of);
  return time || json.findings().fail(value->where(), "is " + value->described(),
                                      "a time of day up to 23:59:59 with its zone, such as "
                                      "\"22:00:00Z\"");
}

// Periods have nothing else: whatever it is, it may say when they apply.
bool only_members(JsonReader& json, Json object, std::initializer_list<std::string_view> known) {
  if (!json.check_letters(object, known)) return false;
  for (const Json member : object.items()) {
    if (std::find(known.begin(), known.end(), member.name()) != known.end()) continue;
    return json.findings().fail(member.where(), "is no member that a period has",
                                "take it out if it does not limit when the area applies");
  }
  return true;
}

// The formats have no 24:00: the last minute or second of a day is what they write for its end.
std::int32_t to_end_of_day_s(TimeOfDay time) {
  constexpr std::int32_t day_s = 86'400, minute_s = 60;
  const bool is_last = time.latest_s == day_s - 1 || time.latest_s == day_s - minute_s;
  return is_last ? day_s - time.latest_s : 0;
}

bool is_same(TimeOfDay a, TimeOfDay b) {
  return a.earliest_s - a.offset_s == b.earliest_s - b.offset_s;
}

bool add_daily(JsonReader& json, Json daily, Period base, Area& area) {
  if (!json.expect_object(daily) ||
      !only_members(json, daily, {"day", "startTime", "endTime", "startEvent", "endEvent"})) {
    return false;
  }
  if (!read_days(json, daily, base.weekdays)) return false;
  for (const char* name : {"startEvent", "endEvent"}) {
    if (const auto event = JsonReader::optional_member(daily, name)) {
      refuse(area, event->where(), "follows the sun: " + event->described(),
             "write `startTime` and `endTime` that hold on every day, with a margin");
      return true;
    }
  }
  base.where = daily.where();
  std::optional<TimeOfDay> from, until;
  if (!read_time(json, daily, "startTime", base, from) ||
      !read_time(json, daily, "endTime", base, until)) {
    return false;
  }
  if (!from && !until && base.weekdays == 0x7f) {
    area.schedule.push_back(base);
  } else if (!from || !until || is_same(*from, *until)) {
    refuse(area, daily.where(),
           from && until ? "ends when it starts" : "does not say both `startTime` and `endTime`",
           "write both, with their zone; a whole day is from 00:00Z to 23:59:59Z");
  } else {
    for (const Period& period : daily_periods(base, *from, *until, to_end_of_day_s(*until))) {
      area.schedule.push_back(period);
    }
  }
  return true;
}

bool read_limit(JsonReader& json, Json object, LimitNames names, double metres,
                std::optional<Altitude>& limit) {
  const auto value = JsonReader::optional_member(object, names.value);
  if (!value) return true;
  if (!value->number()) return json.wrong_kind(*value, "a number");
  const auto reference = json.required_text(object, names.reference);
  if (!reference) return false;
  constexpr std::array<std::pair<std::string_view, AltitudeReference>, 3> references{
      {{"AGL", AltitudeReference::ground},
       {"AMSL", AltitudeReference::mean_sea_level},
       {"WGS84", AltitudeReference::ellipsoid}}};
  for (const auto& [name, known] : references) {
    if (*reference != name) continue;
    limit = Altitude{*value->number() * metres, known};
    return true;
  }
  return json.findings().fail(object.where() + "." + std::string(names.reference),
                              "is " + quote(*reference), "`AGL`, `AMSL` or `WGS84`");
}

}  // namespace

bool add_periods(JsonReader& json, Json period, Area& area) {
  if (!json.expect_object(period) ||
      !only_members(json, period, {"permanent", "startDateTime", "endDateTime", "schedule"})) {
    return false;
  }
  Period base;
  base.where = period.where();
  if (!read_moment(json, period, "startDateTime", base, base.from_us) ||
      !read_moment(json, period, "endDateTime", base, base.until_us)) {
    return false;
  }
  if (base.from_us && base.until_us && *base.from_us >= *base.until_us) {
    refuse(area, period.where(), "ends before it starts", "`startDateTime` is the earlier one");
    return true;
  }
  const auto schedule = JsonReader::optional_member(period, "schedule");
  if (schedule && !schedule->is_array()) return json.wrong_kind(*schedule, "an array");
  if (schedule && schedule->kind() == JsonKind::numbers) {
    return json.wrong_kind(*schedule, "an array of daily periods");
  }
  const auto dailies = schedule ? schedule->items() : std::vector<Json>{};
  if (dailies.empty()) area.schedule.push_back(base);
  return std::all_of(dailies.begin(), dailies.end(),
                     [&](Json daily) { return add_daily(json, daily, base, area); });
}

bool read_limits(JsonReader& json, Json object, LimitNames lower, LimitNames upper, double metres,
                 Band& band) {
  return json.check_letters(object, {lower.value, lower.reference, upper.value, upper.reference}) &&
         read_limit(json, object, lower, metres, band.floor) &&
         read_limit(json, object, upper, metres, band.ceiling) &&
         check_band(band, object.where(), json.findings());
}

std::optional<double> metres_of_unit(JsonReader& json, Json object, std::string_view name) {
  const auto unit = json.required_text(object, name);
  if (!unit) return std::nullopt;
  if (*unit == "M" || *unit == "m") return 1.0;
  if (*unit == "FT" || *unit == "ft") return foot_m;
  json.findings().fail(object.where() + "." + std::string(name), "is " + quote(*unit),
                       "metres (`M`, `m`) or feet (`FT`, `ft`)");
  return std::nullopt;
}

bool set_restriction(JsonReader& json, Json object, std::string_view name, Area& area) {
  const auto restriction = json.required_text(object, name);
  if (!restriction) return false;
  area.restriction = *restriction;
  if (*restriction == "PROHIBITED") area.role = Role::keep_out;
  // ED-269 and ED-318 spell the authorisation differently; a U-space is of ED-318.
  for (const std::string_view known : {"PROHIBITED", "REQ_AUTHORISATION", "REQ_AUTHORIZATION",
                                       "CONDITIONAL", "NO_RESTRICTION", "USPACE"}) {
    if (*restriction == known) return true;
  }
  return json.findings().fail(object.where() + "." + std::string(name), "is " + quote(*restriction),
                              "`PROHIBITED`, `REQ_AUTHORISATION`, `CONDITIONAL` or "
                              "`NO_RESTRICTION`");
}

}  // namespace rtac::geometry::import
