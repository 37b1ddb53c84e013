#include "compiler/analysis/company.h"

#include <algorithm>
#include <string>

#include "compiler/analysis/repairs.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

using namespace ir;

// Does it compare nothing else?
bool is_of(Leaf::Kind kind, const Block& block, const AtLeast& compare) {
  const Linear form = linear_form(block, compare);
  return form.terms.size() == 1 && form.terms.begin()->first.kind == kind;
}

// Where it speaks of an agent first, also of one beside each other robot; null: it does not.
const Value* first_agent(const Block& block) {
  for (const Value& value : block.values) {
    if (std::holds_alternative<AgentDistance>(value.op)) return &value;
    const Block* const others = body_of(value.op);
    if (const Value* const found = others != nullptr ? first_agent(*others) : nullptr) return found;
  }
  return nullptr;
}

// What is said of an agent for each other robot is about both.
bool is_beside_robots(const Block& block) {
  return std::ranges::any_of(block.values, [](const Value& value) {
    const Block* const others = body_of(value.op);
    return others != nullptr && first_agent(*others) != nullptr;
  });
}

// What is broken by a robot whose own check passes, of one monitor.
class Company {
 public:
  Company(const Decision& decision, const Monitor& monitor)
      : decision_(decision), monitor_(monitor) {}

  std::vector<diag::Diagnostic> run() {
    visit(monitor_.property, monitor_.property.result);
    return std::move(found_);
  }

 private:
  // Does it depend on where other robots are?
  static bool of_others(const Block& block, ValueId id) {
    const Op& op = block[id].op;
    if (body_of(op) != nullptr) return true;
    if (const auto* v = std::get_if<And>(&op))
      return of_others(block, v->a) || of_others(block, v->b);
    if (const auto* v = std::get_if<Or>(&op))
      return of_others(block, v->a) || of_others(block, v->b);
    if (const auto* v = std::get_if<Not>(&op)) return of_others(block, v->a);
    if (const auto* v = std::get_if<AtLeast>(&op)) {
      return is_of(Leaf::Kind::distance, block, *v) || is_of(Leaf::Kind::count, block, *v);
    }
    return false;
  }

  // The same condition, whichever robot of the pair looks at the other.
  static bool of_both(const Block& block, ValueId id) {
    const Op& op = block[id].op;
    if (const auto* v = std::get_if<And>(&op)) return of_both(block, v->a) && of_both(block, v->b);
    if (const auto* v = std::get_if<Or>(&op)) return of_both(block, v->a) && of_both(block, v->b);
    if (const auto* v = std::get_if<AtLeast>(&op)) return is_of(Leaf::Kind::distance, block, *v);
    return std::holds_alternative<Truth>(op);
  }

  void visit(const Block& block, ValueId id) {
    const Value& value = block[id];
    if (!of_others(block, id)) return;
    if (const auto* v = std::get_if<And>(&value.op)) {
      visit(block, v->a);
      visit(block, v->b);
    } else if (std::holds_alternative<Or>(value.op)) {
      if (!of_both(block, id)) report_choice(value.source);
    } else if (const auto* each = std::get_if<ForOthers>(&value.op)) {
      // one other robot that cannot be absent is all and some of them at once
      const bool one = decision_.robots <= 2 && !decision_.open_fleet;
      if (!each->universal && !one) return report_some(value.source);
      visit(*each->body, each->body->result);
    } else if (const auto* compare = std::get_if<AtLeast>(&value.op)) {
      if (counts(block, *compare)) report_number(value.source);
    }
  }

  // At most as many as there are is no condition; at least so many cannot be looked ahead (5006).
  [[nodiscard]] bool counts(const Block& block, const AtLeast& compare) const {
    if (!is_of(Leaf::Kind::count, block, compare)) return false;
    const auto most = upper_bound(block, compare);
    return most && most->most + 1 < std::int64_t(decision_.robots);
  }

  void report_some(const SourceRange& source) {
    report(source, "the robot that `" + monitor_.name + "` relies on may leave while `",
           "it checks whom it has near itself, not who relies on it");
  }
  void report_number(const SourceRange& source) {
    report(source, "other robots may change the number in `" + monitor_.name + "` while `",
           "each robot checks its own number alone");
  }
  void report_choice(const SourceRange& source) {
    report(source, "another robot may come near and break `" + monitor_.name + "` while `",
           "it may pass by a side of the `or` that holds for it alone");
  }
  void report(const SourceRange& source, const std::string& what, const std::string& label) {
    const std::string& recovery = monitor_.recovery.name;
    found_.push_back({diag::Code::others_unkept,
                      source,
                      what + recovery + "` drives or holds",
                      label,
                      {},
                      "`forall q : " + decision_.kind + ", q != r : distance(r, q) >= c` works, " +
                          "joined by `and`: both robots of a pair check it; or `acknowledge " +
                          recovery + " may break " + monitor_.name + " \"why\"`",
                      {}});
  }

  const Decision& decision_;
  const Monitor& monitor_;
  std::vector<diag::Diagnostic> found_;
};

}  // namespace

std::vector<diag::Diagnostic> unkept_company(const Decision& decision) {
  std::vector<diag::Diagnostic> all;
  if (decision.robots < 2) return all;
  for (const Monitor& monitor : decision.monitors) {
    if (acknowledged(decision, monitor.recovery.name, monitor.name)) continue;
    for (diag::Diagnostic& found : Company(decision, monitor).run()) {
      all.push_back(std::move(found));
    }
  }
  return all;
}

bool others_may_break(const ir::Decision& decision, const ir::Monitor& monitor,
                      const ir::Recovery& drives) {
  const bool obeys = drives.kind != RecoveryKind::external;
  if (first_agent(monitor.property) && !(obeys && is_slow_beside_agents(decision, monitor)))
    return true;
  return decision.robots > 1 && !Company(decision, monitor).run().empty();
}

std::vector<diag::Diagnostic> unkept_agents(const Decided& of) {
  const Decision& decision = of.decision;
  std::vector<diag::Diagnostic> all;
  for (std::size_t k = 0; k < decision.monitors.size(); ++k) {
    const Monitor& monitor = decision.monitors[k];
    const Value* const first = first_agent(monitor.property);
    const std::string& recovery = monitor.recovery.name;
    if (first == nullptr || acknowledged(decision, recovery, monitor.name)) continue;
    const bool brakes = monitor.recovery.kind == RecoveryKind::brake;
    const bool obeys = monitor.recovery.kind != RecoveryKind::external;
    // who comes near a robot that stands finds it slow enough
    if ((brakes && holds_held(decision, monitor) && !is_beside_robots(monitor.property)) ||
        (obeys && is_slow_beside_agents(decision, monitor))) {
      continue;
    }
    const Fault fault = fault_of(diag::Code::agent_unkept, first->source);
    const auto works = obeys ? held_that_works(of, k, fault) : std::vector<std::string>{};
    const std::string slow = works.empty() ? "" : joined(works) + " works; or ";
    const std::string& agent = decision[std::get<AgentDistance>(first->op).agent].name;
    all.push_back({diag::Code::agent_unkept,
                   first->source,
                   "`" + agent + "` may come near while `" + recovery + "` holds: nobody keeps `" +
                       monitor.name + "` then",
                   "kept while the robot moves, not while it stands",
                   {},
                   slow + "`acknowledge " + recovery + " may break " + monitor.name + " \"why\"`" +
                       (slow.empty() ? " works" : "") + ", with the reason why that is acceptable",
                   {}});
  }
  return all;
}

}  // namespace rtac::analysis
