// The phases in order: text, tree, checked specification, tables and limits, IR, passes.
#pragma once

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/driver/options.h"
#include "compiler/geometry/looks.h"
#include "compiler/ir/module.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"
#include "compiler/support/source.h"

namespace rtac::driver {

struct Compilation {
  SourceManager sources;
  diag::Engine diagnostics;
  std::vector<std::string> dependencies;  // files that were read
  std::optional<sema::Spec> spec;
  std::optional<ir::Module> module;
  std::string internal_error;  // a bug of the compiler; empty otherwise
  bool unreadable = false;     // the specification could not be read (exit code 2)
  ir::TableMap tables;         // of `module`
  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
  std::int64_t looks_before = geometry::looks();  // a clock of its own (geometry/looks.h)
};

// `path`: of the specification, or "-"; nullopt and a report when it cannot be read.
std::optional<FileId> open_source(const std::string& path, Compilation& c);

// What a specification has come to, changed as it may be meanwhile; nullopt: it has errors.
struct BuiltAnew {
  ir::Module module;
  ir::TableMap tables;
  diag::Engine diagnostics;
};
std::optional<BuiltAnew> build_anew(sema::Spec& spec, const SourceManager& sources);

// Reports that a deliberately unsound variant is none; exit_usage.
int refuse_mutant(const Options& options, Compilation& c);

// The specification alone: text, tree, names and types.
void check_only(const Options& options, Compilation& result);

// Dumps asked for by the options go to `out`.
void compile(const Options& options, std::ostream& out, Compilation& result);

}  // namespace rtac::driver
