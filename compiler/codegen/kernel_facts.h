// Prints the facts of a decision: what its monitors say of plain inputs, parameters and the past,
// judged once a tick like a monitor without a robot.
#pragma once

#include <optional>

#include "compiler/codegen/kernel_blocks.h"
#include "compiler/codegen/kernel_decision.h"
#include "compiler/codegen/watch_look.h"

namespace rtac::codegen {

class FactPrinter : public DecisionPrinter {
 public:
  FactPrinter(const ir::Module& module, const ir::Decision& decision, const Names& names,
              std::set<std::string>& uses, Code& out);

  void print_signals();  // the view of the inputs; how samples come into it
  void print_facts();    // a function for each; what a missed tick tells; _facts_judge(v, s, ...)

 protected:
  void init_facts(Code& to) const;
  // Where the robot is with respect to zones that are received, once the inputs are known.
  void hold_against_received(Code& to);
  // Whether some fact speaks of the robot: then the view is to look first.
  [[nodiscard]] bool facts_of_robot() const;

 private:
  void fact(std::size_t index, BlockPrinter& blocks);
  void catch_up();
  void blind_robot(Code& body);
  void look(Code& tick);
  void look_again(Code& body);
  void judge();

  std::optional<WatchLook> look_;  // none: no signals
};

}  // namespace rtac::codegen
