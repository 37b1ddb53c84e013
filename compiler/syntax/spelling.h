// How operators and texts are written: shared by both printers. Internal to the folder.
#pragma once

#include <string>
#include <string_view>

#include "compiler/syntax/ast.h"

namespace rtac::syntax {

std::string_view spell(BinaryOp op);
std::string_view spell(UnaryOp op);
std::string_view spell(PastOp op);
std::string_view spell(Quantifier quantifier);
std::string_view spell(Relation relation);
std::string_view spell(Role role);
std::string_view spell(ImportWord word);

// A string literal with its quotes and escapes.
std::string spell_text(const std::string& text);
std::string join(const std::vector<Name>& names, std::string_view separator);

}  // namespace rtac::syntax
