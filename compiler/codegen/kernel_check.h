// What a tick knows and what every monitor finds in it: the functions of the monitors of a periodic
// decision, and those that call them.
#pragma once

#include "compiler/codegen/kernel_blocks.h"
#include "compiler/codegen/kernel_facts.h"

namespace rtac::codegen {

class CheckPrinter : public FactPrinter {
 public:
  using FactPrinter::FactPrinter;
  void print_monitors();
  void print_look();  // sets what is within reach
  void print_course(Code& to);
  void print_measure();  // inputs -> estimates
  void print_check();    // fills the findings of all monitors
  void print_predict();  // the same under the motion of every recovery, to coordinate by

 private:
  [[nodiscard]] std::string function(const ir::Monitor& m, const char* what) const;
  [[nodiscard]] std::string ahead(const ir::Monitor& m);
  void print_monitor(const ir::Monitor& m, BlockPrinter& blocks);
  void in_order(Code& to, const std::string& sample, const std::string& last,
                const std::string& fault);
  void measure_self(Code& to);
  void measure_charge(Code& to);
  void measure_ages(Code& to);
  void measure_other(Code& to);
  void measure_near(Code& to);
  [[nodiscard]] std::string heard() const;
  [[nodiscard]] std::string is_far();
  void measure_agents(Code& to);
  void print_horizon(std::size_t horizon, Code& to);
  void predict_row(Code& to);
  [[nodiscard]] bool uses_battery() const;
  template <class Each>
  void for_monitors(std::size_t horizon, const Each& each) const;
};

}  // namespace rtac::codegen
