#include "compiler/geometry/import/property_limits.h"

#include <algorithm>
#include <cctype>

#include "compiler/geometry/import/words.h"

namespace rtac::geometry::import {
namespace {

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

// Heights are called so, and other things, too: the value decides. `base_id` numbers bases.
bool may_name_height(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 14> whole{
      "upper", "lower", "floor", "top",  "bottom", "base",     "ceil",
      "fl",    "hmax",  "hmin",  "zmax", "zmin",   "upperval", "lowerval"};
  constexpr std::array<std::string_view, 2> axes{"h", "z"};
  constexpr std::array<std::string_view, 2> ends{"max", "min"};
  constexpr std::array<std::string_view, 12> others{"id",    "ids",   "uid", "uuid",
                                                    "count", "index", "key", "name",
                                                    "area",  "speed", "url", "number"};
  if (has_word(words, others)) return false;
  return has_word(words, whole) || (has_word(words, axes) && has_word(words, ends));
}

// Runs of letters, in small ones, and of digits: `fl`, `95`.
std::vector<std::string> pieces_of(std::string_view text) {
  std::vector<std::string> pieces;
  char before = ' ';
  for (const char c : text) {
    const bool goes_on = is_digit(c) ? is_digit(before) : is_letter(c) ? is_letter(before) : true;
    if (!goes_on) pieces.emplace_back();
    if (is_digit(c) || is_letter(c)) {
      pieces.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    before = c;
  }
  return pieces;
}

// `-5`, `FL95`, `up to 400 ft`; not `Building 12`.
bool is_text_of_height(std::string_view text) {
  constexpr std::array<std::string_view, 14> units{"m",    "metre", "metres", "meter", "meters",
                                                   "km",   "ft",    "foot",   "feet",  "agl",
                                                   "amsl", "msl",   "asl",    "gnd"};
  constexpr std::size_t looked_at = 200;  // a height is said shortly, and texts may be huge
  const std::vector<std::string> pieces = pieces_of(text.substr(0, looked_at));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!is_digit(pieces[i].front())) continue;
    if (i == 0 || pieces[i - 1] == "fl") return true;
    if (i + 1 < pieces.size() && is_one_of(pieces[i + 1], units)) return true;
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

bool is_name_of_time(const std::string& name) {
  constexpr std::array<std::string_view, 27> parts{
      "validfrom",   "validto",      "validuntil",    "validthrough", "validsince", "validity",
      "starttime",   "endtime",      "startdate",     "enddate",      "begintime",  "begindate",
      "timefrom",    "timeuntil",    "datefrom",      "dateuntil",    "schedule",   "expire",
      "expiry",      "expiration",   "effective",     "timesofuse",   "activefrom", "activeto",
      "activeuntil", "openinghours", "operatinghours"};
  constexpr std::array<std::string_view, 5> whole{"start", "end", "begin", "from", "until"};
  return has_part(name, parts) || is_one_of(name, whole);
}

}  // namespace

bool is_limit_of_height(Json property) {
  const std::vector<std::string> words = words_of(property.name());
  if (!is_name_of_height(words)) return may_name_height(words) && says_height(property);
  if (const auto text = property.string()) return digits_of(*text) > 0;
  return property.kind() != JsonKind::null && !property.boolean();
}

bool is_limit_of_time(Json property) {
  if (!is_name_of_time(joined(words_of(property.name())))) return false;
  // seconds since 1970, or days as 20240501; fewer are a count of something
  if (const auto number = property.number()) return *number >= 10'000'000;
  if (const auto text = property.string()) return digits_of(*text) >= 3;  // `8:00`
  return !property.items().empty() || !property.numbers().empty();
}

}  // namespace rtac::geometry::import
