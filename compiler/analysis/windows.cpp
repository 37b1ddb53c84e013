#include "compiler/analysis/windows.h"

#include <algorithm>
#include <optional>
#include <string>

#include "compiler/analysis/at_its_worst.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/reach.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/site_room.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/travel.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/schedule.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

using diag::Code;

constexpr const char* ends_near = "control is not given back there";

// Rounded up to tenths.
std::string seconds(std::int64_t us) {
  return to_decimal(Rational((us + 99'999) / 100'000, 10)) + " s";
}
// Rounded up to milliseconds, in us.
std::int64_t whole_ms_us(const Rational& seconds) {
  return 1000 * ceil_to_int(Rational(seconds * 1000));
}
std::string place_text(std::int64_t x_mm, std::int64_t y_mm) {
  return "(" + metres(x_mm) + ", " + metres(y_mm) + ")";
}

bool keeps_apart(const ir::Decision& decision) {
  return std::any_of(decision.monitors.begin(), decision.monitors.end(), [](const ir::Monitor& m) {
    return std::any_of(m.property.values.begin(), m.property.values.end(),
                       [](const ir::Value& v) { return ir::body_of(v.op) != nullptr; });
  });
}

// The longest time that it is there without a gap; what lasts over the end of the week is one.
std::int64_t longest_us(const ir::Schedule& schedule) {
  std::int64_t most = 0;
  for (const auto* list : {&schedule.once, &schedule.weekly}) {
    for (const ir::Opening& o : *list) most = std::max(most, o.until_us - o.from_us);
  }
  const auto& weekly = schedule.weekly;
  if (weekly.empty() || weekly.front().from_us > 0 || weekly.back().until_us < ir::us_per_week) {
    return most;
  }
  if (weekly.size() == 1) return INT64_MAX;
  return std::max(most, ir::us_per_week - weekly.back().from_us + weekly.front().until_us);
}

class Planner {
 public:
  Planner(const sema::Spec& spec, const sema::Decision& from, const ir::Module& module,
          ir::Decision& decision, const WindowTables& tables, Trials* trials,
          diag::Engine& diagnostics)
      : spec_(spec),
        kind_(spec[from.kind]),
        module_(module),
        decision_(decision),
        tables_(tables),
        trials_(trials),
        diagnostics_(diagnostics) {}

  // false: how long some way out takes is not known.
  bool run() {
    for (std::size_t k = 0; k < decision_.monitors.size(); ++k) {
      ir::Monitor& monitor = decision_.monitors[k];
      if (!has_windows(monitor.property)) continue;
      monitor.recovery.leave_us = stop_us();
      others(k);
      const bool is_route = monitor.recovery.kind == ir::RecoveryKind::route;
      if (is_route && !decision_.body.in_space) {
        route(monitor);
      } else if (!ir::acknowledged(decision_, monitor.recovery.name, monitor.name)) {
        all_known_ = all_known_ && !is_route;
        report(Code::window_without_way_out, monitor,
               "the recovery `" + monitor.recovery.name + "` does not lead out before `" +
                   zone_name(monitor) + "` changes",
               why_not_out(monitor.recovery) + "`acknowledge " + monitor.recovery.name +
                   " may break " + monitor.name + " \"why\"`");
      }
      long_enough(monitor);
    }
    return all_known_;
  }

 private:
  [[nodiscard]] std::string why_not_out(const ir::Recovery& recovery) const {
    if (decision_.body.in_space) {
      return "how long a way out takes is known of robots in the plane alone: ";
    }
    return std::string(recovery.kind == ir::RecoveryKind::brake
                           ? "to stand still is no recovery from a zone that comes or goes: "
                           : "how long a way out takes is known of ways to a site alone: ") +
           "`route to` a site where it does not matter works; or ";
  }
  // theory, two robots (time window): s1 / b + t_lag, from the greatest speed
  [[nodiscard]] std::int64_t stop_us() const {
    const Rational seconds(decision_.motions[0].speed_mmps, decision_.body.brake_mmps2);
    return whole_ms_us(seconds) + 1000 * decision_.body.brake_late_ms;
  }
  // While a recovery that outranks it drives, or another robot is near, it does not lead out.
  void others(std::size_t k) {
    const ir::Monitor& monitor = decision_.monitors[k];
    for (std::size_t j = 0; j < k; ++j) {
      const std::string& other = decision_.monitors[j].recovery.name;
      if (other == monitor.recovery.name || ir::acknowledged(decision_, other, monitor.name))
        continue;
      report(Code::window_may_pass, monitor,
             "while `" + other + "` drives for `" + decision_.monitors[j].name +
                 "`, nobody leads out before `" + zone_name(monitor) + "` changes",
             "a higher priority is needed, or the same recovery; or `acknowledge " + other +
                 " may break " + monitor.name + " \"why\"`");
      return;
    }
    const std::string& own = monitor.recovery.name;
    if (!keeps_apart(decision_) || ir::acknowledged(decision_, own, monitor.name)) return;
    report(Code::window_may_pass, monitor,
           "`" + own + "` stands still while another robot is near, and `" + zone_name(monitor) +
               "` changes meanwhile",
           "`acknowledge " + own + " may break " + monitor.name + " \"why\"` works");
  }

  void route(ir::Monitor& monitor) {
    ir::Recovery& recovery = monitor.recovery;
    const ir::SiteTable& site = module_[recovery.site];
    std::int64_t far_mm = 0, clearance_mm = decision_.body.radius_mm;
    const std::int32_t cell_mm = module_[recovery.zone].cells.cell_mm;
    recovery.leave_beside_mm = std::max<std::int64_t>(0, join_mm(recovery, cell_mm));
    crosses(monitor);
    bool ends_well = true;
    for (std::size_t r = 0; r < site.places.size(); ++r) {
      if (site.table_of(r) != r) continue;
      ends_well = ends_well && matters_not(monitor, site, site.places[r]);
      const auto farthest = farthest_mm(monitor, site.places[r], clearance_mm);
      if (!farthest) {
        all_known_ = false;
        return;
      }
      far_mm = std::max(far_mm, *farthest);
    }
    const Rational seconds =
        travel_seconds(kind_, Rational(recovery.speed_mmps, 1000), decision_.period_us, cell_mm,
                       std::max<std::int64_t>(far_mm, 0));
    recovery.leave_least_mm = clearance_mm - decision_.body.radius_mm;
    recovery.leave_us = std::max(stop_us(), whole_ms_us(seconds));
  }

  // What a way loses of its clearance as it joins its cells: its first leg leads to the centre of
  // one, and steering leaves something beside that; less the room that the look-ahead finds clear
  // around a stop for the hold, which other robots might use up.
  [[nodiscard]] std::int64_t join_mm(const ir::Recovery& recovery, std::int64_t cell_mm) const {
    constexpr std::int64_t joins_mm = 10, table_mm = 4;  // with some to spare; on either side
    sema::RobotKind alone = kind_;
    alone.hears_max_age.reset();
    const ir::Body body = body_of(alone, decision_.period_us, decision_.body.jitter_us);
    const std::int64_t half_diagonal_mm = (cell_mm * 7072 + 9999) / 10'000;
    const Rational speed(recovery.speed_mmps, 1000);
    return half_diagonal_mm + beside_mm(kind_, speed, decision_.period_us) + joins_mm + table_mm -
           body.hold_mm;
  }

  // A way knows its zone alone, and leads through what comes or goes: before its time, as it has to
  // lead out of it, and all the time else. What is left of the zone then, at the worst, is not left
  // by ways over cells if it is a rectangle: none of them is longer than it has to be in either
  // direction; nor if the zone is convex, so that ways are straight, and the site sees all of it,
  // and past its corners with the room that the property asks for.
  void crosses(const ir::Monitor& monitor) {
    const ir::Recovery& way = monitor.recovery;
    if (ir::acknowledged(decision_, way.name, monitor.name)) return;
    const geometry::Region& own = tables_.zone(way.zone).exact;
    const geometry::Region left = left_at_worst(monitor);
    if (left.contains(own) || is_rectangle(left)) return;
    const bool straight = is_convex(own);
    Rational room_m(decision_.body.radius_mm + asked_most_mm(monitor), 1000);
    room_m.canonicalize();
    std::optional<geometry::Point> hidden;
    const ir::SiteTable& site = module_[way.site];
    const ir::SiteTable::Place* blind = nullptr;
    for (const ir::SiteTable::Place& home : site.places) {
      if (hidden || !straight) break;
      hidden = hidden_from(left, point_of(home.x_mm, home.y_mm), own, room_m);
      blind = &home;
    }
    if (straight && !hidden) return;
    diag::Diagnostic d{};
    d.code = Code::window_may_pass;
    d.range = monitor.source;
    d.message = "the way of `" + way.name + "` may lead through where `" + monitor.name +
                "` does not hold, whether `" + zone_name(monitor) + "` is there or not";
    if (straight) {
      d.notes.push_back({std::nullopt, "such as from beside " + text_of(*hidden) +
                                           ", straight to `" + site.name + "`"});
    }
    const auto seeing =
        straight ? site_that_works(monitor, *blind, Code::window_may_pass) : std::nullopt;
    d.help =
        "a zone of ways, and of what keeps robots inside, of which a rectangle is left without it "
        "works, such as a strip beside it" +
        (seeing ? ", or " + *seeing : "") + "; or `acknowledge " + way.name + " may break " +
        monitor.name + " \"why\"`";
    diagnostics_.report(std::move(d));
  }
  static geometry::Point point_of(std::int64_t x_mm, std::int64_t y_mm) {
    return {metres_of(x_mm), metres_of(y_mm)};
  }
  static std::string text_of(const geometry::Point& p) {
    return place_text(floor_to_int(Rational(p.x * 1000)), floor_to_int(Rational(p.y * 1000)));
  }

  // "`home` at (3 m, 5 m)": the nearest place with which it works, of those where it matters not
  // whether the zone is there, and that `rtac verify` finds in front of every corner (P2a) and
  // clear of the walls, where ways bend. none: none is found.
  [[nodiscard]] std::optional<std::string> site_that_works(const ir::Monitor& monitor,
                                                           const ir::SiteTable::Place& place,
                                                           Code code) const {
    constexpr std::int64_t looks_most = 4'000, grid_mm = 10;
    const ir::Recovery& way = monitor.recovery;
    const ir::SiteTable& site = module_[way.site];
    const auto* const written = written_place(spec_, site, place);
    if (trials_ == nullptr || written == nullptr) return std::nullopt;
    const ir::Cells& cells = module_[way.zone].cells;
    const geometry::Region& own = tables_.zone(way.zone).exact;
    const geometry::Region left = left_at_worst(monitor);
    const bool straight = is_convex(own);
    const Rational room_m = metres_of(
        std::max(way.route_clearance_mm, decision_.body.radius_mm + asked_most_mm(monitor)) +
        cells.cell_mm / 2 + grid_mm);
    const std::int64_t least_mm =
        std::max(way.return_clearance_mm, way.route_clearance_mm + cells.cell_mm + grid_mm);
    const auto count = static_cast<std::int64_t>(cells.clearance_mm_lo.size());
    const std::int64_t step = 1 + count / looks_most;
    std::vector<OtherPlace> all;
    for (std::int64_t at = 0; at < count; at += step) {
      const std::int64_t x_mm =
          cells.origin_x_mm + (at % cells.columns) * cells.cell_mm + cells.cell_mm / 2;
      const std::int64_t y_mm =
          cells.origin_y_mm + (at / cells.columns) * cells.cell_mm + cells.cell_mm / 2;
      const std::int64_t clear_mm = cells.clearance_mm_lo[static_cast<std::size_t>(at)];
      if (clear_mm < least_mm || !may_end_at(monitor, x_mm, y_mm)) continue;
      if (straight && hidden_from(left, point_of(x_mm, y_mm), own, room_m)) continue;
      all.push_back({{x_mm, y_mm}, clear_mm});
    }
    const auto works = places_that_work(*trials_, fault_of(code, monitor.source),
                                        {{written->range, std::move(all)}});
    if (works.empty()) return std::nullopt;
    return "`" + site.name + "` at " + place_text(works[0].to.x_mm, works[0].to.y_mm);
  }
  // Of the zone of its ways.
  [[nodiscard]] geometry::Region left_at_worst(const ir::Monitor& monitor) const {
    const ExactZone exact = [&](ir::ZoneIndex zone) -> const geometry::Region& {
      return tables_.zone(zone).exact;
    };
    return exact(monitor.recovery.zone)
        .intersect(region_at_worst(decision_, monitor.property, exact));
  }
  [[nodiscard]] bool may_end_at(const ir::Monitor& monitor, std::int64_t x_mm,
                                std::int64_t y_mm) const {
    return allowed_at_worst(module_, decision_, monitor, ends_clear_by_mm(monitor.recovery), x_mm,
                            y_mm);
  }
  // Beyond what its property asks for.
  [[nodiscard]] std::int64_t ends_clear_by_mm(const ir::Recovery& way) const {
    return way.return_clearance_mm - standoff_mm(decision_, way);
  }

  // Of the place that the way ends at.
  bool matters_not(const ir::Monitor& monitor, const ir::SiteTable& site,
                   const ir::SiteTable::Place& place) {
    const ir::Recovery& way = monitor.recovery;
    const std::int64_t need_mm = ends_clear_by_mm(way);
    if (may_end_at(monitor, place.x_mm, place.y_mm)) return true;
    const auto works = site_that_works(monitor, place, Code::window_without_way_out);
    report(Code::window_without_way_out, monitor,
           "the recovery `" + monitor.recovery.name + "` ends at `" + site.name + "`, " +
               place_text(place.x_mm, place.y_mm) + ", where it matters when `" +
               zone_name(monitor) + "` changes",
           works ? *works + " works, whether that zone is there or not"
                 : "a site with a clearance of " +
                       metres(need_mm + asked_most_mm(monitor) + way.leave_beside_mm) +
                       " is needed, whether that zone is there or not",
           ends_near);
    return false;
  }

  // The largest clearance that its property asks for.
  [[nodiscard]] std::int64_t asked_most_mm(const ir::Monitor& monitor) const {
    std::int64_t most = 0;
    for (const Standoff& each : fence_standoffs(monitor.property, decision_.facts.params)) {
      most = std::max(most, each.mm);
    }
    return most;
  }

  // Raises `clearance_mm` until a way is known from every place that has so much; the longest of
  // these ways. None: from nowhere, reported.
  std::optional<std::int64_t> farthest_mm(const ir::Monitor& monitor,
                                          const ir::SiteTable::Place& to,
                                          std::int64_t& clearance_mm) {
    const ir::Recovery& recovery = monitor.recovery;
    const geometry::BakedZone& baked = tables_.zone(recovery.zone).baked;
    const geometry::CellGrid& cells = baked.cells;
    // where the robot seems to be when it sets out; 2: off the grid on either axis
    const auto nearest_body_mm = static_cast<std::int32_t>(
        std::max<std::int64_t>(0, decision_.body.radius_mm - decision_.body.position_error_mm - 2));
    const auto distances = geometry::distances_to(
        baked, {to.x_mm, to.y_mm}, static_cast<std::int32_t>(recovery.route_clearance_mm),
        nearest_body_mm, tables_.connector_mm(cells.cell_mm));
    std::optional<std::size_t> deepest;  // of those without a way
    for (std::size_t c = 0; c < distances.size(); ++c) {
      if (distances[c] >= 0 || cells.clearance_mm_hi[c] < clearance_mm) continue;
      clearance_mm = std::int64_t{cells.clearance_mm_hi[c]} + 1;
      deepest = c;
    }
    std::int64_t far_mm = -1;
    for (std::size_t c = 0; c < distances.size(); ++c) {
      if (cells.clearance_mm_hi[c] < clearance_mm) continue;
      far_mm = std::max<std::int64_t>(far_mm, distances[c]);
    }
    if (far_mm >= 0 || !deepest) return far_mm;
    report(Code::window_without_way_out, monitor,
           "from " + cell_text(cells, *deepest) + " the recovery `" + recovery.name +
               "` knows no way, nor from any place that is farther from the boundary of `" +
               module_[recovery.zone].name + "`",
           "a zone without that place works, or one in which " +
               metres(recovery.route_clearance_mm) + " can be kept on the way from there");
    return std::nullopt;
  }
  static std::string cell_text(const geometry::CellGrid& cells, std::size_t c) {
    const auto columns = static_cast<std::size_t>(cells.columns);
    const std::int64_t half = cells.cell_mm / 2;
    return place_text(cells.origin.x_mm + std::int64_t(c % columns) * cells.cell_mm + half,
                      cells.origin.y_mm + std::int64_t(c / columns) * cells.cell_mm + half);
  }

  // A zone to stay in that is never there for as long as is looked ahead is none.
  void long_enough(const ir::Monitor& monitor) {
    const std::int64_t need_us =
        horizon_us_max(decision_.body, monitor.lookahead.duration_us) + monitor.recovery.leave_us;
    for (const ir::Value& value : monitor.property.values) {
      const auto* there = std::get_if<ir::ZoneThere>(&value.op);
      if (there == nullptr || is_negated(monitor.property, value)) continue;
      const ir::Schedule& schedule = decision_.facts[there->schedule];
      if (longest_us(schedule) > need_us) continue;
      report(Code::window_too_short, monitor,
             "`" + schedule.name + "` is there for " + seconds(longest_us(schedule)) +
                 " at most, and to look ahead and leave it takes " + seconds(need_us),
             "a window of more than " + seconds(need_us) +
                 " works; or a faster recovery, or a site that is nearer");
    }
  }
  static bool is_negated(const ir::Block& property, const ir::Value& value) {
    return std::any_of(property.values.begin(), property.values.end(), [&](const ir::Value& v) {
      const auto* negation = std::get_if<ir::Not>(&v.op);
      return negation != nullptr && &property[negation->a] == &value;
    });
  }

  [[nodiscard]] std::string zone_name(const ir::Monitor& monitor) const {
    for (const ir::Value& value : monitor.property.values) {
      const auto* there = std::get_if<ir::ZoneThere>(&value.op);
      if (there != nullptr) return decision_.facts[there->schedule].name;
    }
    return "";
  }
  void report(Code code, const ir::Monitor& monitor, std::string message, std::string help,
              std::string label = "") {
    diagnostics_.report(
        {code, monitor.source, std::move(message), std::move(label), {}, std::move(help), {}});
  }

  const sema::Spec& spec_;
  const sema::RobotKind& kind_;
  const ir::Module& module_;
  ir::Decision& decision_;
  const WindowTables& tables_;
  Trials* trials_;
  diag::Engine& diagnostics_;
  bool all_known_ = true;
};

}  // namespace

bool ends_near_window(const diag::Diagnostic& d) {
  return d.code == Code::window_without_way_out && d.label == ends_near;
}

bool has_windows(const ir::Block& property) {
  return std::any_of(property.values.begin(), property.values.end(), [](const ir::Value& v) {
    const ir::Block* others = ir::body_of(v.op);
    return others != nullptr ? has_windows(*others) : std::holds_alternative<ir::ZoneThere>(v.op);
  });
}

bool speaks_of_windows(const ir::Block& block, ir::ValueId id) {
  const ir::Op& op = block[id].op;
  if (std::holds_alternative<ir::ZoneThere>(op)) return true;
  if (const auto* v = std::get_if<ir::Not>(&op)) return speaks_of_windows(block, v->a);
  if (const auto* v = std::get_if<ir::And>(&op)) {
    return speaks_of_windows(block, v->a) || speaks_of_windows(block, v->b);
  }
  if (const auto* v = std::get_if<ir::Or>(&op)) {
    return speaks_of_windows(block, v->a) || speaks_of_windows(block, v->b);
  }
  const ir::Block* const others = ir::body_of(op);
  return others != nullptr && speaks_of_windows(*others, others->result);
}

bool plan_windows(const sema::Spec& spec, const sema::Decision& from, const ir::Module& module,
                  ir::Decision& decision, const WindowTables& tables, Trials* trials,
                  diag::Engine& diagnostics) {
  if (decision.on_plan) return true;
  return Planner(spec, from, module, decision, tables, trials, diagnostics).run();
}

}  // namespace rtac::analysis
