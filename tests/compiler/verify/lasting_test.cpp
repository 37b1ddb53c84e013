// What a charge pays for in advance is found once more: for how long other recoveries hold the
// robot, and how far they drive.
#include "compiler/recheck/zones.h"
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

// Two carts with batteries, which are held and driven for as long as is declared.
std::string carts() {
  return R"(spec detour;
zone yard = rectangle (0 m, 0 m) to (8 m, 8 m);

robot Cart {
  body     radius 10 cm;
  motion   unicycle { speed <= 0.3 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 10 rad/s^2; }
  sense    position : point   error 1 cm    max_age 100 ms;
  sense    heading  : angle   error 2 deg   max_age 100 ms;
  sense    velocity : vector  error 1 cm/s  max_age 100 ms;
  sense    battery  : ratio   error 1 %     max_age 2 s;
  hears    other robots       max_age 100 ms;
  output   drive    : twist;
  latency  20 ms;
  energy   { drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; charge >= 1 %/s at home; held <= 120 s; detour <= 4 m; }
}

fleet one, two : Cart;
site  home(one) = (1 m, 1 m);
site  home(two) = (3 m, 5 m);
controller explore  : advanced for Cart extern;
controller inwards  : safe for Cart = retreat within yard speed 0.2 m/s;
controller go_home  : safe for Cart = route to home within yard speed 0.2 m/s;
monitor walls   for c : Cart { "SR-1: in the yard" always c inside yard; recover inwards; }
monitor charged for c : Cart { "SR-2: home again" always c.battery >= energy_to(home(c)) + 5 %; recover go_home; }
decision drive for Cart { advanced explore; period 100 ms; priority walls > charged; }
)";
}

class Lasting : public Verify {
 protected:
  void prove(const std::string& text) {
    const Outcome o = verified(text, {"-o", "certificates"});
    ASSERT_EQ(o.status, exit_clean) << o.out << o.err;
    report_ = Json::parse(read("certificates/verification.json"));
    source_ = read("certificates/sources/spec.rta");
  }
  static Outcome rechecked() { return recheck_sealed_anew(); }
  Outcome with_source(const std::string& from, const std::string& to) {
    write("certificates/sources/spec.rta", edited(source_, from, to));
    Outcome o = rechecked();
    write("certificates/sources/spec.rta", source_);
    return o;
  }
  static Outcome with_report(const Json& report) {
    write("certificates/verification.json", report.dump());
    return rechecked();
  }
  // The claims of one kind, to be changed.
  static std::vector<Json*> claims_of(Json& report, const std::string& kind) {
    std::vector<Json*> found;
    for (Json& o : report["decisions"][0]["obligations"]) {
      for (Json& c : o["claims"]) {
        if (c["claim"] == kind) found.push_back(&c);
      }
    }
    return found;
  }
  Json report_;
  std::string source_;
};

// Wheels, and a point mass.
TEST_F(Lasting, TheEndOfARecoveryIsFoundOnceMore) {
  prove(carts());
  EXPECT_EQ(claims_of(report_, "lasts").size(), 1U);
  Outcome o = rechecked();
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  prove(edited(carts(), "= retreat within", "= loiter within"));
  o = rechecked();
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  prove(edited(edited(carts(),
                      "unicycle { speed <= 0.3 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 "
                      "m/s^2; turn_accel <= 10 rad/s^2; }",
                      "point { speed <= 0.3 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }"),
               "drive    : twist", "drive    : acceleration"));
  EXPECT_EQ(claims_of(report_, "lasts").size(), 1U);
  o = rechecked();
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

// Sources beside the certificate that reckon with less, or have the recovery take longer.
TEST_F(Lasting, AnEnergyClauseThatReckonsWithLessIsNoticed) {
  prove(carts());
  for (const auto& [from, to, why] :
       {std::tuple("held <= 120 s", "held <= 9 s", "last longer than `held`"),
        std::tuple("detour <= 4 m", "detour <= 10 cm", "drive further than `detour`"),
        std::tuple("inwards  : safe for Cart = retreat within yard speed 0.2",
                   "inwards  : safe for Cart = retreat within yard speed 0.02", "last longer"),
        std::tuple("accel <= 1 m/s^2", "accel <= 0.5 m/s^2", "it may drive further")}) {
    const Outcome o = with_source(from, to);
    EXPECT_EQ(o.status, exit_violation) << to;
    EXPECT_NE((o.out + o.err).find(why), std::string::npos) << to << "\n" << o.out << o.err;
  }
}

// The way of a recovery is found over the cells of its zone: where it may take over outside of
// that, it takes more charge than the claim says, and may take any.
constexpr const char* in_yard = R"(within yard speed 0.2 m/s;
monitor walls   for c : Cart { "SR-1: in the yard" always c inside yard; recover inwards;)";
constexpr const char* in_hall = R"(within hall speed 0.2 m/s;
zone hall = rectangle (-5 m, -5 m) to (13 m, 13 m);
monitor walls   for c : Cart { "SR-1: in the hall" always c inside hall; recover inwards; return when c inside yard;)";
TEST_F(Lasting, WhatBeginsOutsideOfTheZoneIsNotReckonedWith) {
  prove(carts());
  const Outcome o = with_source(in_yard, in_hall);
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_NE((o.out + o.err).find("it may begin outside of its zone"), std::string::npos) << o.out;
}
TEST_F(Lasting, WhatBeginsOutsideOfTheZoneKeepsNoCharge) {
  const Outcome o = verified(edited(carts(), in_yard, in_hall));
  EXPECT_NE(o.status, exit_clean) << o.out << o.err;
  EXPECT_NE(o.out.find("from outside of `yard` `inwards` makes straight for it, and nothing bounds "
                       "how much charge that takes"),
            std::string::npos)
      << o.out;
  EXPECT_NE(o.out.find("a monitor that keeps robots inside `yard` works"), std::string::npos)
      << o.out;
}

// What circles drives on while a condition of return needs its time, and so does an earlier step of
// a sequence: with less of a detour neither is proved.
TEST_F(Lasting, WhatItDrivesWhileItWaitsIsADetour) {
  const auto hall = [](const std::string& recovery, const std::string& detour) {
    return R"(spec laps;
zone hall = rectangle (0 m, 0 m) to (30 m, 6 m);
zone east = rectangle (26 m, 0 m) to (30 m, 6 m);
robot Cart {
  body     radius 10 cm;
  motion   point { speed <= 0.6 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 1 cm    max_age 100 ms;
  sense    velocity : vector  error 1 cm/s  max_age 100 ms;
  sense    battery  : ratio   error 1 %     max_age 2 s;
  output   thrust   : acceleration;
  latency  20 ms;
  energy   { drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.1 %/s; charge >= 1 %/s at home;
             held <= 300 s; detour <= )" +
           detour + R"(; }
}
fleet one : Cart;
site  home(one) = (3 m, 3 m);
controller explore : advanced for Cart extern;
controller inwards : safe for Cart = )" +
           recovery + R"(;
controller go_home : safe for Cart = route to home within hall speed 0.4 m/s;
monitor walls for c : Cart {
  "SR-1" always c inside hall; recover inwards;
  return when historically[0 s, 40 s] (clearance(c, hall) >= 50 cm);
}
monitor charged for c : Cart {
  "SR-2" always c.battery >= energy_to(home(c)) + 5 %; recover go_home;
}
decision drive for Cart { advanced explore; period 100 ms; priority walls > charged; }
)";
  };
  for (const std::string recovery :
       {"loiter within hall speed 0.4 m/s",
        "sequence retreat within east speed 0.4 m/s for 50 s then retreat within hall speed "
        "0.4 m/s"}) {
    prove(hall(recovery, "60 m"));
    const Outcome less = with_source("detour <= 60 m", "detour <= 30 m");
    EXPECT_EQ(less.status, exit_violation) << less.out << less.err;
    const Outcome o = verified(hall(recovery, "30 m"), {"--format", "json"});
    EXPECT_EQ(statuses(o.out, "C", "charged"), Statuses{"unknown"}) << recovery << o.out;
  }
}

TEST_F(Lasting, AMutatedBoundIsNoticed) {
  prove(carts());
  for (const auto& [key, by] :
       {std::pair("held_us", -1'000), std::pair("way_mm", -1), std::pair("starts_mm", 10),
        std::pair("aim_mm", -1), std::pair("return_mm", -60), std::pair("cell_mm", 10),
        std::pair("held_us", 300'000'000), std::pair("leg_mm", 3'000)}) {
    Json report = report_;
    for (Json* const c : claims_of(report, "lasts")) {
      (*c)[key] = std::to_string(std::stoll((*c)[key].get<std::string>()) + by);
    }
    const Outcome o = with_report(report);
    EXPECT_EQ(o.status, exit_violation) << key << " " << by << "\n" << o.out << o.err;
  }
}

// In a yard without narrow parts a retreat takes one leg that is in sight, and no way over cells:
// for a shorter leg there are places that are farther off, and where a passage leads to a room, no
// leg is always in sight.
TEST_F(Lasting, AnEndInSightTakesOneLeg) {
  prove(carts());
  const auto with_leg = [&](const std::function<std::int64_t(std::int64_t)>& change) {
    Json report = report_;
    for (Json* const c : claims_of(report, "lasts")) {
      const std::int64_t leg_mm = std::stoll(c->value("leg_mm", "700"));
      (*c)["leg_mm"] = std::to_string(change(leg_mm));
    }
    return with_report(report);
  };
  ASSERT_TRUE(claims_of(report_, "lasts")[0]->contains("leg_mm"));
  EXPECT_EQ(with_leg([](std::int64_t leg) { return leg; }).status, exit_clean);
  const Outcome shorter = with_leg([](std::int64_t leg) { return leg / 2; });
  EXPECT_EQ(shorter.status, exit_violation);
  EXPECT_NE((shorter.out + shorter.err).find("or a longer leg"), std::string::npos);
  EXPECT_EQ(with_leg([](std::int64_t leg) { return 100 * leg; }).status, exit_violation);

  prove(edited(edited(edited(carts(), "rectangle (0 m, 0 m) to (8 m, 8 m)",
                             "rectangle (0 m, 0 m) to (8 m, 8 m) | "
                             "rectangle (8 m, 0 m) to (12 m, 70 cm)"),
                      "held <= 120 s", "held <= 900 s"),
               "detour <= 4 m", "detour <= 22 m"));
  ASSERT_FALSE(claims_of(report_, "lasts")[0]->contains("leg_mm"));
  const Outcome sought = with_leg([](std::int64_t) { return 5'000; });
  EXPECT_EQ(sought.status, exit_violation);
  EXPECT_NE((sought.out + sought.err).find("a way over cells"), std::string::npos);
}

// Of a corner a retreat tries so many cells that few more would be too many: what the recheck
// cannot tell from a cell that is tried counts as one, so that a claim is always found once more.
TEST_F(Lasting, ALegAcrossManyCellsIsFoundOnceMore) {
  for (const char* const back : {"2.467 m", "2.667 m", "2.867 m"}) {
    prove(R"(spec far;
zone yard = polygon [(0 m, 0 m), (9 m, -3 m), (22 m, 5 m), (16 m, 17 m), (3 m, 11 m)];
site dock = (9 m, 6 m);
robot Cart {
  body    radius 30 cm;
  motion  point { speed <= 0.9 m/s; accel <= 0.8 m/s^2; brake >= 1.2 m/s^2; }
  sense   position : point  error 2 cm   max_age 100 ms;
  sense   velocity : vector error 2 cm/s max_age 100 ms;
  sense   battery  : ratio  error 1 %    max_age 2 s;
  output  push : acceleration;
  latency 50 ms;
  energy  { drive <= 0.3 %/m; idle <= 0.01 %/s; drain <= 0.5 %/s; charge >= 1 %/s at dock; held <= 60 s; detour <= 12 m; }
}
fleet cart : Cart;
controller explore : advanced for Cart extern;
controller inwards : safe for Cart = retreat within yard speed 0.4 m/s;
controller go_home : safe for Cart = route to dock within yard speed 0.5 m/s;
monitor walls for c : Cart { "SR-1" always c inside yard; recover inwards; return when clearance(c, yard) >= )" +
          std::string(back) + R"( for 1 s; }
monitor charged for c : Cart { "SR-2" always c.battery >= energy_to(dock) + 5 %; recover go_home; return when c.battery >= 80 %; }
decision drive for Cart { advanced explore; period 100 ms; priority walls > charged; }
)");
    const Outcome o = rechecked();
    EXPECT_EQ(o.status, exit_clean) << back << o.out << o.err;
  }
}

// What is printed is never exceeded.
TEST_F(Lasting, RunsEndWithinTheTimeOfALeg) {
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  const std::string alone =
      edited(edited(edited(carts(), "fleet one, two : Cart", "fleet one : Cart"),
                    "site  home(two) = (3 m, 5 m);\n", ""),
             "priority walls > charged", "priority walls");
  const std::string yard = "rectangle (0 m, 0 m) to (8 m, 8 m)";
  for (const std::string& zone :
       {yard, std::string("circle (0 m, 0 m) radius 3 m"),
        yard + " - rectangle (3 m, 3 m) to (5 m, 4 m)",
        std::string("polygon [(0 m, 0 m), (10 m, 2 m), (12 m, 12 m), (2 m, 10 m)]")}) {
    for (const char* const what : {"= retreat within", "= loiter within"}) {
      const std::string text = edited(edited(alone, yard, zone), "= retreat within", what);
      const Outcome o = verified(text, {"--format", "json"});
      const std::size_t at = o.out.find(" s in all");
      ASSERT_NE(at, std::string::npos) << zone << o.out;
      const std::size_t from = o.out.rfind(' ', at - 1) + 1;
      const std::string bound = o.out.substr(from, at - from);
      EXPECT_LE(std::stod(bound), 20) << zone;
      write("s.json",
            R"({"duration_s": 90, "runs": 20, "seed": 7, "return_within_s": )" + bound + "}");
      const Outcome run = rtac({"sim", "spec.rta", "--scenario", "s.json"});
      EXPECT_EQ(run.status, exit_clean) << zone << what << bound << run.out << run.err;
    }
  }
}

// A hall with racks, in whose aisles no place is as clear as a retreat asks for: it searches for a
// way, and the legs of that are few, whichever it finds. To be inside is kept without a margin, so
// that one who is seen with less than its body takes is led in first.
std::string aisles(const std::string& property) {
  return edited(edited(edited(edited(carts(), "rectangle (0 m, 0 m) to (8 m, 8 m)",
                                     "rectangle (0 m, 0 m) to (12 m, 9 m) - rectangle (4 m, "
                                     "2 m) to (10 m, 4 m) - rectangle (4 m, 4.8 m) to (10 m, "
                                     "7 m)"),
                              "c inside yard;", property),
                       "held <= 120 s", "held <= 180 s"),
                "detour <= 4 m", "detour <= 24 m");
}

// The same with a wall and a rack that slant.
std::string slanting(const std::string& property) {
  return edited(aisles(property),
                "rectangle (0 m, 0 m) to (12 m, 9 m) - rectangle (4 m, 2 m) to (10 m, 4 m)",
                "polygon [(0 m, 0 m), (12 m, 1 m), (12 m, 9 m), (0 m, 9 m)] - "
                "polygon [(4 m, 2.3 m), (10 m, 2.8 m), (10 m, 4 m), (4 m, 4 m)]");
}
std::string to_docks(const std::string& text) {
  return edited(edited(edited(edited(text, "retreat within", "route to home within"),
                              "site  home(two) = (3 m, 5 m)", "site  home(two) = (2 m, 7.5 m)"),
                       "detour <= 24 m", "detour <= 50 m"),
                "held <= 180 s", "held <= 300 s");
}

TEST_F(Lasting, TheLegsOfAWayAreCounted) {
  const std::string deep = "clearance(c, yard) >= 2 cm;", inside = "c inside yard;";
  for (const auto& [text, led] :
       {std::pair(aisles(deep), false), std::pair(aisles(inside), true),
        std::pair(slanting(deep), false), std::pair(slanting(inside), true),
        std::pair(to_docks(aisles(deep)), false), std::pair(to_docks(slanting(inside)), false)}) {
    prove(text);
    const std::vector<Json*> claims = claims_of(report_, "lasts");
    ASSERT_EQ(claims.size(), 1U) << text;
    ASSERT_TRUE(claims[0]->contains("legs")) << claims[0]->dump();
    EXPECT_EQ((*claims[0])["led_in_mm"] != "0", led) << claims[0]->dump();
    EXPECT_EQ(rechecked().status, exit_clean);
    for (const auto& [key, by] : {std::pair("legs", -1), std::pair("legs", -100),
                                  std::pair("legs", 20), std::pair("led_in_mm", -150),
                                  std::pair("led_in_mm", 30'000), std::pair("held_us", -100'000)}) {
      Json report = report_;
      for (Json* const c : claims_of(report, "lasts")) {
        (*c)[key] = std::to_string(std::stoll((*c)[key].get<std::string>()) + by);
      }
      const Outcome o = with_report(report);
      EXPECT_EQ(o.status, exit_violation) << key << " " << by << "\n" << o.out << o.err;
    }
  }
}

TEST_F(Lasting, RunsEndWithinTheTimeOfFewLegs) {
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  for (const char* const property : {"clearance(c, yard) >= 2 cm;", "c inside yard;"}) {
    const Outcome o = verified(
        edited(edited(edited(aisles(property), "fleet one, two : Cart", "fleet one : Cart"),
                      "site  home(two) = (3 m, 5 m);\n", ""),
               "priority walls > charged", "priority walls"),
        {"--format", "json"});
    const std::size_t at = o.out.find(" s in all");
    ASSERT_NE(at, std::string::npos) << o.out;
    const std::size_t from = o.out.rfind(' ', at - 1) + 1;
    const std::string bound = o.out.substr(from, at - from);
    EXPECT_LE(std::stod(bound), 90) << property;
    write("s.json",
          R"({"duration_s": 120, "runs": 30, "seed": 3, "return_within_s": )" + bound + "}");
    const Outcome run = rtac({"sim", "spec.rta", "--scenario", "s.json"});
    EXPECT_EQ(run.status, exit_clean) << property << bound << run.out << run.err;
  }
}

// Each of them by itself.
TEST_F(Lasting, AProofThatLeavesOutAClaimIsNoticed) {
  prove(carts());
  const auto without = [&](const std::string& obligation, const std::string& claim,
                           const std::string& name) {
    Json report = report_;
    bool found = false;
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] != obligation) continue;
      Json& claims = o["claims"];
      for (std::size_t k = claims.size(); k-- > 0;) {
        if (claims[k]["claim"] != claim || claims[k].value("name", "") != name) continue;
        claims.erase(k);
        found = true;
      }
    }
    EXPECT_TRUE(found) << obligation << " " << claim;
    EXPECT_EQ(with_report(report).status, exit_violation) << obligation << " " << claim << name;
  };
  without("C", "lasts", "");
  without("C", "recovery", "");
  without("C", "contained", "");
  without("P2a", "contained", "");
  without("P2a", "lemma", "way_pieces");
  without("P2b", "lemma", "return_reached");
}

// An input may stay false, and an agent where it is, for as long as a battery lasts: no run shows
// it, and none is needed. What takes no charge at rest lasts as long as it likes.
TEST_F(Lasting, WhatInputsKeepDrivingTakesAllOfACharge) {
  const std::string asked =
      edited(edited(carts(), "fleet one", "input calm : bool max_age 1 s;\nfleet one"),
             "c inside yard;", "c inside yard and calm;");
  const auto judged = [](const std::string& text) {
    const Outcome o = verified(text, {"--format", "json"});
    return std::pair(o.status, statuses(o.out, "C", "charged"));
  };
  EXPECT_EQ(judged(asked), std::pair(int(exit_violation), Statuses{"refuted"}));
  const std::string idle = edited(asked, "idle <= 0.01 %/s", "idle <= 0 %/s");
  EXPECT_EQ(judged(idle).second, Statuses{"unknown"});
  const std::string agent =
      edited(edited(carts(), "fleet one",
                    "agent man : radius 30 cm, speed <= 1 m/s error 5 cm "
                    "max_age 100 ms;\nfleet one"),
             "c inside yard;", "c inside yard and distance(c, man) >= 20 cm;");
  EXPECT_EQ(judged(edited(agent, "walls > charged;",
                          "walls > charged; acknowledge inwards may break walls \"seen\";")),
            std::pair(int(exit_violation), Statuses{"refuted"}));
}

// A passage of 60 cm that leads 8 m along a hall: all the way back from its end.
TEST(LongestWay, LeadsOutOfAPassage) {
  const auto zone = geometry::Region::of_rings({{{0, 0},
                                                 {4, 0},
                                                 {4, Rational(17, 10)},
                                                 {12, Rational(17, 10)},
                                                 {12, Rational(23, 10)},
                                                 {4, Rational(23, 10)},
                                                 {4, 4},
                                                 {0, 4}}});
  const auto longest = [&](const Rational& body) {
    return recheck::longest_way(zone, {100, 0, 0}, body, Rational(19, 100), 1, {});
  };
  const auto way = longest(Rational(1, 10));
  ASSERT_TRUE(way.has_value());
  EXPECT_GE(*way, 8);
  EXPECT_LE(*way, 11);
  // who does not fit into the passage has less of a way
  const auto wide = longest(Rational(1, 2));
  ASSERT_TRUE(wide.has_value());
  EXPECT_LE(*wide, 2);
}

// 96 cells of 0.13 m between two racks are 12.48 m, and no hair more: what a certificate says in
// whole millimetres is not refused for how doubles round.
TEST(LongestWay, OverCellsIsExact) {
  const auto rectangle = [](int x, int y, int right, int top) {
    return geometry::Region::of_rings({{{x, y}, {right, y}, {right, top}, {x, top}}});
  };
  const auto hall =
      rectangle(0, 0, 30, 20).subtract(rectangle(5, 4, 25, 6)).subtract(rectangle(5, 13, 25, 15));
  const auto way = recheck::longest_way(hall, {130, 0, 0}, Rational(2, 5), Rational(19, 20),
                                        Rational(79, 40), {}, true);
  ASSERT_TRUE(way.has_value());
  EXPECT_EQ(*way, Rational(312, 25)) << way->get_d();
}

// From a chamber of its own no way leads to a metre of room: that is no matter of a goal that a
// recovery would like to have, and one of where control is given back.
TEST(LongestWay, HasNoEndWhereNoneLeadsBack) {
  const auto room = geometry::Region::of_rings({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  const auto chamber = geometry::Region::of_rings({{{5, 0}, {6, 0}, {6, 1}, {5, 1}}});
  const auto longest = [&](bool deeper) {
    return recheck::longest_way(room.unite(chamber), {100, 0, 0}, Rational(1, 10),
                                Rational(19, 100), 1, {}, deeper);
  };
  EXPECT_FALSE(longest(false).has_value());
  EXPECT_TRUE(longest(true).has_value());
}

// Each robot has a site of its own: that of another one ends no way, however near it is.
TEST(LongestWay, LeadsToEachSite) {
  const auto hall = geometry::Region::of_rings({{{0, 0}, {9, 0}, {9, 4}, {0, 4}}});
  const auto island = geometry::Region::of_rings({{{10, 0}, {14, 0}, {14, 4}, {10, 4}}});
  const recheck::Cells cells{100, 0, 0};
  const Rational body(1, 10), route(19, 100);
  const geometry::Point west{1, 2}, east{8, 2}, beyond{12, 2};
  const auto longest = [&](const geometry::Region& zone, const geometry::Point& other) {
    return recheck::longest_way(zone, cells, body, route, 1, {west, other});
  };
  const auto both = longest(hall, east), one = longest(hall, west);
  ASSERT_TRUE(both && one);
  EXPECT_GE(*one, 9);
  EXPECT_GE(*both, *one);
  const geometry::Region apart = hall.unite(island);
  EXPECT_EQ(longest(apart, beyond), std::nullopt);
  const auto leads = [&](const geometry::Region& zone, const geometry::Point& other) {
    return recheck::without_way(zone, cells, body, route, 1, {west, other}).index() == 0;
  };
  EXPECT_TRUE(leads(hall, east));
  EXPECT_FALSE(leads(apart, beyond));
}

TEST_F(Lasting, TheSiteOfAnotherRobotIsNoPlaceToComeTo) {
  const std::string rooms =
      edited(edited(carts(), "rectangle (0 m, 0 m) to (8 m, 8 m)",
                    "rectangle (0 m, 0 m) to (8 m, 8 m) | rectangle (10 m, 0 m) to (18 m, 8 m)"),
             "always c inside yard; recover inwards", "always c inside yard; recover go_home");
  const auto judged = [](const std::string& text) {
    return statuses(verified(text, {"--format", "json"}).out, "P2b", "walls");
  };
  const std::string alone = edited(rooms, "priority walls > charged", "priority walls");
  EXPECT_NE(judged(edited(alone, "home(two) = (3 m, 5 m)", "home(two) = (13 m, 5 m)")),
            Statuses{"proved"});
  EXPECT_EQ(judged(edited(alone, " | rectangle (10 m, 0 m) to (18 m, 8 m)", "")),
            Statuses{"proved"});
}

}  // namespace
}  // namespace rtac::driver::test
