// What other robots and agents may break, whatever the robot itself does: no recovery is proved to
// keep it, but where the monitor itself ranks higher, whose own recovery may break it by what is
// acknowledged. What is proved is found once more, and what is not true is denied.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

// Three carts, or as many as are asked for, that stop for what `property` says of others.
std::string carts_with(const std::string& property, const std::string& decides,
                       const std::string& fleet = "Cart[3]") {
  return R"(spec carts;
zone yard = rectangle (0 m, 0 m) to (20 m, 10 m);
robot Cart {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  hears other robots max_age 100 ms;
  output push : acceleration;
  latency 30 ms;
}
fleet c : )" +
         fleet + R"(;
controller policy : advanced for Cart extern;
controller back : safe for Cart = retreat within yard speed 0.3 m/s;
controller stop : safe for Cart = brake_and_hold;
monitor others for x : Cart { "R1: others" always )" +
         property + R"(; recover stop; hold when violated "people look after it"; }
monitor fence for x : Cart { "R2: in" always x inside yard; recover back; }
decision go for Cart { advanced policy; period 50 ms; )" +
         decides + " }\n";
}
const std::string other = " q : Cart, q != x : ";
const std::string company = "exists" + other + "distance(x, q) >= 2 m";
const std::string stops = " acknowledge stop may break others \"people look after it\";";

class Others : public Verify {
 protected:
  // Of `back`, which is to keep what is said of others.
  static std::string status(const std::string& text) {
    const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
    const Statuses all = statuses(o.out, "C", "others");
    return all.size() == 1 ? all.front() : "";
  }
  static Outcome recheck() { return recheck_sealed_anew(); }
  // What `verify` has written of a pair that is proved, with the text and the claims of another
  // specification.
  static Outcome rechecked_as_proved(const std::string& kind, const Json& claims) {
    Json report = Json::parse(read("certificates/verification.json"));
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] != kind || o.value("monitor", "") != "others") continue;
      o["status"] = "proved";
      o["claims"] = claims;
    }
    write("certificates/verification.json", report.dump());
    return recheck();
  }
  static Json claims() {
    const Json report = Json::parse(read("certificates/verification.json"));
    for (const Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == "C" && o.value("monitor", "") == "others") return o["claims"];
    }
    return {};
  }
};

// Whom a robot relies on may leave while its recovery drives, and a robot that passes may come.
TEST_F(Others, WhatTheyMayBreakNoRecoveryKeepsThatRanksHigher) {
  const std::string low = "priority fence > others;" + stops;
  for (const std::string& property : {company, "max(" + other + "distance(x, q)) >= 2 m"}) {
    EXPECT_EQ(status(carts_with(property, low)), "unknown") << property;
  }
  // who stands is slow enough, and so needs nobody that looks after it
  const std::string slow = "forall" + other + "(distance(x, q) >= 2 m or x.speed <= 0.5 m/s)";
  EXPECT_EQ(
      status(edited(carts_with(slow, low), " hold when violated \"people look after it\";", "")),
      "unknown");
  EXPECT_EQ(status(carts_with(company, "priority fence > others;" + stops +
                                           " acknowledge back may break others \"so may it\";")),
            "acknowledged");
}
// It may come near a robot that a gate holds on its way.
TEST_F(Others, NobodyKeepsAnAgentOff) {
  std::string text = carts_with("distance(x, worker) >= 50 cm", "priority fence > others;" + stops);
  text = edited(text, "controller policy",
                "agent worker : radius 25 cm, speed <= 1.6 m/s error 5 cm max_age 200 ms;\n"
                "controller policy");
  text = edited(text, " hold when violated \"people look after it\";", "");
  EXPECT_EQ(status(text), "unknown");
  EXPECT_EQ(status(edited(text, "fence > others", "others > fence")), "proved");
  // who coordinates has its own recovery drive then, wherever it ranks
  text = edited(text, "priority", "coordinate");
  EXPECT_EQ(status(text), "proved");
  const Outcome all = verified(text, {"-o", "certificates"});
  EXPECT_EQ(all.status, exit_clean) << all.out << all.err;
  const Outcome again = recheck();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}
TEST_F(Others, WhoCoordinatesTakesNobodyForAsGood) {
  EXPECT_EQ(status(carts_with(company, "coordinate others > fence;" + stops)), "proved");
  const Outcome again = recheck();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}
TEST_F(Others, WhatTheyMayBreakIsAnsweredByAMonitorThatRanksHigher) {
  EXPECT_EQ(status(carts_with(company, "priority others > fence;" + stops)), "proved");
  const Outcome again = recheck();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}
// One recovery for both: what it may break is acknowledged, wherever the two rank.
TEST_F(Others, TheOwnRecoveryTakesOverFromNobody) {
  const std::string accepted = " acknowledge back may break others \"people look after it\";";
  const std::string text = carts_with(company, "priority others > fence;" + accepted);
  EXPECT_EQ(status(edited(text, "recover stop;", "recover back;")), "acknowledged");
}
// Of a pair of robots each other one is all of them: both check it.
TEST_F(Others, WhatIsAConditionOfEachPairIsKept) {
  const std::string low = "priority fence > others;";
  const std::string apart = "forall" + other + "distance(x, q) >= 2 m";
  for (const auto& [property, fleet] :
       {std::pair(apart, "Cart[3]"), std::pair(company, "Cart[2]")}) {
    EXPECT_EQ(status(carts_with(property, low, fleet)), "proved") << property;
    const Outcome again = recheck();
    EXPECT_EQ(again.status, exit_clean) << property << again.out << again.err;
  }
}
TEST_F(Others, AProofOfWhatTheyMayBreakIsDenied) {
  const std::string low = "priority fence > others;";
  EXPECT_EQ(status(carts_with("forall" + other + "distance(x, q) >= 2 m", low)), "proved");
  const Json kept = claims();
  EXPECT_EQ(status(carts_with(company, low + stops)), "unknown");
  const Outcome pair = rechecked_as_proved("C", kept);
  EXPECT_EQ(pair.status, exit_violation) << pair.out;
  EXPECT_NE((pair.out + pair.err).find("others may break it, and nobody takes over"),
            std::string::npos)
      << pair.out << pair.err;
  EXPECT_EQ(status(carts_with(company, low + stops)), "unknown");
  const Outcome own = rechecked_as_proved("P2a", kept);
  EXPECT_EQ(own.status, exit_violation) << own.out;
  EXPECT_NE((own.out + own.err).find("others may break it, whatever the recovery does"),
            std::string::npos)
      << own.out << own.err;
}
// A robot that is alone has nobody near, and no property that asks for one is ever true.
TEST_F(Others, NobodyIsThereOfAFleetOfOne) {
  const Outcome o =
      verified(carts_with(company, "priority others > fence;", "Cart[1]"), {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_NE(o.err.find("\"code\": 5007"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("there is no other `Cart`"), std::string::npos) << o.err;
  EXPECT_EQ(statuses(o.out, "satisfiable", "others"), Statuses{"refuted"});
  EXPECT_EQ(statuses(o.out, "P2b", "others"), Statuses{"refuted"});
}

// Of two monitors of agents with one brake: while the brake drives for the one, whoever comes near
// finds a robot that is as slow as the other one asks; but for one that asks for a distance alone.
TEST_F(Others, ABrakeOfTwoMonitorsKeepsTheOneThatHoldsAtRest) {
  const auto guide = [](const std::string& near) {
    return R"(spec guide;
zone hall = rectangle (0 m, 0 m) to (30 m, 20 m);
robot Guide {
  body    radius 30 cm;
  motion  point { speed <= 1.2 m/s; accel <= 1 m/s^2; brake >= 1.5 m/s^2; }
  sense   position : point  error 3 cm   max_age 50 ms;
  sense   velocity : vector error 3 cm/s max_age 50 ms;
  output  push : acceleration;
  latency 20 ms;
}
fleet g : Guide;
agent visitors[6] : radius 30 cm, speed <= 1.5 m/s error 10 cm max_age 200 ms, present;
controller tour : advanced for Guide extern;
controller stop : safe for Guide = brake_and_hold;
monitor touch  for r : Guide { "R1" always forall p : visitors : distance(r, p) >= 30 cm; recover stop; }
monitor gentle for r : Guide { "R2" always forall p : visitors : distance(r, p) >= 2 m)" +
           near + R"(; recover stop; }
decision lead for Guide { advanced tour; period 50 ms; priority touch > gentle; acknowledge stop may break touch "seen"; )" +
           (near.empty() ? "acknowledge stop may break gentle \"seen\"; }\n" : "}\n");
  };
  const Outcome slow =
      verified(guide(" or r.speed <= 0.5 m/s"), {"-o", "proofs", "--format", "json"});
  EXPECT_EQ(statuses(slow.out, "C", "gentle"), Statuses{"proved"}) << slow.out << slow.err;
  const Outcome again = recheck_sealed_anew("proofs");
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
  const Outcome far = verified(guide(""), {"--format", "json"});
  EXPECT_EQ(statuses(far.out, "C", "gentle"), Statuses{"acknowledged"}) << far.out << far.err;
}

// Beside people it is slow or far: what counts is how fast it may be where its brake turns into a
// hold, and not what it may reach once it is given back, which may be more than that or less.
class BesidePeople : public Others {
 protected:
  // Stopped by 1 m/s^2 after 135 ms, measured to within 2 cm/s, a cart is held at 0.175 m/s at
  // most.
  static std::string beside(const std::string& limit, const std::string& order,
                            const std::string& recovery = "stop") {
    return asking("distance(x, worker) >= 1 m or x.speed <= " + limit, order, recovery);
  }
  static std::string asking(const std::string& property, const std::string& order,
                            const std::string& recovery = "stop",
                            const std::string& fleet = "Cart") {
    std::string text = carts_with(property, order, fleet);
    text = edited(text, " hold when violated \"people look after it\";", "");
    if (fleet == "Cart") text = edited(text, "  hears other robots max_age 100 ms;\n", "");
    text = edited(text, "accel <= 1 m/s^2", "accel <= 3 m/s^2");
    text = edited(text, "recover stop", "recover " + recovery);
    return edited(text, "controller policy",
                  "agent worker : radius 25 cm, speed <= 1.6 m/s error 5 cm max_age 200 ms;\n"
                  "controller policy");
  }
  // What is said of `others`, and what that rests on.
  static std::pair<std::string, Json> found(const Outcome& o, const std::string& kind) {
    const Json report = Json::parse(o.out);
    for (const Json& each : report["decisions"][0]["obligations"]) {
      if (each["obligation"] == kind && each.value("monitor", "") == "others") {
        return {each["status"], each.value("claims", Json::array())};
      }
    }
    return {};
  }
};
TEST_F(BesidePeople, WhoIsHeldSlowerThanItsLimitKeepsItWhoeverComesNear) {
  const std::string first = "priority others > fence;";
  for (const std::string& recovery : {"stop", "back"}) {
    const Outcome kept =
        verified(beside("0.175 m/s", first, recovery), {"-o", "certificates", "--format", "json"});
    EXPECT_EQ(kept.status, exit_clean) << kept.out << kept.err;
    const Outcome again = recheck();
    EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
    EXPECT_NE(kept.out.find(", as soon as no agent "), std::string::npos) << kept.out;
    const auto [status, claims] = found(kept, "P2a");
    EXPECT_EQ(status, "proved");
    const Outcome fast = verified(beside("0.174 m/s", first, recovery), {"-o", "certificates"});
    EXPECT_EQ(fast.status, exit_violation) << fast.out;
    EXPECT_NE(fast.err.find("a limit of 0.175 m/s"), std::string::npos) << fast.err;
    const Outcome denied = rechecked_as_proved("P2a", claims);
    EXPECT_NE((denied.out + denied.err).find("others may break it, whatever the recovery does"),
              std::string::npos)
        << denied.out << denied.err;
  }
}
// Whatever it drives for, and though it is twice as fast elsewhere.
TEST_F(BesidePeople, TheGateStopsARecoveryThatIsFasterThanTheLimit) {
  for (const std::string& order :
       {"priority others > fence;", "priority fence > others;", "coordinate fence > others;"}) {
    const Outcome kept =
        verified(beside("0.175 m/s", order), {"-o", "certificates", "--format", "json"});
    EXPECT_EQ(kept.status, exit_clean) << order << kept.out << kept.err;
    EXPECT_EQ(found(kept, "C").first, "proved") << order << kept.out;
    const Outcome again = recheck();
    EXPECT_EQ(again.status, exit_clean) << order << again.out << again.err;
  }
  const std::string high = "priority fence > others;";
  const Outcome kept = verified(beside("0.175 m/s", high), {"--format", "json"});
  // who comes near one that is held at 0.175 m/s finds it too fast
  const Outcome fast = verified(edited(beside("0.174 m/s", high), "recover stop;",
                                       "recover stop; hold when violated \"so be it\";"),
                                {"-o", "certificates", "--format", "json"});
  EXPECT_EQ(found(fast, "C").first, "unknown") << fast.out;
  const Outcome denied = rechecked_as_proved("C", found(kept, "C").second);
  EXPECT_NE(
      (denied.out + denied.err).find("C of `others` while `back` drives: others may break it"),
      std::string::npos)
      << denied.out << denied.err;
}
TEST_F(BesidePeople, ItMakesNoDifferenceHowThatIsWritten) {
  for (const std::string& property :
       {"distance(x, worker) < 1 m implies x.speed <= 0.175 m/s",
        "not (distance(x, worker) < 1 m and x.speed > 0.175 m/s)",
        "2 * distance(x, worker) - 2 m >= 0 m or x.speed <= 0.175 m/s"}) {
    const Outcome kept = verified(asking(property, "priority fence > others;"),
                                  {"-o", "certificates", "--format", "json"});
    EXPECT_EQ(found(kept, "C").first, "proved") << property << kept.out << kept.err;
    const Outcome again = recheck();
    EXPECT_EQ(again.status, exit_clean) << property << again.out << again.err;
  }
}
// Also where a property names them beside each other robot.
TEST_F(BesidePeople, AnAgentIsSeenWhereverItIsNamed) {
  const std::string each = "forall q : Cart, q != x : ";
  for (const std::string& property :
       {each + "distance(x, q) >= 50 cm and distance(x, worker) >= 1 m",
        each + "distance(x, worker) >= 1 m or x.speed <= 0.01 m/s"}) {
    const Outcome o = verified(asking(property, "priority others > fence;", "stop", "Cart[2]"),
                               {"--format", "json"});
    EXPECT_NE(o.err.find("\"code\": 6004"), std::string::npos) << property << o.err;
    EXPECT_EQ(found(o, "P2a").first, "refuted") << property << o.out;
  }
}
// The gate looks as far ahead as what speaks of agents: a recovery that it would stop too late is
// not said to keep that.
TEST_F(BesidePeople, ALookAheadThatIsTooShortStopsNobodyInTime) {
  const std::string text = R"(spec yards;
zone yard = rectangle (0 m, 0 m) to (20 m, 20 m);
input halt : bool max_age 1 s;
robot Cart {
  body     radius 40 cm;
  motion   unicycle { speed <= 1.2 m/s; turn <= 2 rad/s; accel <= 0.8 m/s^2; brake >= 1 m/s^2; turn_accel <= 5 rad/s^2; }
  sense    position : point   error 3 cm   max_age 50 ms;
  sense    velocity : vector  error 2 cm/s max_age 50 ms;
  sense    heading  : angle   error 1 deg  max_age 50 ms;
  output   drive : twist;
  latency  40 ms;
}
fleet a : Cart;
site depot = (17 m, 10 m);
agent worker : radius 25 cm, speed <= 5 m/s error 1 cm max_age 20 ms;
controller policy : advanced for Cart extern;
controller back : safe for Cart = route to depot within yard speed 1 m/s;
controller stop : safe for Cart = brake_and_hold;
monitor told for x : Cart { "R3: told" always not halt; recover back; }
monitor others for x : Cart { "R1: slow" always distance(x, worker) >= 1 m or x.speed <= 0.01 m/s; recover stop; }
monitor fence for x : Cart { "R2: in" always x inside yard; recover back; }
decision go for Cart { advanced policy; period 300 ms; priority told > fence > others; }
)";
  const std::string late =
      edited(text, "recover stop;", "recover stop; ahead 1 ms unsound \"so\";");
  const Outcome kept = verified(text, {"-o", "certificates", "--format", "json"});
  EXPECT_EQ(found(kept, "C").first, "proved") << kept.out << kept.err;
  EXPECT_EQ(recheck().status, exit_clean);
  write("certificates/sources/spec.rta", late);
  const Outcome denied = recheck();
  EXPECT_NE(
      (denied.out + denied.err).find("C of `others` while `back` drives: others may break it"),
      std::string::npos)
      << denied.out << denied.err;
  EXPECT_EQ(found(verified(late, {"--format", "json"}), "C").first, "unknown");
  // nor does the monitor's own recovery take over in time, wherever it ranks
  const std::string first = edited(late, "told > fence > others", "others > told > fence");
  EXPECT_EQ(found(verified(first, {"--format", "json"}), "C").first, "acknowledged");
}
// An application may do something else than stop where the gate tells it to.
TEST_F(BesidePeople, WhatIsExternalIsNotTakenToStop) {
  const std::string text =
      edited(beside("0.175 m/s", "priority fence > others;"), "= retreat within yard speed 0.3 m/s",
             "extern keeps inside yard speed <= 0.3 m/s");
  EXPECT_EQ(status(text), "unknown");
}

}  // namespace
}  // namespace rtac::driver::test
