// Prints a C file with every case of printed_cases.h: its state, what it takes, and how it steps.
// Usage: print_cases FILE
#include <fstream>
#include <iostream>

#include "compiler/codegen/code.h"
#include "compiler/codegen/kernel_library.h"
#include "compiler/codegen/temporal.h"
#include "tests/kernel/temporal/printed_cases.h"

namespace {

using namespace rtac;
using codegen::Code;

const char* const head = R"(#include "tests/kernel/temporal/printed.h"
#define MARGIN_MAX INT64_C(1000000000000000000)
#define SPAN_MAX INT64_C(1000000000000)
enum { P_REASON_NONE, P_REASON_MARGIN, P_REASON_INPUT = 6 };
enum { P_INPUT_NONE, P_INPUT_CLOCK = 7 };
)";
const char* const conversions = R"(
static margin to_margin(probe_value v) {
  margin m = margin_of(v.lo, v.hi, v.reason);
  m.input = v.input;
  m.unit = v.unit;
  m.upper_unit = v.upper_unit;
  return m;
}
static span to_span(probe_value v) {
  span s = span_of(v.lo, v.hi);
  s.input = v.input;
  return s;
}
static probe_value from_margin(margin m) {
  const probe_value v = {m.lo, m.hi, m.reason, m.unit, m.input, m.upper_unit};
  return v;
}
static probe_value from_span(span s) {
  const probe_value v = {s.lo, s.hi, 0, 0, s.input, 0};
  return v;
}
)";

void print_case(const ir::Op& op, const std::string& index, std::set<std::string>& uses,
                Code& code) {
  const std::string name = "case_" + index;
  code.block(
      "typedef struct " + name,
      [&](Code& to) {
        to.line(codegen::temporal_ticks_member("p"));
        for (const std::string& member : codegen::temporal_members(op, "p")) to.line(member);
      },
      "} " + name + ";");
  code.line("static " + name + " state_" + index + ";");
  const bool quantity = temporal_test::of_quantity(op);
  code.block(
      "static probe_value step_" + index + "(probe_value first, probe_value second)",
      [&](Code& to) {
        codegen::TemporalCall with{"s->", "&s->ticks", "a", "b", std::nullopt};
        if (temporal_test::has_range(op)) with.declared = temporal_test::printed_range;
        const bool span = std::holds_alternative<ir::Aggregate>(op);
        to.line(name + " *s = &state_" + index + ";");
        to.line(quantity ? "const span a = to_span(first);" : "const margin a = to_margin(first);");
        to.line(std::holds_alternative<ir::Since>(op) ? "const margin b = to_margin(second);"
                                                      : "(void)second;");
        to.line(std::string("const ") + (span ? "span" : "margin") +
                " v = " + codegen::temporal_call(op, with, uses) + ";");
        to.line("s->ticks.now += 1;");
        to.line(std::string("return from_") + (span ? "span" : "margin") + "(v);");
      });
}

std::string print_all() {
  std::set<std::string> uses{"ticks_start", "margin_of", "span_of"}, types;
  Code cases, starts, steps, sizes;
  std::size_t count = 0;
  for (const ir::Op& op : temporal_test::printed_cases()) {
    const std::string index = std::to_string(count++);
    codegen::collect_temporal_types(op, types);
    print_case(op, index, uses, cases);
    starts.line("ticks_start(&state_" + index + ".ticks);");
    starts.line(codegen::temporal_starts(op, "state_" + index + ".", uses));
    steps.line("step_" + index + ",");
    sizes.line("sizeof(case_" + index + "),");
  }
  return head + codegen::kernel_types(types, "p") + codegen::kernel_library(uses, "p") +
         conversions + cases.print(Code::Style::c) + "void printed_start(void) {\n" +
         starts.print(Code::Style::c) + "}\nconst printed_step printed_steps[] = {\n" +
         steps.print(Code::Style::c) + "};\nconst size_t printed_sizes[] = {\n" +
         sizes.print(Code::Style::c) + "};\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: print_cases FILE\n";
    return 2;
  }
  std::ofstream file(argv[1]);
  file << print_all();
  return file.good() ? 0 : 1;
}
