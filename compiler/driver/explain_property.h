// What was derived for the expressions of a property: what each is computed as, and at what cost.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/driver/explain_line.h"
#include "compiler/ir/module.h"

namespace rtac::driver {

class PropertyRemarks {
 public:
  // `watch`: whose inputs and parameters stand in the properties; `decision`: of monitors of
  // robots, whose facts these are. Remarks go to `out`.
  PropertyRemarks(const Compilation& c, const ir::Watch& watch, const ir::Decision* decision,
                  std::vector<Remark>& out)
      : c_(c), spec_(*c.spec), watch_(watch), decision_(decision), out_(out) {}

  // How far margins may be from those of exact numbers, in the units that they are reported in.
  [[nodiscard]] std::string rounding(const ir::PlainMonitor& m) const;

  // Every expression of `root`, which is computed as `block`. `owner`: the text of the monitor.
  void expressions(const sema::Expr& root, const SourceRange& owner, const std::string& monitor,
                   const ir::Block& block);

 private:
  // What an expression is computed as. `own`: it is computed for this piece of text, and not for an
  // equal one.
  struct Found {
    std::size_t value;
    bool own;
    Rational width;
    std::optional<ir::Range> range;
    bool rounded = false;
  };
  // Where an expression is computed.
  struct Place {
    const ir::Block& block;
    bool of_others = false;  // once for each other robot
    bool is_fact = false;    // judged now, once a tick
  };
  void walk(const sema::Expr& e, const Place& place);
  void operands(const sema::Expr& e, const Place& place);
  void expression(const sema::Expr& e, const Place& place);
  [[nodiscard]] const ir::Block* fact_at(const sema::Expr& e, const ir::Block& block) const;
  [[nodiscard]] std::optional<Found> find(const sema::Expr& e, const ir::Block& block);
  [[nodiscard]] const std::vector<Rational>& errors_of(const ir::Block& block);
  void widen(Found& found, const ir::Block& block);
  void elsewhere(const sema::Expr& e, const ir::Value& value, std::vector<std::string>& to) const;

  const Compilation& c_;
  const sema::Spec& spec_;
  const ir::Watch& watch_;
  const ir::Decision* decision_;
  std::vector<Remark>& out_;
  // of the monitor at hand
  SourceRange owner_;
  std::string monitor_;
  std::vector<std::pair<SourceRange, bool>> seen_;
  std::map<const ir::Block*, std::vector<Rational>> errors_;
};

}  // namespace rtac::driver
