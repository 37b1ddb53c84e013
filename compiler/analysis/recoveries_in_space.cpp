#include "compiler/analysis/recoveries_in_space.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "compiler/analysis/boundless.h"
#include "compiler/analysis/dials.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/led_in_height.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/straight_in.h"
#include "compiler/analysis/zone_trials.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

using diag::Code;
using Found = std::optional<diag::Diagnostic>;

constexpr const char* lands_near = "may stray out of it";

Rational thousandths(std::int64_t mm) {
  Rational m(static_cast<long>(mm), 1000);
  m.canonicalize();
  return m;
}

// A corner of what lies in one region and not in the other.
std::string some_corner(const geometry::Region& region) {
  for (const geometry::Ring& ring : region.rings()) {
    for (const geometry::Point& p : ring) {
      return "(" + metres(floor_to_int(Rational(p.x * 1000))) + ", " +
             metres(floor_to_int(Rational(p.y * 1000))) + ")";
    }
  }
  return "";
}

class InSpace {
 public:
  InSpace(const sema::Monitor& written, const ir::Module& module, const ir::Decision& decision,
          const ir::Monitor& monitor, const ExactZone& flat, const ExactSolid& exact,
          Trials* trials)
      : written_(written),
        module_(module),
        decision_(decision),
        monitor_(monitor),
        flat_(flat),
        exact_(exact),
        trials_(trials) {
    collect_heights();
  }

  // The first step that leads out of what it should keep; one that is slow enough keeps it
  // anywhere.
  Found run() const {
    const auto k = static_cast<std::size_t>(&monitor_ - decision_.monitors.data());
    if (holds_while_driving(decision_, k, monitor_)) return std::nullopt;
    for (const ir::Recovery* step : ir::steps_of(monitor_.recovery)) {
      Found found;
      if (ir::moves(step->kind) || step->claims) found = within_zone(*step);
      if (step->kind == ir::RecoveryKind::land) found = landing(*step);
      if (found) return found;
    }
    return std::nullopt;
  }

 private:
  // Between which heights the property keeps the centre.
  void collect_heights() {
    ir::for_each_comparison(monitor_.property, [&](const ir::Block& block, const ir::AtLeast& c) {
      const auto most = ir::upper_bound(block, c);
      if (most && most->leaf.kind == ir::Leaf::Kind::altitude) {
        most_mm_ = std::min(most_mm_.value_or(most->most), most->most);
      }
      const auto least = ir::lower_bound(block, c, decision_.facts.params);
      if (least && least->leaf.kind == ir::Leaf::Kind::altitude) {
        least_mm_ = std::max(least_mm_.value_or(least->need.fixed), least->need.fixed);
      }
    });
  }
  [[nodiscard]] std::vector<ir::ZoneIndex> fences() const {
    return fences_of(monitor_.property, decision_.facts.params);
  }

  // The zones of which inputs say whether they count.
  [[nodiscard]] std::vector<ir::ZoneIndex> when_told() const {
    auto all = told_fences_of(monitor_.property, decision_.facts.params);
    for (const Choice& choice : choices_of(monitor_.property, decision_.facts.params)) {
      if (choice.size() == 1) all.push_back(choice.front());
    }
    return all;
  }

  Found within_zone(const ir::Recovery& step) const {
    for (const ir::ZoneIndex fence : fences()) {
      if (fence == step.zone && !step.claims) continue;
      if (Found found = lies_in(step, fence) ? nearer(step, fence) : outside(step, fence)) {
        return found;
      }
    }
    // inputs may say of each of these that it counts
    for (const ir::ZoneIndex fence : when_told()) {
      if ((fence != step.zone || step.claims) && !lies_in(step, fence)) return outside(step, fence);
    }
    // an external one is braked where its claim does not hold: it leads nowhere from there
    if (Found found = step.claims ? std::nullopt : across(step)) return found;
    return module_[step.zone].has_height() ? too_far_up_or_down(step) : unclaimed_height(step);
  }
  // What moves within a zone of the plane keeps its height; nobody claims that of what is external.
  [[nodiscard]] bool lies_in(const ir::Recovery& step, ir::ZoneIndex fence) const {
    if (!step.claims && lies_level(module_, flat_, exact_, step.zone, {fence, 0})) return true;
    return exact_(step.zone).subtract(exact_(fence)).empty();
  }
  Found outside(const ir::Recovery& step, ir::ZoneIndex fence) const {
    const ir::ZoneTable& zone = module_[step.zone];
    const auto asked = fence_standoffs(monitor_.property, decision_.facts.params);
    const bool deep = step.claims && std::ranges::any_of(asked, [&](const Standoff& each) {
                        return each.zone == fence && each.mm > touching_mm;
                      });
    const std::string name = name_as_written(module_[fence]);
    const std::string works =
        step.kind == ir::RecoveryKind::route && module_[fence].has_height()  // it keeps its height
            ? "a zone of the plane all of which lies in " + name + " at every height works"
            : deep ? "a zone that lies as far in " + name + " as is asked for works"
                   : "a zone that lies in " + name + " " + lying_in(step, fence);
    const bool flat = !zone.has_height() && module_[fence].has_height();
    if (flat && step.claims) {
      return elsewhere(step, name, "a claim of `" + zone.name + "` bounds no height", works);
    }
    if (flat) {
      const geometry::Solid solid = exact_(fence);
      for (const geometry::Slab& slab : solid.slabs()) {
        if (slab.region.contains(flat_(step.zone))) continue;
        return elsewhere(step, name,
                         "it keeps its height, and at " + metres(slab.floor) + " a part of `" +
                             zone.name + "` lies outside " + name + ", such as " +
                             some_corner(flat_(step.zone).subtract(slab.region)),
                         works);
      }
    }
    const geometry::Solid beyond = exact_(step.zone).subtract(exact_(fence));
    const geometry::Slab& slab = beyond.slabs().front();
    const bool bounded = zone.has_height() || module_[fence].has_height();
    const std::string where =
        bounded ? "from " + metres(slab.floor) + " to " + metres(slab.ceiling) : "at every height";
    return elsewhere(step, name,
                     where + " a part of `" + zone.name + "` lies outside " + name + ", such as " +
                         some_corner(slab.region),
                     works);
  }
  Found unclaimed_height(const ir::Recovery& step) const {
    if (!step.claims || (!most_mm_ && !least_mm_)) return std::nullopt;
    const std::string heights = most_mm_ ? "the heights up to " + metres(*most_mm_)
                                         : "the heights from " + metres(*least_mm_) + " on";
    return elsewhere(step, heights, "a claim of `" + module_[step.zone].name + "` bounds no height",
                     "a claim to keep inside a zone with these heights works");
  }
  Found too_far_up_or_down(const ir::Recovery& step) const {
    const ir::ZoneTable& zone = module_[step.zone];
    const std::int64_t top_mm = zone.slabs.back().ceiling_mm;
    const std::int64_t bottom_mm = zone.slabs.front().floor_mm;
    const auto [lowest_mm, highest_mm] = led_between_mm(decision_, step, zone);
    // where it is given back, what it has of the ends of its zone is enough for limits near them
    const std::int64_t spare_mm =
        step.return_clearance_mm - return_height_mm(decision_, monitor_.lookahead.duration_us);
    const bool high = most_mm_ && std::max(highest_mm, top_mm - spare_mm) > *most_mm_;
    const bool low = least_mm_ && std::min(lowest_mm, bottom_mm + spare_mm) < *least_mm_;
    if (!high && !low) return std::nullopt;
    // where it is led past the limit, whatever the other end of its zone is, that has to be its end
    const auto beyond_mm = [&](bool led_past) { return led_past ? 0 : spare_mm; };
    const std::string ceiling =
        high ? "a ceiling of at most " + metres(*most_mm_ + beyond_mm(highest_mm > *most_mm_)) : "";
    const std::string floor =
        low ? "a floor of at least " + metres(*least_mm_ - beyond_mm(lowest_mm < *least_mm_)) : "";
    return elsewhere(step,
                     high ? "the heights up to " + metres(*most_mm_)
                          : "the heights from " + metres(*least_mm_) + " on",
                     high ? "`" + zone.name + "` reaches up to " + metres(top_mm)
                          : "`" + zone.name + "` reaches down to " + metres(bottom_mm),
                     "a zone with " + ceiling + (high && low ? " and " : "") + floor + " works");
  }
  // What is asked beyond touching is kept of another zone than its own as keeps_off.h says.
  Found nearer(const ir::Recovery& step, ir::ZoneIndex fence) const {
    for (const Standoff& each : fence_standoffs(monitor_.property, decision_.facts.params)) {
      if (each.zone != fence ||
          keeps_off(module_, decision_, flat_, exact_, monitor_, monitor_, step, each)) {
        continue;
      }
      const std::string far = metres(each.mm) + " from the boundary of `" + module_[fence].name;
      return elsewhere(
          step, "what is " + far + "`",
          step.claims
              ? "anywhere in `" + module_[step.zone].name + "` its claim holds"
              : "places of `" + module_[step.zone].name +
                    "` are nearer, and it keeps from the boundary of that zone as much as it "
                    "has where it sets out, and no more",
          "a zone all of whose places are that far off " + as_far_off(step, each));
    }
    return std::nullopt;
  }
  // That one itself, if it bounds something; else what the zone leaves of it, as far as is asked.
  [[nodiscard]] std::string lying_in(const ir::Recovery& step, ir::ZoneIndex fence) const {
    const ir::ZoneTable& zone = module_[fence];
    if (zone.has_height() || !is_boundless(zone)) return "works, such as that one itself";
    return as_far_off(step, {fence, asked_mm(fence)});
  }
  // What is left of the zone, if that works.
  [[nodiscard]] std::string as_far_off(const ir::Recovery& step, const Standoff& fence) const {
    if (trials_ == nullptr) return "works";  // nobody reads it
    const std::vector<ZonePart> parts{{{step.zone}}, {{fence.zone}, fence.mm}};
    const std::string text = written_as(*trials_, parts);
    if (text.empty()) return "works";
    const Fault fault = fault_of(Code::recovery_elsewhere, written_.recover_range);
    const bool works =
        works_within(*trials_, fault, written_.range, step.name, module_, step.zone, parts)
            .value_or(false);
    return works ? "works, such as `" + text + "`" : needed_besides(trials_, text);
  }
  // From outside its zone it makes straight for it, as in the plane: what is convex is not left.
  Found across(const ir::Recovery& step) const {
    const auto judged = static_cast<std::size_t>(&monitor_ - decision_.monitors.data());
    const TakeOver take_over{module_, decision_, flat_, exact_, judged};
    for (const ir::ZoneIndex fence : fences()) {
      if (comes_in_within(take_over, step, fence)) continue;
      const geometry::Solid from = led_in_from(take_over, step.zone, fence);
      const std::string name = name_as_written(module_[fence]);
      diag::Diagnostic d =
          finding(Code::no_way_back, "`" + step.name + "` knows a part of what `" + monitor_.name +
                                         "` allows, and may lead across what lies "
                                         "between, or find no way in");
      d.label = "makes straight for its zone";
      d.notes.push_back({std::nullopt, "from the rest of " + name + ", such as at a height of " +
                                           metres(from.slabs().front().floor) + " over " +
                                           some_corner(from.slabs().front().region)});
      const bool works = trials_ == nullptr ||  // nobody reads it
                         works_within(*trials_, fault_of(d.code, d.range), written_.range,
                                      step.name, module_, step.zone, {{{fence}}})
                             .value_or(false);
      d.help = works ? "a recovery within " + name + " works: it finds its ways inside"
                     : "a recovery finds its ways inside of its zone: that has to be all of " +
                           name + " that the other monitors of the decision allow";
      return d;
    }
    return std::nullopt;
  }
  Found elsewhere(const ir::Recovery& step, const std::string& of, std::string note,
                  std::string help) const {
    diag::Diagnostic d = finding(Code::recovery_elsewhere,
                                 "`" + step.name + "` moves within `" + module_[step.zone].name +
                                     "`, and `" + monitor_.name + "` needs it to stay in " + of);
    d.label = "leads out of it";
    d.notes.push_back({std::nullopt, std::move(note)});
    d.help = std::move(help);
    return d;
  }

  // Over a floor it keeps what it keeps of any boundary on its way.
  Found landing(const ir::Recovery& step) const {
    const std::int64_t body_mm = decision_.body.radius_mm;
    if (least_mm_) {
      const std::int64_t lowest_mm = *least_mm_ + step.route_clearance_mm - body_mm;
      if (step.land_mm < lowest_mm) {
        return too_low(step, "`" + monitor_.name + "` needs the centre above " + metres(*least_mm_),
                       lowest_mm, step.land_mm >= *least_mm_);
      }
    }
    for (const ir::ZoneIndex zone : zones_named()) {
      if (!module_[zone].has_height()) continue;
      if (Found found = column(step, zone, exact_(zone))) return found;
    }
    return std::nullopt;
  }
  // Of an `or`, each side: the robot may be in that one alone.
  [[nodiscard]] std::vector<ir::ZoneIndex> zones_named() const {
    std::vector<ir::ZoneIndex> all;
    ir::for_each_comparison(monitor_.property, [&](const ir::Block& block, const ir::AtLeast& c) {
      for (const auto& [leaf, coefficient] : ir::linear_form(block, c).terms) {
        const ir::ZoneIndex zone{leaf.table};
        if (leaf.kind != ir::Leaf::Kind::clearance) continue;
        if (std::ranges::find(all, zone) == all.end()) all.push_back(zone);
      }
    });
    return all;
  }
  // The most that the property asks for beyond the body, on either side of an `or`.
  [[nodiscard]] std::int64_t asked_mm(ir::ZoneIndex fence) const {
    std::int64_t most = 0;
    for (const Standoff& each : fence_standoffs(monitor_.property, decision_.facts.params)) {
      if (each.zone == fence) most = std::max(most, each.mm);
    }
    return most;
  }
  // Every place above has all of the way down below it.
  Found column(const ir::Recovery& step, ir::ZoneIndex fence, const geometry::Solid& solid) const {
    const std::string& zone = module_[fence].name;
    const Rational end = thousandths(step.land_mm);
    const std::vector<geometry::Slab>& slabs = solid.slabs();
    const auto in = std::ranges::find_if(
        slabs, [&](const geometry::Slab& s) { return s.floor <= end && end < s.ceiling; });
    const std::int64_t need_mm = step.route_clearance_mm;
    if (in == slabs.end()) {
      const std::int64_t floor_mm = ceil_to_int(Rational(slabs.front().floor * 1000));
      return too_low(step, "`" + zone + "` has no place at that height", floor_mm + need_mm, false);
    }
    auto lowest = in;
    while (lowest != slabs.begin() && std::prev(lowest)->ceiling == lowest->floor) --lowest;
    const std::int64_t floor_mm = ceil_to_int(Rational(lowest->floor * 1000));
    if (step.land_mm < floor_mm + need_mm) {
      return too_low(step,
                     "the floor of `" + zone + "` is at " + metres(floor_mm) + ", and `" +
                         step.name + "` keeps " + metres(need_mm) + " on its way",
                     floor_mm + need_mm,
                     step.land_mm >= floor_mm + decision_.body.radius_mm + asked_mm(fence));
    }
    // what it reaches below its end belongs to the column, too
    const Rational reach = thousandths(step.land_mm - need_mm);
    for (auto upper = std::next(slabs.begin()); upper != slabs.end(); ++upper) {
      if (upper->floor <= reach) continue;
      const auto lower = std::prev(upper);
      if (lower->ceiling == upper->floor && lower->region.contains(upper->region)) continue;
      const geometry::Region beyond =
          lower->ceiling == upper->floor ? upper->region.subtract(lower->region) : upper->region;
      return obstructed(step, zone, upper->floor, beyond);
    }
    return std::nullopt;
  }
  // `is_near`: the property holds where it is meant to end, and less room is left than it strays.
  Found too_low(const ir::Recovery& step, std::string note, std::int64_t works_mm,
                bool is_near) const {
    diag::Diagnostic d =
        finding(Code::landing_outside, "`" + step.name + "` lands at " + metres(step.land_mm) +
                                           ", where `" + monitor_.name + "` may be false");
    d.label = is_near ? lands_near : "leads out of it";
    d.notes.push_back({std::nullopt, std::move(note)});
    const auto to_mm = height_that_works(step, d, works_mm);
    d.help = to_mm
                 ? "`land to " + metres(*to_mm) + "` works"
                 : "no height alone works: a `retreat` within the zone is needed, or another zone";
    return d;
  }
  [[nodiscard]] std::optional<std::int64_t> height_that_works(const ir::Recovery& step,
                                                              const diag::Diagnostic& found,
                                                              std::int64_t guess_mm) const {
    if (trials_ == nullptr) return std::nullopt;
    const Fault fault = fault_of(found.code, found.range);
    return landing_that_works(*trials_, {fault, 1000, step.land_mm, guess_mm, guess_mm}, step.name);
  }
  Found obstructed(const ir::Recovery& step, const std::string& zone, const Rational& height,
                   const geometry::Region& beyond) const {
    diag::Diagnostic d =
        finding(Code::landing_outside,
                "straight down `" + step.name + "` leaves `" + zone + "` at " + metres(height));
    d.label = "the way down is not all in it";
    d.notes.push_back({std::nullopt,
                       "what is above that height is not all above what is below it, "
                       "such as at " +
                           some_corner(beyond)});
    const std::int64_t works_mm = ceil_to_int(Rational(height * 1000)) + step.route_clearance_mm;
    const auto to_mm = height_that_works(step, d, works_mm);
    d.help = (to_mm ? "`land to " + metres(*to_mm) + "` works, or " : std::string()) +
             "a zone that gets no narrower downwards" +
             (to_mm ? ", or a `retreat`" : " works, or a `retreat`");
    return d;
  }

  [[nodiscard]] diag::Diagnostic finding(Code code, std::string message) const {
    return about_recovery(written_, code, std::move(message));
  }

  const sema::Monitor& written_;
  const ir::Module& module_;
  const ir::Decision& decision_;
  const ir::Monitor& monitor_;
  const ExactZone& flat_;
  const ExactSolid& exact_;
  Trials* trials_;
  std::optional<std::int64_t> most_mm_, least_mm_;
};

}  // namespace

geometry::Solid without_end(const geometry::Region& region) {
  const geometry::Solid everywhere = geometry::Solid::everywhere();
  const geometry::Slab& all = everywhere.slabs().front();
  return geometry::Solid::prism(region, all.floor, all.ceiling);
}

Found misplaced_in_space(const sema::Monitor& written, const ir::Module& module,
                         const ir::Decision& decision, const ir::Monitor& monitor,
                         const ExactZone& flat, const ExactSolid& exact, Trials* trials) {
  return InSpace(written, module, decision, monitor, flat, exact, trials).run();
}

bool lands_near_the_limit(const diag::Diagnostic& report) {
  return report.code == Code::landing_outside && report.label == lands_near;
}

}  // namespace rtac::analysis
