// What `return when` asks for beside the property: it comes about where the recovery has led, or
// the monitor stays engaged, nothing below it is looked after, and charge is spent without end.
#include <cstdlib>
#include <stdexcept>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

std::string returning(const std::string& when, const std::string& more = "",
                      const std::string& order = "fence > charge") {
  return R"(spec hall;
zone hall = rectangle (0 m, 0 m) to (14 m, 10 m);
zone east = rectangle (7 m, 0 m) to (14 m, 10 m);
)" + std::string(when.find("go") != std::string::npos ? "input go : bool max_age 1 s;" : "") +
         R"(
robot Bot {
  body radius 0.2 m;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  sense battery : ratio error 0.5 % max_age 2 s;
  hears other robots max_age 100 ms;
  output push : acceleration;
  latency 20 ms;
  energy { drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.5 %/s; charge >= 1 %/s at dock; held <= 120 s; detour <= 30 m; }
}
fleet a : Bot;
site dock = (2 m, 2 m);
controller policy : advanced for Bot extern;
controller inwards : safe for Bot = retreat within hall speed 0.3 m/s;
controller go_home : safe for Bot = route to dock within hall speed 0.3 m/s;
monitor fence for r : Bot { "R1: in the hall" always r inside hall; recover inwards; return when )" +
         when + "; " + more + R"( }
monitor charge for r : Bot { "R2: home again" always r.battery >= energy_to(dock) + 5 %; recover go_home; return when r.battery >= 90 %; }
decision go_on for Bot { advanced policy; period 50 ms; priority )" +
         order + "; }\n";
}

// Charge may run out while the fence waits, so that nothing is refuted by that alone.
const std::string accepted = "fence > charge; acknowledge inwards may break charge \"staff\"";

class ReturnWhen : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  static std::string status(const std::string& kind, const std::string& monitor) {
    const Json report = Json::parse(read("certificates/verification.json"));
    for (const Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == kind && o.value("monitor", "") == monitor) return o["status"];
    }
    return "";
  }
  static Json& fence(Json& report) {
    for (Json& entry : report["decisions"][0]["obligations"]) {
      if (entry["obligation"] == "P2b" && entry.value("monitor", "") == "fence") return entry;
    }
    throw std::runtime_error("no P2b of fence");
  }
  // The recheck is told that it is proved, with the claims of a condition that is.
  static Outcome rechecked_as_proved(const std::string& when) {
    EXPECT_EQ(verified(returning("r inside hall"), {"-o", "certificates"}).status, exit_clean);
    Json good = Json::parse(read("certificates/verification.json"));
    verified(returning(when, "", accepted), {"-o", "certificates"});
    Json report = Json::parse(read("certificates/verification.json"));
    EXPECT_NE(fence(report)["status"], "proved");
    fence(report)["status"] = "proved";
    fence(report)["claims"] = fence(good)["claims"];
    write("certificates/verification.json", report.dump());
    return rechecked();
  }
  static Outcome rechecked() { return recheck_sealed_anew(); }
};

// The recovery leads away from walls, and nowhere else: a place in the west is clear enough.
TEST_F(ReturnWhen, APlaceWhereTheRecoveryDoesNotLeadIsRefuted) {
  const Outcome o = verified(returning("r inside east for 1 s"), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_EQ(status("P2b", "fence"), "refuted");
  EXPECT_EQ(status("C", "charge"), "refuted");
  EXPECT_NE(o.out.find("leads no further, and `return when` of `fence` does not hold there"),
            std::string::npos)
      << o.out;
  EXPECT_NE(o.err.find("`return when` of `fence` may never hold where it leads"), std::string::npos)
      << o.err;
  // and nobody takes it for a proof
  EXPECT_EQ(rechecked_as_proved("r inside east for 1 s").status, exit_violation);
}

// Nothing is charged there, so that what is missing is missing for ever.
TEST_F(ReturnWhen, AChargeThatTheRecoveryDoesNotLeadToIsNotProved) {
  const Outcome o = verified(returning("r.battery >= 50 %"), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_EQ(status("P2b", "fence"), "unknown");
  EXPECT_EQ(status("C", "charge"), "refuted");
}

// A full battery shows 0.98 at least: a proof of another specification is none of one that asks for
// more.
TEST_F(ReturnWhen, MoreThanAFullBatteryShowsIsDenied) {
  EXPECT_EQ(verified(returning("r inside hall"), {"-o", "certificates"}).status, exit_clean);
  const std::string text = read("certificates/sources/spec.rta");
  write("certificates/sources/spec.rta", edited(text, "r.battery >= 90 %", "r.battery >= 98 %"));
  EXPECT_EQ(rechecked().status, exit_clean);
  write("certificates/sources/spec.rta", edited(text, "r.battery >= 90 %", "r.battery >= 98.1 %"));
  EXPECT_EQ(rechecked().status, exit_violation);
}

// Nor are all monitors let go at one place then, whatever the place.
TEST_F(ReturnWhen, WhoNeverGivesBackDoesNotDoSoWithOthers) {
  const std::string text =
      edited(returning("r inside hall"), "r.battery >= 90 %", "r.battery >= 99 %");
  const Outcome o = verified(text, {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(status("P2b", "charge"), "refuted") << o.out;
  EXPECT_EQ(status("joint return", ""), "refuted") << o.out;
  EXPECT_EQ(status("satisfiable", "charge"), "proved") << o.out;
}

// More than a full battery, and what the way takes as well.
TEST_F(ReturnWhen, ChargeBeyondAFullBatteryIsNeverSeen) {
  const std::string text = edited(returning("r inside hall"), "+ 5 %", "+ 100 %");
  const Outcome o = verified(text, {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(status("satisfiable", "charge"), "refuted") << o.out;
}

// What others do may be accepted, as it is of the distance to them.
TEST_F(ReturnWhen, ThatItMayNeverHoldIsAccepted) {
  const std::string text = returning("r.battery >= 50 %", "hold when violated \"staff\";",
                                     "fence > charge; acknowledge inwards may break charge "
                                     "\"staff\"");
  const Outcome o = verified(text, {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(status("P2b", "fence"), "acknowledged");
  EXPECT_EQ(rechecked().status, exit_clean);
}

// As clear as the recovery leads, slow, in a zone around its own, for a while; and what inputs say.
TEST_F(ReturnWhen, WhatComesAboutIsProved) {
  for (const std::string when : {"clearance(r, hall) >= 40 cm and r.speed <= 0.284 m/s for 2 s",
                                 "historically[0 s, 1 s] r inside hall", "not r.speed > 0.284 m/s",
                                 "r.speed <= 0.284 m/s or r.battery >= 50 %",
                                 "r inside grow(hall, 1 m) or r.battery >= 50 %"}) {
    const Outcome o = verified(returning(when), {"-o", "certificates"});
    EXPECT_EQ(o.status, exit_clean) << when << o.out << o.err;
    const Outcome again = rechecked();
    EXPECT_EQ(again.status, exit_clean) << when << again.out << again.err;
  }
  // which of the two a charge has to be is for nobody to say
  const std::string either = "go iff r.battery >= 50 %";
  verified(returning(either, "", accepted), {"-o", "certificates"});
  EXPECT_EQ(status("P2b", "fence"), "unknown");
  EXPECT_EQ(status("joint return", ""), "unknown");
  EXPECT_EQ(rechecked().status, exit_inconclusive);
}
// As old as samples may be, at rest they show 2 * 2 cm/s of errors, 4 mm/s of the grid, and what
// 1.2 m/s^2, the brake, makes of 100 ms between their stamps and of 100 ms since then: 0.284 m/s,
// of a recovery that may drive at 0.3 m/s. That it would be seen in the best of cases is no proof.
TEST_F(ReturnWhen, ASpeedThatOldSamplesDoNotShowIsNotProved) {
  for (const std::string when :
       {"r.speed <= 5 cm/s", "not r.speed > 0.283 m/s", "r inside hall and r.speed < 0.284 m/s",
        "r.speed <= 0.283 m/s or r.battery >= 50 %"}) {
    const Outcome o = verified(returning(when, "", accepted), {"-o", "certificates"});
    EXPECT_EQ(o.status, exit_inconclusive) << when << o.out;
    EXPECT_EQ(status("P2b", "fence"), "unknown") << when;
    EXPECT_NE(o.out.find("a limit of 0.284 m/s in `return when` works"), std::string::npos)
        << when << o.out;
  }
  // exactly, without the grid, it is 0.28 m/s
  EXPECT_EQ(rechecked_as_proved("r.speed < 0.28 m/s").status, exit_violation);
}
// What no sample shows is an error, which offers what every sample does.
TEST_F(ReturnWhen, ASpeedBelowItsErrorIsAnErrorWithTheOneThatWorks) {
  const Outcome o = verified(returning("r.speed <= 1 cm/s", "", accepted));
  EXPECT_NE(o.err.find("error[5007]"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("a speed of at least 0.284 m/s works, whatever the sample"),
            std::string::npos)
      << o.err;
}
// What would not be mended by it does not name it.
TEST_F(ReturnWhen, TheSpeedThatWorksIsNamedWhereItWorks) {
  const Outcome o =
      verified(returning("r.speed <= 5 cm/s and r.battery >= 50 %", "", accepted), {});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out;
  EXPECT_EQ(o.out.find("in `return when` works"), std::string::npos) << o.out;
}

// Of a choice the other side may hold at the place; with both, or with all, no side does.
TEST_F(ReturnWhen, APlaceIsNoCounterexampleWhereTheOtherSideMayHold) {
  const std::string gates = "once[0 s, 1 s] r inside east";  // it may have come through there
  for (const std::string when : {"r inside east or r.battery >= 50 %", gates.c_str(),
                                 "r.battery >= 50 % or r inside east"}) {
    const Outcome o = verified(returning(when, "", accepted), {"-o", "certificates"});
    EXPECT_EQ(o.status, exit_inconclusive) << when << o.out;
    EXPECT_EQ(status("P2b", "fence"), "unknown") << when;
  }
  for (const std::string when :
       {"r inside east or r inside shrink(east, 1 m)", "r inside east and r.battery >= 50 %",
        "r.battery >= 50 % and (r inside east for 1 s)"}) {
    const Outcome o = verified(returning(when, "", accepted), {"-o", "certificates"});
    EXPECT_EQ(o.status, exit_violation) << when << o.out;
    EXPECT_EQ(status("P2b", "fence"), "refuted") << when;
  }
}
// Less than touching a zone may hold beside it.
TEST_F(ReturnWhen, APlaceBesideAZoneIsNoCounterexampleToLessThanTouchingIt) {
  const Outcome o =
      verified(returning("clearance(r, east) >= 0 m - 20 m", "", accepted), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out;
  EXPECT_EQ(status("P2b", "fence"), "unknown");
}
// That there is another robot never comes about for the only one.
TEST_F(ReturnWhen, NobodyElseIsEverThere) {
  const std::string near = "exists q : Bot, q != r : distance(r, q) >= 1 m";
  const Outcome o = verified(returning(near, "", accepted), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(status("P2b", "fence"), "refuted");
  EXPECT_EQ(rechecked_as_proved(near).status, exit_violation);
}

// They may say so for ever: the recovery waits, and takes charge meanwhile.
TEST_F(ReturnWhen, InputsLetGoAndTakeTheirTime) {
  // runs of an hour each, of which it takes some: as long as a slow machine needs for them
  const Outcome o = verified(returning("go"), {"-o", "certificates", "--attack", "90"});
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_EQ(status("P2b", "fence"), "proved");
  EXPECT_EQ(status("C", "charge"), "refuted");
  const std::string order = "fence > charge; acknowledge inwards may break charge \"staff\"";
  const Outcome first = verified(returning("go", "", order), {"-o", "certificates"});
  EXPECT_EQ(first.status, exit_clean) << first.out << first.err;
  EXPECT_EQ(rechecked().status, exit_clean);
}

// Of an implication either side, of a comparison what its sides come to: proved, and found once
// more.
TEST_F(ReturnWhen, WhatIsWrittenInOtherWordsIsFoundOnceMore) {
  for (const std::string when :
       {"go implies r.battery >= 50 %", "r.speed > 0.284 m/s implies r.battery >= 50 %",
        "clearance(r, hall) >= reserve + 10 cm", "clearance(r, hall) - reserve >= 10 cm",
        "2 * clearance(r, hall) >= 60 cm", "r.speed + 0.1 m/s <= 0.384 m/s"}) {
    const std::string text = edited(returning(when, "", accepted), "robot Bot",
                                    "param reserve : real [m] in 0 m .. 20 cm = 10 cm;\nrobot Bot");
    const Outcome o = verified(text, {"-o", "certificates"});
    EXPECT_EQ(status("P2b", "fence"), "proved") << when << o.out << o.err;
    const Outcome again = rechecked();
    EXPECT_EQ(again.status, exit_clean) << when << again.out << again.err;
  }
}
// Of the charge that it takes home, too.
TEST_F(ReturnWhen, ChargeForTheWayIsFoundOnceMore) {
  const std::string charged = "return when r.battery >= 90 %";
  const std::string to_bay =
      edited(returning("r inside hall", "", accepted), "retreat within", "route to bay within");
  const std::string two_sites = edited(to_bay, "site dock", "site bay = (8 m, 5 m);\nsite dock");
  for (const std::string when :
       {"r.battery - 15 % >= energy_to(dock)", "r.battery >= energy_to(dock) + 15 %"}) {
    const std::string text = edited(two_sites, charged, "return when " + when);
    const Outcome o = verified(text, {"-o", "certificates"});
    EXPECT_EQ(status("P2b", "charge"), "proved") << when << o.out << o.err;
    EXPECT_EQ(rechecked().status, exit_clean) << when;
  }
  // the way to somewhere else is another one
  const Outcome first = verified(two_sites, {"-o", "certificates"});
  ASSERT_EQ(first.status, exit_clean) << first.out << first.err;
  const Json good = Json::parse(read("certificates/verification.json"));
  const std::string elsewhere = "return when r.battery >= energy_to(bay) + 15 %";
  const Outcome o = verified(edited(two_sites, charged, elsewhere), {"-o", "certificates"});
  EXPECT_EQ(status("P2b", "charge"), "unknown") << o.out;
  write("certificates/verification.json", good.dump());
  EXPECT_EQ(rechecked().status, exit_violation);
}
// A robot counts as parked 10 cm beside its site, and has to be seen there, too.
TEST_F(ReturnWhen, ASiteIsAsClearAsWhereARobotParks) {
  const auto at_dock = [](const std::string& edge) {
    const std::string text =
        edited(returning("r inside hall"), "site dock",
               "zone yard = rectangle (" + edge + ", 0 m) to (12 m, 9 m);\nsite dock");
    return edited(text, "return when r.battery >= 90 %", "return when r inside yard");
  };
  // by 0.2 m of the body, 4 cm of errors, 3 cm of what it moves, 10 cm to park, and the grid
  const Outcome o = verified(at_dock("1.6 m"), {"-o", "certificates"});
  EXPECT_EQ(status("P2b", "charge"), "proved") << o.out << o.err;
  EXPECT_EQ(rechecked().status, exit_clean);
  const Json good = Json::parse(read("certificates/verification.json"));
  verified(at_dock("1.7 m"), {"-o", "certificates"});
  EXPECT_EQ(status("P2b", "charge"), "unknown");
  write("certificates/verification.json", good.dump());
  EXPECT_EQ(rechecked().status, exit_violation);
}

// Where the witness lies, all conditions have to hold.
TEST_F(ReturnWhen, APlaceThatAllGiveBackAtFulfilsTheConditions) {
  const auto joint = [](const std::string& when) {
    verified(returning(when, "hold when violated \"staff\";", accepted), {"-o", "certificates"});
    return status("joint return", "");
  };
  EXPECT_EQ(joint("r inside east and clearance(r, hall) >= 1 m"), "proved");
  EXPECT_EQ(rechecked().status, exit_clean);
  const Json good = Json::parse(read("certificates/verification.json"));
  EXPECT_EQ(joint("clearance(r, hall) <= 60 cm or r inside east"), "proved");
  EXPECT_EQ(rechecked().status, exit_clean);
  // no more than is allowed, or what a robot at rest does not do
  EXPECT_EQ(joint("clearance(r, hall) >= 1 m and clearance(r, hall) <= 60 cm"), "refuted");
  EXPECT_EQ(joint("r.speed >= 0.2 m/s"), "unknown");
  EXPECT_EQ(joint("not (r inside hall)"), "refuted");
  // and the recheck looks for itself
  for (const bool moved : {false, true}) {
    Json report = good;
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] != "joint return") continue;
      Json& claims = o["claims"];
      for (std::size_t k = claims.size(); k-- > 0;) {
        if (claims[k]["claim"] == "returned" && !moved) {
          claims.erase(k);
        } else if (moved) {
          claims[k]["x_mm"] = "5000";
        }
      }
    }
    joint("r inside east and clearance(r, hall) >= 1 m");
    write("certificates/verification.json", report.dump());
    const Outcome o = rechecked();
    EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  }
}
TEST_F(ReturnWhen, ConditionsThatExcludeEachOtherHaveNoJointReturn) {
  const std::string west = "zone west = rectangle (0 m, 0 m) to (7 m, 10 m);\nsite dock";
  const std::string text =
      edited(edited(returning("r inside east", "hold when violated \"staff\";", accepted),
                    "site dock", west),
             "return when r.battery >= 90 %", "return when r inside west");
  verified(text, {"-o", "certificates"});
  EXPECT_EQ(status("joint return", ""), "refuted");
}

// To be deeper in the hall than control is given back at the dock is asked of the fence alone,
// which the way home keeps: nobody takes over from that for ever.
TEST_F(ReturnWhen, WhatItAsksForBesidesIsNoMatterOfOthers) {
  const Outcome o = verified(returning("clearance(r, hall) >= 1.8 m"), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(status("switching", ""), "proved") << o.out;
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}

// Beside 0.2 m of the body it takes 4 cm of errors and 2.2 cm that it may have moved: 4 cm/s of
// errors and 12 cm/s of 100 ms between its stamps, for 100 ms, and what it gains in them. What
// rounds that up is less than a centimetre, and without the stamps it would be 1.2 cm less.
TEST_F(ReturnWhen, WhatUnequalStampsLeaveOpenIsDenied) {
  const Outcome o = verified(returning("clearance(r, hall) >= 1.8 m"), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  const std::string text = read("certificates/sources/spec.rta");
  for (const auto& [asked, status] :
       {std::pair{"1.80 m", exit_clean}, {"1.81 m", exit_violation}}) {
    write("certificates/sources/spec.rta", edited(text, "clearance(r, hall) >= 1.8 m",
                                                  std::string("clearance(r, hall) >= ") + asked));
    const Outcome again = recheck_sealed_anew();
    EXPECT_EQ(again.status, status) << asked << again.out << again.err;
  }
}

// A landing ends where it is told to, or lower where it has set out from there.
TEST_F(ReturnWhen, OfALandingAHeightAboveItsEndHolds) {
  const auto page = [](const std::string& when) {
    return R"(spec roof;
robot Quad {
  body radius 40 cm;
  motion point { speed <= 5 m/s; accel <= 4 m/s^2; brake >= 4 m/s^2; }
  sense position : point3 error 10 cm max_age 50 ms;
  sense velocity : vector3 error 10 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller nav : advanced for Quad extern;
controller down : safe for Quad = land to 1 m speed 0.6 m/s;
monitor roof for r : Quad { "SR-1: below 50 m" always r.position.z <= 50 m; recover down; return when )" +
           when + R"(; }
decision d for Quad { advanced nav; period 50 ms; priority roof; }
)";
  };
  for (const char* when : {"r.position.z <= 47 m", "r.position.z <= 2.5 m for 1 s"}) {
    const Outcome o = verified(page(when), {"-o", "shown"});
    EXPECT_EQ(o.status, exit_clean) << when << o.out << o.err;
    const Outcome again = rtac({"verify", "--recheck", "shown"});
    EXPECT_EQ(again.status, exit_clean) << when << again.out;
  }
  for (const char* when : {"r.position.z <= 1.2 m", "r.position.z >= 0.5 m"}) {
    const Outcome o = verified(page(when), {"--format", "json"});
    EXPECT_EQ(statuses(o.out, "P2b", "roof"), Statuses{"unknown"}) << when << o.out;
  }
}

}  // namespace
}  // namespace rtac::driver::test
