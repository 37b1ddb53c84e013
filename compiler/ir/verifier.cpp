#include "compiler/ir/verifier.h"

#include <set>
#include <tuple>
#include <utility>

#include "compiler/ir/edge_tree.h"
#include "compiler/ir/schedule.h"

namespace rtac::ir {
namespace {

// Visits one value; `problem_` keeps the first breach.
class Checker {
 public:
  // Of a decision: its monitors, or (`facts`) what they say that is judged now.
  Checker(const Module& module, const Decision& decision, bool facts)
      : module_(module),
        decision_(&decision),
        watch_(facts ? &decision.facts : nullptr),
        owner_(decision.name) {}
  Checker(const Module& module, const Watch& watch, std::string owner)
      : module_(module), watch_(&watch), owner_(std::move(owner)) {}

  void block(const Block& block, bool inside_others) {
    if (static_cast<std::uint32_t>(block.result) >= block.values.size()) {
      fail("the result of a block is not one of its values");
      return;
    }
    if (block[block.result].unit) fail("the result of a block is not a margin");
    block_ = &block;
    inside_others_ = inside_others;
    for (position_ = 0; position_ < block.values.size(); ++position_) {
      std::visit(*this, block.values[position_].op);
      if (const Block* others = body_of(block.values[position_].op)) {
        const std::size_t position = position_;
        if (inside_others) fail("for_others inside for_others");
        this->block(*others, true);
        block_ = &block;
        inside_others_ = inside_others;
        position_ = position;
      }
    }
  }
  std::optional<std::string> problem() const { return problem_; }

  void operator()(const Const&) { quantity(); }
  void operator()(const Battery&) { robot(), quantity(); }
  void operator()(const Clearance& v) { zone(v.zone), quantity(); }
  void operator()(const Distance&) { pair(), quantity(); }
  void operator()(const AgentDistance& v) { agent(v.agent), quantity(); }
  void operator()(const AgentReach& v) { agent(v.agent), reach(v.more); }
  void operator()(const ReceivedClearance& v) { received(v.received), quantity(); }
  void operator()(const ReceivedReach& v) { received(v.received), reach(v.more); }
  void operator()(const ReceivedCourse& v) { received(v.received), reach(v.more); }
  void operator()(const EnergyTo& v) { site(v.site), quantity(); }
  void operator()(const Speed&) { robot(), quantity(); }
  void operator()(const Add& v) { same_unit(v.a, v.b), quantity(); }
  void operator()(const Negate& v) { same_unit(v.a, v.a), quantity(); }
  void operator()(const Scale& v) {
    operand(v.a), quantity();
    if (v.den <= 0) fail("scale by a denominator that is not positive");
  }
  void operator()(const AtLeast& v) { same_unit(v.a, v.b), margin(); }
  void operator()(const PlanInZone& v) {
    zone(v.zone), margin();
    if (decision_ && !decision_->on_plan) fail("plan_in_zone in a periodic decision");
  }
  void operator()(const Truth&) { margin(); }
  void operator()(const Not& v) { margins(v.a, v.a); }
  void operator()(const And& v) { margins(v.a, v.b); }
  void operator()(const Or& v) { margins(v.a, v.b); }
  void operator()(const HeldFor& v) {
    robot(), margins(v.a, v.a);
    if (decision_ && v.slot >= decision_->held_slots)
      fail("held_for in a slot that the state does not have");
  }
  void operator()(const ForOthers&) { robot(), margin(); }
  void operator()(const CountOthers&) {
    robot(), quantity();
    if (here().unit && *here().unit != Unit::robots) fail("a count that does not count robots");
  }
  void operator()(const Fact& v) {
    robot(), margin();
    if (decision_ && v.index >= decision_->facts.monitors.size()) fail("no such fact");
  }
  void operator()(const ZoneReach& v) { zone(v.zone), reach(v.more); }
  void operator()(const ZoneCourse& v) { zone(v.zone), reach(v.more); }
  void operator()(const PairCourse& v) { pair(), reach(v.more); }
  void operator()(const LegsInZone& v) { zone(v.zone), reach(v.more); }
  void operator()(const PointsInZone& v) { zone(v.zone), reach(v.more); }
  void operator()(const PairReach& v) { pair(), reach(v.more); }
  void operator()(const LegsApart& v) { pair(), reach(v.more); }
  void operator()(const OnTrack& v) {
    robot(), margin();
    if (v.tracking_mm < 0) fail("on_track within a negative length");
  }
  void operator()(const SpeedReach&) { robot(), reach(std::nullopt); }
  void operator()(const Altitude&) { in_space(), quantity(); }
  void operator()(const AltitudeReach&) { in_space(), reach(std::nullopt); }
  void operator()(const ZoneThere& v) { scheduled(v.schedule); }
  void operator()(const ThereThroughout& v) { scheduled(v.schedule), after(v.after_us); }
  void operator()(const GoneThroughout& v) { scheduled(v.schedule), after(v.after_us); }
  void operator()(const EnergyReach& v) { site(v.site), reach(v.more); }
  void operator()(const ChargeReach& v) { robot(), reach(v.more); }

  void operator()(const Input& v) {
    component(v.channel, v.component, ChannelKind::number), quantity();
    if (watch_ && v.channel < watch_->inputs.size() && here().unit &&
        *here().unit != watch_->inputs[v.channel].grid(v.component).unit) {
      fail("an input in a unit that is not its own");
    }
  }
  void operator()(const InputTruth& v) {
    component(v.channel, v.component, ChannelKind::truth), margin();
  }
  void operator()(const InputIs& v) {
    component(v.channel, v.component, ChannelKind::choice), margin();
    if (watch_ && v.channel < watch_->inputs.size() &&
        (v.value < 0 || std::size_t(v.value) >= watch_->inputs[v.channel].values.size())) {
      fail("a value that the input never has");
    }
  }
  void operator()(const InputSame& v) {
    component(v.channel, v.component, ChannelKind::choice), margin();
    component(v.other_channel, v.other_component, ChannelKind::choice);
  }
  void operator()(const Open& v) {
    plain(), margin();
    if (watch_ && static_cast<std::uint32_t>(v.schedule) >= watch_->schedules.size()) {
      fail("no such schedule");
    }
  }
  void operator()(const Elapsed& v) {
    plain(), margin();
    if (v.ticks < 0) fail("a negative number of ticks");
  }
  void operator()(const Age& v) {
    plain(), quantity();
    if (watch_ && v.channel >= watch_->inputs.size()) fail("no such input");
  }
  void operator()(const SensedAge&) { robot(), plain(), quantity(); }
  void operator()(const ParamValue& v) {
    quantity();
    const Watch& signals = watch_ ? *watch_ : decision_->facts;
    if (v.param >= signals.params.size()) fail("no such parameter");
  }
  void operator()(const Multiply& v) { operand(v.a), operand(v.b), plain(), quantity(); }
  void operator()(const Minimum& v) { same_unit(v.a, v.b), plain(), kept(v.a); }
  void operator()(const Maximum& v) { same_unit(v.a, v.b), plain(), kept(v.a); }
  void operator()(const Absolute& v) { plain(), kept(v.a); }
  void operator()(const Root& v) { operand(v.a), plain(), quantity(); }
  void operator()(const PointClearance& v) {
    place(v), quantity();
    if (here().unit && here().unit->step != Rational(1, 1000)) fail("a clearance not in mm");
  }
  void operator()(const PointInside& v) {
    const Value* condition = before(v.condition);
    if (condition && condition->unit) fail("a place in a zone, settled for a quantity");
    place(v), margin();
  }
  void operator()(const SolidClearance& v) {
    place_in_space(v), quantity();
    if (here().unit && here().unit->step != Rational(1, 1000)) fail("a clearance not in mm");
  }
  void operator()(const SolidInside& v) {
    const Value* condition = before(v.condition);
    if (condition && condition->unit) fail("a place in a zone, settled for a quantity");
    place_in_space(v), margin();
  }
  void operator()(const TrailClearance& v) { trail(v.trail), regions(v), in_mm(); }
  void operator()(const TrailInside& v) {
    const Value* condition = before(v.condition);
    if (condition && condition->unit) fail("a trail in a zone, settled for a quantity");
    trail(v.trail), regions(v), margin();
  }
  void operator()(const TrailDistance& v) { trail(v.trail), trail(v.other), in_mm(); }
  void operator()(const PathGiven& v) { component(v.channel, 0, ChannelKind::path), margin(); }
  void operator()(const Norm& v) { same_unit(v.a, v.b), plain(), kept(v.a); }
  void operator()(const Between& v) {
    plain(), quantity();
    if (v.lo > v.hi) fail("a constant above itself");
    if (v.open && v.hi - v.lo != 1)
      fail("a constant strictly between steps that are no neighbours");
  }
  void operator()(const Phase& v) {
    operand(v.a), plain(), quantity();
    if (v.least_q16 < 0 || v.least_q16 > v.most_q16) fail("a phase of no angle");
  }
  void operator()(const Sine& v) { operand(v.a), plain(), quantity(); }
  void operator()(const Cosine& v) { operand(v.a), plain(), quantity(); }
  void operator()(const Choose& v) {
    const Value* condition = before(v.condition);
    if (condition && condition->unit) fail("a choice by a quantity");
    same_unit(v.a, v.b), plain(), kept(v.a);
  }
  void operator()(const Previously& v) { margins(v.a, v.a), remembers(v.slot); }
  void operator()(const Once& v) { margins(v.a, v.a), window(v.window), remembers(v.slot); }
  void operator()(const Historically& v) { margins(v.a, v.a), window(v.window), remembers(v.slot); }
  void operator()(const Since& v) { margins(v.a, v.b), window(v.window), remembers(v.slot); }
  void operator()(const Aggregate& v) {
    const Value* of = before(v.a);
    if (of && of->unit.has_value() == (v.fold == Fold::count)) {
      fail("a count of quantities or a fold of margins");
    }
    quantity(), window(v.window), remembers(v.slot);
  }

 private:
  void fail(const std::string& what) {
    if (!problem_) {
      problem_ = owner_ + ": %" + std::to_string(position_) + ": " + what;
    }
  }
  const Value* before(ValueId id) {
    if (static_cast<std::uint32_t>(id) >= position_) {
      fail("a value is used before it is computed");
      return nullptr;
    }
    return &(*block_)[id];
  }
  const Value& here() const { return block_->values[position_]; }
  // A check of what is within reach, with what parameters add to its limit.
  void reach(const std::optional<ValueId>& more) {
    if (watch_) fail("a fact about what is within reach");
    margin();
    if (more) operand(*more);
  }
  void scheduled(ScheduleIndex schedule) {
    robot(), margin();
    if (watch_) fail("a schedule of a decision in a fact");
    const auto index = static_cast<std::uint32_t>(schedule);
    if (decision_ && index >= decision_->facts.schedules.size()) fail("no such schedule");
  }
  void after(std::int64_t us) {
    if (us < 0) fail("a time before the horizon");
  }
  void quantity() {
    if (!here().unit) fail("a quantity without a unit");
  }
  void margin() {
    if (here().unit) fail("a margin with a unit");
  }
  void same_unit(ValueId a, ValueId b) {
    const Value* left = before(a);
    const Value* right = before(b);
    if (left && right && (!left->unit || left->unit != right->unit)) fail("units differ");
  }
  void margins(ValueId a, ValueId b) {
    margin();
    const Value* left = before(a);
    const Value* right = before(b);
    if ((left && left->unit) || (right && right->unit)) fail("a connective of quantities");
  }
  void operand(ValueId a) {
    const Value* value = before(a);
    if (value && !value->unit) fail("arithmetic of a margin");
  }
  void kept(ValueId a) {
    quantity();
    const Value* value = before(a);
    if (value && value->unit != here().unit) fail("a result in another unit than its operand");
  }
  void robot() {
    if (!decision_) fail("an operation of robots in a monitor without one");
  }
  void plain() {
    if (!watch_) fail("an operation of monitors without a robot in a decision");
  }
  void component(std::uint32_t channel, std::uint32_t index, ChannelKind kind) {
    plain();
    if (!watch_) return;
    if (channel >= watch_->inputs.size() || index >= watch_->inputs[channel].components.size()) {
      fail("no such input");
    } else if (watch_->inputs[channel].kind != kind) {
      fail("an input of another kind");
    }
  }
  void window(const Window& w) {
    if (w.from < 0 || (w.to >= 0 && w.to < w.from)) fail("a window that ends before it starts");
  }
  void remembers(std::uint32_t slot) {
    plain();
    if (watch_ && slot >= watch_->slots) fail("a slot that the state does not have");
    if (!slots_.insert(slot).second) fail("a slot that another operator has");
  }
  template <class Node>
  void place(const Node& v) {
    plain(), same_unit(v.a, v.b);
    in_mm(before(v.a)), regions(v);
  }
  template <class Node>
  void regions(const Node& v) {
    for (const RegionIndex i : {v.within, v.around}) {
      if (watch_ && static_cast<std::uint32_t>(i) >= watch_->regions.size()) fail("no such region");
    }
  }
  void in_mm(const Value* coordinate) {
    const bool is_length = coordinate && coordinate->unit;
    if (is_length && coordinate->unit->step != Rational(1, 1000)) fail("a place not in mm");
  }
  void in_mm() {
    quantity();
    if (here().unit && here().unit->step != Rational(1, 1000)) fail("a distance not in mm");
  }
  void trail(const Trail& t) {
    plain();
    for (const ValueId id : t.own) operand(id), in_mm(before(id));
    if (t.own.size() % 2 != 0 || t.own.size() > 4) fail("a trail of other places than two");
    if (t.own.size() == 4 && t.channel) fail("a path behind a leg");
    if (t.own.empty() && !t.channel) fail("a trail of nothing");
    if (t.channel) component(*t.channel, 0, ChannelKind::path);
  }
  template <class Node>
  void place_in_space(const Node& v) {
    plain(), same_unit(v.a, v.b), same_unit(v.a, v.c);
    const Value* x = before(v.a);
    if (x && x->unit && x->unit->step != Rational(1, 1000)) fail("a place not in mm");
    for (const SolidIndex i : {v.within, v.around}) {
      if (watch_ && static_cast<std::uint32_t>(i) >= watch_->solids.size()) fail("no such solid");
    }
  }
  void in_space() {
    robot();
    if (decision_ && !decision_->body.in_space) fail("the height of a robot in the plane");
  }
  void zone(ZoneIndex i) {
    robot();
    if (static_cast<std::uint32_t>(i) >= module_.zones.size()) {
      fail("no such zone");
    } else if (module_[i].has_height()) {
      in_space();
    }
  }
  void site(SiteIndex i) {
    robot();
    if (static_cast<std::uint32_t>(i) >= module_.sites.size()) return fail("no such site");
    const SiteTable& to = module_.sites[static_cast<std::uint32_t>(i)];
    const std::size_t cells = module_[to.zone].cells.clearance_mm_lo.size();
    for (std::size_t r = 0; r < to.places.size(); ++r) {
      // what is read beyond its end is anything
      if (to.places[to.table_of(r)].cost_ppm.size() != cells) fail("a way without a price");
    }
  }
  void agent(AgentIndex i) {
    robot();
    if (decision_ && static_cast<std::uint32_t>(i) >= decision_->agents.size()) {
      fail("no such agent");
    }
  }
  void received(ReceivedIndex i) {
    robot();
    if (!decision_) return;
    const Watch& facts = decision_->facts;
    if (static_cast<std::uint32_t>(i) >= facts.received.size()) {
      fail("no such zone that is received");
    } else if (facts[i].channel >= facts.inputs.size() ||
               facts.inputs[facts[i].channel].kind != ChannelKind::zone) {
      fail("a zone that is received by an input that is none");
    } else if (decision_->body.in_space || decision_->on_plan) {
      fail("a zone that is received, in space or of a plan");
    }
  }
  void pair() {
    if (!inside_others_) fail("another robot outside for_others");
  }

  const Module& module_;
  const Decision* decision_ = nullptr;
  const Watch* watch_ = nullptr;
  const std::string owner_;
  std::set<std::uint32_t> slots_;
  const Block* block_ = nullptr;
  std::size_t position_ = 0;
  bool inside_others_ = false;
  std::optional<std::string> problem_;
};

std::optional<std::string> verify_signals(const Watch& watch) {
  if (watch.period_us <= 0) return "watch: a period that is not positive";
  for (const Channel& c : watch.inputs) {
    if (c.components.empty()) return c.name + ": an input without components";
    const bool has_grid = sgn(c.unit.step) > 0 && (!c.turning || sgn(c.turning->unit.step) > 0);
    if (c.kind == ChannelKind::number && !has_grid) return c.name + ": no grid";
  }
  return std::nullopt;
}

// What looks them up relies on it.
bool in_order(const std::vector<Opening>& openings, std::int64_t before_us, std::int64_t end_us) {
  std::int64_t last_us = before_us;
  for (const Opening& each : openings) {
    if (each.from_us <= last_us || each.until_us <= each.from_us) return false;
    last_us = each.until_us;
  }
  return last_us <= end_us;
}

std::optional<std::string> verify_schedules(const Watch& watch) {
  for (const Schedule& s : watch.schedules) {
    if (!in_order(s.once, INT64_MIN, INT64_MAX) || !in_order(s.weekly, -1, us_per_week)) {
      return s.name + ": openings out of order";
    }
  }
  return std::nullopt;
}

// What measures distances from it relies on it.
bool is_stack(const Watch& watch, const Solid& solid) {
  std::int64_t top_mm = INT64_MIN;
  for (const Slab& slab : solid.slabs) {
    if (slab.floor_mm < top_mm || slab.ceiling_mm <= slab.floor_mm) return false;
    if (static_cast<std::uint32_t>(slab.region) >= watch.regions.size()) return false;
    top_mm = slab.ceiling_mm;
  }
  return !solid.slabs.empty();
}

bool is_stack(const Module& module, const ZoneTable& zone) {
  std::int64_t top_mm = INT64_MIN;
  for (const ZoneTable::Slab& slab : zone.slabs) {
    if (slab.floor_mm < top_mm || slab.ceiling_mm <= slab.floor_mm) return false;
    const bool known = static_cast<std::uint32_t>(slab.base) < module.zones.size();
    if (!known || module[slab.base].has_height()) return false;
    top_mm = slab.ceiling_mm;
  }
  return true;
}

std::optional<std::string> verify_watch(const Module& module, const Watch& watch) {
  if (auto problem = verify_signals(watch)) return problem;
  std::set<std::tuple<std::string, bool, std::uint32_t>> regions;
  for (const Region& r : watch.regions) {
    if (!regions.insert({r.name, r.around, r.slab}).second) {
      return r.name + ": two regions of this name";
    }
  }
  for (const Solid& s : watch.solids) {
    if (!is_stack(watch, s)) return s.name + ": slabs out of order";
  }
  for (const Region& r : watch.regions) {
    if (r.channel &&
        (*r.channel >= watch.inputs.size() || watch.inputs[*r.channel].kind != ChannelKind::zone)) {
      return r.name + ": no such input";
    }
    if (!leads_to_edges(r.tree, r.edges.size())) return r.name + ": no such edges";
  }
  if (auto problem = verify_schedules(watch)) return problem;
  Checker checker(module, watch, "watch");
  for (const PlainMonitor& monitor : watch.monitors) {
    checker.block(monitor.property, false);
    if (checker.problem()) return monitor.name + ": " + *checker.problem();
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> verify(const Module& module) {
  // passes compare values by their canonical text, which names tables
  std::set<std::string> names;
  for (const ZoneTable& zone : module.zones) {
    if (!names.insert("zone " + zone.name).second) return "two zones named " + zone.name;
    if (zone.has_height()) {
      if (!is_stack(module, zone)) return zone.name + ": slabs out of order";
      continue;
    }
    if (!leads_to_edges(zone.tree, zone.edges.size())) return zone.name + ": no such edges";
  }
  for (const SiteTable& site : module.sites) {
    if (!names.insert("site " + site.name).second) return "two sites named " + site.name;
    if (static_cast<std::uint32_t>(site.zone) >= module.zones.size()) {
      return "site " + site.name + ": no such zone";
    }
  }
  for (const Decision& decision : module.decisions) {
    if (!decision.facts.monitors.empty()) {
      if (auto problem = verify_signals(decision.facts)) return decision.name + ": " + *problem;
    }
    if (auto problem = verify_schedules(decision.facts)) return problem;
    Checker facts(module, decision, true);
    for (const PlainMonitor& fact : decision.facts.monitors) facts.block(fact.property, false);
    if (facts.problem()) return facts.problem();
    Checker checker(module, decision, false);
    for (const Monitor& monitor : decision.monitors) {
      checker.block(monitor.property, false);
      if (monitor.ahead) checker.block(*monitor.ahead, false);
      if (monitor.return_when) checker.block(*monitor.return_when, false);
    }
    if (!decision.on_plan && decision.motions.size() != decision.monitors.size() + 1) {
      return decision.name + ": one motion per recovery and one for any control";
    }
    if (checker.problem()) return checker.problem();
  }
  if (module.watch) return verify_watch(module, *module.watch);
  return std::nullopt;
}

}  // namespace rtac::ir
