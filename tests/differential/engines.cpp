#include "tests/differential/engines.h"

#include <fstream>
#include <map>
#include <sstream>
#include <utility>

#include "compiler/diagnostics/render.h"
#include "compiler/driver/process.h"

namespace rtac::differential {

std::unique_ptr<Checked> check(const std::string& text, Until until) {
  auto result = std::make_unique<Checked>();
  driver::Compilation& c = result->compilation;
  const driver::TemporaryFolder folder;
  driver::Options options;
  options.command = driver::Command::replay;
  options.engine = until == Until::kernel ? driver::EngineKind::kernel : driver::EngineKind::interp;
  options.spec = folder.path() + "/spec.rta";
  std::ofstream(options.spec) << text;
  std::ostringstream ignored;
  driver::compile(options, ignored, c);
  for (const diag::Diagnostic& d : c.diagnostics.all()) {
    if (diag::info(d.code).severity != diag::Severity::error || !d.range) continue;
    result->lines.insert(c.sources.position(d.range->file, d.range->begin).line);
  }
  if (c.diagnostics.has_errors() || !c.spec) {
    result->problem = diag::render_text(c.diagnostics, c.sources, false);
  }
  if (!c.internal_error.empty()) result->problem += "internal error: " + c.internal_error;
  return result;
}

driver::LoadedKernel load(const driver::KernelCode& code, const Edit& edit, Speed speed) {
  std::vector<driver::OutputFile> files = code.files;
  for (driver::OutputFile& file : files) {
    if (file.path != code.interface.source) continue;
    if (edit) file.text = edit(file.text);
    if (speed == Speed::of_building) file.text = "#pragma GCC optimize (\"O0\")\n" + file.text;
  }
  return driver::load_kernel(files, code.interface);
}

driver::LoadedKernel load_verdicts(const driver::KernelCode& code, const Edit& edit, Speed speed) {
  const std::string p = code.interface.prefix + "_monitors";
  const Edit both = [&](std::string text) {
    if (edit) text = edit(text);
    const auto rename = [&](const std::string& entry) {
      const std::string head = "void " + p + entry + "(";
      text.replace(text.find(head), head.size(), "static void whole" + entry + "(");
    };
    rename("_init");
    rename("_step");
    return text + "static " + p + "_verdicts_state verdicts_state;\nvoid " + p + "_init(" + p +
           "_state *s) {\n  whole_init(s);\n  " + p + "_verdicts_init(&verdicts_state);\n}\nvoid " +
           p + "_step(" + p + "_state *s, const " + p + "_in *in, int64_t now_us, " + p +
           "_out *out) {\n  int32_t alone[sizeof out->monitors / sizeof out->monitors[0]];\n" +
           "  int32_t k;\n  whole_step(s, in, now_us, out);\n  " + p +
           "_verdicts(&verdicts_state, in, now_us, alone);\n" +
           "  for (k = 0; k < (int32_t)(sizeof alone / sizeof *alone); ++k) {\n" +
           "    out->monitors[k].verdict = alone[k];\n  }\n}\n";
  };
  return load(code, both, speed);
}

namespace {

char letter(interp::Verdict verdict) {
  switch (verdict) {
    case interp::Verdict::yes:
      return '1';
    case interp::Verdict::no:
      return '0';
    case interp::Verdict::unknown:
      break;
  }
  return '?';
}

void step_once(driver::Engine& engine, const Step& step,
               std::vector<driver::Judgement>& judgements) {
  if (step.is_restart) engine.restart();
  for (const ParamChange& change : step.params) engine.set_param(change.param, change.value);
  engine.step(step.now_us, step.inputs, judgements);
}

}  // namespace

bool is_repeated(const Steps& run, std::size_t step) {
  return step > 0 && !run[step].is_restart && run[step].now_us <= run[step - 1].now_us + 1;
}

Findings find(driver::Engine& engine, const driver::KernelInterface& kernel, const Steps& run) {
  // Units are written alike by both engines; the first one stands for truth values as well.
  std::map<std::string, Rational> millionths;
  for (const auto& unit : kernel.units) millionths.emplace(unit.text, Rational(1 / unit.factor));
  Findings findings;
  std::vector<driver::Judgement> judgements;
  for (const Step& step : run) {
    step_once(engine, step, judgements);
    findings.resize(judgements.size());
    for (std::size_t k = 0; k < judgements.size(); ++k) {
      const driver::MarginEnds margin = engine.margin(k);
      const interp::Extended factor(millionths.at(judgements[k].unit));
      findings[k].push_back({letter(judgements[k].verdict), margin.lo * factor, margin.hi * factor,
                             judgements[k].unit});
    }
  }
  return findings;
}

std::vector<std::string> judge(driver::Engine& engine, const Steps& run) {
  std::vector<std::string> verdicts;
  std::vector<driver::Judgement> judgements;
  for (const Step& step : run) {
    step_once(engine, step, judgements);
    verdicts.resize(judgements.size());
    for (std::size_t k = 0; k < judgements.size(); ++k) {
      verdicts[k] += letter(judgements[k].verdict);
    }
  }
  return verdicts;
}

}  // namespace rtac::differential
