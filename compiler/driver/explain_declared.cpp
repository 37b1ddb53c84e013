// What is known of declarations that no decision drives by: robots that only monitors without a
// robot speak of, or whose plans alone are judged, zones that no monitor asks for, and the times at
// which zones are there.
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "compiler/analysis/zones.h"
#include "compiler/driver/explain_line.h"
#include "compiler/driver/explain_text.h"
#include "compiler/sema/dimension.h"
#include "compiler/sema/openings.h"

namespace rtac::driver {
namespace {

namespace dims = sema::dims;

class DeclaredRemarks {
 public:
  explicit DeclaredRemarks(const Compilation& c) : c_(c), spec_(*c.spec) {}

  std::vector<Remark> run() {
    for (const sema::Zone& zone : spec_.zones) {
      if (!zone.openings.empty() && !zone.name.empty()) times(zone);
    }
    shapes();
    for (std::uint32_t i = 0; i < spec_.kinds.size(); ++i) {
      const bool driven = std::any_of(
          spec_.decisions.begin(), spec_.decisions.end(),
          [&](const sema::Decision& d) { return d.kind == sema::KindId{i} && !d.on_plan; });
      if (!driven) kind(sema::KindId{i});
    }
    return std::move(out_);
  }

 private:
  void add(const SourceRange& source, std::string text, std::vector<std::string> details) {
    out_.push_back({source, std::move(text), std::move(details)});
  }

  // ---- zones

  void times(const sema::Zone& zone) {
    std::vector<std::string> details;
    for (const sema::Opening& opening : zone.openings) {
      details.push_back(sema::text_of(opening) + ", UTC");
    }
    details.emplace_back("outside of that it is empty: nothing is inside, and it is far from all");
    add(whole(zone), "zone " + zone.name + " is there at certain times", std::move(details));
  }
  // Of zones that no monitor asks for, which other zones are made of, or pictures.
  void shapes() {
    const std::vector<analysis::ZoneUse> wanted = analysis::wanted_zones(spec_);
    std::vector<std::vector<analysis::ShownSlab>> exact;  // takes its time, and is seldom needed
    for (std::size_t i = 0; i < spec_.zones.size(); ++i) {
      const sema::Zone& zone = spec_.zones[i];
      const bool has_table = wanted[i].any() && !wanted[i].is_apart_alone();
      if (zone.name.empty() || has_table) continue;
      if (std::holds_alternative<sema::ZoneReceived>(zone.value->node)) continue;
      std::vector<std::string> details;
      const auto* all_but = std::get_if<sema::ZoneComplement>(&zone.value->node);
      if (all_but != nullptr && !spec_[all_but->zone].name.empty()) {
        details.push_back(std::string("every place within 536 km of ") +
                          (zone.has_height ? "(0 m, 0 m, 0 m)" : "(0 m, 0 m)") + " that " +
                          spec_[all_but->zone].name + " does not have");
      } else {
        if (exact.empty()) exact = analysis::exact_zones(spec_);
        for (const analysis::ShownSlab& slab : exact[i]) details.push_back(extent(slab));
      }
      details.emplace_back(all_but != nullptr ? "it takes no table of its own"
                           : wanted[i].any()
                               ? "monitors ask how far it is from others, which takes no table"
                               : "no monitor asks for it: modules have no table of it");
      add(whole(zone), "zone " + zone.name, std::move(details));
    }
  }
  // "14 vertices, x from 0 m to 9 m, y from 0 m to 5 m", to the millimetre, with heights where it
  // has some.
  static std::string extent(const analysis::ShownSlab& slab) {
    std::string text = std::to_string(slab.region.vertices()) + " vertices";
    const auto [low, high] = bounds(slab.region);
    text += between("x", low.x, high.x) + between("y", low.y, high.y);
    if (slab.heights) text += between("z", slab.heights->first, slab.heights->second);
    return text;
  }
  static std::string between(const std::string& axis, const Rational& least, const Rational& most) {
    const Rational from(floor_to_int(least * 1000), 1000), to(ceil_to_int(most * 1000), 1000);
    return ", " + axis + " from " + sema::show(from, dims::length) + " to " +
           sema::show(to, dims::length);
  }
  static std::pair<geometry::Point, geometry::Point> bounds(const geometry::Region& region) {
    std::optional<std::pair<geometry::Point, geometry::Point>> box;
    for (const geometry::PolygonWithHoles& part : region.polygons()) {
      for (const geometry::Point& p : part.outer) {
        if (!box) box.emplace(p, p);
        auto& [low, high] = *box;
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    return box.value_or(std::pair<geometry::Point, geometry::Point>{});
  }
  // With its windows, which may stand on other lines.
  [[nodiscard]] SourceRange whole(const sema::Zone& zone) const {
    SourceRange all = zone.name_range;
    const std::string_view text = c_.sources.text(all.file);
    all.end = static_cast<std::uint32_t>(std::min(text.find(';', all.end), text.size()));
    return all;
  }

  // ---- robots that no decision drives

  void kind(sema::KindId id) {
    const sema::RobotKind& k = spec_[id];
    const auto planner = std::find_if(spec_.decisions.begin(), spec_.decisions.end(),
                                      [&](const sema::Decision& d) { return d.kind == id; });
    planner_ = planner != spec_.decisions.end() ? planner->name : "";
    add(k.name_range, "robot " + k.name,
        {planner_.empty()
             ? "no decision: monitors without a robot judge where it is and how it moves"
             : "decision " + planner_ +
                   " judges the lines of its plans, as they are "
                   "proposed: nothing but the way-points counts there"});
    add_counted(k.radius.range, "radius: " + sema::show(k.radius.value, dims::length),
                "gaps between bodies are those of the centres less both radii, gaps to zones less "
                "one",
                "what a body needs beside the lines of a plan its zones leave, as `shrink(zone, "
                "length)` does");
    add_counted(k.motion.range, "motion of " + k.name,
                "a velocity of more than " + sema::show(k.motion.speed.value, dims::speed) +
                    " along one of the axes, by more than its error, is unknown",
                planner_.empty() ? "what else is declared here, a decision alone makes use of"
                                 : "a plan says where it leads, and not how fast");
    sense(id, "position", k.position, dims::length);
    sense(id, "heading", k.heading, dims::angle);
    sense(id, "velocity", k.velocity, dims::speed);
    sense(id, "battery", k.battery, dims::ratio);
    if (k.hears_max_age) for_decisions(k.hears_max_age->range, "hears other robots");
    if (k.plan) {
      for_decisions(k.plan->range, "plan", "judges all of it; it does not count `tracking`");
    }
    if (k.energy) for_decisions(k.energy->range, "energy");
    for_decisions(k.latency.range, "latency: " + sema::show(k.latency.value, dims::time));
    fleets(id);
  }
  // What monitors without a robot make of it, and why a decision on plans makes nothing of it.
  void add_counted(const SourceRange& source, std::string text, std::string watched,
                   std::string else_said) {
    if (planner_.empty()) {
      add(source, std::move(text), {std::move(watched), std::move(else_said)});
      return;
    }
    std::vector<std::string> details{"decision " + planner_ + " does not count it: " + else_said};
    if (c_.module->watch) details.push_back("in monitors without a robot " + watched);
    add(source, std::move(text), std::move(details));
  }
  // `planned`: what a decision on plans does with it.
  void for_decisions(const SourceRange& source, std::string text,
                     const std::string& planned = "does not count it") {
    add(source, std::move(text),
        {planner_.empty() ? "a decision alone makes use of it"
                          : "decision " + planner_ + " " + planned});
  }

  void sense(sema::KindId id, const std::string& name, const std::optional<sema::Sense>& s,
             const sema::Dimension& dimension) {
    if (!s) return;
    std::vector<std::string> inputs;
    for (const sema::Robot& robot : spec_.robots) {
      const std::string input = robot.name + "." + name;
      if (robot.kind == id && is_asked(input)) inputs.push_back(input);
    }
    SourceRange range = s->error.range;
    range.end = std::max(range.end, s->max_age.range.end);
    add(range, "sense " + name,
        {"error " + sema::show(s->error.value, dimension),
         "unknown when older than " + sema::show(s->max_age.value, dims::time),
         inputs.empty() ? unused_sense() : "inputs: " + listed(inputs)});
  }
  [[nodiscard]] std::string unused_sense() const {
    if (planner_.empty()) return "no monitor speaks of it";
    return "decision " + planner_ +
           " does not count it: it judges plans, wherever the robot is when they are proposed";
  }
  static std::string listed(const std::vector<std::string>& inputs) {
    constexpr std::size_t shown_max = 6;
    std::string text;
    for (std::size_t i = 0; i < inputs.size() && i < shown_max; ++i) {
      text += (i > 0 ? ", " : "") + inputs[i];
    }
    const std::size_t shown = std::min(inputs.size(), shown_max);
    return inputs.size() > shown ? text + " and " + std::to_string(inputs.size() - shown) + " more"
                                 : text;
  }
  // Does a monitor ask for the input of a robot?
  [[nodiscard]] bool is_asked(const std::string& input) const {
    if (!c_.module->watch) return false;
    const auto& inputs = c_.module->watch->inputs;
    return std::any_of(inputs.begin(), inputs.end(), [&](const ir::Channel& channel) {
      return spec_.inputs[channel.declared].name == input;
    });
  }

  // One remark for each name that a `fleet` declares.
  void fleets(sema::KindId id) {
    for (auto first = spec_.robots.begin(); first != spec_.robots.end();) {
      const auto behind = std::find_if(first, spec_.robots.end(), [&](const sema::Robot& each) {
        return !(each.name_range == first->name_range);
      });
      if (first->kind == id) fleet(*first, static_cast<std::size_t>(behind - first));
      first = behind;
    }
  }
  void fleet(const sema::Robot& first, std::size_t robots) {
    const bool numbered = first.number.has_value();
    add(first.name_range,
        (numbered ? "fleet " + first.fleet : "robot " + first.name) + " : " +
            spec_[first.kind].name + (numbered ? ", " + count(robots, "robot") : ""),
        {planner_.empty()
             ? "no decision: the monitors without a robot are told what they ask of it as inputs"
             : "decision " + planner_ + " judges its plans"});
  }

  const Compilation& c_;
  const sema::Spec& spec_;
  std::string planner_;  // the decision that judges the plans of a kind; empty: none does
  std::vector<Remark> out_;
};

}  // namespace

std::vector<Remark> declared_remarks(const Compilation& c) {
  return DeclaredRemarks(c).run();
}

}  // namespace rtac::driver
