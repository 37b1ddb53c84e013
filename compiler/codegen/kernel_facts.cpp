#include "compiler/codegen/kernel_facts.h"

#include <algorithm>

#include "compiler/ir/facts.h"

namespace rtac::codegen {

using namespace ir;

namespace {

bool facts_of_others(const Watch& facts) {
  return std::any_of(facts.monitors.begin(), facts.monitors.end(), [](const PlainMonitor& fact) {
    const auto& values = fact.property.values;
    return std::any_of(values.begin(), values.end(),
                       [](const Value& v) { return body_of(v.op) != nullptr; });
  });
}

}  // namespace

FactPrinter::FactPrinter(const Module& module, const Decision& decision, const Names& names,
                         std::set<std::string>& uses, Code& out)
    : DecisionPrinter(module, decision, names, uses, out) {
  if (has_signals(decision)) look_.emplace(kernel_of_facts(module, decision, names), uses, out);
}

bool FactPrinter::facts_of_robot() const {
  return std::any_of(d_.facts.monitors.begin(), d_.facts.monitors.end(), speaks_of_robot);
}

void FactPrinter::print_signals() {
  if (!look_) return;
  look_->view();
  if (has_past(d_.facts, Telling::margins)) look_->blind();
  look_->channels();
}

void FactPrinter::print_facts() {
  if (!look_) return;
  BlockPrinter blocks(module_, d_, names_, view_, uses_);
  for (std::size_t k = 0; k < d_.facts.monitors.size(); ++k) fact(k, blocks);
  if (has_past(d_.facts, Telling::margins)) catch_up();
  judge();
}

void FactPrinter::fact(std::size_t index, BlockPrinter& blocks) {
  const PlainMonitor& m = d_.facts.monitors[index];
  const std::string name = id_ + "_fact_" + num(std::int64_t(index));
  for (std::size_t i = 0; i < m.property.values.size(); ++i) {
    if (body_of(m.property.values[i].op) != nullptr) {
      blocks.quantifier(name + "_v" + num(std::int64_t(i)), m.property.values[i].op, out_);
    }
  }
  std::size_t at = 0;
  const auto of_robot = [&](const Value& v, const Block& block) -> std::string {
    while (&block.values[at] != &v) ++at;
    if (body_of(v.op) == nullptr) return blocks.call(v, block);
    const std::string others = name + "_v" + num(std::int64_t(at)) + "(v)";
    if (std::holds_alternative<CountOthers>(v.op)) return others;
    use({"halves_of"});
    return "halves_of(" + others + ")";
  };
  WatchValuePrinter values(look_->kernel(), look_->members(), uses_, of_robot);
  Code body;
  const bool sees = look_->property(m.property, values, body);
  out_.comment(fact_symbols(d_, names_)[index] + ": " + m.text);
  out_.block("static margin " + name + "(const " + view_ + " *v)", [&](Code& to) {
    if (!sees) to.line("(void)v;");
    to.append(body);
  });
  out_.blank();
}

// Of the robot nothing is known in a tick that was missed.
void FactPrinter::blind_robot(Code& body) {
  for (const Sensed signal : aged()) {
    use({"span_unknown"});
    body.line(std::string("blind.age_of_") + word_of(signal) + " = span_unknown(" + up_ +
              "_INPUT_CLOCK);");
  }
  if (!facts_of_robot()) return;
  use({"span_unknown", "lost"});
  const std::string clock = up_ + "_INPUT_CLOCK";
  body.line("blind.in = v->in;");
  body.line("blind.m = v->m;");
  body.line("blind.me = v->me;");
  body.line("blind.self = v->self;");
  body.line("lost(&blind.self, " + clock + ");");
  body.line("blind.charge = span_unknown(" + clock + ");");
  for (std::size_t k = 0; k < d_.agents.size(); ++k) {
    const std::string at = "agents[" + num(std::int64_t(k)) + "]";
    body.line("blind." + at + " = v->" + at + ";");
    body.line("blind." + at + ".input = " + clock + ";");
    body.line("blind." + at + ".absent = 0;");
  }
  if (!pairs()) return;
  body.block("for (j = 0; j < ROBOTS; ++j)", [&](Code& each) {
    each.line("blind.others[j] = v->others[j];");
    each.line("lost(&blind.others[j].s, " + clock + ");");
    if (d_.open_fleet && facts_of_others(d_.facts)) each.line("blind.others[j].absent = 0;");
  });
}

void FactPrinter::catch_up() {
  const std::string most = num(missed_ticks_max), facts = look_->kernel().functions;
  const std::vector<std::string> symbols = fact_symbols(d_, names_);
  out_.comment("Ticks that were missed saw nothing. Beyond " + most +
               " of them the past is forgotten.");
  out_.block("static void " + facts + "_catch_up(const " + view_ + " *v, int64_t missed)",
             [&](Code& body) {
               body.line(look_->kernel().state + " *s = v->facts.s;");
               body.line(view_ + " blind;").line("int64_t k;");
               if (facts_of_robot() && pairs()) body.line("int32_t j;");
               body.block("if (missed > " + most + ")", [&](Code& gap) {
                 look_->forget("s->", "s->ticks.now + missed", gap);
                 gap.line("return;");
               });
               blind_robot(body);
               body.line(facts + "_blind(&blind.facts, s);");
               body.block("for (k = 0; k < missed; ++k)", [&](Code& each) {
                 for (std::size_t i = 0; i < d_.facts.monitors.size(); ++i) {
                   use({"fact_margin"});
                   wrapped(each, "blind.fact[" + symbols[i] + "] = fact_margin(" + id_ + "_fact_" +
                                     num(std::int64_t(i)) + "(&blind));");
                 }
                 look_->next_tick("s->", each);
               });
             });
  out_.blank();
}

// Zones that are received, in a tick that has been seen before or that goes back in time: what a
// robot is held against is looked up in every step. Nothing has arrived for this tick since.
void FactPrinter::look_again(Code& body) {
  std::set<std::uint32_t> channels;
  for (const Received& zone : d_.facts.received) channels.insert(zone.channel);
  if (channels.empty()) return;
  body.line("v->facts.now_us = v->now_us;");
  if (arrives_each_tick(d_.facts)) body.line("v->facts.since_us = s->facts.judged_us;");
  for (const std::uint32_t c : channels) {
    const std::string seen = "v->facts." + look_->members().signal(c, 0).seen;
    body.line(look_->call(c, "&v->facts", "&v->in->facts"));
    body.line(seen + " = elapsed < 0 ? 0 : " + seen + ";");
  }
}

// The newest samples and parameters.
void FactPrinter::look(Code& tick) {
  if (!d_.facts.inputs.empty() || !d_.facts.schedules.empty()) {
    tick.line("v->facts.now_us = v->now_us;");
  }
  if (arrives_each_tick(d_.facts)) {
    use({"before"});
    wrapped(tick, "v->facts.since_us = first || elapsed > 1 ? before(v->now_us, " +
                      num(d_.period_us) + ") : s->facts.judged_us;");
    tick.line("s->facts.judged_us = v->now_us;");
  }
  look_->params("s->facts.", "v->in->facts.", tick);
  look_->schedules("v->facts.", tick);
  for (std::size_t c = 0; c < d_.facts.inputs.size(); ++c) {
    if (look_->is_used(c)) tick.line(look_->call(c, "&v->facts", "&v->in->facts"));
  }
}

void FactPrinter::judge() {
  const std::string facts = look_->kernel().functions;
  const bool judges = !d_.facts.monitors.empty();
  const bool each_tick = arrives_each_tick(d_.facts);
  const std::vector<std::string> symbols = fact_symbols(d_, names_);
  out_.comment(
      "Once a tick: a second step within it finds what the first one found, and one back in time "
      "knows nothing.");
  out_.block(
      "static void " + facts + "_judge(" + view_ + " *v, " + name_ +
          "_state *s, int32_t first, int64_t elapsed)",
      [&](Code& body) {
        if (judges) body.line("margin found;").line("int32_t k;");
        body.line("v->facts.s = &s->facts;");
        if (has_past(d_.facts, Telling::margins)) {
          body.block("if (elapsed > 1)",
                     [&](Code& gap) { gap.line(facts + "_catch_up(v, elapsed - 1);"); });
        }
        body.block("if (elapsed > 0)", [&](Code& tick) {
          look(tick);
          for (std::size_t i = 0; i < d_.facts.monitors.size(); ++i) {
            use({"kept_of", "fact_margin"});
            tick.line("found = " + id_ + "_fact_" + num(std::int64_t(i)) + "(v);");
            tick.line("s->facts.found[" + symbols[i] + "] = kept_of(found);");
            tick.line("v->fact[" + symbols[i] + "] = fact_margin(found);");
          }
          look_->next_tick("s->facts.", tick);
          tick.line("return;");
        });
        if (!each_tick) body.line("(void)first;");
        look_again(body);
        if (!judges) return;
        use({"margin_kept", "margin_unknown"});
        body.block("for (k = 0; k < " + fact_count_symbol(d_, names_) + "; ++k)", [&](Code& each) {
          each.line("v->fact[k] = elapsed < 0 ? margin_unknown(" + up_ + "_INPUT_CLOCK)");
          each.line(
              "                          "
              " : fact_margin(margin_kept(s->facts.found[k]));");
        });
      });
  out_.blank();
}

void FactPrinter::hold_against_received(Code& to) {
  if (d_.facts.received.empty()) return;
  use({"rim_of"});
  for (std::size_t k = 0; k < d_.facts.received.size(); ++k) {
    const Received& zone = d_.facts.received[k];
    wrapped(to, "v.received[" + num(std::int64_t(k)) + "] = rim_of(v.facts." +
                    look_->members().signal(zone.channel, 0).seen + ", " +
                    look_->kernel().numbers[zone.channel] + ", " + (zone.outside ? "1" : "0") +
                    ", &v.self);");
  }
}

void FactPrinter::init_facts(Code& to) const {
  if (!look_) return;
  look_->start("s->facts.", to);
}

}  // namespace rtac::codegen
