#include "compiler/codegen/watch_told.h"

#include <bit>
#include <map>

#include "compiler/codegen/repeats.h"

namespace rtac::codegen {

using namespace ir;

namespace {

std::string usually(const std::string& condition) {
  return "USUALLY(" + condition + ")";
}
std::string all_of(const std::vector<std::string>& conditions, const std::string& join) {
  std::string text;
  for (const std::string& each : conditions) text += (text.empty() ? "" : join) + each;
  return text;
}

}  // namespace

WatchTold::WatchTold(const Module& module, const Names& names, WatchLook& look,
                     std::set<std::string>& uses, Code& out)
    : module_(module),
      watch_(*module.watch),
      names_(names),
      look_(look),
      side_(look.kernel()),
      prefix_(module.name),
      uses_(uses),
      out_(out),
      glances_(find()) {
  if (side_.is_full()) return;
  const std::size_t inputs = watch_.inputs.size();
  std::vector<bool> at_a_glance(inputs, false), always(inputs, false);
  for (std::size_t k = 0; k < glances_.size(); ++k) {
    for (const std::uint32_t c : channels_of(watch_, watch_.monitors[k])) {
      (is_told(k) ? at_a_glance : always)[c] = true;
    }
  }
  look_.glance_at(std::move(at_a_glance), std::move(always));
}

WatchTold::Glances WatchTold::find() const {
  Glances all(watch_.monitors.size());
  if (side_.is_full()) return all;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Block& property = watch_.monitors[k].property;
    if (!find_repeats(module_, property).all.empty()) continue;
    all[k] = glance_at(side_, look_.members(), property);
  }
  return all;
}

bool WatchTold::is_alone(std::size_t monitor) const {
  if (!is_told(monitor) || !glances_[monitor]->needs_each) return false;
  const auto is_asked_by = [&](std::size_t other, std::uint32_t channel) {
    return channels_of(watch_, watch_.monitors[other]).contains(channel);
  };
  for (const std::uint32_t c : channels_of(watch_, watch_.monitors[monitor])) {
    if (!glances_[monitor]->components.contains(c) || !look_.is_plain(c)) return false;
    for (std::size_t other = 0; other < watch_.monitors.size(); ++other) {
      if (other != monitor && is_asked_by(other, c)) return false;
    }
  }
  return true;
}

std::string WatchTold::call(std::size_t monitor, const std::string& verdict) const {
  return name(monitor) + "_told(&v, in, &" + verdict + ");";
}

void WatchTold::print(std::size_t monitor, const std::string& judge) {
  closely(monitor, judge);
  uses_.insert("usually");
  const Glance& glance = *glances_[monitor];
  std::vector<std::string> counted;
  std::string given;
  for (const auto& [channel, components] : glance.components) {
    if (glance.needs_each) continue;
    counted.push_back("v->" + fresh(channel) + " != 0");
    given += ", v->" + fresh(channel);
  }
  out_.comment("Far from where it turns, that is told at a glance.");
  const std::vector<std::string> parameters = {"const " + look_.view_type() + " *v", inputs(),
                                               "int32_t *verdict"};
  look_.function("static inline void " + name(monitor) + "_told", parameters, [&](Code& body) {
    if (is_alone(monitor)) {
      body.block("if (" + usually(arrived(glance)) + ")",
                 [&](Code& there) { glanced(glance, {}, there); });
      wrapped(body, name(monitor) + "_closely(v->s, in, v->now_us, verdict, v->since_us);");
    } else {
      missing(glance, body);
      glanced(glance, counted, body);
      wrapped(body, name(monitor) + "_closely(v->s, in" + given + ", verdict);");
    }
  });
  out_.blank();
}

void WatchTold::closely(std::size_t monitor, const std::string& judge) {
  uses_.insert("seldom");
  const Glance& glance = *glances_[monitor];
  const bool alone = is_alone(monitor);
  std::vector<std::string> parameters = {side_.state + " *s", inputs()};
  if (alone) parameters.emplace_back("int64_t now_us");
  for (const auto& [channel, components] : glance.components) {
    if (!glance.needs_each) parameters.push_back("int32_t " + fresh(channel));
  }
  parameters.emplace_back("int32_t *verdict");
  // as the step has its own, so that none has to be moved for the usual path
  if (alone) parameters.emplace_back("int64_t since_us");
  look_.function("static SELDOM void " + name(monitor) + "_closely", parameters, [&](Code& body) {
    body.line(look_.view_type() + " v;");
    body.line("v.s = s;");
    if (alone) body.line("v.now_us = now_us;").line("v.since_us = since_us;");
    for (const auto& [channel, components] : glance.components) {
      if (alone) body.line(look_.call(channel, "&v", "in"));
      std::string counts = glance.needs_each ? "1" : fresh(channel);
      if (alone) counts = "v." + fresh(channel);
      body.line(look_.see(channel, "&v", "in", counts));
    }
    body.line("*verdict = " + judge + "(&v);");
  });
  out_.blank();
}

// At a glance all of the inputs were received when their flags have a bit in common: they are 1.
std::string WatchTold::arrived(const Glance& glance) {
  std::string all, valid;
  for (const auto& [channel, components] : glance.components) {
    all += look_.arrived(channel) + " &&\n      ";
    valid += (valid.empty() ? "" : " & ") + look_.valid(channel);
  }
  return all + (glance.components.size() > 1 ? "(" + valid + ")" : valid) + " != 0";
}

// Without inputs nothing is known, whatever it would take to see.
void WatchTold::missing(const Glance& glance, Code& to) const {
  if (!glance.needs_each && !glance.needs_some) return;
  std::vector<std::string> some;
  for (const auto& [channel, components] : glance.components) {
    some.push_back("v->" + fresh(channel) + " != 0");
  }
  const std::string enough = all_of(some, glance.needs_each ? " && " : " || ");
  verdict_if("!" + usually(enough), "UNKNOWN", to);
}

// Whether samples count and numbers are inside their ranges is asked where it matters.
void WatchTold::glanced(const Glance& glance, const std::vector<std::string>& counted, Code& to) {
  std::vector<std::string> surely = counted, there = counted;
  const bool is_any = glance.surely.find(" || ") != std::string::npos;
  surely.push_back(is_any && !counted.empty() ? "(" + glance.surely + ")" : glance.surely);
  std::string inside = all_inside(glance);
  if (glance.surely_inside) {
    verdict_if(usually(all_of(surely, " && ")), "TRUE", to);
    if (glance.never.empty()) return;
  } else {
    const std::string middle = all_in_the_middle(glance);
    inside = middle.empty() ? usually(inside) : usually(middle) + " ||\n      (" + inside + ")";
    if (!middle.empty() && !counted.empty()) inside = "(" + inside + ")";
  }
  there.push_back(inside);
  to.block("if (" + all_of(there, " &&\n      ") + ")", [&](Code& far) {
    for (const std::string& line : glance.names) wrapped(far, line);
    if (!glance.surely_inside && !glance.surely.empty()) {
      verdict_if(usually(glance.surely), "TRUE", far);
    }
    verdict_if(glance.never, "FALSE", far);
  });
}

// That every number that is asked for is inside its range, and not on its last step.
std::string WatchTold::all_inside(const Glance& glance) {
  std::vector<std::string> each;
  for (const auto& [at, range] : ranges(glance)) each.push_back(number_inside(at, range));
  return all_of(each, " &&\n      ");
}

// The same in fewer steps, of numbers in the middle of their range, which is a power of 2 wide:
// all of one range at once. Empty: no two have the same.
std::string WatchTold::all_in_the_middle(const Glance& glance) {
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::string>> by_range;
  const auto all = ranges(glance);
  for (const auto& [at, range] : all) by_range[{range.lo, range.hi}].push_back(at);
  if (by_range.size() == all.size()) return "";
  std::vector<std::string> middles;
  for (const auto& [ends, numbers] : by_range) {
    const Range range{ends.first, ends.second};
    middles.push_back(numbers.size() == 1 ? number_inside(numbers[0], range)
                                          : in_the_middle(numbers, range));
  }
  return all_of(middles, " &&\n      ");
}

std::vector<std::pair<std::string, Range>> WatchTold::ranges(const Glance& glance) const {
  std::vector<std::pair<std::string, Range>> all;
  for (const auto& [channel, components] : glance.components) {
    for (const std::uint32_t k : components) {
      all.emplace_back("in->" + look_.members().signal(channel, k).name,
                       watch_.inputs[channel].grid(k).range);
    }
  }
  return all;
}

std::string WatchTold::number_inside(const std::string& at, const Range& range) {
  uses_.insert("number_inside");
  return "number_inside(" + at + ", " + num(range.lo) + ", " + num(range.hi) + ")";
}

std::string WatchTold::in_the_middle(const std::vector<std::string>& numbers, const Range& range) {
  uses_.insert("steps_above");
  const std::uint64_t wide = std::uint64_t(range.hi) - std::uint64_t(range.lo);
  const std::uint64_t middle = std::bit_floor(wide);
  const auto from = std::int64_t(std::uint64_t(range.lo) + (wide - middle) / 2);
  std::vector<std::string> above;
  for (const std::string& at : numbers) {
    above.push_back("steps_above(" + at + ", " + num(from) + ")");
  }
  return "(" + all_of(above, " |\n      ") + ") < " + std::to_string(middle) + "U";
}

void WatchTold::verdict_if(const std::string& condition, const std::string& verdict,
                           Code& to) const {
  if (condition.empty()) return;
  wrapped(to, "if (" + condition + ") {");
  to.line("  *verdict = " + upper(prefix_) + "_VERDICT_" + verdict + ";")
      .line("  return;")
      .line("}");
}

}  // namespace rtac::codegen
