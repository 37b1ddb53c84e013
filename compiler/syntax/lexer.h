// From text to tokens: the only place that computes positions. Internal to the folder.
#pragma once

#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/syntax/token.h"

namespace rtac::syntax {

// Deepest nesting of brackets.
inline constexpr std::size_t kBracketDepthMax = 200;
// Reading a file stops after this many errors.
inline constexpr int kErrorsMax = 20;

// Always ends with END. A text that is not UTF-8, or is nested too deeply, is cut there: its END
// is marked bad.
std::vector<Token> tokenize(FileId file, const SourceManager& sources, diag::Engine& diagnostics);

}  // namespace rtac::syntax
