// Parsing of one stretch of a file with recovery from mistakes. Internal to the folder.
//
// The parser stops at the first token that does not fit. Small edits of the tokens are then tried
// there (insert, replace or remove one token); the first one that lets the parser read on is
// reported as the mistake, and the stretch is parsed again with it. When none helps, the clause
// around the token is dropped. A second mistake in an edited clause is not reported: it may be a
// consequence of the edit.
//
//   speed <= 0.22 m/s  turn <= 2 rad/s;     inserts `;` behind `m/s`
//   always r insde free;                    replaces `insde` by `inside`
//   always ;                                inserts an expression that later phases ignore
#pragma once

#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/syntax/parse_attempt.h"

namespace rtac::syntax {

// `tokens` ends with END. The result holds what could be understood.
Attempt parse_with_repair(std::vector<Token> tokens, const SourceManager& sources,
                          diag::Engine& diagnostics);

}  // namespace rtac::syntax
