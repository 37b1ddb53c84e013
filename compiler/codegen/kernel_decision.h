// What the printers of one periodic decision share: its names, its horizons, and the types and
// constants that its functions are written with.
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/codegen/code.h"
#include "compiler/codegen/names.h"
#include "compiler/ir/module.h"
#include "compiler/ir/printer.h"

namespace rtac::codegen {

// What the monitor is for, and where it says so.
std::string requirement(const ir::Monitor& monitor);

class DecisionPrinter {
 public:
  DecisionPrinter(const ir::Module& module, const ir::Decision& decision, const Names& names,
                  std::set<std::string>& uses, Code& out);

  // Constants stand between #define and #undef, so that functions read the same in every decision
  // of the file.
  void print_constants();
  void print_view();
  void close();

 protected:
  // Is some property about other robots?
  [[nodiscard]] bool pairs() const { return pairs_; }
  void use(std::initializer_list<const char*> names) { uses_.insert(names.begin(), names.end()); }
  [[nodiscard]] std::size_t horizon_of(const ir::Monitor& m) const;
  // The zones that some monitor compares the robot's own position with, each once.
  [[nodiscard]] std::vector<ir::ZoneIndex> own_places() const;
  // The measurements of the robot itself whose age some fact compares, each once.
  [[nodiscard]] std::vector<ir::Sensed> aged() const;
  // Does a test of others, or of agents, stop recoveries?
  [[nodiscard]] bool gated() const { return (pairs() && separation_) || !gaps_.empty(); }
  // Of the monitor of such a test that looks furthest.
  [[nodiscard]] std::size_t separation_horizon() const;

  const ir::Module& module_;
  const ir::Decision& d_;
  const Names& names_;
  const std::string id_, p_, name_, up_, view_;
  std::set<std::string>& uses_;
  Code& out_;
  std::vector<std::int64_t> horizons_;           // look-ahead and latency, us, each once
  std::optional<std::int64_t> separation_;       // largest standoff; none: no separation monitor
  std::map<ir::AgentIndex, std::int64_t> gaps_;  // to agents, that whoever moves keeps
  bool pairs_ = false;

 private:
  void print_agents();
  void print_keeps();
  void print_body(const std::string& name, std::int64_t position_age_us,
                  std::int64_t velocity_age_us);
  std::vector<std::string> defined_;
};

}  // namespace rtac::codegen
