#include "compiler/analysis/zone_tables.h"

#include <algorithm>
#include <string>
#include <utility>

#include "compiler/analysis/spread.h"
#include "compiler/geometry/spread.h"
#include "compiler/sema/received.h"

namespace rtac::analysis {
namespace {

class Numbering {
 public:
  Numbering(const sema::Spec& spec, const SourceManager& sources,
            const std::vector<ZoneUse>& wanted, const EvaluatedZones& evaluated, ir::Module& module,
            ir::TableMap& tables)
      : spec_(spec),
        sources_(sources),
        wanted_(wanted),
        evaluated_(evaluated),
        module_(module),
        tables_(tables) {}

  PointTables run() {
    tables_.gaps = evaluated_.gaps;
    number_zones();
    PointTables points;
    points.regions = number_regions();
    points.solids = number_solids(points.regions);
    keep_trees(points.regions);
    return points;
  }

 private:
  // A zone written inside a property is named by its line; names of tables differ.
  std::string table_name(const sema::Zone& zone,
                         const std::vector<ir::Region>& regions = {}) const {
    if (!zone.name.empty()) return zone.name;
    const auto* complement = std::get_if<sema::ZoneComplement>(&zone.value->node);
    const std::string of = complement != nullptr ? spec_[complement->zone].name : "";
    if (!of.empty()) return unlike_others("outside_of_" + of, regions);
    const LineColumn at = sources_.position(zone.value->range.file, zone.value->range.begin);
    return unlike_others("zone_of_line_" + std::to_string(at.line), regions);
  }
  std::string unlike_others(const std::string& base, const std::vector<ir::Region>& regions) const {
    std::string name = base;
    const auto taken = [&](const auto& other) { return other.name == name; };
    for (int n = 2; std::any_of(spec_.zones.begin(), spec_.zones.end(), taken) ||
                    std::any_of(module_.zones.begin(), module_.zones.end(), taken) ||
                    std::any_of(regions.begin(), regions.end(), taken);
         ++n) {
      name = base + "_" + std::to_string(n);
    }
    return name;
  }

  void number_zones() {
    tables_.zones.resize(spec_.zones.size());
    for (std::uint32_t i = 0; i < spec_.zones.size(); ++i) {
      if (!evaluated_.zones[i] || !wanted_[i].robots) continue;
      if (evaluated_.zones[i]->solid) {
        tables_.zones[i] = stack(table_name(spec_.zones[i]), *evaluated_.zones[i]->solid);
        continue;
      }
      tables_.zones[i] = ir::ZoneIndex(module_.zones.size());
      module_.zones.push_back(table(table_name(spec_.zones[i]), *evaluated_.zones[i]));
    }
  }
  static std::vector<ir::Edge> edges(const std::vector<geometry::EdgeRow>& rows) {
    std::vector<ir::Edge> to;
    for (const auto& e : rows) {
      to.push_back({e.a.x_mm, e.a.y_mm, e.b.x_mm, e.b.y_mm, e.ux_q30, e.uy_q30});
    }
    return to;
  }
  static ir::EdgeTree tree(const geometry::CellTree& from) {
    return {.x_mm = from.x_mm,
            .y_mm = from.y_mm,
            .shift = from.shift,
            .column = from.column,
            .row = from.row,
            .columns = from.columns,
            .rows = from.rows,
            .depth = from.depth,
            .leaves = from.leaves,
            .edges_most = from.edges_most,
            .exact_mm = from.exact_mm,
            .exact_inside_mm = from.exact_inside_mm,
            .words = from.words,
            .lists = from.lists};
  }
  // A zone on the grid is one region, another one two: what is in it, and what contains it.
  std::vector<ir::Region> number_regions() {
    std::vector<ir::Region> regions;
    tables_.regions.resize(spec_.zones.size());
    for (std::uint32_t i = 0; i < spec_.zones.size(); ++i) {
      if (wanted_[i].points && is_received(spec_.zones[i])) {
        tables_.regions[i] = {ir::RegionIndex(regions.size()), ir::RegionIndex(regions.size())};
        regions.push_back({spec_.zones[i].name, false, {}, {}, 0});  // the channel is found later
      }
      if (!evaluated_.zones[i] || !wanted_[i].points || evaluated_.zones[i]->solid) continue;
      const auto& zone = tables_.zones[i];
      const std::string name = zone ? module_[*zone].name : table_name(spec_.zones[i], regions);
      regions.push_back(
          {name, false, edges(evaluated_.zones[i]->baked.edges), tree(evaluated_.zones[i]->tree)});
      const ir::RegionIndex within{static_cast<std::uint32_t>(regions.size() - 1)};
      ir::RegionIndex around = within;
      const auto same = [](const geometry::EdgeRow& a, const geometry::EdgeRow& b) {
        return a.a == b.a && a.b == b.b;
      };
      if (!std::ranges::equal(evaluated_.zones[i]->baked.edges, evaluated_.zones[i]->around,
                              same)) {
        around = ir::RegionIndex(regions.size());
        regions.push_back({name, true, edges(evaluated_.zones[i]->around),
                           tree(evaluated_.zones[i]->around_tree)});
        regions.back().spread_mm =
            geometry::spread_mm(evaluated_.zones[i]->baked.edges, evaluated_.zones[i]->around);
      }
      tables_.regions[i] = {within, around};
    }
    return regions;
  }
  static bool is_received(const sema::Zone& zone) {
    return std::holds_alternative<sema::ZoneReceived>(zone.value->node);
  }
  // A kernel has one kind of zone: with trees when one of them needs it.
  void keep_trees(std::vector<ir::Region>& regions) {
    for (std::uint32_t i = 0; i < wanted_.size(); ++i) {
      if (wanted_[i].robots && sema::received_by(spec_, sema::ZoneId(i))) return;
    }
    const auto many = [](const auto& z) { return z.edges.size() > ir::edges_without_tree; };
    if (std::ranges::any_of(regions, [](const ir::Region& r) { return r.channel.has_value(); })) {
      return;
    }
    if (std::ranges::any_of(module_.zones, many) || std::ranges::any_of(regions, many)) return;
    for (ir::ZoneTable& z : module_.zones) z.tree = {};
    for (ir::Region& r : regions) r.tree = {};
  }
  // A zone with height: a region for each of its slabs.
  std::vector<ir::Solid> number_solids(std::vector<ir::Region>& regions) {
    std::vector<ir::Solid> solids;
    tables_.solids.resize(spec_.zones.size());
    for (std::uint32_t i = 0; i < spec_.zones.size(); ++i) {
      if (!evaluated_.zones[i] || !evaluated_.zones[i]->solid || !wanted_[i].points) continue;
      const EvaluatedSolid& zone = *evaluated_.zones[i]->solid;
      const std::string name = table_name(spec_.zones[i], regions);
      solids.push_back(solid(name, false, zone.within, regions));
      const ir::SolidIndex within{static_cast<std::uint32_t>(solids.size() - 1)};
      ir::SolidIndex around = within;
      if (!std::ranges::equal(zone.within, zone.around, same_slab)) {
        around = ir::SolidIndex(solids.size());
        solids.push_back(solid(name, true, zone.around, regions));
        solids.back().spread_mm = spread_mm(zone.within, zone.around);
      }
      tables_.solids[i] = {within, around};
    }
    return solids;
  }
  static bool same_slab(const BakedSlab& a, const BakedSlab& b) {
    return a.floor_mm == b.floor_mm && a.ceiling_mm == b.ceiling_mm &&
           std::ranges::equal(a.edges, b.edges,
                              [](const geometry::EdgeRow& e, const geometry::EdgeRow& f) {
                                return e.a == f.a && e.b == f.b;
                              });
  }
  static ir::Solid solid(const std::string& name, bool around, const std::vector<BakedSlab>& slabs,
                         std::vector<ir::Region>& regions) {
    ir::Solid to{name, around, {}};
    for (const BakedSlab& slab : slabs) {
      to.slabs.push_back({slab.floor_mm, slab.ceiling_mm, ir::RegionIndex(regions.size())});
      regions.push_back({name, around, edges(slab.edges), tree(slab.tree), std::nullopt,
                         static_cast<std::uint32_t>(to.slabs.size())});
    }
    return to;
  }
  static ir::ZoneTable table(std::string name, const EvaluatedZone& zone) {
    return table(std::move(name), zone.snapped, zone.baked, zone.tree);
  }
  static ir::ZoneTable table(std::string name, const geometry::SnappedZone& snapped,
                             const geometry::BakedZone& baked, const geometry::CellTree& tree) {
    ir::ZoneTable t;
    t.name = std::move(name);
    t.edges = edges(baked.edges);
    t.tree = Numbering::tree(tree);
    std::uint32_t start = 0;
    for (const auto& ring : snapped.rings) {
      t.ring_starts.push_back(start);
      start += static_cast<std::uint32_t>(ring.size());
    }
    const auto& cells = baked.cells;
    t.cells = {cells.origin.x_mm, cells.origin.y_mm, cells.cell_mm,
               cells.columns,     cells.rows,        cells.clearance_mm_lo};
    t.widest_mm = baked.widest_mm;
    t.widest_x_mm = baked.widest_at.x_mm;
    t.widest_y_mm = baked.widest_at.y_mm;
    return t;
  }
  // A zone with height: a table for each of its slabs, and one of the slabs.
  ir::ZoneIndex stack(const std::string& name, const EvaluatedSolid& solid) {
    ir::ZoneTable t;
    t.name = name;
    for (std::size_t k = 0; k < solid.within.size(); ++k) {
      const BakedSlab& slab = solid.within[k];
      t.slabs.push_back({slab.floor_mm, slab.ceiling_mm, ir::ZoneIndex(module_.zones.size())});
      module_.zones.push_back(table(unlike_others(name + "_slab_" + std::to_string(k + 1), {}),
                                    slab.snapped, slab.baked, slab.tree));
    }
    t.widest_mm = solid.widest.mm;
    t.widest_x_mm = solid.widest.at.x_mm;
    t.widest_y_mm = solid.widest.at.y_mm;
    t.widest_z_mm = solid.widest.z_mm;
    module_.zones.push_back(std::move(t));
    return ir::ZoneIndex(module_.zones.size() - 1);
  }

  const sema::Spec& spec_;
  const SourceManager& sources_;
  const std::vector<ZoneUse>& wanted_;
  const EvaluatedZones& evaluated_;
  ir::Module& module_;
  ir::TableMap& tables_;
};

}  // namespace

PointTables number_zones(const sema::Spec& spec, const SourceManager& sources,
                         const std::vector<ZoneUse>& wanted, const EvaluatedZones& evaluated,
                         ir::Module& module, ir::TableMap& tables) {
  return Numbering(spec, sources, wanted, evaluated, module, tables).run();
}

}  // namespace rtac::analysis
