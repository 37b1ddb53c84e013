#include "compiler/codegen/kernel_blocks.h"

#include <algorithm>
#include <utility>

#include "compiler/codegen/fleet_index.h"
#include "compiler/codegen/kernel_decision.h"
#include "compiler/codegen/watch_values.h"
#include "compiler/ir/margin_unit.h"

namespace rtac::codegen {
namespace {

using namespace ir;

std::string ref(ValueId id) {
  return "v" + std::to_string(static_cast<std::uint32_t>(id));
}
const char* weight(const Unit& unit) {
  if (unit == Unit::mmps) return "WEIGHT_MMPS";
  return unit == Unit::mm ? "WEIGHT_MM" : "WEIGHT_PPM";
}

}  // namespace

std::string zone_symbol(const ZoneTable& zone, const Names& names) {
  return "zone_" + names(zone.name);
}
std::string place_symbol(const ZoneTable& zone, const Names& names) {
  return "at_" + names(zone.name);
}
std::string cells_symbol(const SiteTable& site, const Names& names) {
  return "cells_to_" + names(site.name);
}

std::vector<std::string> fact_symbols(const Decision& decision, const Names& names) {
  const std::string prefix = "FACT_" + upper(names(decision.name)) + "_";
  std::set<std::string> taken = {fact_count_symbol(decision, names)};
  std::vector<std::string> symbols;
  for (const PlainMonitor& fact : decision.facts.monitors) {
    std::string symbol = prefix + upper(fact.name);
    while (!taken.insert(symbol).second) symbol += "_";  // names may differ in case alone
    symbols.push_back(std::move(symbol));
  }
  return symbols;
}
std::string fact_count_symbol(const Decision& decision, const Names& names) {
  return "FACT_" + upper(names(decision.name)) + "_COUNT";
}

std::string BlockPrinter::use(const std::string& function, const std::string& arguments) {
  uses_.insert(function);
  return function + "(" + arguments + ")";
}

void BlockPrinter::function(const std::string& name, const std::string& comment, const Block& block,
                            Code& out, bool units) {
  units_ = units;
  for (std::size_t i = 0; i < block.values.size(); ++i) {
    if (const Block* body = body_of(block.values[i].op)) {
      others(name + "_" + ref(ValueId(i)), *body, out);
    }
  }
  if (!comment.empty()) out.comment(comment);
  out.block("static margin " + name + "(const " + view_ + " *v)",
            [&](Code& to) { body(name, block, to); });
  out.blank();
}

void BlockPrinter::others(const std::string& name, const Block& block, Code& out) {
  out.comment("Of one other robot, number j of the fleet; joined below.");
  out.block("static margin " + name + "(const " + view_ + " *v, int32_t j)",
            [&](Code& to) { body(name, block, to); });
  out.blank();
}

void BlockPrinter::body(const std::string& name, const Block& block, Code& out) {
  for (std::size_t i = 0; i < block.values.size(); ++i) {
    const Value& v = block.values[i];
    const std::string target = ref(ValueId(i));
    if (body_of(v.op) != nullptr) {
      loop(v.op, target, name + "_" + target, out);
      continue;
    }
    say(v, block, out);
    out.line(std::string("const ") + (v.unit ? "span " : "margin ") + target + " = " +
             value(v, block) + ";");
  }
  out.line("return " + ref(block.result) + ";");
}

// What a comparison or a fact is, as it is written; what the whole block is stands above it.
void BlockPrinter::say(const Value& value, const Block& block, Code& out) {
  if (const auto* fact = std::get_if<Fact>(&value.op)) {
    out.comment(decision_.facts.monitors[fact->index].text);
  } else if (std::holds_alternative<AtLeast>(value.op) && &value != &block[block.result]) {
    out.comment(value.text);
  }
}

// Over the other robots; those that are known to be absent neither fail nor count.
void BlockPrinter::loop(const Op& op, const std::string& target, const std::string& body,
                        Code& out) {
  const auto* quantifier = std::get_if<ForOthers>(&op);
  std::string join = "span_count", type = "span ", start = "span_of(0, 0)";
  if (quantifier == nullptr) {
    uses_.insert("span_of");
  } else {
    type = "margin ";
    join = quantifier->universal ? "margin_and" : "margin_or";
    start = use(quantifier->universal ? "margin_true" : "margin_false", "");
  }
  uses_.insert(join);
  out.line(type + target + " = " + start + ";");
  const std::string present =
      (decision_.open_fleet ? " && !" + use("is_absent", "&v->others[j]") : "") +
      (leaves_far_out(decision_) ? " && !" + use("is_far", "&v->others[j]") : "");
  // a property may have several quantifiers: each loop declares its own index
  out.block("for (int32_t j = 0; j < ROBOTS; ++j)", [&](Code& each) {
    each.block("if (j != v->in->self" + present + ")", [&](Code& other) {
      other.line(target + " = " + join + "(" + target + ", " + body + "(v, j));");
    });
  });
}

void BlockPrinter::quantifier(const std::string& name, const Op& op, Code& out) {
  units_ = false;
  this->others(name + "_each", *body_of(op), out);
  const bool counts = std::holds_alternative<CountOthers>(op);
  out.block(
      "static " + std::string(counts ? "span " : "margin ") + name + "(const " + view_ + " *v)",
      [&](Code& to) {
        loop(op, "all", name + "_each", to);
        // what is missing leaves the ends numbers
        if (counts) to.line("all.input = " + upper(module_.name) + "_INPUT_NONE;");
        to.line("return all;");
      });
  out.blank();
}

std::string BlockPrinter::limit(std::int64_t fixed, const std::optional<ValueId>& more) {
  if (!more) return num(fixed);
  return (fixed == 0 ? "" : num(fixed) + " + ") + ref(*more) + ".hi";
}

// Of the margins of a decision: three have names, others a place in its list.
std::string BlockPrinter::unit_number(const Unit& unit) const {
  const std::string prefix = upper(module_.name) + "_UNIT_";
  if (unit == Unit::robots) return prefix + "COUNT";
  if (unit == Unit::mm) return prefix + "METRE";
  if (unit == Unit::ppm) return prefix + "PERCENT";
  const auto& all = decision_.facts.units;
  return num(std::int64_t(std::find(all.begin(), all.end(), unit) - all.begin()));
}

std::string BlockPrinter::value(const Value& v, const Block& block) {
  std::string text = call(v, block);
  if (const auto unit = units_ ? atom_unit(block, v) : std::nullopt) {
    text = use("in_unit", text + ", " + unit_number(*unit));
  }
  const bool of_legs =
      std::holds_alternative<LegsInZone>(v.op) || std::holds_alternative<PointsInZone>(v.op) ||
      std::holds_alternative<LegsApart>(v.op) || std::holds_alternative<OnTrack>(v.op);
  if (!of_legs) return text;
  uses_.insert("margin_true");
  return "v->legs != 0 ? " + text + " : margin_true()";
}

// One case per operation.
// NOLINTNEXTLINE(readability-function-size)
std::string BlockPrinter::call(const Value& v, const Block& block) {
  struct Visitor {
    BlockPrinter& p;
    const Block& block;

    std::string zone(ZoneIndex z) const { return "&" + zone_symbol(p.module_[z], p.names_); }
    std::string place(ZoneIndex z) const { return "&v->" + place_symbol(p.module_[z], p.names_); }
    std::string cells(SiteIndex s) const {
      return "&" + cells_symbol(p.module_[s], p.names_) + "[v->me]";
    }
    std::string operator()(const Const& c) const {
      return p.use("span_of", num(c.value) + ", " + num(c.value));
    }
    std::string operator()(const Battery&) const { return "v->charge"; }
    std::string operator()(const SensedAge& a) const {
      return std::string("v->age_of_") + word_of(a.signal);
    }
    std::string operator()(const Clearance& c) const {
      return p.use("clearance_now", place(c.zone) + ", &v->self, &BODY, v->m");
    }
    std::string operator()(const Distance&) const {
      return p.use("distance_now", "&v->self, &v->others[j], &BODY, v->m, &MOTIONS[0], j");
    }
    static std::string received(ReceivedIndex r) {
      return "&v->received[" + num(static_cast<std::uint32_t>(r)) + "]";
    }
    std::string operator()(const ReceivedClearance& c) const {
      return p.use("rim_clearance", received(c.received) + ", &v->self, &BODY, v->m");
    }
    std::string operator()(const ReceivedReach& r) const {
      return p.use("rim_reach",
                   received(r.received) + ", &v->within, " + limit(r.least_mm, r.more));
    }
    std::string operator()(const ReceivedCourse& r) const {
      return p.use("rim_course", received(r.received) + ", &v->told, " + limit(r.least_mm, r.more));
    }
    static std::string agent(AgentIndex a) {
      return "&v->agents[" + num(static_cast<std::uint32_t>(a)) + "]";
    }
    std::string operator()(const AgentDistance& a) const {
      return p.use("agent_distance", agent(a.agent) + ", &v->self, &BODY, v->m");
    }
    std::string operator()(const AgentReach& a) const {
      return p.use("agent_reach", agent(a.agent) + ", &v->within, " + limit(a.least_mm, a.more));
    }
    std::string operator()(const EnergyTo& e) const {
      return p.use("energy_now", cells(e.site) + ", &v->self, &BODY, v->m");
    }
    std::string operator()(const Speed&) const {
      return p.use("speed_now", "&v->self, &BODY, v->m");
    }
    std::string operator()(const Add& a) const {
      return p.use("span_add", ref(a.a) + ", " + ref(a.b));
    }
    std::string operator()(const Negate& n) const { return p.use("span_negate", ref(n.a)); }
    std::string operator()(const Scale& s) const {
      return p.use("span_scale", ref(s.a) + ", " + num(s.num) + ", " + num(s.den));
    }
    std::string operator()(const AtLeast& a) const {
      if (block[a.a].unit == Unit::robots) {
        return p.use("count_at_least", ref(a.a) + ", " + ref(a.b) + (a.strict ? ", 1" : ", 0"));
      }
      if (*block[a.a].unit == Unit::mmps) p.uses_.insert("speed_weight");
      return p.use("margin_at_least", ref(a.a) + ", " + ref(a.b) + ", " + weight(*block[a.a].unit) +
                                          (a.strict ? ", 1" : ", 0"));
    }
    std::string operator()(const PlanInZone& z) const {
      // 1 mm: way-points are rounded to the nearest grid point
      return p.use("plan_in_zone", zone(z.zone) + ", v, 1");
    }
    std::string operator()(const Truth& t) const {
      return t.value ? p.use("margin_true", "") : p.use("margin_false", "");
    }
    std::string operator()(const Not& n) const { return p.use("margin_not", ref(n.a)); }
    std::string operator()(const And& a) const {
      return p.use("margin_and", ref(a.a) + ", " + ref(a.b));
    }
    std::string operator()(const Or& a) const {
      return p.use("margin_or", ref(a.a) + ", " + ref(a.b));
    }
    std::string operator()(const HeldFor& h) const {
      return p.use("held_for", ref(h.a) + ", &v->runs[" + num(2 * h.slot) + "], " + num(h.ticks) +
                                   ", v->new_tick");
    }
    std::string operator()(const Fact& f) const {
      return "v->fact[" + fact_symbols(p.decision_, p.names_)[f.index] + "]";
    }
    std::string operator()(const ParamValue& v) const {
      const WatchKernel kernel = kernel_of_facts(p.module_, p.decision_, p.names_);
      const std::string value = param_value(kernel, watch_names(kernel.watch), v.param);
      return p.use("span_of", value + ", " + value);
    }
    std::string operator()(const ForOthers&) const { return ""; }    // printed as a loop
    std::string operator()(const CountOthers&) const { return ""; }  // likewise
    std::string operator()(const ZoneReach& z) const {
      const bool high = p.module_[z.zone].has_height();
      return p.use(
          high ? "solid_reach" : "zone_reach",
          zone(z.zone) + ", " + place(z.zone) + ", &v->within, " + limit(z.least_mm, z.more));
    }
    std::string operator()(const ZoneCourse& z) const {
      const char* const course = p.module_[z.zone].has_height() ? "solid_course" : "zone_course";
      return p.use(
          course, zone(z.zone) + ", " + place(z.zone) + ", &v->told, " + limit(z.least_mm, z.more));
    }
    std::string operator()(const PairCourse& r) const {
      return p.use("pair_course",
                   "&v->told, &v->others[j], &BODY, " + limit(r.least_mm, r.more) + ", j");
    }
    std::string operator()(const LegsInZone& z) const {
      return p.use("legs_in_zone", zone(z.zone) + ", " + place(z.zone) +
                                       ", &v->self, &v->in->plan, " + num(z.legs) + ", " +
                                       limit(z.need_mm, z.more));
    }
    std::string operator()(const PointsInZone& z) const {
      return p.use("points_in_zone", zone(z.zone) + ", &v->in->plan, " + num(z.points) + ", " +
                                         limit(z.need_mm, z.more));
    }
    std::string operator()(const PairReach& r) const {
      return p.use("pair_reach",
                   "&v->within, &v->others[j], &BODY, " + limit(r.least_mm, r.more) + ", j");
    }
    std::string operator()(const LegsApart& l) const {
      return p.use("legs_apart", "&v->self, &v->in->plan, &v->others[j], &v->in->others[j].plan, " +
                                     num(l.legs) + ", " + limit(l.need_mm, l.more) + ", " +
                                     num(p.decision_.body.hold_mm) + ", " +
                                     num(p.decision_.body.tracking_mm) + ", " +
                                     (l.ranked ? "v->in->others[j].goes_first" : "1") + ", j");
    }
    std::string operator()(const OnTrack& t) const {
      return p.use("on_track", "&v->self, &v->in->plan, " + num(t.tracking_mm));
    }
    std::string operator()(const SpeedReach& r) const {
      return p.use("speed_reach", "&v->self, v->m, v->horizon_us, " + num(r.most_mmps));
    }
    std::string operator()(const Altitude&) const {
      return p.use("altitude_now", "&v->self, &BODY, v->m");
    }
    std::string operator()(const AltitudeReach& r) const {
      return p.use("altitude_reach",
                   "&v->within, &BODY, " + num(r.limit_mm) + (r.above ? ", 1" : ", 0"));
    }
    std::string schedule(ScheduleIndex s) const {
      return "&" + schedule_symbol(p.decision_.facts[s]);
    }
    std::string operator()(const ZoneThere& z) const {
      p.uses_.insert({"margin_true", "margin_false"});
      return p.use("is_open", schedule(z.schedule) + ", v->now_us") +
             " ? margin_true() : margin_false()";
    }
    std::string operator()(const ThereThroughout& z) const {
      return p.use("there_until", schedule(z.schedule) + ", &v->self, v->now_us, v->horizon_us + " +
                                      num(z.after_us));
    }
    std::string operator()(const GoneThroughout& z) const {
      return p.use("gone_until", schedule(z.schedule) + ", &v->self, v->now_us, v->horizon_us + " +
                                     num(z.after_us));
    }
    std::string operator()(const EnergyReach& e) const {
      return p.use("energy_reach", cells(e.site) + ", &v->within, v->charge, " +
                                       limit(e.reserve_ppm, e.more) + ", " +
                                       num(p.decision_.body.drain_ppm_per_s) + ", v->horizon_us");
    }
    std::string operator()(const ChargeReach& c) const {
      return p.use("charge_reach", "v->charge, " + limit(c.least_ppm, c.more) + ", " +
                                       num(p.decision_.body.drain_ppm_per_s) + ", v->horizon_us");
    }
  };
  const Visitor visitor{*this, block};
  return std::visit(
      [&](const auto& op) -> std::string {
        if constexpr (requires { visitor(op); }) {
          return visitor(op);
        } else {
          return "";  // of monitors without a robot: verified IR has none here
        }
      },
      v.op);
}

}  // namespace rtac::codegen
