// What readers share to say what is wrong. Internal to this folder.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/geometry/import/areas.h"

namespace rtac::geometry::import {

// Text of the file between back-ticks: cut when long, with what cannot be shown left out.
std::string quote(std::string_view text);
// The shortest text that reads back as the same number.
std::string shown(double value);
std::string shown(Position position);  // `(x, y)`
// `line 3, column 7`, counted from 1 in bytes; `offset` may be the end.
std::string line_and_column(std::string_view text, std::size_t offset);

// The same for many places of one text.
class Lines {
 public:
  explicit Lines(std::string_view text);
  std::string place(std::size_t offset) const;

 private:
  std::vector<std::size_t> starts_;
};

// Readers return as soon as something is wrong; the first failure is the one that is told.
class Findings {
 public:
  // Always false, so that `return fail(...)` ends a step.
  bool fail(std::string where, std::string message, std::string help) {
    if (!failure_) failure_ = {std::move(where), std::move(message), std::move(help)};
    return false;
  }
  bool fail(Failure failure) {
    if (!failure_) failure_ = std::move(failure);
    return false;
  }
  const std::optional<Failure>& failure() const { return failure_; }

 private:
  std::optional<Failure> failure_;
};

}  // namespace rtac::geometry::import
