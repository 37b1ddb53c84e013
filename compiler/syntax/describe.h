// The wording of syntax errors. Internal to the folder.
#pragma once

#include <optional>

#include "compiler/diagnostics/engine.h"
#include "compiler/syntax/edit.h"

namespace rtac::syntax {

diag::Diagnostic describe_error(const std::vector<Token>& tokens, const SyntaxError& error,
                                const std::optional<Edit>& edit, const SourceManager& sources);

}  // namespace rtac::syntax
