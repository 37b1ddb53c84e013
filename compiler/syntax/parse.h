// From text to tree. Recovers at `;` and `}`, so that one run reports many errors.
#pragma once

#include "compiler/diagnostics/engine.h"
#include "compiler/support/source.h"
#include "compiler/syntax/ast.h"

namespace rtac::syntax {

// Parses one file that is already in `sources`. Errors go to `diagnostics`; the tree holds what
// could be understood (ErrorExpr where an expression could not).
File parse_file(FileId file, const SourceManager& sources, diag::Engine& diagnostics);

// Parses the root and, depth first, everything that it imports (paths relative to the importing
// file; each file once; a cycle is an error). An import that cannot be read is an error at the
// import. `dependencies` receives the path of every file that was read.
Program parse_program(FileId root, SourceManager& sources, diag::Engine& diagnostics,
                      std::vector<std::string>& dependencies);

}  // namespace rtac::syntax
