// Shorthand for the tests of readers.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "compiler/geometry/import/areas.h"

namespace rtac::geometry::import {

// The areas of a text that can be read; none, and a failed test, of another one.
inline Areas areas_of(Format format, const std::string& text, const Limits& limits = {}) {
  auto outcome = read(format, text, limits);
  if (const auto* failure = std::get_if<Failure>(&outcome)) {
    ADD_FAILURE() << failure->where << ": " << failure->message << " (" << failure->help << ")";
    return {};
  }
  return std::get<Areas>(std::move(outcome));
}

inline Area only_area(Format format, const std::string& text) {
  Areas areas = areas_of(format, text);
  EXPECT_EQ(areas.areas.size(), 1U);
  return areas.areas.size() == 1 ? areas.areas.front() : Area{};
}

// `WHERE: MESSAGE (HELP)`, empty when the text can be read with its axes in the order of the
// format; no part may be missing.
inline std::string failure_of(Format format, const std::string& text, const Limits& limits = {}) {
  const auto outcome = read(format, text, limits);
  const auto* areas = std::get_if<Areas>(&outcome);
  if (areas != nullptr && !areas->only_turned) return {};
  const auto* failure = areas != nullptr ? &*areas->only_turned : std::get_if<Failure>(&outcome);
  EXPECT_FALSE(failure->where.empty());
  EXPECT_FALSE(failure->message.empty());
  EXPECT_FALSE(failure->help.empty());
  return failure->where + ": " + failure->message + " (" + failure->help + ")";
}

inline std::string refusal_of(const Area& area) {
  EXPECT_TRUE(area.parts.empty());
  if (!area.refusal) return {};
  return area.refusal->where + ": " + area.refusal->message + " (" + area.refusal->help + ")";
}

inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "`" << text << "` lacks `" << part << "`";
}

inline const Polygon& polygon_of(const Area& area, std::size_t part = 0) {
  return std::get<Polygon>(area.parts.at(part).shape);
}
inline const Circle& circle_of(const Area& area, std::size_t part = 0) {
  return std::get<Circle>(area.parts.at(part).shape);
}

inline bool operator==(Position a, Position b) {
  return a.x == b.x && a.y == b.y;
}

}  // namespace rtac::geometry::import
