// `0,5 m`: a comma where the point of a decimal belongs. Internal to the folder.
#pragma once

#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/syntax/token.h"

namespace rtac::syntax {

// Reports what can be read as a list only by mistake, and joins it to one number.
void mend_decimal_commas(std::vector<Token>& tokens, const SourceManager& sources,
                         diag::Engine& diagnostics);

}  // namespace rtac::syntax
