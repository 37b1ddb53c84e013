// Prints how the verdict of a monitor without a robot is told at a glance (watch_glance.h), and the
// closer look for when it is not.
//
//   *_told(v, in, verdict)       the usual tick, without a call
//   *_closely(s, in, ..., verdict)   every other one
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/codegen/repeat_printer.h"
#include "compiler/codegen/watch.h"
#include "compiler/codegen/watch_glance.h"
#include "compiler/codegen/watch_look.h"

namespace rtac::codegen {

class WatchTold {
 public:
  // Tells `look` which inputs are seen at a glance. With margins nothing is.
  WatchTold(const ir::Module& module, const Names& names, WatchLook& look,
            std::set<std::string>& uses, Code& out);

  [[nodiscard]] bool is_told(std::size_t monitor) const { return glances_[monitor].has_value(); }
  // It is told, takes all of its inputs, and no other monitor asks for them: so it asks itself
  // whether they are there.
  [[nodiscard]] bool is_alone(std::size_t monitor) const;
  // Both functions; `judge`: the one that looks closely, of the view.
  void print(std::size_t monitor, const std::string& judge);
  // The statement that finds it; `verdict`: where to.
  [[nodiscard]] std::string call(std::size_t monitor, const std::string& verdict) const;

 private:
  using Glances = std::vector<std::optional<Glance>>;  // by monitor

  [[nodiscard]] Glances find() const;
  [[nodiscard]] std::string name(std::size_t monitor) const {
    return names_(watch_.monitors[monitor].name);
  }
  [[nodiscard]] std::string fresh(std::uint32_t channel) const {
    return "fresh_" + look_.members().channels[channel];
  }
  [[nodiscard]] std::string inputs() const { return "const " + prefix_ + "_monitors_in *in"; }
  void closely(std::size_t monitor, const std::string& judge);
  [[nodiscard]] std::string arrived(const Glance& glance);
  void missing(const Glance& glance, Code& to) const;
  void glanced(const Glance& glance, const std::vector<std::string>& counted, Code& to);
  [[nodiscard]] std::string all_inside(const Glance& glance);
  [[nodiscard]] std::string all_in_the_middle(const Glance& glance);
  [[nodiscard]] std::vector<std::pair<std::string, ir::Range>> ranges(const Glance& glance) const;
  std::string number_inside(const std::string& at, const ir::Range& range);
  std::string in_the_middle(const std::vector<std::string>& numbers, const ir::Range& range);
  void verdict_if(const std::string& condition, const std::string& verdict, Code& to) const;

  const ir::Module& module_;
  const ir::Watch& watch_;
  const Names& names_;
  WatchLook& look_;
  const WatchKernel& side_;
  const std::string prefix_;
  std::set<std::string>& uses_;
  Code& out_;
  const Glances glances_;
};

}  // namespace rtac::codegen
