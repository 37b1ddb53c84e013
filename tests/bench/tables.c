/* The kernel keeps its tables to itself. A second copy of its source, with the entry points
 * renamed, gives access to them without changing what is measured. Zones without a name are named
 * by their line: 63 in the study, 88 with the fence of 100 vertices. */
#define robot_delivery_plan_executor_init bench_copy_init
#define robot_delivery_plan_executor_step bench_copy_step
#define robot_delivery_motion_planner_judge bench_copy_judge
#define robot_delivery_leave_mm bench_copy_leave_mm
#define robot_delivery_border_of bench_copy_border_of
#define robot_delivery_free_area bench_copy_free_area
#define robot_delivery_zone_of_line_63_area bench_copy_zone_of_line_63_area
#define robot_delivery_zone_of_line_88_area bench_copy_zone_of_line_88_area
#define robot_delivery_zone_of_line_88_area bench_copy_zone_of_line_88_area
#include "robot_delivery_kernel.c"

#include "tests/bench/tables.h"

void bench_tables_init(hand_tables* t) {
  int32_t edges_mm[4 * HAND_EDGES];
  const int32_t count = (int32_t)(sizeof zone_free_edges / sizeof zone_free_edges[0]);
  int32_t i, j;
  for (i = 0; i < count && i < HAND_EDGES; ++i) {
    const edge* e = &zone_free.edges[i];
    edges_mm[4 * i] = e->ax;
    edges_mm[4 * i + 1] = e->ay;
    edges_mm[4 * i + 2] = e->bx;
    edges_mm[4 * i + 3] = e->by;
  }
  hand_zone_init(&t->zone, edges_mm, count);
  for (j = 0; j < HAND_MONITORS + 2; ++j) {
    t->motions[j].speed = (double)plan_executor_motions[j].speed_mmps * 1e-3;
    t->motions[j].accel = (double)plan_executor_motions[j].accel_mmps2 * 1e-3;
    t->motions[j].recovery = plan_executor_motions[j].recovery;
  }
  for (j = 0; j < HAND_ROBOTS; ++j) {
    const cells* from = &cells_to_dock[j];
    hand_cells* to = &t->to_dock[j];
    to->ppm = from->value;
    to->origin_x = from->origin_x * 1e-3;
    to->origin_y = from->origin_y * 1e-3;
    to->cells_per_m = 1e3 / from->cell_mm;
    to->columns = from->columns;
    to->rows = from->rows;
    to->dock.x = from->site_x * 1e-3;
    to->dock.y = from->site_y * 1e-3;
    to->per_m = from->drive_ppm_per_m * 1e-6;
  }
}
