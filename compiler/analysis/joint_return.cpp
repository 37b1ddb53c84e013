#include "compiler/analysis/joint_return.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/repairs.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/widening.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

using geometry::Region;

// What offsets of regions round, in mm (geometry/region.h, `offset_excess_um`).
constexpr std::int64_t rounded_mm = 1;

// So many times the clearance that is needed: who has zones that are farther off means another
// place.
constexpr std::int64_t grown_most = 4;

// In the message, and in that of no other report of its code.
constexpr const char* together = " can never hand control back together with ";

// A zone that a property keeps the robot in, and how far from its boundary.
struct Fence {
  std::size_t monitor;
  ir::ZoneIndex zone;
  std::int64_t standoff_mm;
};

class Joint {
 public:
  Joint(const Decided& of, const ExactZone& exact) : of_(of), exact_(exact) {
    const auto& params = of.decision.facts.params;
    for (std::size_t k = 0; k < of.decision.monitors.size(); ++k) {
      const ir::Monitor& m = of.decision.monitors[k];
      if (!m.lookahead.duration) continue;
      for (const ir::ZoneIndex zone : fences_of(m.property, params)) {
        std::int64_t standoff_mm = 0;
        for (const Standoff& each : fence_standoffs(m.property, params)) {
          if (each.zone == zone) standoff_mm = std::max(standoff_mm, each.mm);
        }
        fences_.push_back({k, zone, standoff_mm});
      }
    }
  }

  std::optional<diag::Diagnostic> finding() const {
    const auto other = [&](const Fence& f) { return f.zone != fences_[0].zone; };
    if (fences_.empty() || std::none_of(fences_.begin(), fences_.end(), other)) {
      return std::nullopt;  // one zone alone: looked at where its recoveries are
    }
    const Trial now = trial_of(of_.spec, of_.written);
    const std::int64_t need_mm = return_clearance_mm(now.decision, now.lookahead_us) - rounded_mm;
    if (!common(fences_.size(), need_mm).empty()) return std::nullopt;
    std::size_t first = 1;
    while (first < fences_.size() && !common(first, need_mm).empty()) ++first;
    return first < 2 ? std::nullopt : std::optional(report(first, need_mm));
  }

 private:
  // A zone that is so much wider on every side.
  struct Grown {
    ir::ZoneIndex zone;
    std::int64_t by_mm;
  };
  // Of the first `count` zones, the places that are so far within each of them.
  [[nodiscard]] Region common(std::size_t count, std::int64_t clearance_mm,
                              const std::optional<Grown>& grown = {}) const {
    Region all = Region::everywhere();
    for (std::size_t i = 0; i < count && !all.empty(); ++i) {
      const Region& zone = exact_(fences_[i].zone);
      const std::int64_t off_mm = clearance_mm + fences_[i].standoff_mm;
      const bool wider = grown && grown->zone == fences_[i].zone;
      const Region from = wider ? zone.grow(metres_of(grown->by_mm)) : zone;
      all = all.intersect(within(from, off_mm).value_or(from));
    }
    return all;
  }

  [[nodiscard]] diag::Diagnostic report(std::size_t count, std::int64_t need_mm) const {
    const Fence& last = fences_[count - 1];
    const ir::Monitor& m = of_.decision.monitors[last.monitor];
    diag::Diagnostic d{};
    d.code = diag::Code::return_set_empty;
    d.range = m.source;
    d.message = "monitor `" + m.name + "`" + together + others(count);
    if (of_.trials == nullptr) return d;    // nobody reads more
    std::int64_t low = -1, high = need_mm;  // mm of clearance that they do have in common
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (common(count, middle).empty() ? high : low) = middle;
    }
    const std::string needed = metres(need_mm + rounded_mm);
    d.label = "no place in common has a clearance of " + needed;
    d.notes.push_back({std::nullopt, low < 0 ? "nor any at all: they do not overlap so far"
                                             : "the widest place in common has a clearance of " +
                                                   metres(low) + ", beyond what they ask for"});
    const Fault fault = fault_of(d.code, d.range);
    if (const auto wider = wider_zone(count, need_mm, fault)) d.help = *wider;
    const auto numbers = repairs(of_.written, of_.trials, fault, [&](const Trial& t) {
      return return_clearance_mm(t.decision, t.lookahead_us) <= low;
    });
    if (!numbers.empty()) d.help += (d.help.empty() ? "" : "; or ") + joined(numbers) + " works";
    if (d.help.empty()) {
      d.help = "zones that have a place in common with a clearance of " + needed + " are needed";
    }
    return d;
  }
  // One of them, the last one first, that is so much wider that there is a place in common: by less
  // than what is rounded it is not shown to be one (P2b, joint return).
  [[nodiscard]] std::optional<std::string> wider_zone(std::size_t count, std::int64_t need_mm,
                                                      const Fault& fault) const {
    const std::int64_t most_mm = grown_most * (need_mm + rounded_mm);
    for (std::size_t i = count; i-- > 0;) {
      const ir::ZoneIndex zone = fences_[i].zone;
      const auto none = [&](std::int64_t by_mm) {
        return common(count, need_mm + rounded_mm, Grown{zone, by_mm}).empty();
      };
      std::int64_t low = 0, high = most_mm;
      if (none(high)) continue;
      while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (none(middle) ? low : high) = middle;
      }
      auto works = growth_that_works(*of_.trials, zone, exact_(zone), high, most_mm, fault, high);
      if (works) return works;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::string others(std::size_t count) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const std::string name = "`" + of_.decision.monitors[fences_[i].monitor].name + "`";
      const bool own = fences_[i].monitor == fences_[count - 1].monitor;
      if (!own && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all.empty() ? "its own zones" : all;
  }

  const Decided& of_;
  const ExactZone& exact_;
  std::vector<Fence> fences_;
};

}  // namespace

std::optional<diag::Diagnostic> apart_for_ever(const Decided& of, const ExactZone& exact) {
  return Joint(of, exact).finding();
}

bool is_apart_for_ever(const diag::Diagnostic& report) {
  return report.code == diag::Code::return_set_empty &&
         report.message.find(together) != std::string::npos;
}

}  // namespace rtac::analysis
