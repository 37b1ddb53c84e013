// The wording of syntax errors. Internal to the folder.
#pragma once

#include <optional>

#include "compiler/diagnostics/engine.h"
#include "compiler/syntax/edit.h"

namespace rtac::syntax {

// `mends`: with the edit, the rest of the clause is as it should be.
diag::Diagnostic describe_error(const std::vector<Token>& tokens, const SyntaxError& error,
                                const std::optional<Edit>& edit, bool mends,
                                const SourceManager& sources);

}  // namespace rtac::syntax
