// What was derived for robots: limits on the grid, tables, look-ahead and clearances.
#include <algorithm>
#include <variant>

#include "compiler/analysis/derive.h"
#include "compiler/analysis/liveness.h"
#include "compiler/codegen/decision_bytes.h"
#include "compiler/codegen/watch.h"
#include "compiler/driver/explain_line.h"
#include "compiler/driver/explain_property.h"
#include "compiler/driver/explain_text.h"
#include "compiler/ir/facts.h"
#include "compiler/ir/source_text.h"
#include "compiler/sema/dimension.h"

namespace rtac::driver {
namespace {

using namespace ir;
namespace dims = sema::dims;

std::string scaled(std::int64_t value, long per_si, const sema::Dimension& dimension) {
  return sema::show(Rational(Rational(static_cast<long>(value)) / per_si), dimension);
}
std::string length_of(std::int64_t mm) {
  return scaled(mm, 1000, dims::length);
}
std::string speed(std::int64_t mmps) {
  return scaled(mmps, 1000, dims::speed);
}
std::string time(std::int64_t us) {
  return scaled(us, 1'000'000, dims::time);
}
std::string bytes(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " byte" : " bytes");
}

class RobotRemarks {
 public:
  explicit RobotRemarks(const Compilation& c) : c_(c), spec_(*c.spec), module_(*c.module) {}

  std::vector<Remark> run() {
    for (const sema::Zone& z : spec_.zones) zone(z);
    for (const sema::Site& s : spec_.sites) site(s);
    for (std::size_t i = 0; i < spec_.decisions.size(); ++i) {
      const sema::Decision& from = spec_.decisions[i];
      const Decision& d = module_.decisions[i];
      decision(from, d);
      kind(spec_[from.kind], d);
      for (std::size_t k = 0; k < from.priority.size(); ++k) monitor(spec_[from.priority[k]], d, k);
    }
    return std::move(out_);
  }

 private:
  void add(const SourceRange& source, std::string text, std::vector<std::string> details) {
    out_.push_back({source, std::move(text), std::move(details)});
  }

  void zone(const sema::Zone& from) {
    const auto table =
        std::find_if(module_.zones.begin(), module_.zones.end(),
                     [&](const ZoneTable& z) { return !from.name.empty() && z.name == from.name; });
    if (table == module_.zones.end()) return;
    if (table->has_height()) {
      slabs(from, *table);
      return;
    }
    const Cells& cells = table->cells;
    const std::size_t size = table->edges.size() * sizeof(Edge) + table->tree.bytes() +
                             cells.clearance_mm_lo.size() * sizeof(std::int32_t);
    add(join(from.name_range, from.value->range), "zone " + from.name,
        {std::to_string(table->edges.size()) + " edges, exact, snapped to the mm on the safe side",
         edges_checked(table->edges.size(), table->tree),
         "widest place: clearance " + length_of(table->widest_mm) + " at (" +
             length_of(table->widest_x_mm) + ", " + length_of(table->widest_y_mm) + ")",
         std::to_string(cells.columns) + " x " + std::to_string(cells.rows) + " cells of " +
             length_of(cells.cell_mm),
         "tables: " + bytes(size)});
  }
  void slabs(const sema::Zone& from, const ZoneTable& table) {
    std::vector<std::string> lines;
    for (const ZoneTable::Slab& slab : table.slabs) {
      lines.push_back("from " + length_of(slab.floor_mm) + " to " + length_of(slab.ceiling_mm) +
                      ": " + std::to_string(module_[slab.base].edges.size()) + " edges");
    }
    lines.push_back("widest place: clearance " + length_of(table.widest_mm) + " at (" +
                    length_of(table.widest_x_mm) + ", " + length_of(table.widest_y_mm) + ", " +
                    length_of(table.widest_z_mm) + ")");
    add(join(from.name_range, from.value->range), "zone " + from.name, std::move(lines));
  }
  static SourceRange join(const SourceRange& a, const SourceRange& b) {
    return a.file == b.file ? SourceRange{a.file, a.begin, b.end} : a;
  }

  void site(const sema::Site& from) {
    for (const SiteTable& table : module_.sites) {
      if (table.name != from.name && table.name.rfind(from.name + "_of_", 0) != 0) continue;
      for (const SiteTable::Place& place : table.places) {
        const auto same = [&](const sema::Site::Place& p) {
          return !p.robot || spec_[*p.robot].name == place.robot;
        };
        const auto at = std::find_if(from.places.begin(), from.places.end(), same);
        if (at == from.places.end()) continue;
        std::vector<std::string> details = {"on the cells of zone " + module_[table.zone].name};
        if (!place.cost_ppm.empty()) {
          details.push_back("charge that the way there takes, by cell: " +
                            bytes(place.cost_ppm.size() * sizeof(std::int32_t)));
        }
        add(at->range, "site " + from.name + " of " + place.robot, std::move(details));
      }
    }
  }

  static std::string jitter(const sema::Decision& from, const Decision& d) {
    std::int64_t gap_us = INT64_MAX;
    for (const Monitor& m : d.monitors) gap_us = std::min(gap_us, m.lookahead.gap_us);
    std::string text =
        "a step is missed when it comes later than " + time(gap_us) + " after the one before";
    if (d.body.jitter_us == 0) return text;
    text += ", " + time(d.body.jitter_us) + " of it for jitter, part of every horizon";
    if (!from.jitter) text += " (not declared: a tenth of the period)";
    return text;
  }

  // "": of one by priority whose recovery gives way to every monitor that ranks higher.
  static std::string driving_on(const Decision& d, std::size_t row) {
    std::string kept;
    for (std::size_t j = 0; j < row; ++j) {
      if (d.keeps[row][j] != Kept::proved) continue;
      kept += (kept.empty() ? "" : ", ") + d.monitors[j].name;
    }
    if (kept.empty()) return "";
    return d.monitors[row].recovery.name + " is shown to keep " + kept +
           ", and drives on though that engages, unless it is false or a tick was missed";
  }
  // Of a decision that coordinates.
  static std::string keeping(const Decision& d, std::size_t row) {
    std::string doubtful;
    for (std::size_t j = 0; j < d.keeps[row].size(); ++j) {
      if (d.keeps[row][j] != Kept::unproved) continue;
      doubtful += (doubtful.empty() ? "" : ", ") + d.monitors[j].name;
    }
    const std::string who = "coordinated: " + d.monitors[row].recovery.name + " keeps ";
    if (doubtful.empty()) return who + "all of them";
    return who + "the others, and " + doubtful + " as long as that is seen ahead of it";
  }

  void decision(const sema::Decision& from, const Decision& d) {
    std::vector<std::string> details;
    if (!d.on_plan) {
      details.push_back("every " + time(d.period_us) + ", " + std::to_string(d.robots) +
                        (d.robots == 1 ? " robot" : " robots"));
      details.push_back(jitter(from, d));
      details.push_back("control returns after " + std::to_string(d.dwell_ticks) +
                        " ticks on which every return condition holds, " + time(d.return_extra_us) +
                        " further ahead");
      details.push_back("a planner that keeps a clearance of " + length_of(d.cruise_clearance_mm) +
                        " never meets a fence, at any speed");
      details.push_back("state: " + bytes(codegen::decision_state_bytes(d)) + " a robot");
    }
    for (const Monitor& m : d.monitors) details.push_back("monitor " + m.name);
    for (std::size_t k = 0; k < d.keeps.size(); ++k) {
      std::string says = d.coordinated ? keeping(d, k) : driving_on(d, k);
      if (!says.empty()) details.push_back(std::move(says));
    }
    add(from.period ? join(from.name_range, from.period->range) : from.name_range,
        "decision " + d.name + " for " + d.kind + (d.on_plan ? ", on a plan" : ""),
        std::move(details));
    for (const sema::Acknowledgement& a : from.acknowledgements) {
      add(a.range,
          "acknowledged: " + spec_[a.recovery].name + " may break " + spec_[a.monitor].name,
          {a.reason});
    }
  }

  // ---- the robot: what its bounds are on the integers of the kernel, rounded to the safe side

  void kind(const sema::RobotKind& k, const Decision& d) {
    if (d.on_plan) return;
    const Body& b = d.body;
    add(k.radius.range, "radius: " + length_of(b.radius_mm), {});
    const auto sense = [&](const char* name, const std::optional<sema::Sense>& s,
                           const std::string& error, std::int64_t age_us) {
      if (!s) return;
      add(join(s->error.range, s->max_age.range), std::string("sense ") + name,
          {"error " + error + ", rounded up", "unknown when older than " + time(age_us)});
    };
    sense("position", k.position, length_of(b.position_error_mm), b.position_age_us);
    sense("heading", k.heading, k.heading ? sema::show(k.heading->error.value, dims::angle) : "",
          b.heading_age_us.value_or(0));
    sense("velocity", k.velocity, speed(b.velocity_error_mmps), b.velocity_age_us);
    sense("battery", k.battery, scaled(b.battery_error_ppm, 1'000'000, dims::ratio),
          b.battery_age_us);
    motion(k, d);
    if (k.hears_max_age) {
      add(k.hears_max_age->range, "hears other robots",
          {"another robot is unknown when its announcement is older than " + time(b.hears_age_us)});
    }
    if (k.energy) {
      add(k.energy->range, "energy",
          {"a sample loses up to " + scaled(b.drain_ppm_per_s, 1'000'000, dims::ratio) +
               " a second of its age",
           "other recoveries may take " + scaled(d.hold_reserve_ppm, 1'000'000, dims::ratio) +
               " by holding and detours"});
    }
    add(k.latency.range, "latency: " + time(b.latency_us),
        {"part of every horizon, with the age of the sample"});
    if (k.plan) {
      add(k.plan->range, "plan",
          {"legs are checked " + length_of(b.tracking_mm) + " wider on either side",
           "memory: " + std::to_string(d.plan_capacity) + " way-points"});
    }
  }

  void motion(const sema::RobotKind& k, const Decision& d) {
    const Body& b = d.body;
    const auto accel = [](std::int64_t mmps2) { return scaled(mmps2, 1000, dims::acceleration); };
    std::vector<std::string> details = {"any control: at most " + speed(d.motions[0].speed_mmps) +
                                            " and " + accel(b.accel_mmps2) +
                                            " in the plane, turning included",
                                        "brakes with " + accel(b.brake_mmps2) + " at least"};
    if (b.disturbance_mmps2 > 0) {
      details.push_back("is pushed with up to " + accel(b.disturbance_mmps2) +
                        ": a stop is longer and bends by up to " +
                        std::to_string(sway_permille(b)) +
                        " permille of its length, a recovery is "
                        "off its speed by up to " +
                        speed(d.pushed_mmps));
    }
    if (b.brake_late_ms > 0) {
      details.push_back("samples and noise delay the brake by up to " +
                        time(b.brake_late_ms * 1000));
    }
    if (b.brake_lag_permille > 0) {
      details.push_back("the way to a stop bends away by up to " +
                        std::to_string(b.brake_lag_permille) + " permille of its length");
    }
    details.push_back("holds its place within " + length_of(b.hold_mm));
    add(k.motion.range, "motion of " + k.name, std::move(details));
  }

  // ---- monitors

  void monitor(const sema::Monitor& from, const Decision& d, std::size_t k) {
    const Monitor& m = d.monitors[k];
    const std::string id = m.requirement_id.empty() ? "" : m.requirement_id + ": ";
    std::vector<std::string> details = {id + m.requirement_text};
    if (d.on_plan) {
      details.emplace_back("every leg of the plan");
    } else {
      lookahead(m, analysis::summarise(module_, d)[k], details);
      recovery(m.recovery, details);
      comes_back(from, d, m, details);
      if (!m.return_text.empty()) details.push_back("returns only when " + m.return_text);
      details.push_back(cost(d, m));
    }
    add(from.range,
        "monitor " + m.name + " of decision " + d.name + ", number " + std::to_string(k + 1) +
            " of " + std::to_string(d.monitors.size()),
        std::move(details));
    PropertyRemarks properties(c_, d.facts, &d, out_);
    if (!d.on_plan) {
      properties.expressions(*from.always, from.range, m.name, m.property);
      if (m.return_when) {
        properties.expressions(*from.return_when, from.range, m.name, *m.return_when);
      }
    }
    if (from.recover && !d.on_plan) {
      std::vector<std::string> of_recovery = {"for monitor " + m.name + " of decision " + d.name};
      recovery(m.recovery, of_recovery);
      add(spec_[*from.recover].name_range, "controller " + m.recovery.name, std::move(of_recovery));
    }
  }
  // What a tick of the property and of its return condition takes, and what is remembered for them.
  static std::string cost(const Decision& d, const Monitor& m) {
    constexpr std::size_t run_bytes = 8, found_bytes = 32;
    std::size_t operations = 0, of_others = 0, remembered = 0;
    const auto add = [&](const Block& block) {
      for (const Value& v : block.values) {
        operations += 1;
        if (const Block* others = body_of(v.op)) of_others += others->values.size();
        remembered += std::holds_alternative<HeldFor>(v.op) ? run_bytes : 0;
      }
    };
    add(m.property);
    if (m.return_when) add(*m.return_when);
    for (const std::uint32_t index : facts_of(d, m)) {
      const PlainMonitor& fact = d.facts.monitors[index];
      add(fact.property);
      remembered += found_bytes + static_cast<std::size_t>(codegen::watch_monitor_bytes(fact));
    }
    return "judged now: " + count(operations, "operation") + " a tick" +
           (of_others > 0 ? ", " + std::to_string(of_others) + " more for each other robot" : "") +
           ", remembers " + bytes(remembered);
  }
  static void lookahead(const Monitor& m, const analysis::MonitorSummary& s,
                        std::vector<std::string>& to) {
    if (m.lookahead.duration) {
      to.push_back("looks " + time(s.lookahead_us) + " ahead; horizon " + time(s.horizon_us) +
                   ", with sample age, latency and jitter");
      to.push_back("stopping from full speed takes a clearance of " + length_of(s.stopping_mm));
      to.push_back("control returns at a clearance of " + length_of(s.return_clearance_mm));
      if (!s.zone.empty()) {
        to.push_back("predicted share of the advanced controller: of the places in " + s.zone +
                     " where the body fits, it may go at any speed in " +
                     std::to_string(s.share.any_speed) + " %, and gets control back in " +
                     std::to_string(s.share.returns) + " %");
      }
      if (s.lookahead_max_us > 0) {
        to.push_back("the zone allows a look-ahead of up to " + time(s.lookahead_max_us));
      }
      if (s.leave_us > 0) {
        to.push_back("to lead out of zones that come and go takes " + time(s.leave_us) +
                     " at most");
      }
    }
    if (m.lookahead.waypoints > 0) {
      to.push_back("checks " + std::to_string(m.lookahead.waypoints) +
                   (m.lookahead.points_only ? " way-points, no legs"
                                            : " legs of the plan behind the present one"));
    }
    if (m.lookahead.command) {
      to.emplace_back("judges the commands that are known and the one that is proposed, too");
    }
    const bool sound = m.lookahead.duration && !m.lookahead.too_short && !m.lookahead.points_only;
    if (!sound) to.emplace_back("unsound, as it is written");
  }
  void recovery(const Recovery& r, std::vector<std::string>& to) const {
    switch (r.kind) {
      case RecoveryKind::brake:
        to.push_back("recovery " + r.name + ": brakes and holds its place");
        to.push_back("control returns only where it stops with a clearance of " +
                     length_of(r.return_clearance_mm) + ": it does not move there");
        return;
      case RecoveryKind::sequence:
        for (const Recovery& step : r.steps) {
          recovery(step, to);
          if (step.lasts_us > 0) to.push_back("for " + time(step.lasts_us) + ", then");
        }
        return;
      case RecoveryKind::loiter:
        to.push_back("recovery " + r.name + ": retreats within " + module_[r.zone].name +
                     " and circles where control can be given back");
        break;
      case RecoveryKind::external:
        to.push_back("recovery " + r.name + ": external");
        if (!r.claims) return;
        to.push_back("assumed: it stays inside " + module_[r.zone].name + ", at " +
                     speed(r.speed_mmps) +
                     " at most; checked in every tick, and braked where it "
                     "does not");
        return;
      case RecoveryKind::land:
        to.push_back("recovery " + r.name + ": goes straight down to " + length_of(r.land_mm) +
                     " and holds, at " + speed(r.speed_mmps) + " at most");
        to.push_back("control returns only where that place has a clearance of " +
                     length_of(r.return_clearance_mm));
        return;
      case RecoveryKind::retreat:
        to.push_back("recovery " + r.name + ": retreats within " + module_[r.zone].name);
        break;
      case RecoveryKind::route:
        to.push_back("recovery " + r.name + ": drives to " + module_[r.site].name + " within " +
                     module_[r.zone].name);
        break;
      case RecoveryKind::yield:
        to.push_back("recovery " + r.name + ": makes way within " + module_[r.zone].name +
                     ", passes others at a distance of centres of " + length_of(r.pass_gap_mm));
        break;
    }
    to.back() += ", at " + speed(r.speed_mmps) + " at most";
    to.push_back("it keeps a clearance of " + length_of(r.route_clearance_mm) + " on its way");
  }

  // theory, P2b.
  void comes_back(const sema::Monitor& from, const Decision& d, const Monitor& m,
                  std::vector<std::string>& to) const {
    if (!m.hold_reason.empty()) to.push_back("accepted where it is false: " + m.hold_reason);
    const auto seconds = analysis::return_seconds(spec_[from.kind], module_, d, m.recovery);
    if (seconds) {
      // whether they do, verify finds out
      const bool legs = d.body.in_space && ir::goes_back(ir::last_step(m.recovery).kind);
      to.push_back("control comes back within " +
                   to_decimal(Rational(ceil_to_int(Rational(*seconds * 10)), 10)) + " s, where " +
                   (legs ? "straight legs lead to room, " : "") +
                   "no other robot is near and nothing else keeps it");
    } else {
      to.emplace_back("nothing bounds the time until control comes back");
    }
  }

  const Compilation& c_;
  const sema::Spec& spec_;
  const Module& module_;
  std::vector<Remark> out_;
};

}  // namespace

std::vector<Remark> robot_remarks(const Compilation& c) {
  return RobotRemarks(c).run();
}

}  // namespace rtac::driver
