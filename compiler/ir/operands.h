// Visits the operands of an operation, for passes that rename or trace them.
#pragma once

#include <type_traits>

#include "compiler/ir/module.h"

namespace rtac::ir {

// `AnyOp`: Op or const Op.
template <class AnyOp, class Visit>
void for_each_operand(AnyOp& op, const Visit& visit) {
  std::visit(
      [&](auto& node) {
        using Node = std::decay_t<decltype(node)>;
        if constexpr (requires { node.condition; }) visit(node.condition);
        if constexpr (requires { node.trail; }) {
          for (auto& id : node.trail.own) visit(id);
        }
        if constexpr (requires { node.other.own; }) {
          for (auto& id : node.other.own) visit(id);
        }
        if constexpr (requires { node.more; }) {
          if (node.more) visit(*node.more);
        }
        if constexpr (requires { node.b; }) {
          visit(node.a);
          visit(node.b);
          if constexpr (requires { node.c; }) visit(node.c);
        } else if constexpr (requires { node.a; }) {
          visit(node.a);
        } else {
          static_assert(!std::is_same_v<Node, void>);
        }
      },
      op);
}

}  // namespace rtac::ir
