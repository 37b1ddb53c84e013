// One place, one height and one moment at which all monitors give control back: what no zone says
// counts, too, and a recheck asks for it as well.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

const std::string cart = R"(robot Cart {
  body    radius 30 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 3 cm   max_age 50 ms;
  sense   velocity : vector error 3 cm/s max_age 50 ms;
  hears   other robots max_age 200 ms;
  output  push : acceleration;
  latency 20 ms;
}
)";

class JointReturn : public Verify {
 protected:
  // Of the first monitor of which it is not proved.
  static std::string status_of(const Json& report, const std::string& kind) {
    std::string found;
    for (const Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == kind && (found.empty() || found == "proved")) found = o["status"];
    }
    return found;
  }
  // What is left open or refuted of one page is denied with the certificates of another one whose
  // names are the same.
  void expect_not_proved(const std::string& kind, const std::string& good, const std::string& bad,
                         const std::string& why) {
    fs::remove_all("certificates");
    verified(good, {"--attack", "1", "-o", "certificates"});
    const Json known = Json::parse(read("certificates/verification.json"));
    ASSERT_EQ(status_of(known, kind), "proved") << good;
    const Outcome honest = recheck_sealed_anew();
    EXPECT_NE(honest.status, exit_violation) << honest.out;
    const Outcome o = verified(bad, {"--attack", "1", "--format", "json"});
    EXPECT_NE(status_of(Json::parse(o.out), kind), "proved") << bad << o.out;
    write("certificates/sources/spec.rta", bad);
    const Outcome forged = recheck_sealed_anew();
    EXPECT_EQ(forged.status, exit_violation) << bad << forged.out;
    EXPECT_NE(forged.out.find(why), std::string::npos) << forged.out;
  }
};

// No zone is asked for.
TEST_F(JointReturn, HeightsHaveToSuitAll) {
  const auto page = [](const std::string& least, const std::string& back = "") {
    return "spec heights;\n" + a_quad + R"(controller stop   : safe for Quad = brake_and_hold;
monitor roof  for r : Quad { "R1" always r.position.z <= 10 m; recover stop; hold when violated "a test"; }
monitor floor for r : Quad { "R2" always r.position.z >= )" +
           least + "; recover stop; " + back + R"( hold when violated "a test"; }
decision fly for Quad { advanced policy; period 50 ms; priority roof > floor; }
)";
  };
  expect_not_proved("joint return", page("2 m"), page("12 m"), "needs another height");
  // narrower than the clearance of the return
  expect_not_proved("joint return", page("2 m"), page("9 m"), "needs another height");
  const std::string low = "return when r.position.z >= 2 m;",
                    high = "return when r.position.z >= 12 m;";
  expect_not_proved("joint return", page("1 m", low), page("1 m", high), "may not hold");
  const Outcome o = verified(page("12 m"), {"--attack", "1", "--format", "json"});
  EXPECT_EQ(statuses(o.out, "joint return", ""), Statuses{"refuted"}) << o.out;
}

// One is there in the morning, the other one in the afternoon, all around the room.
TEST_F(JointReturn, ZonesThatComeAndGoHaveToBeGoneAtOnce) {
  const auto page = [](const std::string& until, const std::string& from) {
    const std::string daily =
        " during monday, tuesday, wednesday, thursday, friday, saturday, sunday ";
    return "spec hall;\nclock utc;\nzone room = rectangle (0 m, 0 m) to (8 m, 4 m);\n"
           "zone am = rectangle (-1 m, -1 m) to (9 m, 5 m)" +
           daily + "00:00 .. " + until + ";\nzone pm = rectangle (-1 m, -1 m) to (9 m, 5 m)" +
           daily + from + " .. 24:00;\n" + cart + R"(fleet a : Cart;
controller pilot : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
monitor one for r : Cart { "R1" always distance(r, am) >= 30 cm; recover stop; hold when violated "x"; }
monitor two for r : Cart { "R2" always distance(r, pm) >= 30 cm; recover stop; hold when violated "x"; }
decision fly for Cart { advanced pilot; period 50 ms; priority one > two; acknowledge stop may break one "x"; acknowledge stop may break two "x"; }
)";
  };
  expect_not_proved("joint return", page("11:00", "12:00"), page("13:00", "12:00"),
                    "zones that come and go may never be gone at once");
  // a moment between them is less than the minute that is asked for
  verified(page("12:00", "12:00"), {"--attack", "1", "-o", "certificates"});
  EXPECT_EQ(status_of(Json::parse(read("certificates/verification.json")), "joint return"),
            "unknown");
}

std::string returning(const std::string& when, const std::string& fleet = "c") {
  return "spec ask;\nzone hall = rectangle (0 m, 0 m) to (30 m, 20 m);\n" + cart + "fleet " +
         fleet +
         R"( : Cart;
input permit : bool max_age 1 s;
input load : real in 0 .. 90 error 1 max_age 1 s;
controller tour : advanced for Cart extern;
controller back : safe for Cart = retreat within hall speed 0.3 m/s;
monitor one for r : Cart { "R1" always clearance(r, hall) >= 10 cm and (permit or load >= 0); recover back; return when )" +
         when + (fleet == "c" ? "" : "; hold when violated \"x\"") + R"(; }
decision lead for Cart { advanced tour; period 50 ms; priority one; }
)";
}

TEST_F(JointReturn, OtherRobotsAreCountedAndKeptOff) {
  const auto page = [](const std::string& when) { return returning(when, "c, d"); };
  const std::string near = "(forall q : Cart, q != r : distance(r, q) >= 3 m)";
  expect_not_proved("joint return", page(near),
                    page("count(q : Cart, q != r : distance(r, q) <= 50 m) <= 0"),
                    "`return when` of `one` may not hold");
  expect_not_proved("joint return", page(near),
                    page("(forall q : Cart, q != r : distance(r, q) >= 33 m)"),
                    "too near to each other");
  expect_not_proved("joint return", page(near), page(near + " or r.speed <= 0.01 m/s"),
                    "may not hold");
}

// Who is far from an agent need not be slow, however far below what a robot at rest may reach until
// the look-ahead ends.
TEST_F(JointReturn, WhoIsFarFromAnAgentNeedNotBeSlow) {
  const auto page = [](const std::string& says) {
    return R"(spec worker;
robot Cart {
  body     radius 20 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point  error 1 cm   max_age 50 ms;
  sense    velocity : vector error 1 cm/s max_age 50 ms;
  output   thrust : acceleration;
  latency  20 ms;
}
fleet one : Cart;
agent worker : radius 25 cm, speed <= 1.6 m/s error 5 cm max_age 200 ms;
controller plan : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
monitor gentle for r : Cart { "SR-1" always distance(r, worker) >= 1 m )" +
           says + R"( r.speed <= 0.02 m/s; recover stop; }
decision go for Cart { advanced plan; period 50 ms; priority gentle; acknowledge stop may break gentle "who comes sees it"; }
)";
  };
  expect_not_proved("joint return", page("or"), page("and"),
                    "joint return: who rests may be too fast for `gentle`");
}

TEST_F(JointReturn, WhatIsAskedOfInputsToReturnCanBe) {
  const std::string why = "not all that is asked for need be true";
  for (const char* const never : {"historically[0 s, 1 s] permit and once[0 s, 1 s] not permit",
                                  "once[0 s, 1 s] (permit and not permit)",
                                  "previously (load >= 60) and previously (load <= 40)"}) {
    expect_not_proved("joint return", returning("permit and load >= 20"), returning(never), why);
    expect_not_proved("P2b", returning("permit and load >= 20"), returning(never), why);
  }
}

// Beside a zone that comes and goes the rest of a property counts.
TEST_F(JointReturn, AZoneThatComesAndGoesSettlesNothingElse) {
  const auto page = [](const std::string& more) {
    return "spec hall;\nclock utc;\nzone room = rectangle (0 m, 0 m) to (8 m, 4 m);\n"
           "zone lessons = rectangle (5 m, 0 m) to (8 m, 4 m) during monday, friday 07:30 .. "
           "16:00;\nsite home = (1.6 m, 2 m);\n" +
           cart + R"(fleet a, b : Cart;
controller pilot : advanced for Cart extern;
controller go_home : safe for Cart = route to home within room speed 0.3 m/s;
monitor quiet for r : Cart { "R1" always distance(r, lessons) >= 30 cm)" +
           more + R"(; recover go_home; }
decision fly for Cart { advanced pilot; period 50 ms; priority quiet; }
)";
  };
  const Outcome o = verified(page(" and (forall q : Cart, q != r : distance(r, q) >= 1 m)"),
                             {"--attack", "1", "--format", "json"});
  EXPECT_EQ(statuses(o.out, "P2b", "quiet"), Statuses{"unknown"}) << o.out;
  const Outcome alone = verified(page(""), {"--attack", "1", "--format", "json"});
  EXPECT_EQ(statuses(alone.out, "P2b", "quiet"), Statuses{"proved"}) << alone.out;
}

// A cart that takes a tenth of its charge for a metre and more, far from its dock.
std::string charged(const std::string& reserve, const std::string& far = "(7 m, 7 m)") {
  return "spec charge;\nzone yard = rectangle (0 m, 0 m) to (8 m, 8 m);\nzone far = rectangle " +
         far + R"( to (8 m, 8 m);
robot Cart {
  body radius 10 cm;
  motion unicycle { speed <= 0.3 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 10 rad/s^2; }
  sense position : point error 1 cm max_age 100 ms;
  sense heading : angle error 2 deg max_age 100 ms;
  sense velocity : vector error 1 cm/s max_age 100 ms;
  sense battery : ratio error 1 % max_age 2 s;
  output push : twist;
  latency 20 ms;
  energy { drive <= 7 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; charge >= 1 %/s at home; held <= 100 s; detour <= 3 m; }
}
fleet one : Cart;
site home = (1 m, 1 m);
controller explore : advanced for Cart extern;
controller inwards : safe for Cart = retreat within far speed 0.2 m/s;
controller go_home : safe for Cart = route to home within yard speed 0.2 m/s;
monitor stay for c : Cart { "R1" always c inside far; recover inwards; }
monitor charge for c : Cart { "R2" always c.battery >= energy_to(home) + )" +
         reserve + R"(; recover go_home; }
decision go for Cart { advanced explore; period 50 ms; priority charge > stay; acknowledge go_home may break stay "a test"; }
)";
}

// A place is none where a full battery is not enough for the way from there.
TEST_F(JointReturn, ThereIsEnoughChargeForTheWayFromThere) {
  expect_not_proved("joint return", charged("1 %"), charged("45 %"),
                    "no battery has enough for the ways from there");
  // nearer to the dock there is
  verified(charged("30 %", "(0 m, 0 m)"), {"--attack", "1", "-o", "certificates"});
  EXPECT_EQ(status_of(Json::parse(read("certificates/verification.json")), "joint return"),
            "proved");
  EXPECT_NE(recheck_sealed_anew().status, exit_violation);
}

// Charge and a zone in one property, which is seen at one place.
TEST_F(JointReturn, ChargeIsSeenWhereTheZoneIs) {
  const auto page = [](const std::string& reserve) {
    std::string text = edited(charged("1 %"), "always c inside far",
                              "always c inside far and c.battery >= energy_to(home) + " + reserve);
    return edited(text, "priority charge > stay;",
                  "priority charge > stay; acknowledge inwards may break stay \"a test\";");
  };
  expect_not_proved("satisfiable", page("1 %"), page("40 %"), "need not be seen at that place");
}

TEST_F(JointReturn, AHeightIsSeenWhereTheZoneIs) {
  const auto page = [](const std::string& least) {
    return "spec heights;\nzone hall = prism (rectangle (0 m, 0 m) to (20 m, 20 m)) from 0 m to 10 "
           "m;\n" +
           a_quad + R"(controller back : safe for Quad = retreat within hall speed 0.5 m/s;
monitor walls for r : Quad { "R1" always r inside hall and r.position.z >= )" +
           least + R"(; recover back; hold when violated "a test"; }
decision fly for Quad { advanced policy; period 50 ms; priority walls; acknowledge back may break walls "a test"; }
)";
  };
  // above the middle of the hall, and above all of it
  expect_not_proved("satisfiable", page("6 m"), page("20 m"), "need not be seen at that place");
}

TEST_F(JointReturn, NobodyIsFartherAwayThanCanBe) {
  const auto apart = [](const std::string& gap) {
    return "spec apart;\nzone hall = rectangle (0 m, 0 m) to (12 m, 12 m);\n" + cart +
           R"(fleet c, d : Cart;
controller tour : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
monitor one for r : Cart { "R1" always r inside hall and forall q : Cart, q != r : distance(r, q) >= )" +
           gap + R"(; recover stop; hold when violated "a test"; }
decision lead for Cart { advanced tour; period 50 ms; priority one; }
)";
  };
  expect_not_proved("satisfiable", apart("1 m"), apart("100 m"), "no two robots are so far apart");
  const auto agent = [](const std::string& gap) {
    return "spec agent;\nagent man : radius 25 cm, speed <= 1 m/s error 5 cm max_age 200 ms;\n" +
           cart + R"(fleet c : Cart;
controller tour : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
monitor one for r : Cart { "R1" always distance(r, man) >= )" +
           gap + R"(; recover stop; }
decision lead for Cart { advanced tour; period 50 ms; priority one; acknowledge stop may break one "a test"; }
)";
  };
  expect_not_proved("satisfiable", agent("1 m"), agent("150 km"), "known to be so far away");
  expect_not_proved("joint return", agent("1 m"), agent("150 km"), "known to be as far away");
}

// Others are far from where control is given back, however a comparison is written.
TEST_F(JointReturn, AnAgentIsFarAndNotNear) {
  const auto page = [](const std::string& when) {
    return edited(returning(when), "input permit",
                  "agent man : radius 25 cm, speed <= 1 m/s error 5 cm max_age 200 ms;\n"
                  "input permit");
  };
  const std::string far = page("distance(r, man) - 3 m >= 0 m");
  for (const char* const near : {"3 m - distance(r, man) >= 0 m", "0 m <= 3 m - distance(r, man)",
                                 "distance(r, man) >= 150 km"}) {
    expect_not_proved("joint return", far, page(near), "`return when` of `one` may not hold");
  }
}

}  // namespace
}  // namespace rtac::driver::test
