// Monitors without a robot, from text to IR.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/ir/printer.h"
#include "compiler/ir/verifier.h"
#include "compiler/ir/watch_builder.h"
#include "compiler/sema/check.h"
#include "compiler/syntax/parse.h"

namespace rtac::ir::test {

struct Built {
  SourceManager sources;
  diag::Engine diagnostics;
  std::optional<sema::Spec> spec;
  Module module;

  [[nodiscard]] const PlainMonitor& first() const { return module.watch->monitors.at(0); }
  [[nodiscard]] std::string block() const {
    return print(module, &*module.watch, first().property, "");
  }
  [[nodiscard]] bool has(const std::string& line) const {
    return print(module).find(line) != std::string::npos;
  }
  // "7001: message | help" of the first report
  [[nodiscard]] std::string report() const {
    if (diagnostics.all().empty()) return "";
    const diag::Diagnostic& d = diagnostics.all()[0];
    return std::to_string(static_cast<int>(d.code)) + ": " + d.message + " | " + d.help;
  }
};

// `declarations` after `spec s; period 10 ms;`, then one monitor with this property.
inline Built built(const std::string& declarations, const std::string& property) {
  Built b;
  const FileId file =
      b.sources.add("s.rta", "spec s;\nperiod 10 ms;\n" + declarations +
                                 "\nmonitor m { \"T-1: a test\" always " + property + "; }\n");
  std::vector<std::string> dependencies;
  const syntax::Program program =
      syntax::parse_program(file, b.sources, b.diagnostics, dependencies);
  if (b.diagnostics.has_errors()) return b;
  b.spec = sema::check(program, b.diagnostics);
  if (!b.spec) return b;
  b.module.name = "s";
  b.module.watch = build_watch(*b.spec, build_signals(*b.spec, b.diagnostics), b.sources, {}, {},
                               {}, b.diagnostics);
  return b;
}

}  // namespace rtac::ir::test
