// Choices between quantities whose condition a kernel rounds: where the margin of the condition is
// within its bound, the kernel may take both sides for possible.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compiler/ir/rounding.h"
#include "tests/differential/engines.h"

namespace rtac::differential {

// The monitors with such choices, the conditions of which are inputs of their own: true or false
// where the kernel has to decide them, else unknown. What the reference finds then, with the bound
// of what is rounded besides, is all that a kernel may leave open.
class OpenedChoices {
 public:
  // Of a specification that has no mistakes.
  explicit OpenedChoices(const std::string& text);
  // By monitor of the specification; empty: it has no such choice.
  [[nodiscard]] Findings find(const Steps& run) const;
  [[nodiscard]] const ir::Rounding& bound(std::size_t monitor) const;

 private:
  void open(const std::vector<bool>& rounded);
  [[nodiscard]] Steps with_conditions(const Steps& run,
                                      const std::vector<std::string>& letters) const;
  [[nodiscard]] char decided(std::size_t condition, const Finding& opened) const;

  std::unique_ptr<Checked> checked_;  // first the monitors, then the conditions of choices
  driver::KernelInterface interface_;
  std::vector<std::size_t> opened_;  // monitors of the specification
  std::vector<ir::Rounding> bounds_;
  std::size_t conditions_ = 0, monitors_ = 0;
};

}  // namespace rtac::differential
