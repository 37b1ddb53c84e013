// Whether all robots of a fleet have room at once, as far apart as is asked.
#include <cmath>
#include <functional>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

std::string fleet(const std::string& robots, const std::string& apart,
                  const std::string& room = "rectangle (0 m, 0 m) to (10 m, 10 m)") {
  return R"(spec crowd;
zone hall = )" +
         room + R"(;
robot Cart {
  body radius 30 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 30 ms;
  hears other robots max_age 200 ms;
}
fleet )" +
         robots +
         R"( : Cart;
controller go : advanced for Cart extern;
controller back : safe for Cart = retreat within hall speed 0.3 m/s;
controller halt : safe for Cart = brake_and_hold;
monitor walls for r : Cart { "R1" always r inside hall; recover back; }
monitor apart for r : Cart {
  "R2" always )" +
         apart + R"(;
  recover halt; hold when violated "they are led apart by hand";
}
decision drive for Cart { advanced go; period 50 ms; priority walls > apart; }
)";
}
std::string each_other(const std::string& distance) {
  return "forall q : Cart, q != r : distance(r, q) >= " + distance;
}

class RoomForAll : public Verify {
 protected:
  static Json joint(const std::string& text) {
    const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
    const Json report = Json::parse(o.out);
    for (const Json& each : report["decisions"][0]["obligations"]) {
      if (each["obligation"] == "joint return") return each;
    }
    return {};
  }
};

TEST_F(RoomForAll, PlacesForAllOfThemAreShown) {
  const std::pair<const char*, const char*> fit[] = {
      {"a, b", "10 m"}, {"a, b, c", "7 m"}, {"a, b, c, d, e", "4 m"}};
  for (const auto& [robots, distance] : fit) {
    const Json found = joint(fleet(robots, each_other(distance)));
    EXPECT_EQ(found["status"], "proved") << found;
    const Outcome again = rtac({"verify", "--recheck", "certificates"});
    EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
  }
}
// Three in a square are 1.035 times its side apart at most, here 9.06 m. Of that goes what two
// robots may cover that nobody holds, until they have been stopped.
TEST_F(RoomForAll, TheLargestDistanceThatLeavesRoomIsOffered) {
  const Json found = joint(fleet("a, b, c", each_other("9.2 m")));
  EXPECT_EQ(found["status"], "unknown") << found;
  const std::string repair = found["repair"];
  const std::string lead = "a distance of at most ";
  ASSERT_EQ(repair.find(lead), 0U) << repair;
  const std::string most = repair.substr(lead.size(), repair.find(" m ") - lead.size());
  EXPECT_GT(std::stod(most), 7);
  EXPECT_EQ(joint(fleet("a, b, c", each_other(most + " m")))["status"], "proved") << most;
  const std::string more = std::to_string(std::lround(std::stod(most) * 105)) + " cm";
  EXPECT_EQ(joint(fleet("a, b, c", each_other(more)))["status"], "unknown") << more;
}
// So is the zone that has room, which is no wider than it has to be: as it is found in the wider
// zone itself, where robots are placed one by one, and not in one that is like it.
TEST_F(RoomForAll, TheLeastGrowthThatMakesRoomIsOffered) {
  struct Crowd {
    std::string robots, distance, room = "rectangle (0 m, 0 m) to (10 m, 10 m)";
  };
  const auto grown = [](double by_m, const Crowd& crowd) {
    const std::string by = std::to_string(std::lround(by_m * 1000)) + " mm";
    return joint(
        fleet(crowd.robots, each_other(crowd.distance), "grow(" + crowd.room + ", " + by + ")"));
  };
  const std::string apron = "polygon [(0 m, 0 m), (18 m, 0 m), (22 m, 12 m), (4 m, 14 m)]";
  const Crowd crowds[] = {{"a, b, c", "9.2 m"},
                          {"a, b, c, d, e, f", "7 m"},
                          {"a, b", "15 m"},
                          {"a, b, c", "14.2 m", apron},
                          {"a, b, c", "16 m", apron}};
  for (const Crowd& crowd : crowds) {
    const std::string repair =
        joint(fleet(crowd.robots, each_other(crowd.distance), crowd.room))["repair"];
    const std::string lead = "`grow(hall, ";
    const std::size_t at = repair.find(lead);
    ASSERT_NE(at, std::string::npos) << repair;
    EXPECT_NE(repair.find("in place of `hall`", at), std::string::npos) << repair;
    std::size_t used = 0;
    double by_m = std::stod(repair.substr(at + lead.size()), &used);
    if (repair.substr(at + lead.size() + used, 3) == " cm") by_m /= 100;
    EXPECT_EQ(grown(by_m, crowd)["status"], "proved") << repair;
    EXPECT_NE(grown(by_m * 0.95, crowd)["status"], "proved") << repair;
  }
}
TEST_F(RoomForAll, MoreThanEverFitAreRefuted) {
  const Json found = joint(fleet("a, b, c, d, e, f", each_other("7 m")));
  EXPECT_EQ(found["status"], "refuted") << found;
  EXPECT_NE(found["because"].get<std::string>().find("6 robots that are so far apart do not fit"),
            std::string::npos)
      << found;
}
// In space they are looked for at one height.
TEST_F(RoomForAll, RobotsInSpaceNeedItToo) {
  const auto drones = [](const std::string& distance) {
    return R"(spec swarm;
zone box = prism (rectangle (0 m, 0 m) to (8 m, 6 m)) from 0 m to 6 m;
robot Quad {
  body radius 15 cm;
  motion point { speed <= 1 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense position : point3 error 2 cm max_age 50 ms;
  sense velocity : vector3 error 2 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 30 ms;
  hears other robots max_age 100 ms;
}
fleet a, b, c : Quad;
controller go : advanced for Quad extern;
controller back : safe for Quad = retreat within box speed 0.3 m/s;
controller halt : safe for Quad = brake_and_hold;
monitor walls for r : Quad { "R1" always r inside box; recover back; }
monitor apart for r : Quad {
  "R2" always forall q : Quad, q != r : distance(r, q) >= )" +
           distance + R"(;
  recover halt; hold when violated "they are led apart by hand";
}
decision fly for Quad { advanced go; period 50 ms; priority walls > apart; }
)";
  };
  EXPECT_EQ(joint(drones("6.5 m"))["status"], "unknown");
  const Json found = joint(drones("2 m"));
  EXPECT_EQ(found["status"], "proved") << found;
  const Outcome again = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}
// At the places that are shown all of them drive as their advanced controllers say from the start
// on; a decimetre nearer than that, nobody does.
TEST_F(RoomForAll, WhereThereIsRoomAllAreGivenBack) {
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  const auto text = [](const std::string& distance) {
    return fleet("a, b, c", each_other(distance), "rectangle (0 m, 0 m) to (8 m, 2 m)");
  };
  const Json found = joint(text("1.5 m"));
  ASSERT_EQ(found["status"], "proved") << found;
  const auto held_from_the_start = [](const Json& starts) {
    const Json scenario = {{"starts", starts},
                           {"return_within_s", 1},
                           {"duration_s", 1.5},
                           {"runs", 24},
                           {"about", "apart"}};
    write("starts.json", scenario.dump());
    const Outcome o = rtac({"sim", "spec.rta", "--scenario", "starts.json"});
    return o.out.find("from 0 s to") != std::string::npos;
  };
  Json starts = Json::object();
  for (const Json& c : found["claims"]) {
    if (!c.contains("robot")) continue;
    const std::string robot(1, static_cast<char>('a' + std::stoi(c["robot"].get<std::string>())));
    starts[robot]["at"] = {std::stod(c["x_mm"].get<std::string>()) / 1000,
                           std::stod(c["y_mm"].get<std::string>()) / 1000};
  }
  ASSERT_EQ(starts.size(), 3U);
  EXPECT_FALSE(held_from_the_start(starts));
  const Json near = {{"a", {{"at", {1.9, 1}}}}, {"b", {{"at", {4, 1}}}}, {"c", {{"at", {6.1, 1}}}}};
  EXPECT_TRUE(held_from_the_start(near));
}
// One other robot that is far off is enough, or a stop.
TEST_F(RoomForAll, WhatDoesNotAskForAllOfThemToBeApartNeedsNoRoom) {
  for (const char* const apart : {"exists q : Cart, q != r : distance(r, q) >= 9.5 m",
                                  "forall q : Cart, q != r : distance(r, q) >= 9.5 m or "
                                  "r.speed <= 0.3 m/s"}) {
    const Json found = joint(fleet("a, b, c, d, e, f", apart));
    EXPECT_EQ(found["status"], "proved") << apart << found;
  }
}
TEST_F(RoomForAll, ForgedPlacesAreNoticed) {
  ASSERT_EQ(joint(fleet("a, b, c", each_other("5 m")))["status"], "proved");
  const Json report = Json::parse(read("certificates/verification.json"));
  const auto rechecked = [&](const std::function<bool(Json&)>& change, const char* complaint) {
    Json forged = report;
    for (Json& o : forged["decisions"][0]["obligations"]) {
      if (o["obligation"] != "joint return") continue;
      Json claims = Json::array();
      for (Json& c : o["claims"]) {
        if (!c.contains("robot") || change(c)) claims.push_back(c);
      }
      o["claims"] = claims;
    }
    write("certificates/verification.json", forged.dump(2));
    const Outcome again = recheck_sealed_anew();
    EXPECT_NE((again.out + again.err).find(complaint), std::string::npos) << again.out << again.err;
    EXPECT_EQ(again.status, exit_violation);
  };
  rechecked([](Json& c) { return c["robot"] != "1"; }, "no place for all robots at once");
  rechecked(
      [](Json& c) {
        c["x_mm"] = "5000", c["y_mm"] = c["robot"] == "0" ? "2000" : "6000";
        return true;
      },
      "too near to each other");
  rechecked(
      [](Json& c) {
        if (c["robot"] == "2") c["x_mm"] = "9900", c["y_mm"] = "9900";
        return true;
      },
      "nearer to the boundary");
}

}  // namespace
}  // namespace rtac::driver::test
