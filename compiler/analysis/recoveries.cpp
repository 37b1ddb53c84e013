#include "compiler/analysis/recoveries.h"

#include <algorithm>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/reach.h"
#include "compiler/analysis/return_set.h"
#include "compiler/analysis/standoffs.h"

namespace rtac::analysis {
namespace {

using diag::Code;

std::string metres(std::int64_t mm) {
  return to_decimal(Rational(mm, 1000)) + " m";
}
std::string millis(std::int64_t us) {
  return to_decimal(Rational(us, 1000)) + " ms";
}

std::string place(std::int64_t x_mm, std::int64_t y_mm) {
  return "(" + metres(x_mm) + ", " + metres(y_mm) + ")";
}

// A part of fewer cells is a notch: whoever has stopped in it sees what lies beside it.
constexpr std::int64_t stranded_cells_least = 4;

class Recoveries {
 public:
  Recoveries(const sema::Spec& spec, const ir::Module& module, const ExactZone& exact,
             const ir::Decision& decision, const sema::Monitor& written, const ir::Monitor& monitor,
             diag::Engine& diagnostics)
      : spec_(spec),
        module_(module),
        exact_(exact),
        decision_(decision),
        written_(written),
        monitor_(monitor),
        controller_(spec[*written.recover]),
        diagnostics_(diagnostics) {}

  void run() {
    const auto& params = decision_.facts.params;
    for (const ir::Recovery* step : ir::steps_of(monitor_.recovery)) {
      if (!ir::moves(step->kind) || decision_.body.in_space) continue;
      for (const ir::ZoneIndex fence : fences_of(monitor_.property, params)) {
        if (elsewhere(*step, fence)) break;
      }
      for (const Choice& choice : choices_of(monitor_.property, params)) chosen(*step, choice);
    }
    outward(asks_of(monitor_.property, params));
    claimed();
    acts_in_time();
    way_back();
  }

 private:
  // A recovery keeps clear of the border of its own zone, whatever the property says of another.
  bool elsewhere(const ir::Recovery& step, ir::ZoneIndex fence) {
    return step.zone != fence && elsewhere(step, exact_(fence), name_of(fence), name_of(fence));
  }
  bool elsewhere(const ir::Recovery& step, const geometry::Region& fence, const std::string& of,
                 const std::string& works) {
    if (fence.contains(exact_(step.zone))) return false;
    const geometry::Region beyond = exact_(step.zone).subtract(fence);
    const std::string zone = "`" + module_[step.zone].name + "`";
    diag::Diagnostic d = finding(Code::recovery_elsewhere,
                                 "`" + controller_.name + "` moves within " + zone + ", and `" +
                                     monitor_.name + "` needs it to stay in " + of);
    d.label = "leads out of " + of;
    d.notes.push_back({std::nullopt, area(beyond) + " of " + zone + " lie outside " + of +
                                         some_place(beyond, fence)});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    d.help = "a zone that lies in " + of + " works, such as " + works;
    diagnostics_.report(std::move(d));
    return true;
  }
  // Of several zones one is enough: the recovery stays in their union. Where it knows a part of it
  // alone, it may lead there from another part, and across what lies between.
  void chosen(const ir::Recovery& step, const Choice& choice) {
    const geometry::Region& own = exact_(step.zone);
    geometry::Region all;
    std::string names;
    for (const ir::ZoneIndex zone : choice) {
      all = all.unite(exact_(zone));
      names += (names.empty() ? "" : " or ") + name_of(zone);
    }
    const std::string works = choice.size() < 2 ? names : "their union";
    if (elsewhere(step, all, names, works) || choice.size() < 2) return;
    const auto within = [&](ir::ZoneIndex zone) { return exact_(zone).contains(own); };
    if (std::all_of(choice.begin(), choice.end(), within) || own.contains(all)) return;
    const geometry::Region beyond = all.subtract(own);
    diag::Diagnostic d = finding(Code::recovery_elsewhere,
                                 "`" + controller_.name + "` knows a part of what `" +
                                     monitor_.name + "` allows, and may lead there from the rest");
    d.label = "leads across what lies between";
    d.notes.push_back({std::nullopt, area(beyond) + " of " + names + " lie outside `" +
                                         module_[step.zone].name + "`" + some_place(beyond, own)});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    d.help = "a recovery within " + works + " works";
    diagnostics_.report(std::move(d));
  }
  // As it is written: a zone within a property has no name of its own.
  std::string name_of(ir::ZoneIndex zone) const {
    const std::string& name = module_[zone].name;
    const std::string unnamed = "zone_of_line_";
    return name.starts_with(unnamed) ? "the zone of line " + name.substr(unnamed.size())
                                     : "`" + name + "`";
  }
  static std::string area(const geometry::Region& region) {
    const std::int64_t square_mm = ceil_to_int(Rational(region.area() * 1'000'000));
    return to_decimal(Rational(square_mm, 1'000'000)) + " m^2";
  }
  static std::string some_place(const geometry::Region& region,
                                const geometry::Region& outside_of) {
    for (const geometry::Ring& ring : region.rings()) {
      for (const geometry::Point& p : ring) {
        if (outside_of.contains(p)) continue;
        return ", such as (" + metres(floor_to_int(Rational(p.x * 1000))) + ", " +
               metres(floor_to_int(Rational(p.y * 1000))) + ")";
      }
    }
    return "";
  }

  // Language rule 11: where the property is false, at the start or because an assumption was, the
  // recovery has to lead out of that.
  void outward(const Asks& asks) {
    const ir::RecoveryKind last = ir::last_step(monitor_.recovery).kind;
    const bool stands = last == ir::RecoveryKind::brake || last == ir::RecoveryKind::land;
    const bool stays = (asks.clearance || asks.distance) && stands;
    const bool waits = asks.clearance && last == ir::RecoveryKind::yield;
    const bool holds = stays || waits;
    // Whether there is room to pass each other is not shown: it may be accepted that there is none.
    const bool may_wait = asks.distance && last == ir::RecoveryKind::yield;
    if (written_.hold_reason && !holds && !may_wait) return unneeded();
    if (written_.hold_reason || !holds) return;
    const ir::Motion& any = decision_.motions[0];
    const std::int64_t farther_mm =
        disc_mm(decision_.body, any, any.speed_mmps,
                horizon_us_max(decision_.body, monitor_.lookahead.duration_us)) -
        decision_.body.radius_mm;
    const std::string name = "`" + controller_.name + "`";
    diag::Diagnostic d = finding(Code::recovery_stands,
                                 name +
                                     (waits ? " makes way for robots alone"
                                      : last == ir::RecoveryKind::land ? " only goes down"
                                                                       : " only stands") +
                                     ": where `" + monitor_.name + "` is false, it stays false");
    d.label = "does not lead out of a violation";
    d.notes.push_back({std::nullopt, "beyond the property at full speed, it stops up to " +
                                         metres(farther_mm) + " farther on, and stays there"});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    d.help = std::string(asks.clearance ? "`retreat within Z speed 0.1 m/s` works"
                                        : "`yield within Z speed 0.1 m/s order id` works") +
             ", or `hold when violated \"why\";` in the monitor";
    diagnostics_.report(std::move(d));
  }
  void unneeded() {
    diag::Diagnostic d{};
    d.code = Code::clause_without_effect;
    d.range = *written_.hold_range;
    d.message = "`hold when violated` has no effect: `" + controller_.name +
                "` leads out of a violation of `" + monitor_.name + "`";
    d.label = "the recovery moves";
    d.help = "leave it out, or recover with `brake_and_hold`";
    diagnostics_.report(std::move(d));
  }

  // theory, horizon: the module runs every Delta; a command that acts later than the look-ahead
  // lasts is overtaken by the next decisions before it does anything.
  void acts_in_time() {
    const std::int64_t latency_us = decision_.body.latency_us;
    const std::int64_t ahead_us = monitor_.lookahead.duration_us;
    if (!monitor_.lookahead.duration || monitor_.lookahead.too_short || latency_us <= ahead_us) {
      return;
    }
    diag::Diagnostic d{};
    d.code = Code::latency_too_long;
    d.range = monitor_.lookahead_source;
    if (d.range->begin == d.range->end) d.range = written_.name_range;
    d.message = "a command acts " + millis(latency_us) + " after it is decided, and `" +
                monitor_.name + "` looks " + millis(ahead_us) + " ahead";
    d.label = "the latency is longer than the look-ahead";
    d.notes.push_back({spec_[written_.kind].latency.range, "the latency is declared here"});
    const std::string least = "a latency of at most " + millis(ahead_us);
    d.help = returns_with(latency_us) ? "`ahead " + millis(latency_us) + "` works, or " + least
                                      : least + " works";
    diagnostics_.report(std::move(d));
  }
  // With that look-ahead, the fences of the property leave a place to return to.
  bool returns_with(std::int64_t ahead_us) const {
    const auto fences = fences_of(monitor_.property, decision_.facts.params);
    return std::all_of(fences.begin(), fences.end(), [&](ir::ZoneIndex zone) {
      return lookahead_max_us(decision_, module_[zone].widest_mm,
                              standoffs_of(decision_).fence_mm) >= ahead_us;
    });
  }

  // What nobody has verified may be wrong; what it claims is checked while it drives.
  void claimed() {
    const ir::Recovery& r = monitor_.recovery;
    if (r.kind != ir::RecoveryKind::external) return;
    if (r.claims && decision_.body.in_space) return;  // refused before
    if (r.claims) {
      ir::Recovery mover = r;
      for (const ir::ZoneIndex fence : fences_of(monitor_.property, decision_.facts.params)) {
        if (elsewhere(mover, fence)) break;
      }
      return;
    }
    const auto fences = fences_of(monitor_.property, decision_.facts.params);
    const std::string zone = fences.empty() ? "Z" : module_[fences.front()].name;
    diag::Diagnostic d =
        finding(Code::recovery_unclaimed,
                "nothing is known of the external recovery `" + controller_.name + "`");
    d.label = "claims nothing that could be checked";
    d.notes.push_back({controller_.name_range, "it is declared here"});
    d.help = "`extern keeps inside " + zone +
             " speed <= " + to_decimal(Rational(decision_.motions[0].speed_mmps, 1000)) +
             " m/s` works: a robot that leaves its claim is braked";
    diagnostics_.report(std::move(d));
  }

  // theory, P2b: parts of the zone from where the recovery finds no way to give control back.
  void way_back() {
    const ir::Recovery& last = ir::last_step(monitor_.recovery);
    if (!ir::moves(last.kind) || last.kind == ir::RecoveryKind::yield) return;
    if (decision_.body.in_space) return;    // its ways are not those over cells
    if (diagnostics_.has_errors()) return;  // numbers that do not work out yet
    const Ways ways = ways_of(module_, decision_, last);
    if (ways.stranded.empty()) too_narrow(last);
    if (ways.stranded.empty() || ways.stranded.front().cells < stranded_cells_least) return;
    const Stranded& part = ways.stranded.front();
    const ir::ZoneTable& zone = module_[last.zone];
    const std::int64_t cell_mm = zone.cells.cell_mm;
    diag::Diagnostic d =
        finding(Code::no_way_back, "from " + place(part.x_mm, part.y_mm) + " in `" + zone.name +
                                       "`, `" + controller_.name +
                                       "` finds no way to where control can be given back");
    d.label = "ends there once the robot is there";
    d.notes.push_back(
        {std::nullopt,
         "the clearance there is " + metres(part.clearance_mm) + ", control returns at " +
             metres(last.return_clearance_mm) + "; the part has about " +
             to_decimal(Rational(part.cells * cell_mm * cell_mm, 1'000'000)) + " m^2" +
             (ways.stranded.size() > 1
                  ? ", and there are " + std::to_string(ways.stranded.size() - 1) + " more"
                  : "")});
    d.help = "widen it to " + metres(2 * last.return_clearance_mm) +
             ", join it to a wider part, or take it out of the zone";
    diagnostics_.report(std::move(d));
  }

  // The advanced controller never drives there: what is too narrow for control to be given back is
  // too narrow for it to be kept.
  void too_narrow(const ir::Recovery& last) {
    const ir::ZoneTable& zone = module_[last.zone];
    const std::int64_t body_mm = decision_.body.radius_mm + standoffs_of(decision_).fence_mm;
    const auto parts = narrow_parts(zone.cells, body_mm, last.return_clearance_mm);
    if (parts.empty() || parts.front().cells < stranded_cells_least) return;
    diag::Diagnostic d =
        finding(Code::corridor_too_narrow, "control is never given back near " +
                                               place(parts.front().x_mm, parts.front().y_mm) +
                                               " in `" + zone.name + "`");
    d.label = "takes the robot out of there";
    d.help = "it is about " + metres(2 * parts.front().clearance_mm) + " wide there, and " +
             metres(2 * last.return_clearance_mm) + " would be wide enough";
    diagnostics_.report(std::move(d));
  }

  diag::Diagnostic finding(Code code, std::string message) const {
    diag::Diagnostic d{};
    d.code = code;
    d.range = written_.recover_range;
    d.message = std::move(message);
    return d;
  }

  const sema::Spec& spec_;
  const ir::Module& module_;
  const ExactZone& exact_;
  const ir::Decision& decision_;
  const sema::Monitor& written_;
  const ir::Monitor& monitor_;
  const sema::Controller& controller_;
  diag::Engine& diagnostics_;
};

}  // namespace

void check_recoveries(const sema::Spec& spec, const ir::Module& module, const ExactZone& exact,
                      const ExactSolid& solid, diag::Engine& diagnostics) {
  for (std::size_t i = 0; i < module.decisions.size(); ++i) {
    const ir::Decision& decision = module.decisions[i];
    if (decision.on_plan) continue;
    for (std::size_t k = 0; k < decision.monitors.size(); ++k) {
      const sema::Monitor& written = spec[spec.decisions[i].priority[k]];
      if (!written.recover) continue;
      Recoveries(spec, module, exact, decision, written, decision.monitors[k], diagnostics).run();
      if (!decision.body.in_space) continue;
      if (auto found = misplaced_in_space(written, module, decision, decision.monitors[k], solid)) {
        diagnostics.report(std::move(*found));
      }
    }
  }
}

}  // namespace rtac::analysis
