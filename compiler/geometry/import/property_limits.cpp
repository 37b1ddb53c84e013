#include "compiler/geometry/import/property_limits.h"

#include <algorithm>

#include "compiler/geometry/import/times_in_text.h"
#include "compiler/geometry/import/words.h"

namespace rtac::geometry::import {
namespace {

constexpr std::size_t looked_at = 200;  // limits are said shortly, and texts may be huge

std::size_t digits_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_digit));
}

// Nothing but a height is called so.
bool is_name_of_height(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 11> parts{
      "upperlimit", "lowerlimit", "verticallimit", "heightlimit", "altitude",   "ceiling",
      "maxheight",  "minheight",  "maxalt",        "minalt",      "flightlevel"};
  constexpr std::array<std::string_view, 12> whole{"alt",       "altmax",     "altmin", "heights",
                                                   "elevation", "elevations", "ele",    "elev",
                                                   "agl",       "msl",        "amsl",   "asl"};
  return has_part(joined(words), parts) || has_word(words, whole) ||
         std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return word.ends_with("height"); });
}

// `base_id`, `effective_area`.
bool names_other_thing(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 12> others{"id",    "ids",   "uid", "uuid",
                                                    "count", "index", "key", "name",
                                                    "area",  "speed", "url", "number"};
  return has_word(words, others);
}

// Heights are called so, and other things, too: the value decides. `base_id` numbers bases.
bool may_name_height(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 14> whole{
      "upper", "lower", "floor", "top",  "bottom", "base",     "ceil",
      "fl",    "hmax",  "hmin",  "zmax", "zmin",   "upperval", "lowerval"};
  constexpr std::array<std::string_view, 2> axes{"h", "z"};
  constexpr std::array<std::string_view, 2> ends{"max", "min"};
  if (names_other_thing(words)) return false;
  return has_word(words, whole) || (has_word(words, axes) && has_word(words, ends));
}

// `-5`, `FL95`, `up to 400 ft`; not `Building 12`.
bool is_text_of_height(std::string_view text) {
  constexpr std::array<std::string_view, 14> units{"m",    "metre", "metres", "meter", "meters",
                                                   "km",   "ft",    "foot",   "feet",  "agl",
                                                   "amsl", "msl",   "asl",    "gnd"};
  const std::vector<Piece> pieces = pieces_of(text.substr(0, looked_at));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].digits) continue;
    if (i == 0 || pieces[i - 1].text == "fl") return true;
    if (i + 1 < pieces.size() && is_one_of(pieces[i + 1].text, units)) return true;
  }
  return false;
}

// Also within an object or an array, such as `{"value": 120, "unit": "m"}`.
bool says_height(Json value) {
  if (value.number() || !value.numbers().empty()) return true;
  if (const auto text = value.string()) return is_text_of_height(*text);
  const auto items = value.items();
  return std::any_of(items.begin(), items.end(), says_height);
}

// Nothing but a limit of time is called so.
bool is_name_of_time(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 28> parts{
      "validfrom",    "validto",        "validuntil", "validthrough", "validsince", "validity",
      "starttime",    "endtime",        "startdate",  "enddate",      "begintime",  "begindate",
      "timefrom",     "timeuntil",      "datefrom",   "dateuntil",    "schedule",   "expire",
      "expiry",       "expiration",     "timesofuse", "activefrom",   "activeto",   "activeuntil",
      "openinghours", "operatinghours", "applicab",   "timeperiod"};
  return !names_other_thing(words) && has_part(joined(words), parts);
}
// Limits of time are called so, and other things, too: the value decides.
bool may_name_time(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 7> parts{"start", "end",  "begin",    "from",
                                                  "until", "till", "effective"};
  constexpr std::array<std::string_view, 8> whole{"valid", "active", "when", "time",
                                                  "times", "hours",  "days", "period"};
  return !names_other_thing(words) && (has_word(words, parts) || is_one_of(joined(words), whole));
}

// Also within an object or an array, such as `{"end": "2024-05-01"}`.
bool says_time(Json value) {
  // seconds since 1970, or days as 20240501; fewer are a count of something
  constexpr double least = 10'000'000;
  if (const auto number = value.number()) return *number >= least;
  if (const auto text = value.string()) return tells_time(*text);
  const auto numbers = value.numbers();
  if (std::any_of(numbers.begin(), numbers.end(), [](double n) { return n >= least; })) return true;
  const auto items = value.items();
  return std::any_of(items.begin(), items.end(), says_time);
}
// `never`, and nothing at all.
bool is_said(std::string_view text) {
  constexpr std::array<std::string_view, 6> no_limits{"none",      "never",     "always",
                                                      "unlimited", "permanent", "null"};
  const std::vector<Piece> pieces = pieces_of(text.substr(0, looked_at));
  return !pieces.empty() && !(pieces.size() == 1 && is_one_of(pieces[0].text, no_limits));
}

}  // namespace

bool is_limit_of_height(Json property) {
  const std::vector<std::string> words = words_of(property.name());
  if (!is_name_of_height(words)) return may_name_height(words) && says_height(property);
  if (const auto text = property.string()) return digits_of(*text) > 0;
  return property.kind() != JsonKind::null && !property.boolean();
}
bool is_limit_of_height(std::string_view name, std::string_view text) {
  const std::vector<std::string> words = words_of(name);
  if (!is_name_of_height(words)) return may_name_height(words) && is_text_of_height(text);
  return digits_of(text) > 0;
}

bool is_limit_of_time(Json property) {
  const std::vector<std::string> words = words_of(property.name());
  if (!is_name_of_time(words)) return may_name_time(words) && says_time(property);
  if (const auto text = property.string()) return is_said(*text);
  return property.kind() != JsonKind::null && !property.boolean();
}
bool is_limit_of_time(std::string_view name, std::string_view text) {
  const std::vector<std::string> words = words_of(name);
  return is_name_of_time(words) ? is_said(text) : may_name_time(words) && tells_time(text);
}

}  // namespace rtac::geometry::import
