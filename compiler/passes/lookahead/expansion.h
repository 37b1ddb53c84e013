// What a property becomes when it has to hold on everything within reach: the walk over its
// connectives. What each atom becomes: registry.h.
#pragma once

#include <optional>
#include <string>

#include "compiler/diagnostics/engine.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/module.h"

namespace rtac::passes::lookahead {

// A comparison of a property, and the block that its transformer adds to.
struct Atom {
  const ir::Block& from;
  const ir::AtLeast& compare;
  const SourceRange& source;
  ir::Block& to;
};

// Of one monitor. The transformers of atoms share it.
class Expansion {
 public:
  Expansion(const ir::Module& module, const ir::Decision& decision, ir::Monitor& monitor,
            diag::Engine& diagnostics)
      : module_(module), decision_(decision), monitor_(monitor), diagnostics_(diagnostics) {}

  // The whole property; the unit of its margin, if all atoms share one.
  ir::Block run();

  // ---- for transformers ----

  [[nodiscard]] const ir::Module& module() const { return module_; }
  [[nodiscard]] const ir::Decision& decision() const { return decision_; }
  [[nodiscard]] const ir::Monitor& monitor() const { return monitor_; }
  [[nodiscard]] const ir::Lookahead& look() const { return monitor_.lookahead; }

  // What holds where `id` surely fails on everything within reach: the negation, moved inwards.
  ir::ValueId negated(const ir::Block& from, ir::ValueId id, ir::Block& to);
  // What the parameters add to a need, at their present values; none: nothing.
  std::optional<ir::ValueId> more_of(const ir::Need& need, const ir::Unit& unit,
                                     const SourceRange& source, ir::Block& to) const;

  void decides_in(const ir::Unit& unit);
  // Of the members of a count neither the margin decides nor the distance gates.
  [[nodiscard]] bool counting() const { return counting_; }
  void counting(bool on) { counting_ = on; }
  void keeps_apart(std::int64_t least_mm);
  // `on_legs`: they rest on the declared tracking.
  void judges_waypoints(bool on_legs);
  void judges_commands() { commands_judged_ = true; }
  void without_effect(std::string what, std::string help);
  void report(diag::Diagnostic diagnostic) { diagnostics_.report(std::move(diagnostic)); }
  // 5006, with the forms of the registry; the margin that stands in its place.
  // `first`: of the help.
  ir::ValueId refuse(const SourceRange& source, const std::string& what, ir::Block& to,
                     const std::string& first = "");

 private:
  void report_idle_command(const ir::Block& ahead);  // 2022
  ir::Block transformed(const ir::Block& property);
  ir::ValueId margin(const ir::Block& from, ir::ValueId id, ir::Block& to);
  ir::ValueId refuse_negation(const SourceRange& source, ir::Block& to);
  ir::ValueId refuse_quantifier(bool universal, const SourceRange& source, ir::Block& to);
  void tell_of_idle_waypoints();

  const ir::Module& module_;
  const ir::Decision& decision_;
  ir::Monitor& monitor_;
  diag::Engine& diagnostics_;
  bool waypoints_judged_ = false, judges_legs_ = false, units_differ_ = false, counting_ = false;
  bool commands_judged_ = false;
};

// Adds a margin, or a quantity, to the block.
ir::ValueId add(ir::Block& to, ir::Op op, const SourceRange& source);
ir::ValueId add_quantity(ir::Block& to, ir::Op op, const ir::Unit& unit, const SourceRange& source);

}  // namespace rtac::passes::lookahead
