// Expressions as specification text. Internal to the folder.
#pragma once

#include <string>

#include "compiler/syntax/ast.h"

namespace rtac::syntax {

std::string print_expr(const Expr& expr);

}  // namespace rtac::syntax
