#include "compiler/analysis/site_room.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "compiler/analysis/sides.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/support/rational.h"

namespace rtac::analysis {
namespace {

// Counts cells without a way in rectangles of cells.
class Blocked {
 public:
  Blocked(const ir::Cells& cells, const std::vector<std::int32_t>& cost_ppm)
      : cells_(cells), sums_(std::size_t(cells.columns + 1) * std::size_t(cells.rows + 1), 0) {
    for (std::int64_t row = 0; row < cells.rows; ++row) {
      for (std::int64_t column = 0; column < cells.columns; ++column) {
        const std::int32_t cost = cost_ppm[std::size_t(row * cells.columns + column)];
        const std::int64_t own = cost < 0 || cost >= ir::no_way ? 1 : 0;
        sum(column + 1, row + 1) =
            own + sum(column, row + 1) + sum(column + 1, row) - sum(column, row);
      }
    }
  }
  // Of the cells that come within `radius_mm` of a place, in x and y; beside the grid there are
  // none.
  [[nodiscard]] bool around(const PlaceMm& p, std::int64_t radius_mm) {
    const auto column = [&](std::int64_t x_mm) {
      return cell(x_mm - cells_.origin_x_mm, cells_.columns);
    };
    const auto row = [&](std::int64_t y_mm) {
      return cell(y_mm - cells_.origin_y_mm, cells_.rows);
    };
    const std::int64_t left = column(p.x_mm - radius_mm), right = column(p.x_mm + radius_mm) + 1;
    const std::int64_t low = row(p.y_mm - radius_mm), high = row(p.y_mm + radius_mm) + 1;
    return sum(right, high) - sum(left, high) - sum(right, low) + sum(left, low) > 0;
  }
  [[nodiscard]] std::int64_t clearance_mm(std::int64_t column, std::int64_t row) const {
    return cells_.clearance_mm_lo[std::size_t(row * cells_.columns + column)];
  }
  [[nodiscard]] PlaceMm middle(std::int64_t column, std::int64_t row) const {
    const std::int64_t half = cells_.cell_mm / 2;
    return {cells_.origin_x_mm + column * cells_.cell_mm + half,
            cells_.origin_y_mm + row * cells_.cell_mm + half};
  }

 private:
  [[nodiscard]] std::int64_t cell(std::int64_t from_origin_mm, std::int32_t count) const {
    return std::clamp<std::int64_t>(from_origin_mm / cells_.cell_mm, 0, count - 1);
  }
  std::int64_t& sum(std::int64_t column, std::int64_t row) {
    return sums_[std::size_t(row * (cells_.columns + 1) + column)];
  }
  const ir::Cells& cells_;
  std::vector<std::int64_t> sums_;
};

}  // namespace

const sema::Site::Place* written_place(const sema::Spec& spec, const sema::Site& site,
                                       const std::string& robot) {
  const auto is_of_robot = [&](const sema::Site::Place& p) {
    return !p.robot || spec[*p.robot].name == robot;
  };
  const auto found = std::ranges::find_if(site.places, is_of_robot);
  return found == site.places.end() ? nullptr : &*found;
}

const sema::Site::Place* written_place(const sema::Spec& spec, const ir::SiteTable& site,
                                       const ir::SiteTable::Place& place) {
  const auto robot = std::ranges::find(spec.robots, place.robot, &sema::Robot::name);
  if (robot == spec.robots.end()) return nullptr;
  // a second kind of robots that goes there has a table of its own (derive.cpp)
  const std::string of_kind = "_of_" + spec[robot->kind].name;
  const auto of = std::ranges::find_if(spec.sites, [&](const sema::Site& each) {
    return each.name == site.name || each.name + of_kind == site.name;
  });
  return of == spec.sites.end() ? nullptr : written_place(spec, *of, place.robot);
}

namespace {

// A place of the specification that is tried elsewhere.
struct Moved {
  sema::Site::Place* place;
  sema::Point from;
  std::vector<OtherPlace> to;  // nearest first, each clearer than the one before
};
std::optional<Moved> moved(sema::Spec& spec, const Move& move) {
  for (sema::Site& site : spec.sites) {
    const auto found = std::ranges::find(site.places, move.written, &sema::Site::Place::range);
    if (found == site.places.end() || move.to.empty()) continue;
    Moved all{&*found, found->position, move.to};
    const std::int64_t x_mm = floor_to_int(Rational(all.from.x * 1000));
    const std::int64_t y_mm = floor_to_int(Rational(all.from.y * 1000));
    std::ranges::stable_sort(all.to, {}, [&](const OtherPlace& p) {
      const std::int64_t dx = p.at.x_mm - x_mm, dy = p.at.y_mm - y_mm;
      return dx * dx + dy * dy;  // coordinates differ by 2^30 at most
    });
    std::int64_t clearest_mm = -1;
    std::erase_if(all.to, [&](const OtherPlace& p) {
      if (p.clearance_mm <= clearest_mm) return true;
      clearest_mm = p.clearance_mm;
      return false;
    });
    return all;
  }
  return std::nullopt;
}

}  // namespace

std::int64_t at_once_mm(const ir::Decision& decision) {
  return 2 * decision.body.radius_mm + sure_separation_mm(decision);
}

std::int64_t square_mm2(const ir::SiteTable::Place& one, const ir::SiteTable::Place& other) {
  const std::int64_t dx = other.x_mm - std::int64_t{one.x_mm};
  const std::int64_t dy = other.y_mm - std::int64_t{one.y_mm};
  return dx * dx + dy * dy;  // coordinates differ by 2^30 at most
}

std::vector<MovedTo> places_that_work(Trials& trials, const Fault& fault,
                                      const std::vector<Move>& moves) {
  std::vector<Moved> all;
  std::size_t last = 0;
  std::string name = "place of " + std::to_string(static_cast<int>(fault.code)) + " at " +
                     std::to_string(fault.begin) + ":";
  for (const Move& move : moves) {
    auto each = moved(trials.spec(), move);
    if (!each) return {};
    last = std::max(last, each->to.size());
    name += " " + std::to_string(move.written.begin);
    all.push_back(std::move(*each));
  }
  // each as far as the others, or as far as it goes
  const auto at = [](const Moved& each, std::int64_t k) {
    return each.to[std::min(static_cast<std::size_t>(k), each.to.size()) - 1];
  };
  const Dial dial{name, 0, static_cast<std::int64_t>(last),
                  [&](std::int64_t k) {
                    if (k < 1 || k > static_cast<std::int64_t>(last)) return false;
                    for (const Moved& each : all) {
                      const PlaceMm p = at(each, k).at;
                      each.place->position = {metres_of(p.x_mm), metres_of(p.y_mm)};
                    }
                    return true;
                  },
                  [&] {
                    for (const Moved& each : all) each.place->position = each.from;
                  }};
  std::vector<MovedTo> found;
  const auto works = last > 0 ? trials.nearest(dial, 1, fault) : std::nullopt;
  if (!works) return found;
  for (const Moved& each : all) found.push_back({each.from, at(each, *works).at});
  return found;
}

std::vector<Cramped> cramped_places(const ir::Module& module, ir::SiteIndex site,
                                    std::int64_t radius_mm) {
  const ir::Cells& cells = module[module[site].zone].cells;
  std::vector<Cramped> all;
  for (const ir::SiteTable::Place& place : module[site].places) {
    if (place.cost_ppm.empty()) continue;
    Blocked blocked(cells, place.cost_ppm);
    if (!blocked.around({place.x_mm, place.y_mm}, radius_mm)) continue;
    Cramped found{place, {}};
    for (std::int64_t row = 0; row < cells.rows; ++row) {
      for (std::int64_t column = 0; column < cells.columns; ++column) {
        const PlaceMm p = blocked.middle(column, row);
        if (!blocked.around(p, radius_mm))
          found.roomy.push_back({p, blocked.clearance_mm(column, row)});
      }
    }
    all.push_back(std::move(found));
  }
  return all;
}

}  // namespace rtac::analysis
