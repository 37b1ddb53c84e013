// The judge function of a decision on a plan.
#include "compiler/codegen/kernel_blocks.h"
#include "compiler/codegen/kernel_decision.h"
#include "compiler/codegen/kernel_step.h"
#include "compiler/ir/facts.h"
#include "compiler/ir/margin_unit.h"

namespace rtac::codegen {

using namespace ir;

void print_judge(const Module& module, const Decision& d, const Names& names,
                 std::set<std::string>& uses, Code& out) {
  const std::string& prefix = module.name;
  const std::string& id = names(d.name);
  const std::string name = prefix + "_" + id;
  const std::string up = upper(prefix);
  uses.insert({"verdict_of", "finding_of"});
  out.comment("---- decision " + d.name + " for " + d.kind + ", on a plan ----");
  BlockPrinter blocks(module, d, names, prefix + "_plan", uses);
  for (const Monitor& m : d.monitors) {
    blocks.function(id + "_" + names(m.name) + "_now", requirement(m) + ". " + m.text, m.property,
                    out);
  }
  out.block(
      signature("void " + name + "_judge", {"const " + prefix + "_plan *plan", name + "_out *out"}),
      [&](Code& to) {
        const std::string count = num(std::int64_t(d.monitors.size()));
        to.line("margin found[" + count + "];");
        to.line("int32_t k;");
        for (std::size_t k = 0; k < d.monitors.size(); ++k) {
          to.line("found[" + num(std::int64_t(k)) + "] = " + id + "_" + names(d.monitors[k].name) +
                  "_now(plan);");
        }
        to.line("out->mode = 0;");
        to.line("out->monitor = -1;");
        to.line("out->found = finding_of(found[0]);");
        to.line("out->found.reason = " + up + "_REASON_NONE;");
        to.block("for (k = " + count + " - 1; k >= 0; --k)", [&](Code& each) {
          each.line("const int32_t verdict = verdict_of(found[k]);");
          each.line("out->monitors[k].now = verdict;");
          each.line("out->monitors[k].ahead = verdict;");
          each.line("out->monitors[k].safer = verdict;");
          each.line("out->monitors[k].engaged = verdict != " + up + "_VERDICT_TRUE;");
          each.line("out->monitors[k].margin = found[k].lo;");
          each.line("out->monitors[k].now_margin = found[k].lo;");
          if (mixes_units(module)) {
            each.line("out->monitors[k].unit = found[k].unit;");
            each.line("out->monitors[k].now_unit = found[k].unit;");
          }
          if (has_return_conditions(module)) {
            each.line("out->monitors[k].returns = " + up + "_VERDICT_TRUE;");
          }
          each.block("if (verdict != " + up + "_VERDICT_TRUE)", [&](Code& body) {
            body.line("out->mode = 1;");
            body.line("out->monitor = k;");
            body.line("out->found = finding_of(found[k]);");
          });
        });
      });
  out.blank();
}

}  // namespace rtac::codegen
