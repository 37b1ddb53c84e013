// The expression of one value of a monitor without a robot.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>

#include "compiler/codegen/watch.h"
#include "compiler/ir/module.h"

namespace rtac::codegen {

class WatchValuePrinter {
 public:
  // What a value of a robot is, in a fact.
  using OfRobot = std::function<std::string(const ir::Value&, const ir::Block&)>;
  // How an operand is written.
  using Operands = std::function<std::string(ir::ValueId)>;

  // `uses` collects library functions. In the text, `v` is the view of a tick.
  WatchValuePrinter(const WatchKernel& kernel, const WatchNames& names, std::set<std::string>& uses,
                    OfRobot of_robot = nullptr, Operands operands = nullptr)
      : kernel_(kernel),
        names_(names),
        uses_(uses),
        of_robot_(std::move(of_robot)),
        operands_(std::move(operands)) {}

  std::string value(const ir::Value& value, const ir::Block& block);
  // The trail, of operands that are spans.
  std::string trail(const ir::Trail& t);
  // How a value is written where it is used.
  std::string named(ir::ValueId id, const ir::Block& block) {
    block_ = &block;
    return operand(id);
  }
  // The first values of a block are at hand, by their names, whatever they are.
  void take_as_given(std::size_t count) { given_ = count; }
  [[nodiscard]] std::size_t given() const { return given_; }
  // Inputs, parameters and constants are written where they are used; all else is `vN`.
  static bool is_leaf(const ir::Op& op);

  // One per operation; those of robots occur in facts only (verified IR).
  std::string operator()(const ir::Const& v);
  std::string operator()(const ir::Truth& v);
  std::string operator()(const ir::Add& v) { return call("sum_of", v.a, v.b); }
  std::string operator()(const ir::Negate& v) { return call("span_negate", v.a); }
  std::string operator()(const ir::Scale& v);
  std::string operator()(const ir::AtLeast& v);
  std::string operator()(const ir::Not& v) { return call("opposite", v.a); }
  std::string operator()(const ir::And& v) { return call("both", v.a, v.b); }
  std::string operator()(const ir::Or& v) { return call("either", v.a, v.b); }
  std::string operator()(const ir::Input& v);
  std::string operator()(const ir::InputTruth& v);
  std::string operator()(const ir::InputIs& v);
  std::string operator()(const ir::InputSame& v);
  std::string operator()(const ir::Open& v);
  std::string operator()(const ir::Elapsed& v);
  std::string operator()(const ir::Age& v);
  std::string operator()(const ir::ParamValue& v);
  std::string operator()(const ir::Multiply& v);
  std::string operator()(const ir::Minimum& v) { return call("smaller_of", v.a, v.b); }
  std::string operator()(const ir::Maximum& v) { return call("greater_of", v.a, v.b); }
  std::string operator()(const ir::Absolute& v) { return call("absolute_of", v.a); }
  std::string operator()(const ir::Root& v) { return call("root_of", v.a); }
  std::string operator()(const ir::Norm& v) { return call("norm_of", v.a, v.b); }
  std::string operator()(const ir::PointClearance& v);
  std::string operator()(const ir::PointInside& v);
  std::string operator()(const ir::SolidClearance& v);
  std::string operator()(const ir::SolidInside& v);
  std::string operator()(const ir::TrailClearance& v);
  std::string operator()(const ir::TrailInside& v);
  std::string operator()(const ir::TrailDistance& v);
  std::string operator()(const ir::PathGiven& v);
  std::string operator()(const ir::Between& v);
  std::string operator()(const ir::Phase& v);
  std::string operator()(const ir::Sine& v) { return call("sine_of", v.a); }
  std::string operator()(const ir::Cosine& v) { return call("cosine_of", v.a); }
  std::string operator()(const ir::Choose& v);
  std::string operator()(const ir::Previously& v) { return temporal(v, v.a); }
  std::string operator()(const ir::Once& v) { return temporal(v, v.a); }
  std::string operator()(const ir::Historically& v) { return temporal(v, v.a); }
  std::string operator()(const ir::Since& v) { return temporal(v, v.a, v.b); }
  std::string operator()(const ir::Aggregate& v) { return temporal(v, v.a); }
  template <class RobotOperation>
  std::string operator()(const RobotOperation&) {
    return of_robot_(*value_, *block_);
  }

 private:
  std::string operand(ir::ValueId id);
  std::string use(const std::string& function, const std::string& arguments);
  std::string call(const char* function, ir::ValueId a);
  std::string call(const char* function, ir::ValueId a, ir::ValueId b);
  std::string temporal(const ir::Op& op, ir::ValueId a, ir::ValueId b = {});
  // The zone that is received, and the number of its input.
  [[nodiscard]] std::string received(std::uint32_t channel) const;
  [[nodiscard]] std::string solids(ir::SolidIndex within, ir::SolidIndex around) const;
  [[nodiscard]] std::string regions(ir::RegionIndex within, ir::RegionIndex around) const;
  [[nodiscard]] std::string signal(std::uint32_t channel, std::uint32_t component) const;

  const WatchKernel& kernel_;
  const WatchNames& names_;
  std::set<std::string>& uses_;
  const OfRobot of_robot_;
  const Operands operands_;  // none: by its name, a leaf by its text
  std::size_t given_ = 0;
  const ir::Block* block_ = nullptr;
  const ir::Value* value_ = nullptr;
};

std::string value_name(ir::ValueId id);
// The present value of a parameter.
std::string param_value(const WatchKernel& kernel, const WatchNames& names, std::uint32_t param);

}  // namespace rtac::codegen
