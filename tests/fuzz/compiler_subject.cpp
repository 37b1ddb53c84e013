#include <algorithm>

#include "compiler/analysis/derive.h"
#include "compiler/codegen/generate.h"
#include "compiler/interp/interpreter.h"
#include "compiler/ir/printer.h"
#include "compiler/ir/verifier.h"
#include "compiler/passes/pipeline.h"
#include "compiler/sema/check.h"
#include "compiler/syntax/parse.h"
#include "tests/fuzz/reports.h"
#include "tests/fuzz/subjects.h"

namespace rtac::fuzz {
namespace {

constexpr std::int64_t kTickUs = 10'000;
constexpr int kTicks = 3;

// A few ticks without and with samples that are all zero.
void interpret(const sema::Spec& spec) {
  if (spec.watches.empty()) return;
  interp::Interpreter reference(spec);
  for (int tick = 0; tick < kTicks; ++tick) {
    const std::int64_t now_us = tick * kTickUs;
    interp::Inputs inputs(spec.inputs.size());
    for (std::size_t i = 0; tick > 0 && i < inputs.size(); ++i) {
      const std::size_t count = spec.inputs[i].components.size();
      inputs[i] = {std::vector<std::optional<Rational>>(count, Rational(0)), now_us};
    }
    reference.step(now_us, inputs);
  }
}

std::string generate(ir::Module module, const sema::Spec& spec, diag::Engine& engine) {
  if (const auto problem = ir::verify(module)) return "after building the IR: " + *problem;
  const auto nothing = [](const passes::Pass&) {};
  if (const auto problem = passes::run_pipeline(module, engine, nothing)) return *problem;
  if (engine.has_errors()) return {};
  for (const auto& file : codegen::generate(std::move(module), spec, {"fuzz", "fuzz.rta", ""})) {
    if (file.text.empty()) return "nothing is generated for " + file.name;
  }
  return {};
}

}  // namespace

std::string run_compiler(std::string_view text) {
  SourceManager sources;
  diag::Engine engine;
  const FileId id = sources.add("fuzz.rta", std::string(text));
  syntax::Program program;
  program.files.push_back(syntax::parse_file(id, sources, engine));
  if (engine.has_errors()) return {};
  auto spec = sema::check(program, engine);
  if (!spec) return {};
  interpret(*spec);
  auto derived = analysis::derive(*spec, sources, engine);
  // An error of arbitration leaves a module that can be played, to show it.
  const auto& all = engine.all();
  const bool refused = std::any_of(all.begin(), all.end(), [](const diag::Diagnostic& d) {
    return diag::info(d.code).severity == diag::Severity::error &&
           d.code != diag::Code::recovery_breaks;
  });
  if (derived.has_value() ? refused : !engine.has_errors()) return "neither refused nor accepted";
  if (derived) {
    if (std::string problem = generate(std::move(derived->module), *spec, engine);
        !problem.empty()) {
      return problem;
    }
  }
  return judge_reports(engine, sources);
}

}  // namespace rtac::fuzz
