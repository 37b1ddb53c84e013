#include "compiler/geometry/import/times_in_text.h"

#include <array>
#include <string>
#include <vector>

#include "compiler/geometry/import/words.h"

namespace rtac::geometry::import {
namespace {

bool is_day_or_month(const Piece& piece) {
  constexpr std::array<std::string_view, 47> words{
      "mon",       "monday",  "tue",      "tues",     "tuesday",  "wed",   "wednesday", "thu",
      "thur",      "thurs",   "thursday", "fri",      "friday",   "sat",   "saturday",  "sun",
      "sunday",    "weekday", "weekend",  "weekdays", "weekends", "daily", "sunrise",   "sunset",
      "jan",       "january", "feb",      "february", "mar",      "march", "apr",       "april",
      "may",       "jun",     "june",     "jul",      "july",     "aug",   "august",    "sep",
      "september", "oct",     "october",  "nov",      "november", "dec",   "december"};
  return !piece.digits && is_one_of(piece.text, words);
}

// `8:00`, `2024-05`, `8 am`.
bool are_time(const Piece& a, const Piece& b) {
  if (!a.is_number(1, 4)) return false;
  if (!b.digits) return b.text == "am" || b.text == "pm";
  if (b.between == ":") return a.is_number(1, 2) && b.is_number(2, 2);
  const bool joined = b.between == "-" || b.between == "/" || b.between == ".";
  return joined && a.is_number(4, 4) && b.is_number(1, 2);
}
// `1.5.24`, `05/01/2024`.
bool are_date(const Piece& a, const Piece& b, const Piece& c) {
  const bool joined =
      b.between == c.between && (b.between == "-" || b.between == "/" || b.between == ".");
  return joined && a.is_number(1, 2) && b.is_number(1, 2) && c.is_number(2, 4);
}

}  // namespace

bool tells_time(std::string_view text) {
  constexpr std::size_t looked_at = 200, digits_of_dates = 8, digits_of_years = 4;
  const std::vector<Piece> pieces = pieces_of(text.substr(0, looked_at));
  if (pieces.size() == 1 && pieces[0].is_number(digits_of_years, digits_of_years)) return true;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (is_day_or_month(pieces[i])) return true;
    // 20240501, or seconds since 1970
    if (pieces[i].digits && pieces[i].text.size() >= digits_of_dates) return true;
    if (i >= 1 && are_time(pieces[i - 1], pieces[i])) return true;
    if (i >= 2 && are_date(pieces[i - 2], pieces[i - 1], pieces[i])) return true;
  }
  return false;
}

}  // namespace rtac::geometry::import
