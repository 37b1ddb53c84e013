#include "compiler/ir/printer.h"

#include "compiler/ir/words.h"

namespace rtac::ir {
namespace {

std::string name(ValueId id) {
  return "%" + std::to_string(static_cast<std::uint32_t>(id));
}
std::string num(std::int64_t value) {
  return std::to_string(value);
}
std::string window(const Window& w) {
  const std::string to = w.to < 0 ? "inf" : num(w.to);
  return " [" + num(w.from) + ", " + to + "]" + (w.full ? "" : " verdicts");
}
std::string more(const std::optional<ValueId>& id) {
  return id ? " plus " + name(*id) : "";
}
std::string remembers(std::uint32_t slot) {
  return ", slot " + num(slot);
}
const char* name(Fold fold) {
  switch (fold) {
    case Fold::minimum:
      return "min";
    case Fold::maximum:
      return "max";
    case Fold::mean:
      return "mean";
    case Fold::sum:
      return "sum";
    case Fold::count:
      return "count";
    case Fold::rate:
      return "rate";
  }
  return "";
}

class Printer {
 public:
  explicit Printer(const Module& module, const Watch* watch = nullptr)
      : module_(module), watch_(watch) {}

  void block(const Block& block, const std::string& indent) {
    for (std::size_t i = 0; i < block.values.size(); ++i) {
      const Value& value = block.values[i];
      out_ += indent + name(ValueId(i)) + " = " + std::visit(*this, value.op);
      out_ += value.unit ? " : " + ir::name(*value.unit) : " : margin";
      if (value.range) out_ += " [" + num(value.range->lo) + ", " + num(value.range->hi) + "]";
      out_ += "\n";
      if (const Block* others = body_of(value.op)) this->block(*others, indent + "  ");
    }
    out_ += indent + "result " + name(block.result) + "\n";
  }
  void line(const std::string& text) { out_ += text + "\n"; }
  std::string take() { return std::move(out_); }

  std::string operator()(const Const& v) const { return "const " + num(v.value); }
  std::string operator()(const Battery&) const { return "battery"; }
  std::string operator()(const Clearance& v) const { return "clearance " + module_[v.zone].name; }
  std::string operator()(const Distance&) const { return "distance"; }
  std::string operator()(const AgentDistance& v) const {
    return "agent_distance " + num(static_cast<std::uint32_t>(v.agent));
  }
  std::string operator()(const AgentReach& v) const {
    return "agent_reach " + num(static_cast<std::uint32_t>(v.agent)) + ", least " +
           num(v.least_mm) + more(v.more);
  }
  std::string operator()(const ReceivedClearance& v) const {
    return "received_clearance " + received(v.received);
  }
  std::string operator()(const ReceivedReach& v) const {
    return "received_reach " + received(v.received) + ", least " + num(v.least_mm) + more(v.more);
  }
  std::string operator()(const ReceivedCourse& v) const {
    return "received_course " + received(v.received) + ", least " + num(v.least_mm) + more(v.more);
  }
  std::string operator()(const EnergyTo& v) const { return "energy_to " + module_[v.site].name; }
  std::string operator()(const Speed&) const { return "speed"; }
  std::string operator()(const Add& v) const { return "add " + name(v.a) + ", " + name(v.b); }
  std::string operator()(const Negate& v) const { return "negate " + name(v.a); }
  std::string operator()(const Scale& v) const {
    return "scale " + name(v.a) + ", " + num(v.num) + "/" + num(v.den);
  }
  std::string operator()(const AtLeast& v) const {
    return (v.strict ? "more_than " : "at_least ") + name(v.a) + ", " + name(v.b);
  }
  std::string operator()(const PlanInZone& v) const {
    return "plan_in_zone " + module_[v.zone].name;
  }
  std::string operator()(const Truth& v) const { return v.value ? "true" : "false"; }
  std::string operator()(const Not& v) const { return "not " + name(v.a); }
  std::string operator()(const And& v) const { return "and " + name(v.a) + ", " + name(v.b); }
  std::string operator()(const Or& v) const { return "or " + name(v.a) + ", " + name(v.b); }
  std::string operator()(const HeldFor& v) const {
    return "held_for " + name(v.a) + ", " + num(v.ticks) + " ticks, slot " + num(v.slot);
  }
  std::string operator()(const ForOthers& v) const {
    return v.universal ? "for_all_others" : "for_some_other";
  }
  std::string operator()(const CountOthers&) const { return "count_others"; }
  std::string operator()(const ZoneReach& v) const {
    return "zone_reach " + module_[v.zone].name + ", least " + num(v.least_mm) + more(v.more);
  }
  std::string operator()(const ZoneCourse& v) const {
    return "zone_course " + module_[v.zone].name + ", least " + num(v.least_mm) + more(v.more);
  }
  std::string operator()(const PairCourse& v) const {
    return "pair_course least " + num(v.least_mm) + more(v.more);
  }
  std::string operator()(const LegsInZone& v) const {
    return "legs_in_zone " + module_[v.zone].name + ", legs " + num(v.legs) + ", need " +
           num(v.need_mm) + more(v.more);
  }
  std::string operator()(const PointsInZone& v) const {
    return "points_in_zone " + module_[v.zone].name + ", points " + num(v.points) + ", need " +
           num(v.need_mm) + more(v.more);
  }
  std::string operator()(const PairReach& v) const {
    return "pair_reach least " + num(v.least_mm) + more(v.more);
  }
  std::string operator()(const LegsApart& v) const {
    return "legs_apart legs " + num(v.legs) + ", need " + num(v.need_mm) + more(v.more) +
           (v.ranked ? ", ranked" : "");
  }
  std::string operator()(const OnTrack& v) const { return "on_track within " + num(v.tracking_mm); }
  std::string operator()(const SpeedReach& v) const {
    return "speed_reach most " + num(v.most_mmps);
  }
  std::string operator()(const Altitude&) const { return "altitude"; }
  std::string operator()(const AltitudeReach& v) const {
    return std::string("altitude_reach ") + (v.above ? "least " : "most ") + num(v.limit_mm);
  }
  std::string operator()(const ZoneThere& v) const { return "there " + (*watch_)[v.schedule].name; }
  std::string operator()(const ThereThroughout& v) const {
    return "there_throughout " + (*watch_)[v.schedule].name + ", after " + num(v.after_us);
  }
  std::string operator()(const GoneThroughout& v) const {
    return "gone_throughout " + (*watch_)[v.schedule].name + ", after " + num(v.after_us);
  }
  std::string operator()(const EnergyReach& v) const {
    return "energy_reach " + module_[v.site].name + ", reserve " + num(v.reserve_ppm) +
           more(v.more);
  }
  std::string operator()(const ChargeReach& v) const {
    return "charge_reach least " + num(v.least_ppm) + more(v.more);
  }

  std::string operator()(const Fact& v) const { return "fact " + watch_->monitors[v.index].name; }
  std::string operator()(const Input& v) const {
    return "input " + component(v.channel, v.component);
  }
  std::string operator()(const InputTruth& v) const {
    return "truth " + component(v.channel, v.component);
  }
  std::string operator()(const InputIs& v) const {
    return "is " + component(v.channel, v.component) + ", " +
           watch_->inputs[v.channel].values[std::size_t(v.value)];
  }
  std::string operator()(const InputSame& v) const {
    return "same " + component(v.channel, v.component) + ", " +
           component(v.other_channel, v.other_component);
  }
  std::string operator()(const Open& v) const { return "open " + (*watch_)[v.schedule].name; }
  std::string operator()(const Elapsed& v) const { return "elapsed " + num(v.ticks) + " ticks"; }
  std::string operator()(const Age& v) const { return "age " + watch_->inputs[v.channel].name; }
  std::string operator()(const SensedAge& v) const {
    return std::string("age of ") + word_of(v.signal);
  }
  std::string operator()(const ParamValue& v) const {
    return "param " + watch_->params[v.param].name;
  }
  std::string operator()(const Multiply& v) const { return two("multiply ", v); }
  std::string operator()(const Minimum& v) const { return two("minimum ", v); }
  std::string operator()(const Maximum& v) const { return two("maximum ", v); }
  std::string operator()(const Absolute& v) const { return "absolute " + name(v.a); }
  std::string operator()(const Root& v) const { return "root " + name(v.a); }
  std::string operator()(const PointClearance& v) const {
    return two("point_clearance ", v) + regions(v);
  }
  std::string operator()(const PointInside& v) const {
    return "point_inside " + name(v.condition) + ", " + name(v.a) + ", " + name(v.b) + regions(v);
  }
  std::string operator()(const SolidClearance& v) const {
    return two("solid_clearance ", v) + ", " + name(v.c) + solids(v);
  }
  std::string operator()(const SolidInside& v) const {
    return "solid_inside " + name(v.condition) + ", " + name(v.a) + ", " + name(v.b) + ", " +
           name(v.c) + solids(v);
  }
  std::string operator()(const TrailClearance& v) const {
    return (v.greatest ? "greatest_clearance " : "least_clearance ") + trail(v.trail) + regions(v);
  }
  std::string operator()(const TrailInside& v) const {
    return (v.outside ? "trail_outside " : "trail_inside ") + name(v.condition) + ", " +
           trail(v.trail) + regions(v);
  }
  std::string operator()(const TrailDistance& v) const {
    return "trail_distance " + trail(v.trail) + ", " + trail(v.other);
  }
  std::string operator()(const PathGiven& v) const {
    return "given " + watch_->inputs[v.channel].name;
  }
  std::string operator()(const Norm& v) const { return two("norm ", v); }
  std::string operator()(const Between& v) const {
    return (v.open ? "strictly_between " : "between ") + num(v.lo) + ", " + num(v.hi);
  }
  std::string operator()(const Phase& v) const {
    return "phase " + name(v.a) + ", " + num(v.least_q16) + " .. " + num(v.most_q16) + " / 65536";
  }
  std::string operator()(const Sine& v) const { return "sine " + name(v.a); }
  std::string operator()(const Cosine& v) const { return "cosine " + name(v.a); }
  std::string operator()(const Choose& v) const {
    return "choose " + name(v.condition) + " ? " + name(v.a) + " : " + name(v.b);
  }
  std::string operator()(const Previously& v) const {
    return "previously " + name(v.a) + remembers(v.slot);
  }
  std::string operator()(const Once& v) const {
    return "once" + window(v.window) + " " + name(v.a) + remembers(v.slot);
  }
  std::string operator()(const Historically& v) const {
    return "historically" + window(v.window) + " " + name(v.a) + remembers(v.slot);
  }
  std::string operator()(const Since& v) const {
    return "since" + window(v.window) + " " + name(v.a) + ", " + name(v.b) + remembers(v.slot);
  }
  std::string operator()(const Aggregate& v) const {
    return name(v.fold) + window(v.window) + " " + name(v.a) + remembers(v.slot);
  }

  void tables() {
    for (const ZoneTable& z : module_.zones) {
      if (z.has_height()) {
        stack(z);
        continue;
      }
      line("zone " + z.name + " edges " + num(std::int64_t(z.edges.size())) + " cells " +
           num(z.cells.columns) + "x" + num(z.cells.rows) + " of " + num(z.cells.cell_mm) +
           " mm, widest " + num(z.widest_mm) + " mm at (" + num(z.widest_x_mm) + ", " +
           num(z.widest_y_mm) + ")");
      tree(z.tree);
      edges(z.edges, "  ");
    }
    for (const SiteTable& s : module_.sites) {
      for (const SiteTable::Place& p : s.places) {
        line("site " + s.name + " of " + p.robot + " at (" + num(p.x_mm) + ", " + num(p.y_mm) +
             ") on " + module_[s.zone].name +
             (p.cost_ppm.empty() ? ""
                                 : ", with cost of at least " + num(s.drive_ppm_per_m) + " ppm/m"));
      }
    }
  }
  void tree(const EdgeTree& t) {
    if (t.edges_most == 0) return;
    line("  tree of " + num(t.leaves) + " cells, depth " + num(t.depth) + ", at most " +
         num(t.edges_most) + " edges" +
         (t.exact_mm ? ", exact up to " + num(*t.exact_mm) + " mm" : ""));
  }
  void edges(const std::vector<Edge>& all, const std::string& indent) {
    for (const Edge& e : all) {
      line(indent + "edge (" + num(e.ax) + ", " + num(e.ay) + ") to (" + num(e.bx) + ", " +
           num(e.by) + ")");
    }
  }
  void monitor(const Monitor& m) {
    line("  monitor " + m.name + " \"" + m.requirement_id + "\" at " + m.file + ":" + num(m.line));
    if (m.lookahead.duration) line("    horizon " + num(m.lookahead.duration_us) + " us");
    line("    property");
    block(m.property, "      ");
    if (m.ahead) {
      line("    ahead");
      block(*m.ahead, "      ");
    }
    if (m.return_when) {
      line("    return");
      block(*m.return_when, "      ");
    }
    line("    recovery " + m.recovery.name + " route " + num(m.recovery.route_clearance_mm) +
         " return " + num(m.recovery.return_clearance_mm) + " pass " + num(m.recovery.pass_gap_mm));
    for (const Recovery& step : m.recovery.steps) {
      line(std::string("      step ") + word_of(step.kind) + " speed " + num(step.speed_mmps) +
           (step.lasts_us > 0 ? " for " + num(step.lasts_us) + " us" : ""));
    }
  }
  void decision(const Decision& d) {
    const Body& b = d.body;
    line("decision " + d.name + " for " + d.kind +
         (d.on_plan ? std::string(" on plan")
                    : " every " + num(d.period_us) + " us, return +" + num(d.return_extra_us) +
                          " us, dwell " + num(d.dwell_ticks)) +
         (d.open_fleet ? ", open fleet" : ""));
    line("  body radius " + num(b.radius_mm) + ", errors " + num(b.position_error_mm) + " mm " +
         num(b.velocity_error_mmps) + " mm/s, accel " + num(b.accel_mmps2) + ", brake " +
         num(b.brake_mmps2) + ", brake lag " + num(b.brake_late_ms) + " ms, aside " +
         num(b.brake_lag_ms) + " ms " + num(b.brake_lag_permille) + " permille, hold " +
         num(b.hold_mm) +
         (b.disturbance_mmps2 > 0 ? ", disturbance " + num(b.disturbance_mmps2) : "") +
         (b.command_mmps2 > 0
              ? ", commands " + num(b.command_mmps2) + " error " + num(b.command_error_mmps2)
              : "") +
         (b.jitter_us > 0 ? ", jitter " + num(b.jitter_us) + " us" : ""));
    for (const Motion& m : d.motions) {
      line("  motion " + m.name + " speed " + num(m.speed_mmps) + " accel " + num(m.accel_mmps2));
    }
    for (const Agent& a : d.agents) {
      line("  agent " + a.name + (a.in_space ? " in space" : "") + " radius " + num(a.radius_mm) +
           ", error " + num(a.error_mm) + " mm, speed " + num(a.speed_mmps) + ", age " +
           num(a.age_us) + " us");
    }
    for (std::size_t i = 0; i < d.keeps.size(); ++i) {
      std::string row;
      for (const Kept kept : d.keeps[i]) row += " " + num(std::int64_t(kept));
      line("  keeps " + d.monitors[i].recovery.name + row);
    }
    watch_ = &d.facts;
    signals(d.facts);
    for (const Schedule& s : d.facts.schedules) schedule(s);
    for (const PlainMonitor& fact : d.facts.monitors) {
      line("  fact " + fact.name);
      block(fact.property, "    ");
    }
    for (const Monitor& m : d.monitors) monitor(m);
  }
  static std::string grid(const ChannelGrid& g) {
    std::string text = " on " + ir::name(g.unit) + " [" + num(g.range.lo) + ", " + num(g.range.hi) +
                       "]" + (g.range.declared ? "" : " by default");
    if (g.error_steps > 0) text += " error " + num(g.error_steps);
    return text;
  }
  void channel(const Channel& c) {
    std::string text = "  input " + c.name + " : " + word(c.kind);
    if (c.kind == ChannelKind::number) {
      text += grid(c);
      if (c.turning) text += "," + grid(*c.turning);
    }
    for (const std::string& part : c.components) text += part.empty() ? "" : " ." + part;
    if (c.kind == ChannelKind::zone) text += " of " + num(c.edges_most) + " edges";
    if (c.kind == ChannelKind::path) text += " of " + num(c.places_most) + " way-points";
    text += c.held         ? ", held"
            : c.max_age_us ? ", for " + num(*c.max_age_us) + " us"
                           : ", every tick";
    line(text);
  }
  void watch(const Watch& w) {
    watch_ = &w;
    line("watch every " + num(w.period_us) + " us, slots " + num(w.slots));
    signals(w);
    for (const Region& r : w.regions) {
      if (r.channel) {
        line("  region " + r.name + " received");
        continue;
      }
      const std::string slab = r.slab > 0 ? " slab " + num(std::int64_t(r.slab)) : "";
      line("  region " + std::string(r.around ? "around " : "within ") + r.name + slab + " edges " +
           num(std::int64_t(r.edges.size())));
      edges(r.edges, "    ");
    }
    for (const Solid& s : w.solids) solid(s);
    for (const Schedule& s : w.schedules) schedule(s);
    for (const PlainMonitor& m : w.monitors) {
      line("  monitor " + m.name + " \"" + m.requirement_id + "\" at " + m.file + ":" +
           num(m.line));
      block(m.property, "    ");
    }
  }

 private:
  void solid(const Solid& s) {
    line("  solid " + std::string(s.around ? "around " : "within ") + s.name);
    for (const Slab& slab : s.slabs) {
      line("    slab " + num(slab.floor_mm) + " to " + num(slab.ceiling_mm));
    }
  }
  void schedule(const Schedule& s) {
    std::string text = "  schedule " + s.name;
    for (const Opening& o : s.once) text += " [" + num(o.from_us) + ", " + num(o.until_us) + ")";
    if (!s.weekly.empty()) text += " weekly";
    for (const Opening& o : s.weekly) text += " [" + num(o.from_us) + ", " + num(o.until_us) + ")";
    line(text);
  }
  void signals(const Watch& w) {
    for (const Channel& c : w.inputs) channel(c);
    for (const Param& p : w.params) {
      line("  param " + p.name + " on " + ir::name(p.unit) + " [" + num(p.range.lo) + ", " +
           num(p.range.hi) + "] = " + num(p.value) +
           (p.tightens > 0   ? ", up only"
            : p.tightens < 0 ? ", down only"
                             : ", fixed"));
    }
  }
  void stack(const ZoneTable& z) {
    line("zone " + z.name + " of slabs, widest " + num(z.widest_mm) + " mm at (" +
         num(z.widest_x_mm) + ", " + num(z.widest_y_mm) + ", " + num(z.widest_z_mm) + ")");
    for (const ZoneTable::Slab& s : z.slabs) {
      line("  [" + num(s.floor_mm) + ", " + num(s.ceiling_mm) + "] " + module_[s.base].name);
    }
  }
  std::string received(ReceivedIndex index) const {
    const Received& r = (*watch_)[index];
    return (r.outside ? "outside_of " : "") + r.name;
  }
  std::string component(std::uint32_t channel, std::uint32_t index) const {
    const Channel& c = watch_->inputs[channel];
    return c.name + (c.components[index].empty() ? "" : "." + c.components[index]);
  }
  std::string region(RegionIndex index) const {
    const Region& r = (*watch_)[index];
    if (r.channel) return "received " + r.name;
    return (r.around ? "around " : "within ") + r.name;
  }
  template <class Node>
  std::string regions(const Node& v) const {
    const bool one = v.within == v.around;
    return ", " + region(v.within) + (one ? "" : " and " + region(v.around));
  }
  std::string trail(const Trail& t) const {
    std::string text;
    for (std::size_t i = 0; i < t.own.size(); ++i) text += (i > 0 ? " " : "") + name(t.own[i]);
    if (!t.channel) return "(" + text + ")";
    text += (t.own.empty() ? "" : t.next_only ? " next of " : " then ");
    return "(" + text + watch_->inputs[*t.channel].name + ")";
  }
  template <class Node>
  std::string solids(const Node& v) const {
    const bool one = v.within == v.around;
    const std::string zone = (*watch_)[v.within].name;
    return ", within " + zone + (one ? "" : " and around " + zone);
  }
  template <class Node>
  static std::string two(const char* word, const Node& v) {
    return word + name(v.a) + ", " + name(v.b);
  }

  const Module& module_;
  const Watch* watch_;
  std::string out_;
};

}  // namespace

const char* word_of(Sensed signal) {
  switch (signal) {
    case Sensed::position:
      return "position";
    case Sensed::velocity:
      return "velocity";
    case Sensed::battery:
      return "battery";
  }
  return "";
}

std::string print(const Module& module) {
  Printer printer(module);
  printer.line("module " + module.name);
  printer.tables();
  for (const Decision& d : module.decisions) printer.decision(d);
  if (module.watch) printer.watch(*module.watch);
  return printer.take();
}

std::string print(const Module& module, const Watch* watch, const Block& block,
                  const std::string& indent) {
  Printer printer(module, watch);
  printer.block(block, indent);
  return printer.take();
}

}  // namespace rtac::ir
