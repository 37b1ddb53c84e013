#include "compiler/codegen/kernel_areas.h"

#include <algorithm>

namespace rtac::codegen {
namespace {

void record(Code& out, const std::string& name, const std::vector<std::string>& fields) {
  out.block(
      "typedef struct " + name,
      [&](Code& body) {
        for (const std::string& field : fields) body.line(field);
      },
      "} " + name + ";");
  out.blank();
}

}  // namespace

bool has_areas(const ir::Module& module) {
  return std::any_of(module.zones.begin(), module.zones.end(),
                     [](const ir::ZoneTable& z) { return !z.tree.words.empty(); });
}

std::string area_symbol(const ir::Module& module, const ir::ZoneTable& zone, const Names& names) {
  return module.name + "_" + names(zone.name) + "_area";
}

void print_area_declarations(const ir::Module& module, const Names& names, Code& out) {
  if (!has_areas(module)) return;
  const std::string& p = module.name;
  out.comment(
      "A zone as its checks have it: six numbers an edge, ax ay bx by in mm, the zone on the left, "
      "and its direction in Q30; cells that tell which edges matter where (rtac/zone_table.h). "
      "exact: distances below are those of edges.");
  record(out, p + "_area",
         {"const int32_t *edges;", "const uint32_t *cells, *lists;",
          "int32_t edge_count, cell_count, list_count;",
          "int32_t x, y, shift, column, row, columns, rows, depth, leaves;", "int32_t exact;"});
  for (const ir::ZoneTable& zone : module.zones) {
    if (zone.has_height()) continue;
    out.line("extern const " + p + "_area " + area_symbol(module, zone, names) + ";");
  }
  out.blank();
  out.comment(
      "How far in mm a disc, or for radius 0 a place, may move from (x, y) to (to_x, to_y): at "
      "most "
      "as far as it stays in the zone without touching the boundary; 0: not at all; INT64_MAX: all "
      "the way. A place less than 3 mm short of that; a disc before 2 mm more would bring it to a "
      "place where it has less than 5 mm to spare. Divided by its speed, the time to leave.");
  out.line("int64_t " + p + "_leave_mm(const " + p + "_area *zone, int64_t x, int64_t y,");
  out.line("    int64_t to_x, int64_t to_y, int64_t radius_mm);");
  out.blank();
  out.comment(
      "Where the boundary is nearest to a place: (x, y) of it, within 1 mm up to 10 km, else 3; a "
      "unit vector in Q30, outside towards it, inside away from it, on it into the zone; bounds of "
      "the distance. nearest 0: of a place that is too far away for exact distances, (x, y) is a "
      "place of the boundary in some direction.");
  record(out, p + "_border",
         {"int64_t x, y;", "int64_t inward_x_q30, inward_y_q30;", "int64_t gap_mm_lo, gap_mm_hi;",
          "int32_t inside, nearest;"});
  out.line("void " + p + "_border_of(const " + p + "_area *zone, int64_t x, int64_t y,");
  out.line("    " + p + "_border *to);");
  out.blank();
}

void print_area(const ir::Module& module, const ir::ZoneTable& zone, const std::string& symbol,
                const Names& names, Code& out) {
  const ir::EdgeTree& t = zone.tree;
  const auto count = [](const auto& all) { return num(static_cast<std::int64_t>(all.size())); };
  out.block(
      "const " + module.name + "_area " + area_symbol(module, zone, names) + " =",
      [&](Code& body) {
        body.line("&" + symbol + "_edges[0].ax, " + symbol + "_cells, " +
                  (t.lists.empty() ? "0" : symbol + "_lists") + ",");
        body.line(count(zone.edges) + ", " + count(t.words) + ", " + count(t.lists) + ",");
        std::string fields;
        for (const std::int32_t f : {t.x_mm, t.y_mm, t.shift, t.column, t.row, t.columns, t.rows,
                                     t.depth, t.leaves, t.exact_mm.value_or(INT32_MAX)}) {
          fields += (fields.empty() ? "" : ", ") + num(f);
        }
        body.line(fields);
      },
      "};");
  out.blank();
}

void use_areas(const ir::Module& module, std::set<std::string>& uses) {
  if (has_areas(module)) uses.insert({"area_leave", "area_border"});
}

}  // namespace rtac::codegen
