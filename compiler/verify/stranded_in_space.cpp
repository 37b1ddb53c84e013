// Places of robots in space from which a recovery that goes back leads nowhere: those that are
// clear enough for it, and do not have what its monitor says when inputs ask for it, or what its
// `return when` asks for, and those from where no leg leads straight to a clear one. Nothing is
// claimed of them.
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "compiler/ir/linear.h"
#include "compiler/verify/in_space.h"

namespace rtac::verify {
namespace {

using analysis::outline::norm;
using analysis::outline::P;

// All in mm. By which a property holds at the start, and by which a place is clear enough or not.
constexpr double holds_by_mm = 15, surely_mm = 30;
constexpr double look_each_mm = 200, apart_mm = 6000, unbounded_mm = 10'000;
constexpr std::size_t starts_most = 4;
// Of a grid, and how many levels of it are looked at; how many of the nearest clear places may be
// in sight.
constexpr int places_across = 64, levels = 5;
constexpr std::size_t nearest_most = 32;

class Stranded {
 public:
  Stranded(const Subject& s, std::size_t k)
      : monitor_(s.decision.monitors[k]),
        last_(ir::last_step(monitor_.recovery)),
        own_(s, last_.zone),
        body_mm_(double(s.decision.body.radius_mm)),
        clear_mm_(double(last_.return_clearance_mm + s.decision.body.end_reach_mm)),
        level_(s.module[last_.zone].slabs.size() < 2) {
    for (const ir::Monitor& m : s.decision.monitors) all_.push_back(says_of(s, m.property));
    all_.push_back({{{own_, 0}}});
    if (monitor_.return_when) returns_ = says_of(s, *monitor_.return_when);
    ir::for_each_comparison(monitor_.property, [&](const ir::Block& block, const ir::AtLeast& c) {
      const auto least = ir::lower_bound(block, c, s.decision.facts.params);
      if (!least || least->leaf.kind != ir::Leaf::Kind::clearance) return;
      asked_.emplace_back(Volume(s, ir::ZoneIndex{least->leaf.table}),
                          double(least->need.strictest));
    });
  }

  // Those that are the farthest from what leads somewhere come first.
  std::vector<Start> run() const {
    std::vector<At> stranded, led;
    const std::vector<At> all = places();
    for (const At& at : all) {
      const auto holds = [&](const Says& says) { return says.holds(at, body_mm_, holds_by_mm); };
      const auto above = [&](const At& other) { return norm(other.p - at.p) < 1; };
      if (std::ranges::any_of(stranded, above) || !std::ranges::all_of(all_, holds)) continue;
      // what is in sight is so on every level
      const bool looks = at.z == all.front().z;
      if (is_left(at) || (looks && sees_nothing(at))) {
        stranded.push_back(at);
      } else if (looks) {
        led.push_back(at);
      }
    }
    const auto away = [](const std::vector<At>& from, const At& at) {
      double least = endless_mm;
      for (const At& other : from) least = std::min(least, norm(other.p - at.p));
      return least;
    };
    std::vector<std::pair<double, At>> by_distance;
    for (const At& at : stranded) by_distance.emplace_back(away(led, at), at);
    std::ranges::stable_sort(by_distance, std::greater(), &std::pair<double, At>::first);
    std::vector<At> found;
    for (const auto& [distance, at] : by_distance) {
      if (away(found, at) >= apart_mm && found.size() < starts_most) found.push_back(at);
    }
    std::vector<Start> starts;
    for (const At& at : found) {
      starts.push_back({{std::llround(at.p.x), std::llround(at.p.y), std::llround(at.z)}});
    }
    return starts;
  }

 private:
  // Clear enough to be led no further, where control is not given back.
  [[nodiscard]] bool is_left(const At& at) const {
    return own_.clear(at, clear_mm_ + surely_mm) &&
           (!returns_.holds(at, body_mm_, -surely_mm) ||
            std::ranges::any_of(asked_, [&](const auto& each) {
              return !each.first.clear(at, body_mm_ + each.second - surely_mm);
            }));
  }
  [[nodiscard]] bool sees_nothing(const At& at) const {
    // over and below others there may be more room
    if (!level_ || own_.clear(at, clear_mm_ - surely_mm)) return false;
    const std::vector<At> in = own_.inwards(at, clear_mm_);
    const At level{at.p, in.empty() ? at.z : in.front().z};
    std::vector<std::pair<double, P>> nearest;
    for (const P to : clear_places(level.z)) nearest.emplace_back(norm(to - at.p), to);
    const auto many = std::ptrdiff_t(std::min(nearest.size(), nearest_most));
    std::ranges::partial_sort(nearest, nearest.begin() + many, {}, &std::pair<double, P>::first);
    return std::none_of(nearest.begin(), nearest.begin() + many,
                        [&](const auto& to) { return leads_to(level, to.second); });
  }
  // Of the box around it on several levels, the one in the middle first.
  [[nodiscard]] std::vector<At> places() const {
    double floor = -endless_mm, ceiling = endless_mm;
    for (const Says& says : all_) {
      floor = std::max(floor, says.least_mm), ceiling = std::min(ceiling, says.most_mm);
    }
    P low{-endless_mm, -endless_mm}, high{endless_mm, endless_mm};
    own_.narrow(low, high, floor, ceiling);
    if (ceiling >= endless_mm) ceiling = std::max(floor, 0.0) + unbounded_mm;
    if (floor <= -endless_mm) floor = std::min(0.0, ceiling - unbounded_mm);
    std::vector<At> all;
    for (const int level : {2, 3, 1, 4, 0}) {
      const double z = floor + (ceiling - floor) * (level + 0.5) / levels;
      for (const P& p : grid(low, high)) all.push_back({p, z});
    }
    return all;
  }
  static std::vector<P> grid(P low, P high) {
    std::vector<P> all;
    for (int n = 0; n < places_across * places_across; ++n) {
      const int column = n % places_across, row = n / places_across;
      const P part{(column + 0.5) / places_across, (row + 0.5) / places_across};
      all.push_back({low.x + part.x * (high.x - low.x), low.y + part.y * (high.y - low.y)});
    }
    return all;
  }
  // On the level that `sees_nothing` is asked of, which is one.
  [[nodiscard]] const std::vector<P>& clear_places(double z) const {
    if (places_) return *places_;
    P low{-endless_mm, -endless_mm}, high{endless_mm, endless_mm};
    double floor = z, ceiling = z;
    own_.narrow(low, high, floor, ceiling);
    places_.emplace();
    for (const P& p : grid(low, high)) {
      if (own_.clear({p, z}, clear_mm_)) places_->push_back(p);
    }
    return *places_;
  }
  // As a point does, which sees more than a body.
  [[nodiscard]] bool leads_to(const At& from, P to) const {
    const double looks = std::ceil(norm(to - from.p) / look_each_mm);
    for (double k = 1; k < looks; ++k) {
      if (!own_.clear({from.p + (k / looks) * (to - from.p), from.z}, 0)) return false;
    }
    return true;
  }

  const ir::Monitor& monitor_;
  const ir::Recovery& last_;
  const Volume own_;
  const double body_mm_, clear_mm_;
  const bool level_;
  std::vector<Says> all_;
  Says returns_;
  std::vector<std::pair<Volume, double>> asked_;
  mutable std::optional<std::vector<P>> places_;
};

}  // namespace

std::vector<Start> starts_stranded_in_space(const Subject& s, std::size_t k) {
  const ir::Recovery& last = ir::last_step(s.decision.monitors[k].recovery);
  if (!s.decision.body.in_space || !ir::goes_back(last.kind)) return {};
  return Stranded(s, k).run();
}

// Up or down and then level, it is led to no place that is farther than the farthest one.
Obligation shown_from(const Subject& s, const ir::Recovery& last, Obligation o,
                      std::vector<Start> starts) {
  P low{-endless_mm, -endless_mm}, high{endless_mm, endless_mm};
  double floor = -endless_mm, ceiling = endless_mm, farthest = 0;
  Volume(s, last.zone).narrow(low, high, floor, ceiling);
  for (const Start& start : starts) {
    const P at{double(start.place_mm[0]), double(start.place_mm[1])};
    for (const P& corner : {low, high, P{low.x, high.y}, P{high.x, low.y}}) {
      farthest = std::max(farthest, norm(corner - at));
    }
  }
  if (s.module[last.zone].has_height()) farthest += ceiling - floor;
  o.status = Status::refuted;
  o.method = "straight legs";
  o.by_a_run = true;
  o.starts = std::move(starts);
  o.patience_s += std::llround(1.5 * farthest) / std::max<std::int64_t>(1, last.speed_mmps);
  return o;
}

}  // namespace rtac::verify
