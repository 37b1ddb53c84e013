// Out of what a zone leaves out around a block that stands free: the search of the runtime keeps
// what is asked of the block, wherever that is said of it, and it is said of nothing else.
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "compiler/recheck/free_blocks.h"
#include "rtac/safe/space.h"
#include "tests/compiler/geometry/testing.h"
#include "tests/compiler/geometry/zone_view.h"
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

using geometry::Region;
using geometry::Solid;
using recheck::FreeRoom;

class Looking : public safe::RetreatInSpace {
 public:
  using Legs = Carried::Legs;
  using Carried::sway_m;
  using RetreatInSpace::look;
  using RetreatInSpace::RetreatInSpace;
};

Rational milli(std::int64_t mm) {
  return geometry::q(mm, 1000);
}

// A hut of 2 m by 4 m in a box of air, all in mm.
struct Scene {
  std::int64_t left = 8000, right = 8000, low = 8000, top = 8000;  // from the hut to the walls
  std::int64_t height = 3000, ceiling = 9000, wide = 2000, deep = 4000;
  std::int64_t grown = 1000, asked = 1000, radius = 200;
  bool bent = false;       // an L in place of a rectangle
  bool hanging = false;    // off the ground
  bool covered = false;    // by a roof beside it
  std::int64_t other = 0;  // another one, so high, by the walls
  bool in_two = false;     // with a step in its wall
  static constexpr std::int64_t back = 600;

  [[nodiscard]] Solid hut() const {
    Region base = geometry::box(0, 0, wide, deep);
    if (bent) base = base.subtract(geometry::box(1000, 2000, 2000, 4000));
    Solid hut = Solid::prism(base, milli(hanging ? 500 : 0), milli(height));
    if (in_two) hut = hut.unite(Solid::prism(geometry::box(-200, 0, 0, 4000), 0, milli(1000)));
    return hut;
  }
  [[nodiscard]] Solid air() const {
    const Region plot = geometry::box(-left, -low, wide + right, deep + top);
    Solid air = Solid::prism(plot, 0, milli(ceiling));
    if (covered) {
      air = air.subtract(
          Solid::prism(geometry::box(-4000, 0, -2000, 2000), milli(3500), milli(5000)));
    }
    if (other > 0) {
      const std::int64_t x = wide + right - 300, y = deep + top - 300;
      air = air.subtract(Solid::prism(geometry::box(x - 300, y - 300, x, y), 0, milli(other)));
    }
    return air;
  }
  [[nodiscard]] Solid fence() const { return air().subtract(hut()); }
  [[nodiscard]] Solid zone() const {
    return air().subtract(hut().grow(milli(grown), milli(grown)));
  }
  // Where bodies are that have what is asked of the hut and the air, and reach out of the zone.
  [[nodiscard]] Solid starts() const {
    const Rational r = milli(radius), off = milli(radius + asked);
    return air()
        .shrink(r, r)
        .intersect(Solid::everywhere().subtract(hut()).shrink_by_ball(off))
        .subtract(zone().shrink(r, r))
        .intersect(air().subtract(zone()).grow(r, r));
  }
};

// A zone as the robot has it.
class Flown {
 public:
  explicit Flown(const Solid& zone) {
    const auto snapped = geometry::snap_inside(zone);
    for (const geometry::SnappedSlab& slab : *snapped) {
      baked_.push_back(std::make_unique<geometry::BakedZone>(geometry::bake(slab.zone, 100)));
      views_.push_back(std::make_unique<geometry::View>(*baked_.back()));
      slabs_.push_back({&**views_.back(), 1e-3 * slab.floor_mm, 1e-3 * slab.ceiling_mm});
    }
    view_ = {"zone", slabs_.data(), slabs_.size()};
  }
  [[nodiscard]] const SolidView& operator*() const { return view_; }

 private:
  std::vector<std::unique_ptr<geometry::BakedZone>> baked_;  // which views point to
  std::vector<std::unique_ptr<geometry::View>> views_;
  std::vector<SlabView> slabs_;
  SolidView view_;
};

safe::Setting setting_of(const Scene& scene, const SolidView& zone) {
  safe::Setting s;
  s.limits.speed_mps = 1, s.limits.accel_mps2 = 2, s.limits.brake_mps2 = 2;
  s.limits.radius_m = 1e-3 * static_cast<double>(scene.radius), s.limits.latency_us = 20'000;
  s.limits.in_space = true;
  s.period_us = 50'000, s.speed_mps = 0.3, s.solid = &zone;
  s.route_clearance_m = 0.4, s.return_clearance_m = 1e-3 * Scene::back;
  return s;
}
// What is said of the scene.
bool is_free(const Scene& scene) {
  const Flown zone(scene.zone());
  const double sway_m = Looking(setting_of(scene, *zone)).sway_m();
  const FreeRoom room{milli(scene.radius), milli(scene.asked),
                      milli(Scene::back + std::lround(1000 * sway_m) + 1)};
  return recheck::beside_free_blocks(scene.zone(), scene.fence(), room, scene.starts());
}

// Of ways from places where the robot has what is asked of the hut, and is not in the zone, the
// most that is lost of that, m.
struct Lost {
  double most_m = 0;
  int ways = 0, none = 0;  // none: no way was found
};
Lost lost_in(const Scene& scene, std::mt19937& random, int count) {
  const Flown zone(scene.zone());
  Looking retreat(setting_of(scene, *zone));
  const auto metres = [](std::int64_t mm) { return 1e-3 * static_cast<double>(mm); };
  const double radius_m = metres(scene.radius), asked_m = radius_m + metres(scene.asked);
  const double beside_m = metres(scene.grown) + radius_m, height_m = metres(scene.height);
  const double wide_m = metres(scene.wide), deep_m = metres(scene.deep);
  const auto off_hut_m = [&](Vec3 p) {
    return norm({std::max({-p.x, p.x - wide_m, 0.0}), std::max({-p.y, p.y - deep_m, 0.0}),
                 std::max(p.z - height_m, 0.0)});
  };
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Lost lost;
  for (int tries = 0; lost.ways < count && tries < 1000 * count; ++tries) {
    // within the air, by the radius, near the hut
    const Vec3 from{
        draw(std::max(-beside_m, radius_m - metres(scene.left)),
             wide_m + std::min(beside_m, metres(scene.right) - radius_m)),
        draw(std::max(-beside_m, radius_m - metres(scene.low)),
             deep_m + std::min(beside_m, metres(scene.top) - radius_m)),
        draw(radius_m, std::min(height_m + beside_m, metres(scene.ceiling) - radius_m))};
    if (off_hut_m(from) < asked_m || signed_clearance(*zone, from) >= radius_m) continue;
    ++lost.ways;
    Looking::Legs legs;
    retreat.look(0, from, legs);
    lost.none += legs.empty() ? 1 : 0;
    Vec3 at = from;
    for (const Vec3 to : legs) {
      for (int i = 0; i <= 200; ++i) {
        lost.most_m = std::max(lost.most_m, asked_m - off_hut_m(at + (i / 200.0) * (to - at)));
      }
      at = to;
    }
  }
  return lost;
}

TEST(FreeStanding, NoWayOfTheSearchComesNearerThanIsAsked) {
  std::mt19937 random(7);
  const auto any = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  constexpr int scenes = 40, ways = 40;
  int free = 0, looked = 0;
  for (int i = 0; i < scenes; ++i) {
    Scene scene;
    for (std::int64_t* far : {&scene.left, &scene.right, &scene.low, &scene.top})
      *far = any(3000, 12'000);
    scene.height = any(200, 4000);
    scene.ceiling = std::max<std::int64_t>(1400, scene.height + any(0, 9000));  // with places
    scene.grown = any(300, 2000), scene.asked = any(0, scene.grown), scene.radius = any(100, 400);
    if (any(0, 1) == 0) scene.other = any(200, scene.ceiling - 200);
    scene.wide = any(1000, 40'000), scene.deep = any(1000, 40'000);
    if (!is_free(scene)) continue;
    ++free;
    const Lost lost = lost_in(scene, random, ways);
    looked += lost.ways;
    // less than the centimetre that a hold has room for
    EXPECT_LE(lost.most_m, 9.5e-3) << "scene " << i;
    EXPECT_EQ(lost.none, 0) << "scene " << i;
  }
  EXPECT_GT(free, scenes / 8);
  EXPECT_GT(looked, free * ways / 2);
}

// Where the roof is low and one side narrow, a way leads level across the roof.
TEST(FreeStanding, AWayAcrossALowRoofIsNotSaidToKeepOff) {
  Scene scene;
  scene.left = 950, scene.ceiling = 4050, scene.radius = 100;
  EXPECT_FALSE(is_free(scene));
  std::mt19937 random(7);
  EXPECT_GT(lost_in(scene, random, 1000).most_m, 0.1);
}

// Along level legs it would look, piece by piece, until it may not look any more.
TEST(FreeStanding, OverAWideRoofItGoesStraightUp) {
  Scene scene;
  scene.wide = scene.deep = 36'000;
  for (const std::int64_t asked : {scene.asked, std::int64_t{0}}) {
    scene.asked = asked;
    EXPECT_TRUE(is_free(scene));
    std::mt19937 random(7);
    const Lost lost = lost_in(scene, random, 200);
    EXPECT_EQ(lost.ways, 200);
    EXPECT_EQ(lost.none, 0);
    EXPECT_LE(lost.most_m, 9.5e-3);
  }
}

TEST(FreeStanding, ABlockIsUprightAndConvexAndHasRoomAllAround) {
  const auto with = [](const auto& change) {
    Scene scene;
    change(scene);
    return is_free(scene);
  };
  ASSERT_TRUE(with([](Scene&) {}));
  EXPECT_TRUE(with([](Scene& s) { s.other = 1500; }));
  EXPECT_TRUE(with([](Scene& s) { s.other = 4700; }));  // a little higher
  EXPECT_TRUE(with([](Scene& s) { s.height = 500; }));  // below what it looks for
  EXPECT_FALSE(with([](Scene& s) { s.left = 2500; }));
  EXPECT_FALSE(with([](Scene& s) { s.top = 2500; }));
  EXPECT_TRUE(with([](Scene& s) { s.ceiling = 3000; }));  // up to it
  EXPECT_FALSE(with([](Scene& s) { s.ceiling = 5300; }));
  EXPECT_FALSE(with([](Scene& s) { s.bent = true; }));
  EXPECT_FALSE(with([](Scene& s) { s.hanging = true; }));
  EXPECT_FALSE(with([](Scene& s) { s.covered = true; }));
  EXPECT_FALSE(with([](Scene& s) { s.in_two = true; }));
  EXPECT_FALSE(with([](Scene& s) { s.radius = 450; }));
  EXPECT_FALSE(with([](Scene& s) { s.grown = 8000, s.left = s.right = s.low = s.top = 14'000; }));
}

// A drone that its monitor keeps 1 m off a hut, and its retreat within what is `left` of the air.
std::string flight(const std::string& plot, const std::string& left) {
  return "spec flight;\nzone air = prism (" + plot +
         ") from 0 m to 12 m;\n"
         "zone hut = prism (rectangle (0 m, 0 m) to (2 m, 4 m)) from 0 m to 3 m;\n"
         "zone away = " +
         left + ";\n" + edited(edited(a_quad, "30 cm", "20 cm"), "speed <= 3", "speed <= 1") +
         "controller off : safe for Quad = retreat within away speed 0.3 m/s;\n"
         "monitor walls for r : Quad { \"R1\" always r inside air; recover off; }\n"
         "monitor hut_off for r : Quad { \"R2\" always distance(r, hut) >= 1 m; recover off; }\n"
         "decision fly for Quad { advanced policy; period 50 ms; priority hut_off > walls; }\n";
}
constexpr const char* wide = "rectangle (-14 m, -14 m) to (16 m, 18 m)";
constexpr const char* narrow = "rectangle (-3.5 m, -14 m) to (16 m, 18 m)";

class FreeStandingPages : public Verify {};

TEST_F(FreeStandingPages, ARetreatOutOfMoreThanIsAskedIsProvedAndFoundOnceMore) {
  const std::string near = flight(wide, "air - grow(hut, 1 m)");
  const std::string pages[] = {
      near, flight(wide, "air - grow(hut, 2 m)"),
      flight("rectangle (-150 m, -150 m) to (150 m, 150 m)", "air - grow(hut, 2 m)"),
      edited(near, "from 0 m to 3 m", "from 0 m to 60 cm"),
      // two of somewhat different heights
      edited(
          edited(edited(flight("rectangle (-30 m, -30 m) to (30 m, 30 m)", "air - grow(huts, 1 m)"),
                        "zone away",
                        "zone huts = hut | prism (rectangle (14 m, 16 m) to (16 m, 17 m)) "
                        "from 0 m to 3.5 m;\nzone away"),
                 "(r, hut)", "(r, huts)"),
          "to 12 m", "to 15 m")};
  for (const std::string& page : pages) {
    const Outcome o = verified(page, {"-o", "proofs"});
    EXPECT_EQ(o.status, exit_clean) << page << o.out << o.err;
    EXPECT_EQ(rtac({"verify", "--recheck", "proofs"}).status, exit_clean) << page;
  }
}

// What recoveries look for there is the same wherever it is looked at once more.
TEST_F(FreeStandingPages, WhatIsProvedIsFoundOnceMoreWhateverElseMovesThere) {
  const std::string page = edited(flight(wide, "air - grow(hut, 1 m)"), "to 12 m", "to 9.6 m");
  const std::string another =
      "controller other : safe for Quad = loiter within away speed 0.6 m/s;\n";
  const std::string variants[] = {
      edited(page, "recover off; }\nmonitor hut_off",
             "recover off; return when clearance(r, air) >= 2 m; }\nmonitor hut_off"),
      edited(page, "= retreat within away speed 0.3", "= loiter within away speed 1"),
      edited(edited(page, "monitor walls", another + "monitor walls"), "r inside air; recover off",
             "r inside air; recover other")};
  for (const std::string& each : variants) {
    (void)verified(each, {"-o", "proofs"});
    const Outcome again = rtac({"verify", "--recheck", "proofs"});
    EXPECT_NE(again.status, exit_violation) << each << again.out << again.err;
  }
}

// What holds of a hut that stands free is denied of one that does not, and not proved of it.
TEST_F(FreeStandingPages, BesideAWallItIsDenied) {
  (void)verified(flight(wide, "air - grow(hut, 1 m)"), {"-o", "certificates"});
  const std::string other = flight(narrow, "air - grow(hut, 1 m)");
  write("certificates/sources/spec.rta", other);
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_violation) << again.out << again.err;
  const std::string why =
      "from outside of its zone the recovery may lead across what is not convex";
  EXPECT_NE((again.out + again.err).find(why), std::string::npos) << again.out << again.err;
  const Outcome o = verified(other);
  EXPECT_EQ(o.status, exit_inconclusive) << o.out;
  const std::string because =
      "from outside of `away` it makes straight for it, and is not shown to stay in "
      "`complement(hut)` on its way, which is not convex: `away` has to go on for ";
  EXPECT_NE(o.out.find(because), std::string::npos) << o.out;
}

}  // namespace
}  // namespace rtac::driver::test
