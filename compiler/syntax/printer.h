// The canonical text of a tree: `--dump-ast`, and the base of the formatter.
#pragma once

#include <string>

#include "compiler/syntax/ast.h"

namespace rtac::syntax {

// An indented tree, one node a line, `Kind detail @line:column`; stable for goldens.
std::string dump(const Program& program, const SourceManager& sources);

// Specification text: parsing it again gives a tree that dumps the same, places apart.
std::string print(const File& file);

}  // namespace rtac::syntax
