// What is said of ways out is held against the search that recoveries drive by: from wherever the
// look-ahead lets a robot stop no way leads nearer to a zone that comes and goes than is asked, in
// all that the compiler accepts, and so wherever the recheck agrees to `leaves`.
#include <random>

#include "compiler/driver/compile.h"
#include "compiler/recheck/leaving.h"
#include "rtac/safe/grid_route.h"
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

struct Rect {
  int left, low, right, top;  // mm
  [[nodiscard]] double off_m(Vec2 p) const {
    const double x = std::max({left * 1e-3 - p.x, 0.0, p.x - right * 1e-3});
    const double y = std::max({low * 1e-3 - p.y, 0.0, p.y - top * 1e-3});
    return std::hypot(x, y);
  }
  [[nodiscard]] double off_m(Vec2 a, Vec2 b) const {
    double least = off_m(b);
    const int steps = 1 + static_cast<int>(norm(b - a) / 2e-3);
    for (int k = 0; k < steps; ++k) least = std::min(least, off_m(a + (1.0 * k / steps) * (b - a)));
    return least;
  }
  [[nodiscard]] std::string text() const {
    const auto m = [](int mm) { return std::to_string(mm) + " mm"; };
    return "rectangle (" + m(left) + ", " + m(low) + ") to (" + m(right) + ", " + m(top) + ")";
  }
};

struct Scene {
  bool wheels = false;
  Rect room{}, lessons{};
  int home_x = 0, home_y = 0, asked_mm = 0, walls_mm = 0, speed_mmps = 300;
};
constexpr double radius_m = 0.1;
constexpr int scenes_most = 100, places_most = 400;

std::string text_of(const Scene& s) {
  const std::string point = R"(
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  output   drive : acceleration;)";
  const std::string wheels = R"(
  motion   unicycle { speed <= 0.5 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 10 rad/s^2; }
  sense    heading  : angle  error 0.01 rad max_age 20 ms;
  output   drive : twist;)";
  const auto mm = [](int n) { return std::to_string(n) + " mm"; };
  return "spec scene;\nclock utc;\nzone room = " + s.room.text() +
         ";\nzone lessons = " + s.lessons.text() +
         " during monday 08:00 .. 16:00;\nrobot Cart {\n  body radius 10 cm;\n" +
         (s.wheels ? wheels : point) + R"(
  sense    position : point  error 1 cm   max_age 20 ms;
  sense    velocity : vector error 1 cm/s max_age 20 ms;
  latency  10 ms;
}
fleet cart : Cart;
site home = ()" +
         mm(s.home_x) + ", " + mm(s.home_y) + R"();
controller pilot   : advanced for Cart extern;
controller go_home : safe for Cart = route to home within room speed )" +
         std::to_string(s.speed_mmps) + R"( mm/s;
monitor quiet for c : Cart { "R1: off" always distance(c, lessons) >= )" +
         mm(s.asked_mm) + R"(; recover go_home; }
monitor walls for c : Cart { "R2: in" always clearance(c, room) >= )" +
         mm(s.walls_mm) + R"(; recover go_home; }
decision go for Cart { advanced pilot; period 20 ms; priority quiet > walls; }
)";
}

class Scenes {
 public:
  explicit Scenes(unsigned seed) : random_(seed) {}
  Scene next() {
    Scene s;
    s.wheels = any(0, 2) == 0;
    const int wide = any(0, 9) == 0 ? 30'000 : 4'000;  // now and then with wider cells
    s.room = {any(-500, 500), any(-500, 500), 0, 0};
    s.room.right = s.room.left + any(wide, 3 * wide),
    s.room.top = s.room.low + any(2'000, 2 * wide);
    const auto share = [&](int from, int to, int percent) {
      return from + (to - from) / 100 * percent;
    };
    s.home_x = share(s.room.left, s.room.right, any(15, 40));
    s.home_y = share(s.room.low, s.room.top, any(20, 60));
    s.asked_mm = any(0, 3) == 0 ? 0 : any(0, 600);
    s.walls_mm = any(0, 2) == 0 ? 0 : any(0, 500);
    s.speed_mmps = any(100, 300);
    s.lessons = zone_in(s.room);
    return s;
  }
  // Near the zone, near the walls, or anywhere.
  Vec2 place(const Scene& s) {
    const Rect& r = s.room;
    Vec2 p{any(r.left, r.right) * 1e-3, any(r.low, r.top) * 1e-3};
    const double near = radius_m + s.asked_mm * 1e-3 + any(0, 200) * 1e-3;
    if (any(0, 2) == 0)
      p.x = any(0, 1) == 0 ? s.lessons.left * 1e-3 - near : s.lessons.right * 1e-3 + near;
    if (any(0, 2) == 0)
      p.y = any(0, 1) == 0 ? s.lessons.low * 1e-3 - near : s.lessons.top * 1e-3 + near;
    const double wall = radius_m + s.walls_mm * 1e-3 + any(0, 700) * 1e-3;
    if (any(0, 2) == 0) p.y = any(0, 1) == 0 ? r.low * 1e-3 + wall : r.top * 1e-3 - wall;
    if (any(0, 5) == 0) p.x = any(0, 1) == 0 ? r.left * 1e-3 + wall : r.right * 1e-3 - wall;
    return p;
  }

 private:
  int any(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
  Rect zone_in(const Rect& room) {
    const int x = any((room.left + room.right) / 2, room.right), y = any(room.low, room.top);
    const int beyond = any(0, 1) * any(0, 800);
    Rect zone{x, room.low - beyond, room.right + beyond, room.top + beyond};  // a strip
    const int kind = any(0, 5);
    if (kind < 2) zone.low = y;                                              // a corner
    if (kind == 2) zone = {x, room.top, room.right, room.top + 1'000};       // beyond a wall
    if (kind == 3) zone = {x, y, x + any(300, 3'000), y + any(300, 3'000)};  // anywhere
    return zone;
  }
  std::mt19937 random_;
};

// The view that generated code gives the controllers.
class View {
 public:
  explicit View(const ir::ZoneTable& zone) {
    for (const ir::Edge& e : zone.edges) edges_.insert(edges_.end(), {e.ax, e.ay, e.bx, e.by});
    view_.edges_mm = edges_.data();
    view_.edge_count = zone.edges.size();
    view_.origin_x_mm = zone.cells.origin_x_mm;
    view_.origin_y_mm = zone.cells.origin_y_mm;
    view_.cell_mm = zone.cells.cell_mm;
    view_.columns = zone.cells.columns;
    view_.rows = zone.cells.rows;
    view_.clearance_mm_lo = zone.cells.clearance_mm_lo.data();
  }
  [[nodiscard]] const ZoneView& operator*() const { return view_; }

 private:
  std::vector<std::int32_t> edges_;
  ZoneView view_;
};

std::optional<recheck::Doubt> doubt_of(const Compilation& c) {
  const ir::Decision& d = c.module->decisions.front();
  const ir::Recovery& r = d.monitors.front().recovery;
  const ir::Cells& cells = (*c.module)[r.zone].cells;
  const auto text = [](std::int64_t n) { return std::to_string(n); };
  recheck::Claims claims(*c.spec, c.sources, [](const std::string&) { return std::nullopt; });
  return recheck::check_leaving(*c.spec, c.spec->decisions.front(), claims,
                                (*c.spec)[c.spec->decisions.front().priority.front()],
                                {{"zone", "room"},
                                 {"cell_mm", text(cells.cell_mm)},
                                 {"cells_x_mm", text(cells.origin_x_mm)},
                                 {"cells_y_mm", text(cells.origin_y_mm)},
                                 {"starts_mm", text(d.body.radius_mm + r.leave_least_mm)},
                                 {"route_mm", text(r.route_clearance_mm)},
                                 {"leave_us", text(r.leave_us)}});
}

struct Study {
  int accepted = 0, agreed = 0, wheels = 0, ways = 0, joined = 0;
};

void drive(const Scene& s, const ir::Module& module, bool agreed, Scenes& scenes, Study& study) {
  const ir::Recovery& r = module.decisions.front().monitors.front().recovery;
  const View view(module[r.zone]);
  safe::GridRoute route(*view);
  const ir::Body& body = module.decisions.front().body;
  const double asked = radius_m + s.asked_mm * 1e-3,
               route_m = static_cast<double>(r.route_clearance_mm) * 1e-3,
               stops = asked + static_cast<double>(r.leave_beside_mm + body.hold_mm) * 1e-3;
  const Vec2 home{s.home_x * 1e-3, s.home_y * 1e-3};
  for (int k = 0; k < places_most; ++k) {
    const Vec2 p = scenes.place(s);
    const double off = s.lessons.off_m(p);
    if (off < stops || signed_clearance(*view, p) < radius_m + s.walls_mm * 1e-3) continue;
    Path way;
    if (!route.to_point({route_m, p, {}, {}}, home, way)) continue;
    double least = off;
    Vec2 from = p;
    for (const Vec2 to : way.points) {
      least = std::min(least, s.lessons.off_m(from, to));
      from = to;
    }
    ++study.ways;
    study.joined += way.points.size() > 1 ? 1 : 0;
    if (agreed) {
      EXPECT_LE(way.points.size(), 2U) << text_of(s);
    }
    EXPECT_GE(least, asked) << "from " << p.x << ", " << p.y << "\n" << text_of(s);
    if (testing::Test::HasFailure()) return;
  }
}

class WaysOut : public Verify {};

TEST_F(WaysOut, LeadNoNearerThanIsClaimed) {
  Scenes scenes(7);
  Study study;
  for (int k = 0; k < scenes_most; ++k) {
    const Scene s = scenes.next();
    write("scene.rta", text_of(s));
    Options options;
    options.spec = "scene.rta";
    std::ostringstream out;
    Compilation c;
    compile(options, out, c);
    if (!c.spec || !c.module || c.spec->decisions.empty() || c.module->decisions.empty()) continue;
    if (c.diagnostics.has_errors()) continue;
    const bool agreed = !doubt_of(c);
    ++study.accepted;
    study.agreed += agreed ? 1 : 0;
    study.wheels += s.wheels && agreed ? 1 : 0;
    drive(s, *c.module, agreed, scenes, study);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(study.accepted, study.agreed);
  EXPECT_GT(study.agreed - study.wheels, 3);
  EXPECT_GT(study.wheels, 3);
  EXPECT_GT(study.joined, 300);
}

}  // namespace
}  // namespace rtac::driver::test
