#include <algorithm>
#include <string_view>

#include "compiler/geometry/import/outlines.h"
#include "compiler/geometry/import/readers.h"

namespace rtac::geometry::import {
namespace {

bool is_continuation(std::string_view text, std::size_t index) {
  return index < text.size() && (static_cast<unsigned char>(text[index]) & 0xc0U) == 0x80U;
}

// Bytes of the character at `index`; 0: no UTF-8. NUL counts as none: it is UTF-8, but no format
// has a use for it.
std::size_t length_of_character(std::string_view text, std::size_t index) {
  const auto first = static_cast<unsigned char>(text[index]);
  const auto second = index + 1 < text.size() ? static_cast<unsigned char>(text[index + 1]) : 0U;
  if (first < 0x80U) return first == 0 ? 0 : 1;
  if (!is_continuation(text, index + 1)) return 0;
  if (first >= 0xc2U && first < 0xe0U) return 2;
  if (!is_continuation(text, index + 2)) return 0;
  if ((first == 0xe0U && second < 0xa0U) || (first == 0xedU && second >= 0xa0U)) return 0;
  if (first >= 0xe0U && first < 0xf0U) return 3;
  if (!is_continuation(text, index + 3)) return 0;
  if ((first == 0xf0U && second < 0x90U) || (first == 0xf4U && second >= 0x90U)) return 0;
  return first >= 0xf0U && first < 0xf5U ? 4 : 0;
}

bool check_text(std::string_view text, const Limits& limits, Findings& findings) {
  if (text.starts_with("PK\x03\x04")) {
    return findings.fail("the whole text", "is a packed archive",
                         "unpack it; a .kmz holds a file doc.kml, which can be read");
  }
  if (text.size() > limits.bytes_max) {
    return findings.fail("the whole text",
                         "has " + std::to_string(text.size()) + " bytes; at most " +
                             std::to_string(limits.bytes_max) + " are read",
                         "simplify the outlines, or split the file");
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return findings.fail("the whole text", "is empty", "write the file again");
  }
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_of_character(text, i);
    if (text[i] == '\0') {
      return findings.fail(line_and_column(text, i), "this byte is zero, which no text has",
                           "take the zeros out: what has copied or sent the file has filled it up, "
                           "or has sent the end of a string of C with it");
    }
    if (length == 0 && i == 0 && (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))) {
      return findings.fail("the whole text", "is UTF-16", "save the file as text in UTF-8");
    }
    if (length == 0) {
      return findings.fail(line_and_column(text, i), "this byte is no UTF-8",
                           "save the file as text in UTF-8");
    }
    i += length;
  }
  return true;
}

Outcome read_format(Format format, std::string_view text, const Limits& limits) {
  switch (format) {
    case Format::geojson:
      return read_geojson(text, limits);
    case Format::wkt:
      return read_wkt(text, limits);
    case Format::qgc_plan:
      return read_qgc_plan(text, limits);
    case Format::waypoints:
      return read_waypoints(text, limits);
    case Format::kml:
      return read_kml(text, limits);
    case Format::ed269:
      return read_ed269(text, limits);
    case Format::ed318:
      return read_ed318(text, limits);
  }
  return Failure{"the whole text", "is of an unknown format", "name one of the formats"};
}

// Of the order of bytes, which UTF-8 does not need.
std::string_view without_mark(std::string_view text) {
  return text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text;
}

bool is_always(const Period& period) {
  const Period always;
  return !period.from_us && !period.until_us && period.weekdays == always.weekdays &&
         period.from_s == always.from_s && period.until_s == always.until_s;
}

// A refused area keeps no parts, so that nobody uses half of it. One period without limits makes
// the others empty words.
bool finish(Areas& areas, Findings& findings) {
  if (areas.areas.empty()) {
    return findings.fail("the whole text", "has no areas", "draw at least one");
  }
  for (Area& area : areas.areas) {
    if (area.refusal) area.parts.clear();
    const std::vector<Period> all = joined(area.schedule);
    if (std::any_of(all.begin(), all.end(), is_always)) area.schedule.clear();
  }
  return check_positions(areas, findings);
}

}  // namespace

std::optional<Failure> no_text(const std::string& text, const Limits& limits) {
  Findings findings;
  if (check_text(without_mark(text), limits, findings)) return std::nullopt;
  return findings.failure();
}

std::variant<Areas, Failure> read(Format format, const std::string& text, const Limits& limits) {
  Findings findings;
  const std::string_view content = without_mark(text);
  if (!check_text(content, limits, findings)) return *findings.failure();
  Outcome outcome = read_format(format, content, limits);
  if (auto* areas = std::get_if<Areas>(&outcome); areas != nullptr && !finish(*areas, findings)) {
    return *findings.failure();
  }
  return outcome;
}

}  // namespace rtac::geometry::import
