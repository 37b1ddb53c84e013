// Clients of the engine: the same diagnostics for people and for tools. Report order is kept.
#pragma once

#include <string>

#include "compiler/diagnostics/engine.h"
#include "compiler/support/source.h"

namespace rtac::diag {

// For a terminal: message, place, source line with carets, notes, help, and a last line with the
// counts. Empty when nothing was reported. `colour` adds ANSI escapes.
std::string render_text(const Engine& engine, const SourceManager& sources, bool colour);

// A JSON array, one object a diagnostic:
//   {"code", "name", "severity", "message", "location", "label", "notes", "help", "fixits"}
// A location is null or {"file", "begin", "end"} with begin and end {"line", "column", "offset"}:
// lines and columns start at 1, columns and offsets count bytes, `end` is exclusive.
std::string render_json(const Engine& engine, const SourceManager& sources);

}  // namespace rtac::diag
