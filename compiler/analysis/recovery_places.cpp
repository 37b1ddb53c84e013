#include "compiler/analysis/recovery_places.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "compiler/analysis/around.h"
#include "compiler/analysis/boundless.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/ways_in.h"
#include "compiler/analysis/widening.h"
#include "compiler/analysis/zone_trials.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

using geometry::Region;

// What offsets of regions round, in mm, and a snapped zone does: less than a hold strays.
constexpr std::int64_t rounded_mm = 5;

std::string area(const Region& region) {
  return square_metres(region.area());
}
// A corner that does not lie in the other region as well.
std::string some_place(const Region& region, const Region& outside_of) {
  for (const geometry::Ring& ring : region.rings()) {
    for (const geometry::Point& p : ring) {
      if (outside_of.contains(p)) continue;
      return ", such as (" + metres(floor_to_int(Rational(p.x * 1000))) + ", " +
             metres(floor_to_int(Rational(p.y * 1000))) + ")";
    }
  }
  return "";
}
constexpr const char* nearer_label = "may come nearer to it";

// What holds the centre of a robot, body and all: one zone, or of several at least one.
struct Kept {
  Choice zones;
  mutable std::optional<Region> centres{};  // once asked for
};

class Places {
 public:
  Places(const sema::RobotKind& kind, const sema::Monitor& written,
         const sema::Controller& controller, const ir::Module& module, const ExactZone& exact,
         const ir::Decision& decision, const ir::Monitor& monitor, Trials* trials)
      : kind_(kind),
        written_(written),
        controller_(controller),
        module_(module),
        exact_(exact),
        decision_(decision),
        monitor_(monitor),
        radius_mm_(decision.body.radius_mm),
        trials_(trials) {}

  std::vector<diag::Diagnostic> run() {
    for (const ir::ZoneIndex fence : fences_of(monitor_.property, decision_.facts.params)) {
      kept_.push_back({{fence}});
    }
    for (const Choice& c : choices_of(monitor_.property, decision_.facts.params)) {
      kept_.push_back({c});
    }
    if (holds_nowhere()) return std::move(found_);
    for (const ir::ZoneIndex fence : told_fences_of(monitor_.property, decision_.facts.params)) {
      told_.push_back({{fence}});
    }
    for (const ir::Recovery* step : ir::steps_of(monitor_.recovery)) {
      if (ir::moves(step->kind) || step->claims) look(*step);
    }
    return std::move(found_);
  }

 private:
  // Of several zones that the property asks for at once.
  bool holds_nowhere() {
    if (kept_.size() < 2) return false;
    Region all = Region::everywhere();
    std::string names;
    for (const Kept& each : kept_) {
      all = all.intersect(centres_of(each));
      names += (names.empty() ? "" : ", and in ") + names_of(each.zones, " or ");
    }
    if (!all.empty()) return false;
    diag::Diagnostic d = finding(
        diag::Code::return_set_empty,
        "monitor `" + monitor_.name + "` can never hand control back: its property holds nowhere");
    d.range = written_.always_range;
    d.label = "no body is at once in " + names;
    d.notes.push_back({std::nullopt, "the body has a radius of " + metres(radius_mm_) +
                                         ", and lies all in a zone"});
    d.help = "zones that overlap by more than the body and what is asked beyond it work, or `or`";
    found_.push_back(std::move(d));
    return true;
  }
  // One of very many vertices counts without the body.
  static Region shrunk(const Region& region, std::int64_t by_mm) {
    return within(region, by_mm).value_or(region);
  }
  const Region& centres_of(const Kept& kept) const {
    if (kept.centres) return *kept.centres;
    Region all;
    for (const ir::ZoneIndex zone : kept.zones) {
      all = all.unite(shrunk(exact_(zone), radius_mm_ + standoff_mm(monitor_, zone)));
    }
    return *(kept.centres = std::move(all));
  }
  // The least that the property asks for of the zone, wherever it does.
  [[nodiscard]] std::int64_t standoff_mm(const ir::Monitor& m, ir::ZoneIndex zone) const {
    std::optional<std::int64_t> least;
    for (const Standoff& each : fence_standoffs(m.property, decision_.facts.params)) {
      if (each.zone == zone) least = std::min(least.value_or(each.mm), each.mm);
    }
    return std::max<std::int64_t>(least.value_or(0), 0);
  }
  // What a step has to keep: the most of these, where it may be anywhere in its zone.
  [[nodiscard]] std::int64_t kept_mm(const ir::Recovery& step, ir::ZoneIndex zone) const {
    if (!step.claims) return standoff_mm(monitor_, zone);
    std::int64_t most = 0;
    for (const Standoff& each : fence_standoffs(monitor_.property, decision_.facts.params)) {
      if (each.zone == zone) most = std::max(most, each.mm);
    }
    return most;
  }
  [[nodiscard]] static bool is_own(const ir::Recovery& step, const Kept& kept) {
    return kept.zones.size() == 1 && step.zone == kept.zones[0] && !step.claims;
  }

  void look(const ir::Recovery& step) {
    for (Kept& each : kept_) {
      if (!is_own(step, each) && elsewhere(step, each)) return;
    }
    if (elsewhere_when_told(step)) return;
    // an external one is braked where its claim does not hold: it leads nowhere from there
    if (step.claims) return;
    for (Kept& each : kept_) {
      if (!is_own(step, each) && across(step, each)) return;
    }
  }

  // Of zones that count when inputs say so the recovery has to be in each, as in those of an `and`.
  bool elsewhere_when_told(const ir::Recovery& step) {
    const std::size_t at_once = kept_.size();
    kept_.insert(kept_.end(), told_.begin(), told_.end());
    bool found = false;
    for (std::size_t k = at_once; k < kept_.size() && !found; ++k) {
      found = !is_own(step, kept_[k]) && elsewhere(step, kept_[k]);
    }
    kept_.resize(at_once);
    return found;
  }

  // A recovery keeps clear of the border of its own zone, whatever the property says of another.
  bool elsewhere(const ir::Recovery& step, Kept& kept) {
    const Region& own = exact_(step.zone);
    const Region all = united(kept);
    const std::string names = names_of(kept.zones, " or ");
    const bool outside = !all.contains(own);
    // between two zones of a choice a body may be in neither, in the middle of a way as well
    const Region centres = kept.zones.size() > 1 ? centres_of(kept) : all;
    const std::int64_t keeps_mm =
        ir::moves(step.kind) ? std::max(step.route_clearance_mm, radius_mm_) : radius_mm_;
    const Region body = kept.zones.size() > 1 ? shrunk(own, keeps_mm + rounded_mm) : own;
    const bool between = !centres.contains(body);
    const std::int64_t overlap_mm = 2 * (std::max(keeps_mm, step.return_clearance_mm) + rounded_mm);
    if (!outside && kept.zones.size() == 1) return nearer(step, kept.zones[0]);
    if (!outside) return between && seam(step, kept, body, overlap_mm);
    const Region beyond = own.subtract(all);
    const std::string zone = "`" + module_[step.zone].name + "`";
    diag::Diagnostic d = finding(diag::Code::recovery_elsewhere,
                                 "`" + controller_.name + "` moves within " + zone + ", and `" +
                                     monitor_.name + "` needs it to stay in " + names);
    d.label = "leads out of " + names;
    d.notes.push_back({std::nullopt, area(beyond) + " of " + zone + " lie outside " + names +
                                         some_place(beyond, all)});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    d.help = kept_.size() == 1 && kept.zones.size() == 1 ? lies_in(step, kept.zones[0])
                                                         : works(step, d.code);
    found_.push_back(std::move(d));
    return true;
  }
  // Where the property keeps it out of a zone, what is left of its own.
  std::string lies_in(const ir::Recovery& step, ir::ZoneIndex zone) const {
    const std::string in = "a zone that lies in " + name_of(zone);
    if (trials_ == nullptr) return in + " works";  // nobody reads it
    const bool out = is_boundless(module_[zone]) || step.claims;
    std::vector<ZonePart> parts{{{zone}, out ? kept_mm(step, zone) : 0}};
    if (out) parts.insert(parts.begin(), {{step.zone}});
    const std::string such = written_as(*trials_, parts);
    const auto has_worked = tried(diag::Code::recovery_elsewhere, step, parts);
    if (has_worked.value_or(true)) {
      const bool named = !out && !is_unnamed(zone);
      return in + " works" +
             (named          ? ", such as " + name_of(zone)
              : such.empty() ? ", such as that one with a name"
                             : ", such as `" + such + "`");
    }
    return in + " " + needed_besides(trials_, such);
  }
  [[nodiscard]] bool is_unnamed(ir::ZoneIndex zone) const {
    const auto id = trials_->zone_of(zone);
    return !id || trials_->spec()[*id].name.empty();
  }
  // On the whole specification.
  std::optional<bool> tried(diag::Code code, const ir::Recovery& step,
                            const std::vector<ZonePart>& parts) const {
    if (trials_ == nullptr) return std::nullopt;  // nobody reads it
    return works_within(*trials_, fault_of(code, written_.recover_range), written_.range, step.name,
                        module_, step.zone, parts);
  }
  // Of another zone than its own it keeps what is asked for only as keeps_off.h says.
  bool nearer(const ir::Recovery& step, ir::ZoneIndex zone) {
    const Standoff fence{zone, kept_mm(step, zone)};
    if (keeps_off(module_, decision_, exact_, ExactSolid{}, monitor_, monitor_, step, fence) ||
        keeps_around(kind_, module_, decision_, exact_, monitor_, monitor_, fence)) {
      return false;
    }
    const std::string own = "`" + module_[step.zone].name + "`", far = metres(fence.mm);
    diag::Diagnostic d =
        finding(diag::Code::recovery_elsewhere,
                "`" + controller_.name + "` moves within " + own + ", and `" + monitor_.name +
                    "` needs it to keep " + far + " from the boundary of " + name_of(zone));
    d.label = "may come nearer to it";
    const Region kept = shrunk(exact_(zone), fence.mm), near = exact_(step.zone).subtract(kept);
    d.notes.push_back({std::nullopt, area(near) + " of " + own + " are nearer than that" +
                                         some_place(near, kept)});
    d.notes.push_back({std::nullopt, step.claims
                                         ? "anywhere in " + own + " its claim holds"
                                         : "on its way it keeps from every boundary of " + own +
                                               " as much as it has where it sets "
                                               "out, and no more"});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    const std::string deep = deep_text(module_, step.zone, fence);
    std::vector<ZonePart> parts{{{zone}, fence.mm}};
    if (zone != step.zone) parts.push_back({{step.zone}});
    const bool works = !deep.empty() && tried(d.code, step, parts).value_or(true);
    const std::string far_off = "a zone all of whose places are that far off ";
    d.help = !deep.empty() && !works
                 ? far_off + needed_besides(trials_, deep)
                 : far_off + "works" + (works ? ", such as `" + deep + "`" : "");
    found_.push_back(std::move(d));
    return true;
  }
  // A route in a convex zone is straight, and leads across the seam from its other side. What else
  // moves may stop in front of it: control is not given back there.
  bool seam(const ir::Recovery& step, const Kept& kept, const Region& body,
            std::int64_t overlap_mm) {
    const Region& own = exact_(step.zone);
    const Region& allowed = centres_of(kept);
    if (step.kind == ir::RecoveryKind::route && is_convex(own)) {
      const auto way = straight_across(module_, step, starts().intersect(own), allowed);
      if (way) crosses(step, kept, *way, true);
      return way.has_value();
    }
    const std::string names = names_of(kept.zones, " or ");
    diag::Diagnostic d = finding(diag::Code::no_way_back,
                                 "at the seam of " + names + " a body is in none of them, and `" +
                                     controller_.name + "` may stop there or lead across");
    d.label = "knows nothing of seams";
    d.notes.push_back({std::nullopt, "a body in the middle of `" + module_[step.zone].name +
                                         "` may lie in none of them alone" +
                                         some_place(body.subtract(allowed), allowed)});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    d.help = wider_side(kept, overlap_mm, d.code)
                 .value_or("zones are needed that overlap by about " + metres(overlap_mm));
    found_.push_back(std::move(d));
    return true;
  }
  // One of the zones of a choice, the last one first, that is so much wider.
  std::optional<std::string> wider_side(const Kept& kept, std::int64_t overlap_mm,
                                        diag::Code code) const {
    if (trials_ == nullptr) return std::nullopt;  // nobody reads it
    for (auto zone = kept.zones.rbegin(); zone != kept.zones.rend(); ++zone) {
      auto works = growth_that_works(*trials_, *zone, exact_(*zone), overlap_mm, overlap_mm,
                                     fault_of(code, written_.recover_range));
      if (works) return works;
    }
    return std::nullopt;
  }

  // From outside its zone a recovery makes straight for it, as it knows nothing of what lies
  // between: that stays in what is convex. Elsewhere its ways are looked at (ways_in.h).
  bool across(const ir::Recovery& step, Kept& kept) {
    const Region& own = exact_(step.zone);
    const Region& allowed = centres_of(kept);
    if (is_convex(allowed) || own.contains(allowed)) return false;
    const Region from = starts().subtract(own);
    if (from.empty()) return false;
    const WaysIn ways = ways_in(module_, decision_, step, from, allowed);
    // where another side of an `or` allows a place, nothing is asked of the way out of it; which
    // places those are is not known while parameters move them
    const bool is_fixed = decision_.facts.params.empty();
    const auto leaves =
        ways.leaves && is_fixed
            ? ways_in(module_, decision_, step, from.intersect(allowed), allowed).leaves
            : ways.leaves;
    if (leaves) {
      crosses(step, kept, *leaves, false);
    } else if (ways.stranded) {
      strands(step, kept, *ways.stranded);
    }
    return leaves || ways.stranded;
  }
  void crosses(const ir::Recovery& step, const Kept& kept, const WaysIn::Leaves& way, bool inside) {
    const std::string zone = "`" + module_[step.zone].name + "`";
    diag::Diagnostic d =
        finding(diag::Code::recovery_elsewhere,
                "on its way " + std::string(inside ? "through " : "into ") + zone + " from " +
                    text(way.from) + ", `" + controller_.name + "` leads across " + text(way.at) +
                    ", where `" + monitor_.name + "` does not hold");
    d.label = "leads out of " + names_of(kept.zones, " or ");
    const std::string knows = " it knows nothing of what lies between";
    d.notes.push_back(
        {std::nullopt, inside ? "on a seam of two zones a body is in neither"
                              : "outside of " + zone + knows + ", and makes straight for it"});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    d.help = works(step, d.code);
    found_.push_back(std::move(d));
  }
  void strands(const ir::Recovery& step, const Kept& kept, const PlaceMm& place) {
    const std::string zone = "`" + module_[step.zone].name + "`";
    diag::Diagnostic d = finding(diag::Code::no_way_back,
                                 "from " + text(place) + " in " + names_of(kept.zones, " or ") +
                                     ", `" + controller_.name + "` finds no way into " + zone);
    d.label = "ends there once the robot is there";
    d.notes.push_back({std::nullopt, "control returns at a clearance of " +
                                         metres(step.return_clearance_mm) +
                                         ", and nothing leads there in sight"});
    d.notes.push_back({controller_.name_range, "the recovery is declared here"});
    d.help = works(step, d.code);
    found_.push_back(std::move(d));
  }
  // Where the robot may be while its own property holds, and those of monitors that keep it there.
  const Region& starts() {
    if (starts_) return *starts_;
    const auto& params = decision_.facts.params;
    Region all = Region::everywhere();
    for (const ir::Monitor& m : decision_.monitors) {
      if (m.name != monitor_.name && !relied_on(decision_, m)) continue;
      for (const std::vector<Standoff>& either : surely_in(m.property, params)) {
        Region some;
        for (const Standoff& each : either) {
          some = some.unite(shrunk(exact_(each.zone), radius_mm_ + each.mm));
        }
        all = all.intersect(some);
      }
    }
    // of zones that come and go as well, which no parameter moves
    for (Kept& each : kept_) {
      if (params.empty() && each.zones.size() > 1) all = all.intersect(centres_of(each));
    }
    return *(starts_ = std::move(all));
  }

  // A recovery within all that the property keeps the robot in, if that would do: it has a place
  // to return to, and between the zones of a choice a body is always in one of them.
  std::string works(const ir::Recovery& step, diag::Code code) const {
    Region all = Region::everywhere();
    for (const Kept& each : kept_) all = all.intersect(deep(each));
    if (all.empty()) {
      return "zones that overlap work, or `brake_and_hold` with `hold when violated \"why\"`";
    }
    // to be in one of them everywhere, and to be given back where it comes to rest, which of zones
    // that come and go is a matter of where the recovery leads to (5030)
    const auto& values = monitor_.property.values;
    const bool windows = std::any_of(values.begin(), values.end(), [](const ir::Value& v) {
      return std::holds_alternative<ir::ZoneThere>(v.op);
    });
    const std::int64_t rests_mm = windows ? 0 : step.return_clearance_mm;
    const std::int64_t keeps_mm =
        std::max({step.route_clearance_mm, rests_mm, radius_mm_}) + rounded_mm;
    const bool inside = std::all_of(kept_.begin(), kept_.end(), [&](const Kept& each) {
      if (each.zones.size() < 2) return true;
      if (windows) return centres_of(each).contains(shrunk(all, keeps_mm));
      const auto none = between(all, each.zones, exact_, keeps_mm - rounded_mm, keeps_mm);
      return none && none->empty();
    });
    // what the zone itself keeps off is no part of what its places have to
    std::int64_t kept_off_mm = 0;
    for (const Kept& each : kept_) kept_off_mm = std::max(kept_off_mm, off_mm(each));
    const std::int64_t back_mm = step.return_clearance_mm - kept_off_mm;
    const auto returns = within(all, back_mm);
    if (!inside) {
      return "both are needed: a recovery within their union, and zones that overlap by about " +
             metres(2 * keeps_mm);
    }
    if (returns && returns->empty()) {
      return "no recovery works: no place of " + written() + " has a clearance of " +
             metres(back_mm) + ", less has to be asked for";
    }
    std::vector<ZonePart> parts;
    for (const Kept& each : kept_) parts.push_back({each.zones, off_mm(each)});
    return tried(code, step, parts).value_or(true)
               ? "a recovery within " + written() + " works: it finds its ways inside"
               : "a recovery within " + written() +
                     " is needed, and not alone: other errors are left";
  }
  // What is asked of a zone beyond touching its boundary, where the property names no other one in
  // its place: its ways know nothing of that, so that the zone has to.
  std::int64_t off_mm(const Kept& kept) const {
    if (kept.zones.size() != 1) return 0;
    std::int64_t most_mm = 0;
    for (const Standoff& each : fence_standoffs(monitor_.property, decision_.facts.params)) {
      if (each.zone == kept.zones[0]) most_mm = std::max(most_mm, each.mm);
    }
    return most_mm > touching_mm ? most_mm : 0;
  }
  Region deep(const Kept& kept) const {
    const std::int64_t mm = off_mm(kept);
    return mm == 0 ? united(kept) : shrunk(exact_(kept.zones[0]), mm);
  }
  Region united(const Kept& kept) const {
    Region all;
    for (const ir::ZoneIndex zone : kept.zones) all = all.unite(exact_(zone));
    return all;
  }
  std::string written() const {
    if (kept_.size() == 1 && kept_[0].zones.size() == 1 && off_mm(kept_[0]) == 0) {
      return name_of(kept_[0].zones[0]);
    }
    std::string all;
    for (const Kept& each : kept_) {
      const bool several = each.zones.size() > 1 && kept_.size() > 1;
      if (const std::int64_t mm = off_mm(each); mm > 0) {
        all += (all.empty() ? "" : " & ") + std::string("shrink(") + bare_names_of(each.zones, "") +
               ", " + metres(mm) + ")";
        continue;
      }
      all += (all.empty() ? "" : " & ") + std::string(several ? "(" : "") +
             bare_names_of(each.zones, " | ") + (several ? ")" : "");
    }
    return "a zone that is `" + all + "`";
  }
  std::string names_of(const Choice& zones, const std::string& between) const {
    std::string names;
    for (const ir::ZoneIndex zone : zones) {
      names += (names.empty() ? "" : between) + name_of(zone);
    }
    return names;
  }
  std::string bare_names_of(const Choice& zones, const std::string& between) const {
    std::string names = names_of(zones, between);
    names.erase(std::remove(names.begin(), names.end(), '`'), names.end());
    return names;
  }
  std::string name_of(ir::ZoneIndex zone) const { return name_as_written(module_[zone]); }
  static std::string text(const PlaceMm& p) {
    return "(" + metres(p.x_mm) + ", " + metres(p.y_mm) + ")";
  }
  [[nodiscard]] diag::Diagnostic finding(diag::Code code, std::string message) const {
    return about_recovery(written_, code, std::move(message));
  }

  const sema::RobotKind& kind_;
  const sema::Monitor& written_;
  const sema::Controller& controller_;
  const ir::Module& module_;
  const ExactZone& exact_;
  const ir::Decision& decision_;
  const ir::Monitor& monitor_;
  const std::int64_t radius_mm_;
  Trials* trials_;
  std::vector<Kept> kept_;
  std::vector<Kept> told_;  // of which inputs say when each of them counts
  std::optional<Region> starts_;
  std::vector<diag::Diagnostic> found_;
};

}  // namespace

diag::Diagnostic about_recovery(const sema::Monitor& written, diag::Code code,
                                std::string message) {
  diag::Diagnostic d{};
  d.code = code;
  d.range = written.recover_range;
  d.message = std::move(message);
  return d;
}

std::string name_as_written(const ir::ZoneTable& zone) {
  for (const auto& [prefix, text] :
       {std::pair<std::string, std::string>{"zone_of_line_", "the zone of line "},
        {"outside_of_", "`complement("}}) {
    if (!zone.name.starts_with(prefix)) continue;
    return text + zone.name.substr(prefix.size()) + (text[0] == '`' ? ")`" : "");
  }
  return "`" + zone.name + "`";
}

bool is_convex(const Region& region) {
  const auto parts = region.polygons();
  if (parts.size() != 1 || !parts[0].holes.empty()) return false;
  const geometry::Ring& ring = parts[0].outer;  // counter-clockwise
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const geometry::Point &a = ring[i], &b = ring[(i + 1) % ring.size()],
                          &c = ring[(i + 2) % ring.size()];
    if ((b.x - a.x) * (c.y - b.y) < (b.y - a.y) * (c.x - b.x)) return false;
  }
  return true;
}

std::optional<Region> within(const Region& region, std::int64_t mm) {
  constexpr std::size_t vertices_most = 4000;  // two seconds
  if (region.vertices() > vertices_most) return std::nullopt;
  Rational by_m(static_cast<long>(-mm), 1000);
  by_m.canonicalize();
  return region.offset(by_m);
}

std::vector<diag::Diagnostic> misplaced(const sema::RobotKind& kind, const sema::Monitor& written,
                                        const sema::Controller& controller,
                                        const ir::Module& module, const ExactZone& exact,
                                        const ir::Decision& decision, const ir::Monitor& monitor,
                                        Trials* trials) {
  return Places(kind, written, controller, module, exact, decision, monitor, trials).run();
}

}  // namespace rtac::analysis
