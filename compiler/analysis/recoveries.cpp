#include "compiler/analysis/recoveries.h"

#include <algorithm>

#include "compiler/analysis/boundless.h"
#include "compiler/analysis/dials.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/joint_return.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/reach.h"
#include "compiler/analysis/repairs.h"
#include "compiler/analysis/return_set.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/timing.h"
#include "compiler/analysis/travel.h"
#include "compiler/analysis/widening.h"
#include "compiler/analysis/windows.h"
#include "compiler/analysis/zone_trials.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/words.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

using diag::Code;

// A part of fewer cells is a notch: whoever has stopped in it sees what lies beside it.
constexpr std::int64_t stranded_cells_least = 4;
using Places = std::vector<ir::SiteTable::Place>;
constexpr const char* kept_moving = "may be kept moving where it holds its place";

class Recoveries {
 public:
  Recoveries(const sema::Spec& spec, const ir::Module& module, const ExactZone& exact,
             const ExactSolid& solid, const sema::Decision& decided, const ir::Decision& decision,
             const sema::Monitor& written, const ir::Monitor& monitor, Trials* trials,
             diag::Engine& diagnostics)
      : spec_(spec),
        module_(module),
        exact_(exact),
        solid_(solid),
        decided_(decided),
        decision_(decision),
        written_(written),
        monitor_(monitor),
        controller_(spec[*written.recover]),
        trials_(trials),
        diagnostics_(diagnostics) {}

  void run(bool remarks) {
    look_at_places();
    if (!stays_for_received()) return;
    outward(asks_of(monitor_.property, decision_.facts.params));
    claimed();
    acts_in_time();
    if (remarks) way_back();
  }

 private:
  void look_at_places() {
    std::vector<diag::Diagnostic> all;
    if (decision_.body.in_space) {
      auto found =
          misplaced_in_space(written_, module_, decision_, monitor_, exact_, solid_, trials_);
      if (found) all.push_back(std::move(*found));
    } else {
      all = misplaced(spec_[written_.kind], written_, controller_, module_, exact_, decision_,
                      monitor_, trials_);
    }
    misplaced_ = !all.empty();
    for (diag::Diagnostic& found : all) diagnostics_.report(std::move(found));
  }
  // Language rule 9.9: nobody knows a way relative to a zone that is received later. False:
  // reported.
  bool stays_for_received() {
    const bool asks = ir::asks_for_received(monitor_.property) ||
                      (monitor_.return_when && ir::asks_for_received(*monitor_.return_when));
    if (!asks || monitor_.recovery.kind == ir::RecoveryKind::brake) return true;
    diag::Diagnostic d =
        finding(Code::zone_not_fixed, "`" + controller_.name +
                                          "` recovers for a zone that is received, and where that "
                                          "will be is not known before");
    d.label = "moves, and may leave that zone or enter it";
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    d.help =
        "`brake_and_hold` works, which keeps every zone that stays as it is until the robot "
        "stands, with `hold when violated \"why\";` in the monitor";
    diagnostics_.report(std::move(d));
    return false;
  }
  // Language rule 11: where the property is false, at the start or because an assumption was, the
  // recovery has to lead out of that.
  void outward(const Asks& asks) {
    const ir::RecoveryKind last = ir::last_step(monitor_.recovery).kind;
    const bool stands =
        last == ir::RecoveryKind::brake || (last == ir::RecoveryKind::land && !asks.only_lower);
    // who yields has braked first, and moves for others alone
    const bool brakes = last == ir::RecoveryKind::brake || last == ir::RecoveryKind::yield;
    const bool at_rest = brakes && holds_in_hold(decision_, monitor_);
    if (at_rest && !written_.hold_reason) return;
    const bool stays = (asks.clearance || asks.distance) && stands && !at_rest;
    const bool waits = asks.clearance && last == ir::RecoveryKind::yield;
    const bool braked = asks.clearance && monitor_.recovery.claims;
    const bool holds = stays || waits || braked;
    // Whether there is room to pass each other is not shown, nor that what leads away from
    // boundaries leads away from others, nor where an external one leads: it may be accepted that
    // robots wait for each other. Nor is what becomes of a robot on the ground, or of one that its
    // return condition keeps.
    const bool leads_elsewhere = ir::moves(last) || last == ir::RecoveryKind::external;
    const bool may_wait = (asks.distance && leads_elsewhere) ||
                          (asks.only_lower && last == ir::RecoveryKind::land) ||
                          monitor_.returns.how == ir::Returns::How::open;
    // what cannot be looked ahead is reported by itself (5006), and so is what leads elsewhere, and
    // an external one without a claim (5019)
    const bool unclaimed =
        monitor_.recovery.kind == ir::RecoveryKind::external && !monitor_.recovery.claims;
    const bool reported = asks.other || misplaced_ || unclaimed;
    if (written_.hold_reason && !holds && !may_wait) return reported ? void() : unneeded();
    // nor does it lead out of what comes and goes (5030), unless that is accepted
    const bool stays_in = has_windows(monitor_.property) &&
                          !ir::acknowledged(decision_, monitor_.recovery.name, monitor_.name);
    if (written_.hold_reason || !holds || stays_in) return;
    if (braked) return breaks_its_claim();
    if (brakes && holds_standing(monitor_)) return waits_slow(waits);
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
    d.help = ways_out_of(d, asks.clearance);
    diagnostics_.report(std::move(d));
  }
  // Who leads out of a violation, or why nobody has to.
  std::string ways_out_of(const diag::Diagnostic& d, bool of_place) const {
    const std::string held = "`hold when violated \"why\";` in the monitor";
    // who moves knows no way in a zone that is received later
    const auto speed = ir::asks_for_received(monitor_.property) ? std::nullopt : speed_to_lead();
    const auto zone = zone_to_lead();
    const std::string at = speed ? " speed " + to_decimal(*speed) + " m/s" : "";
    if (!speed || trials_ == nullptr) return held + " works";
    if (!of_place) {
      return "`yield within Z" + at + " order id`, Z being where they may pass, is needed, or " +
             held + ", which works";
    }
    if (!zone) {
      return "`retreat within Z" + at + "`, Z being where it holds, is needed, or " + held +
             ", which works";
    }
    const std::string back = "`retreat within " + spec_[*zone].name + at + "`";
    if (leads_back(*zone, *speed, d)) return back + " works, or " + held;
    const std::string left = trials_->left_last();
    return held + " works" + (left.empty() ? "" : "; " + back + " is not enough (" + left + ")");
  }
  // It is slow enough there, and would not be as soon as it was given back.
  void waits_slow(bool yields) {
    const std::int64_t from_rest_mmps =
        fastest_from_hold(decision_, monitor_.lookahead.duration_us);
    diag::Diagnostic d = finding(
        Code::recovery_stands,
        "`" + controller_.name + "` " + (yields ? "makes way for robots alone" : "only stands") +
            ": where `" + monitor_.name + "` asks it to be slow, it may never be given back");
    d.label = holds_at_rest(decision_, monitor_) ? kept_moving
                                                 : "does not lead to where it may be faster";
    d.notes.push_back({std::nullopt, from_rest_text(spec_[controller_.kind], from_rest_mmps)});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    const auto speed = ir::asks_for_received(monitor_.property) ? std::nullopt : speed_to_lead();
    const std::string leads = speed ? "`retreat within Z speed " + to_decimal(*speed) +
                                          " m/s`, Z being where it may be faster, or "
                                    : "";
    // as fast as it may ever be no limit says anything
    const std::string limits =
        from_rest_mmps < decision_.motions.front().speed_mmps
            ? "limits of at least " + to_decimal(Rational(from_rest_mmps, 1000)) + " m/s work, or "
            : "";
    const auto numbers = repairs(decided_, trials_, fault_of(d.code, d.range), [&](const Trial& t) {
      const std::int64_t ahead_us = lookahead_us(spec_, written_, t.decision.period_us);
      return fastest_from_hold(t.decision, ahead_us) <= least_limit_mmps(monitor_.property);
    });
    d.help = (numbers.empty() ? "" : joined(numbers) + " works, or ") + limits + leads +
             "`hold when violated \"why\";` in the monitor" +
             (limits.empty() && numbers.empty() ? " works" : "");
    diagnostics_.report(std::move(d));
  }
  // Outside of what it claims an external recovery is braked, in every tick.
  void breaks_its_claim() {
    const std::string zone = "`" + module_[monitor_.recovery.zone].name + "`";
    diag::Diagnostic d =
        finding(Code::no_way_back, "where `" + monitor_.name + "` is false, `" + controller_.name +
                                       "` breaks its claim: it is braked, and control is never "
                                       "given back");
    d.label = "does not lead out of a violation";
    d.notes.push_back(
        {controller_.name_range, "its claim to stay inside " + zone + " is declared here"});
    d.help = "`hold when violated \"why\";` in the monitor says why that is acceptable";
    const auto to = zone_to_lead();
    const auto speed = speed_to_lead();
    if (to && speed && leads_back(*to, *speed, d)) {
      d.help += "; or `retreat within " + spec_[*to].name + " speed " + to_decimal(*speed) +
                " m/s` leads back in";
    }
    diagnostics_.report(std::move(d));
  }
  // The one zone that the property keeps the robot in; none: there are several, or it has no name.
  [[nodiscard]] std::optional<sema::ZoneId> zone_to_lead() const {
    const auto fences = fences_of(monitor_.property, decision_.facts.params);
    if (fences.size() != 1 || trials_ == nullptr) return std::nullopt;
    const std::string& name = module_[fences[0]].name;
    if (name.starts_with("outside_of_") || name.starts_with("zone_of_line_")) return std::nullopt;
    return trials_->zone_of(fences[0]);
  }
  // none: its robot is led at no speed.
  [[nodiscard]] std::optional<Rational> speed_to_lead() const {
    const ir::Recovery& last = ir::last_step(monitor_.recovery);
    const std::int64_t own_mmps = ir::moves(last.kind) ? last.speed_mmps : 100;
    const sema::RobotKind& kind = spec_[written_.kind];
    const Rational wanted =
        std::min(kind.motion.speed.value, Rational(static_cast<long>(own_mmps), 1000));
    return led_at(kind, wanted, decision_.period_us);
  }
  // A retreat there, instead of what is reported.
  [[nodiscard]] bool leads_back(sema::ZoneId zone, const Rational& speed,
                                const diag::Diagnostic& reported) const {
    sema::Controller back = controller_;
    back.name += " that leads back in " + spec_[zone].name + " at " + to_decimal(speed);
    back.implementation = sema::Retreat{zone, {speed, {}}};
    return works_recovered_by(*trials_, fault_of(reported.code, reported.range), written_.name,
                              std::move(back));
  }
  void unneeded() {
    diag::Diagnostic d{};
    d.code = Code::clause_without_effect;
    d.range = *written_.hold_range;
    d.message = "`hold when violated` has no effect: ";
    if (ir::last_step(monitor_.recovery).kind == ir::RecoveryKind::brake) {
      d.message += "where `" + monitor_.name + "` is false, there is no place to be led out of";
      d.label = "a robot that stands is enough";
      d.help = "leave it out";
    } else {
      d.message += "`" + controller_.name + "` leads out of a violation of `" + monitor_.name + "`";
      d.label = "the recovery moves";
      d.help = "leave it out, or recover with `brake_and_hold`";
    }
    diagnostics_.report(std::move(d));
  }

  // theory, horizon: the module runs every Delta; a command that acts later than the look-ahead
  // lasts is overtaken by the next decisions before it does anything. No look-ahead that covers it
  // may leave a place to return to.
  void acts_in_time() {
    const std::int64_t latency_us = decision_.body.latency_us;
    const std::int64_t ahead_us = monitor_.lookahead.duration_us;
    if (!monitor_.lookahead.duration || monitor_.lookahead.too_short || latency_us <= ahead_us) {
      return;
    }
    const Fits returns = [&](const Trial& t) { return returns_covered(t); };
    const bool covered = returns(trial_of(spec_, decided_));
    diag::Diagnostic d{};
    d.code = covered ? Code::latency_too_long : Code::limit_contradictory;
    d.range = monitor_.lookahead_source;
    if (d.range->begin == d.range->end) d.range = written_.name_range;
    d.message = "a command acts " + millis(latency_us) + " after it is decided, and `" +
                monitor_.name + "` looks " + millis(ahead_us) + " ahead";
    d.label = covered ? "the latency is longer than the look-ahead"
                      : "no look-ahead that covers the latency leaves a place to return to";
    d.notes.push_back({spec_[written_.kind].latency.range, "the latency is declared here"});
    const auto others = covered ? std::vector<std::string>{}
                                : repairs(decided_, trials_, fault_of(d.code, d.range), returns);
    const std::string least = "a latency of at most " + millis(ahead_us);
    d.help =
        covered ? timely(fault_of(d.code, d.range), latency_us, ahead_us)
        : others.empty()
            ? as_tried(trials_, "no number alone works: a wider zone and " + least + " are needed")
            : joined(others) + " works";
    diagnostics_.report(std::move(d));
  }
  // A look-ahead that covers the latency, or a latency that is covered.
  std::string timely(const Fault& fault, std::int64_t latency_us, std::int64_t ahead_us) const {
    if (trials_ == nullptr) return "";  // nobody reads it
    const std::int64_t ahead_ms = ahead_us / 1000, latency_ms = (latency_us + 999) / 1000;
    const auto longer = lookahead_that_works(
        *trials_, {fault, 1000, ahead_ms, latency_ms, 2 * latency_ms}, monitor_.name);
    const std::string left = longer ? "" : trials_->left_last();
    sema::RobotKind& kind = trials_->spec().kinds[static_cast<std::size_t>(written_.kind)];
    const auto sooner = quantity_that_works(*trials_, {fault, 1000, 0, ahead_ms, 0},
                                            "latency of " + kind.name, kind.latency);
    const std::string latency =
        sooner ? "a latency of at most " + std::to_string(*sooner) + " ms" : "";
    if (longer) {
      return "`ahead " + std::to_string(*longer) + " ms` works" + (sooner ? ", or " + latency : "");
    }
    return sooner ? latency + " works"
                  : as_tried(trials_, "`ahead " + millis(latency_us) +
                                          "` or less of a latency is needed, and not alone: other "
                                          "errors are left" +
                                          (left.empty() ? "" : " (" + left + ")"));
  }
  // With a look-ahead that covers the latency, each zone that a recovery of the decision ends in,
  // or that a property keeps the robot in, has a place to return to.
  bool returns_covered(const Trial& t) const {
    const std::int64_t need_mm = return_clearance_mm(t.decision, covering_us(t));
    for (const ir::Monitor& m : decision_.monitors) {
      const ir::Recovery& last = ir::last_step(m.recovery);
      const auto zones = fences_of(m.property, decision_.facts.params);
      const std::int64_t standoff = standoff_mm(decision_, m.recovery);
      if (ir::goes_back(last.kind) &&
          need_mm + standoff > room_mm(decision_, last, module_[last.zone])) {
        return false;
      }
      for (const ir::ZoneIndex zone : zones) {
        if (need_mm + standoff > module_[zone].widest_mm) return false;
      }
    }
    return true;
  }

  // What nobody has verified may be wrong; what it claims is checked while it drives.
  void claimed() {
    const ir::Recovery& r = monitor_.recovery;
    if (r.kind != ir::RecoveryKind::external) return;
    if (r.claims) return claims_too_little();
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

  // runtime, claim: the body, and what it may do until it is braked, have to be seen to lie in the
  // zone, at rest and whatever the measurements err.
  void claims_too_little() {
    const ir::ZoneTable& zone = module_[monitor_.recovery.zone];
    std::int64_t ahead_us = 0;
    for (const ir::Monitor& m : decision_.monitors) {
      if (m.recovery.name != monitor_.recovery.name) continue;
      ahead_us = std::max(ahead_us, m.lookahead.duration_us);
    }
    const auto k = static_cast<std::size_t>(&monitor_ - decision_.monitors.data());
    const std::int64_t need_mm = claim_clearance_mm(decision_, decision_.motions[k + 1], ahead_us);
    if (zone.widest_mm >= need_mm) return;
    diag::Diagnostic d =
        finding(Code::recovery_unclaimed, "`" + controller_.name + "` claims to stay inside `" +
                                              zone.name + "`, which is never seen to hold");
    d.label = "braked at once, and for good";
    d.notes.push_back({std::nullopt, "the widest place of `" + zone.name + "` has a clearance of " +
                                         metres(zone.widest_mm) + ", at " +
                                         ir::widest_place(zone)});
    d.notes.push_back({std::nullopt,
                       "body, errors, and what a robot at rest may do until it is "
                       "braked take " +
                           metres(need_mm)});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    d.help = "a zone in which a place has a clearance of " + metres(need_mm) + " works" +
             wider_claim(need_mm);
    diagnostics_.report(std::move(d));
  }
  std::string wider_claim(std::int64_t need_mm) const {
    const auto fences = fences_of(monitor_.property, decision_.facts.params);
    const auto zone = zone_to_lead();
    if (!zone || module_[fences[0]].widest_mm < need_mm) return "";
    return ", such as `" + spec_[*zone].name + "`";
  }

  void boundless(const ir::Recovery& last) {
    const ir::ZoneTable& zone = module_[last.zone];
    const std::string name = name_as_written(zone);
    diag::Diagnostic d = finding(Code::no_way_back, "`" + controller_.name + "` moves within " +
                                                        name + ", which has no end");
    d.label = "nobody looks for ways over all of that";
    d.notes.push_back({std::nullopt, "a grid over all of it has cells of " +
                                         metres(zone.cells.cell_mm) +
                                         ", which say nothing of ways around what bounds it"});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    const bool is_route = last.kind == ir::RecoveryKind::route;
    if (trials_ != nullptr) {  // else nobody reads it
      d.help = "a recovery within a zone with an end " +
               with_an_end(*trials_, fault_of(d.code, d.range), written_.range, module_, last,
                           is_route ? module_[last.site].places : Places{});
    }
    diagnostics_.report(std::move(d));
  }
  // theory, P2b: parts of the zone from where the recovery finds no way to give control back.
  void way_back() {
    const ir::Recovery& last = ir::last_step(monitor_.recovery);
    if (!ir::moves(last.kind) || last.kind == ir::RecoveryKind::yield) return;
    const bool is_route = last.kind == ir::RecoveryKind::route;
    if (decision_.body.in_space && !is_route) return;           // its ways are not those over cells
    if (diagnostics_.has_errors()) return;                      // numbers that do not work out yet
    if (is_route && module_[last.site].places.empty()) return;  // there is no robot (2031)
    if (is_boundless(module_[last.zone])) return boundless(last);
    const Ways ways = ways_of(module_, decision_, last);
    // of what is only tried, and nobody reads, none may be left, or P2b of it is not proved
    const bool is_read = trials_ != nullptr;
    if (is_read) {
      const std::vector<Stranded> shut = shut_off(module_[last.zone].cells, last, ways);
      if (!shut.empty() && shut.front().cells >= stranded_cells_least) {
        return no_way(last, shut, true);
      }
    }
    // a few cells that no way leads from may be all that is seen of a passage that is too narrow
    if ((is_read || ways.stranded.empty()) && too_narrow(last)) return;
    if (!ways.stranded.empty()) no_way(last, ways.stranded, false);
  }
  // From these parts of its zone the recovery has none, or none has been found.
  void no_way(const ir::Recovery& last, const std::vector<Stranded>& parts, bool is_shut) {
    const bool is_read = trials_ != nullptr, is_route = last.kind == ir::RecoveryKind::route;
    const Stranded& part = parts.front();
    const ir::ZoneTable& zone = module_[last.zone];
    const std::int64_t cell_mm = zone.cells.cell_mm;
    diag::Diagnostic d = finding(
        Code::no_way_back,
        "from " + place(part.x_mm, part.y_mm) + " in `" + zone.name + "`, " +
            (is_shut ? "`" + controller_.name + "` finds no way to "
                     : "no way of `" + controller_.name + "` over its cells has been found to ") +
            aim_of(last, part));
    d.label = is_shut ? "ends there once the robot is there" : "may end there";
    d.notes.push_back(
        {std::nullopt,
         "the clearance there is " + metres(part.clearance_mm) + ", control returns at " +
             metres(last.return_clearance_mm) + "; the part has about " +
             square_metres(Rational(part.cells * cell_mm * cell_mm, 1'000'000)) +
             (parts.size() > 1 ? ", and there are " + std::to_string(parts.size() - 1) + " more"
                               : "")});
    const auto leads = [](const Ways& of_it) { return of_it.stranded.empty(); };
    const auto over_cells = [&](const std::vector<geometry::EdgeRow>&, const ir::Cells& cells) {
      return leads(ways_over(cells, module_, decision_, last));
    };
    const auto leads_back = [&](const std::vector<geometry::EdgeRow>& edges,
                                const ir::Cells& cells) {
      return leads(ways_over(edges, cells, module_, decision_, last));
    };
    const auto works = grown(last, d, part.clearance_mm, over_cells, leads_back);
    // what has not been looked at, for want of time, and no width helps, may work as it is
    if (is_read && !is_shut && !works) return;
    const std::string without = opened(last, d);
    d.help = without + works.value_or("widen it") + ", or join it to a wider part" +
             (without.empty() ? ", or take it out of the zone" : "");
    // a site is reached wherever control returns
    if (!is_route) d.help += nearer(last.return_clearance_mm - part.clearance_mm, d);
    diagnostics_.report(std::move(d));
  }
  // Of several sites the one that is not reached.
  [[nodiscard]] std::string aim_of(const ir::Recovery& last, const Stranded& from) const {
    const std::string aim = "where control can be given back";
    const bool is_route = last.kind == ir::RecoveryKind::route;
    if (trials_ == nullptr || !is_route || module_[last.site].places.size() < 2) return aim;
    const auto robot = robot_without_way(module_, last, from);
    const ir::SiteTable& site = module_[last.site];
    if (!robot) return aim;
    return "`" + site.name + "(" + site.places[*robot].robot + ")`, " + aim;
  }
  // Numbers with which control returns there, or where a way leads from there: looked for from so
  // much less clearance on.
  [[nodiscard]] std::string nearer(std::int64_t by_mm, const diag::Diagnostic& of) const {
    if (trials_ == nullptr) return "";  // nobody reads it
    const Fault fault = fault_of(of.code, of.range);
    std::string text;
    const auto asked = least_asked(by_mm);
    if (asked && asked->steps > 0) {
      const auto works = asked_that_works(
          *trials_, {fault, 1000, asked->steps + by_mm, asked->steps, asked->steps / asked_share},
          asked->source);
      if (works) text = "; or a clearance of at most " + metres(*works) + " works";
    }
    const std::int64_t back_mm =
        return_clearance_mm(decision_, monitor_.lookahead.duration_us) - by_mm;
    const auto numbers = repairs(decided_, trials_, fault, [&](const Trial& t) {
      const std::int64_t ahead_us = lookahead_us(spec_, written_, t.decision.period_us);
      return return_clearance_mm(t.decision, ahead_us) <= back_mm;
    });
    return text + (numbers.empty() ? "" : "; or " + joined(numbers) + " works");
  }
  struct Asked {
    SourceRange source;
    std::int64_t steps;  // mm
  };
  // What the property asks for beyond being inside, as so much less.
  [[nodiscard]] std::optional<Asked> least_asked(std::int64_t by_mm) const {
    std::optional<Asked> most;
    for (const ir::Value& value : monitor_.property.values) {
      const auto* compare = std::get_if<ir::AtLeast>(&value.op);
      const auto bound = compare
                             ? ir::lower_bound(monitor_.property, *compare, decision_.facts.params)
                             : std::nullopt;
      if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance) continue;
      const std::int64_t mm = bound->need.strictest;
      if (!most || mm - by_mm > most->steps) most = Asked{value.source, mm - by_mm};
    }
    return most;
  }
  // With how much more on every side it works, looked for from where `fits` holds, which is about
  // where a place of so little clearance has what control returns at.
  std::optional<std::string> grown(const ir::Recovery& last, const diag::Diagnostic& of,
                                   std::int64_t clearance_mm, const FitsZone& fits,
                                   const FitsZone& whole = {}) const {
    if (trials_ == nullptr) return std::nullopt;  // nobody reads it
    const ir::ZoneTable& zone = module_[last.zone];
    const geometry::Region& exact = exact_(last.zone);
    const std::int64_t most_mm = 2 * last.return_clearance_mm + 4 * zone.cells.cell_mm;
    const std::int64_t guess_mm = last.return_clearance_mm - clearance_mm;
    const auto by_mm = widening_mm(exact, guess_mm, most_mm, fits, whole);
    if (!by_mm) return std::nullopt;
    return growth_that_works(*trials_, last.zone, exact, *by_mm, most_mm,
                             fault_of(of.code, of.range));
  }

  // Without what is too narrow for control to be given back.
  [[nodiscard]] std::string opened(const ir::Recovery& last, const diag::Diagnostic& of) const {
    if (trials_ == nullptr) return "";  // nobody reads it
    const std::int64_t least_mm = last.return_clearance_mm;
    const auto works = opening_that_works(*trials_, last.zone, least_mm,
                                          least_mm + 2 * module_[last.zone].cells.cell_mm,
                                          fault_of(of.code, of.range));
    return works ? *works + "; or " : "";
  }

  // The advanced controller never drives there: what is too narrow for control to be given back is
  // too narrow for it to be kept. Whether there is such a place.
  bool too_narrow(const ir::Recovery& last) {
    const ir::ZoneTable& zone = module_[last.zone];
    const std::int64_t body_mm = decision_.body.radius_mm + standoff_mm(decision_, last);
    const auto parts = narrow_parts(zone.cells, body_mm, last.return_clearance_mm);
    if (parts.empty() || parts.front().cells < stranded_cells_least) return false;
    diag::Diagnostic d =
        finding(Code::corridor_too_narrow, "control is never given back near " +
                                               place(parts.front().x_mm, parts.front().y_mm) +
                                               " in `" + zone.name + "`");
    d.label = "takes the robot out of there";
    const auto wide = [&](const std::vector<geometry::EdgeRow>&, const ir::Cells& cells) {
      const auto left = narrow_parts(cells, body_mm, last.return_clearance_mm);
      return left.empty() || left.front().cells < stranded_cells_least;
    };
    d.help =
        "it is about " + metres(2 * parts.front().clearance_mm) + " wide there, as cells of " +
        metres(zone.cells.cell_mm) + " tell; " +
        grown(last, d, parts.front().clearance_mm, wide)
            .value_or("control returns " + metres(last.return_clearance_mm) + " from the boundary");
    diagnostics_.report(std::move(d));
    return true;
  }

  [[nodiscard]] diag::Diagnostic finding(Code code, std::string message) const {
    return about_recovery(written_, code, std::move(message));
  }

  const sema::Spec& spec_;
  const ir::Module& module_;
  const ExactZone& exact_;
  const ExactSolid& solid_;
  const sema::Decision& decided_;
  const ir::Decision& decision_;
  const sema::Monitor& written_;
  const ir::Monitor& monitor_;
  const sema::Controller& controller_;
  Trials* trials_;
  diag::Engine& diagnostics_;
  bool misplaced_ = false;  // it moves where its property need not hold
};

}  // namespace

bool stands_near_its_limit(const diag::Diagnostic& report) {
  return report.code == Code::recovery_stands && report.label == kept_moving;
}

void check_recoveries(const sema::Spec& spec, const ir::Module& module, const ExactZone& exact,
                      const ExactSolid& solid, const HowItLies& lies, Trials* trials, bool remarks,
                      diag::Engine& diagnostics) {
  for (std::size_t i = 0; i < module.decisions.size(); ++i) {
    const ir::Decision& decision = module.decisions[i];
    if (decision.on_plan) continue;
    for (std::size_t k = 0; k < decision.monitors.size(); ++k) {
      const sema::Monitor& written = spec[spec.decisions[i].priority[k]];
      if (!written.recover) continue;
      Recoveries(spec, module, exact, solid, spec.decisions[i], decision, written,
                 decision.monitors[k], trials, diagnostics)
          .run(remarks);
    }
    if (decision.body.in_space || diagnostics.has_errors()) continue;
    if (auto found =
            apart_for_ever({spec, spec.decisions[i], module, decision, lies, trials}, exact)) {
      diagnostics.report(std::move(*found));
    }
  }
}

}  // namespace rtac::analysis
