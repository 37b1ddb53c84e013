// What monitors say of one input, and ask for to return: it has to be so at once, which a recheck
// reads from the specification. So does a joint return lie at one place, with its height.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

// Two monitors of one robot; what they say and ask for besides.
std::string asking(const std::string& one, const std::string& two) {
  return R"(spec ask;
zone hall = rectangle (0 m, 0 m) to (30 m, 20 m);
zone yard = rectangle (100 m, 0 m) to (130 m, 20 m);
robot Cart {
  body    radius 30 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 3 cm   max_age 50 ms;
  sense   velocity : vector error 3 cm/s max_age 50 ms;
  output  push : acceleration;
  latency 20 ms;
}
fleet c : Cart;
input permit : bool max_age 1 s;
input load   : real in 0 .. 90 error 1 max_age 1 s;
controller tour : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
controller back : safe for Cart = retreat within hall speed 0.3 m/s;
monitor one for r : Cart { "R1" always )" +
         one + R"(; }
monitor two for r : Cart { "R2" always )" +
         two + R"(; }
decision lead for Cart { advanced tour; period 50 ms; priority one > two; acknowledge back may break one "a test"; }
)";
}
const char* const off_walls = "clearance(r, hall) >= 10 cm";

class AtOnce : public Verify {
 protected:
  static Outcome judged(const std::string& text) {
    return verified(text, {"--attack", "1", "--format", "json"});
  }
  void proved(const std::string& text) {
    const Outcome o = verified(text, {"-o", "certificates"});
    ASSERT_EQ(o.status, exit_clean) << o.out << o.err;
    report_ = Json::parse(read("certificates/verification.json"));
    ASSERT_EQ(recheck_sealed_anew().status, exit_clean);
  }
  // Of an obligation, each claim as `change` leaves it, or left out.
  template <class Change>
  void expect_denied(const std::string& kind, const Change& change, const std::string& why) {
    Json report = report_;
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] != kind) continue;
      Json left = Json::array();
      for (Json& claim : o["claims"]) {
        if (change(claim)) left.push_back(claim);
      }
      o["claims"] = left;
    }
    write("certificates/verification.json", report.dump());
    const Outcome o = recheck_sealed_anew();
    EXPECT_EQ(o.status, exit_violation) << why << "\n" << o.out << o.err;
    EXPECT_NE((o.out + o.err).find(why), std::string::npos) << why << "\n" << o.out << o.err;
  }
  Json report_;
};

TEST_F(AtOnce, WhatExcludesEachOtherRefutesTheReturn) {
  const std::string in = std::string(off_walls) + " and ", back = "; recover back";
  for (const auto& [one, two] : {std::pair(in + "permit" + back, in + "not permit" + back),
                                 std::pair(off_walls + back + "; return when permit",
                                           off_walls + back + "; return when not permit"),
                                 std::pair(in + "load <= 40" + back, in + "load >= 39" + back)}) {
    const Outcome o = judged(asking(one, two));
    EXPECT_EQ(statuses(o.out, "joint return", ""), Statuses{"refuted"}) << one << o.out;
    EXPECT_EQ(statuses(o.out, "P2b", "one"), Statuses{"proved"}) << one << o.out;
  }
  // of one monitor, its own condition
  const Outcome own =
      judged(asking(off_walls + back, in + "permit" + back + "; return when not permit"));
  EXPECT_EQ(statuses(own.out, "P2b", "one"), Statuses{"proved"}) << own.out;
  EXPECT_EQ(statuses(own.out, "P2b", "two"), Statuses{"refuted"}) << own.out;
}

// Older than its age an input says nothing any more.
TEST_F(AtOnce, AnAgeThatNoSampleHasIsNoneOfOneThatIsRead) {
  const std::string told = R"(permit or r inside yard; recover stop; hold when violated "a test")";
  const auto page = [&](const std::string& age) {
    return asking(told, "r inside hall and age(permit) " + age + "; recover back");
  };
  EXPECT_NE(statuses(judged(page(">= 2 s")).out, "joint return", ""), Statuses{"proved"});
  const std::string both = std::string(off_walls) + " and permit; recover back";
  const auto fresh = asking(both, "r inside hall and age(permit) <= 500 ms; recover back");
  EXPECT_EQ(statuses(judged(fresh).out, "joint return", ""), Statuses{"proved"});
  const auto stale = asking(both, "r inside hall and age(permit) >= 2 s; recover back");
  EXPECT_EQ(statuses(judged(stale).out, "joint return", ""), Statuses{"refuted"});
}

TEST_F(AtOnce, InputsThatSuitAllAreClaimedAndFoundAgain) {
  const std::string in = std::string(off_walls) + " and ", back = "; recover back";
  proved(asking(in + "load <= 40" + back + "; return when permit and load <= 30",
                in + "load >= 20" + back + "; return when permit"));
  for (const char* const kind : {"joint return", "P2b"}) {
    expect_denied(
        kind, [](Json& c) { return c["claim"] != "at_once"; }, "no claim `at_once`");
    expect_denied(
        kind,
        [](Json& c) {
          if (c["claim"] == "at_once") c["inputs"] = "load.0=25;permit.0=0";
          return true;
        },
        "not all that is asked for need be true");
  }
  expect_denied(
      "joint return",
      [](Json& c) {
        if (c["claim"] == "at_once") c["alone"] = "one";
        return true;
      },
      "need not be true");
}

// A robot that rests there is measured beside it.
TEST_F(AtOnce, APlaceIsClearByTheErrorOfItsMeasurement) {
  proved(asking(std::string(off_walls) + "; recover back", "r inside hall; recover back"));
  expect_denied(
      "joint return",
      [](Json& c) {
        if (c["claim"] != "place") return true;
        c["clearance_mm"] = std::to_string(std::stoll(c["clearance_mm"].get<std::string>()) - 10);
        return true;
      },
      "may not be given back");
}

TEST_F(AtOnce, APlaceHasOneHeight) {
  std::string text =
      driver::test::edited(asking("r inside low; recover back", "r inside hall; recover back"),
                           "zone yard = rectangle (100 m, 0 m) to (130 m, 20 m);",
                           "zone low = prism (hall) from 0 m to 15 m;");
  text = edited(text, "position : point ", "position : point3 ");
  text = edited(text, "velocity : vector ", "velocity : vector3 ");
  text = edited(text, "retreat within hall", "retreat within low");
  text = edited(text, "r inside hall;", "r.position.z <= 20 m;");
  proved(text);
  expect_denied(
      "joint return",
      [](Json& c) {
        if (c["claim"] == "height") c["z_mm"] = "9000";
        return true;
      },
      "it is not one place");
}

// Two monitors, by night and by day, whose zones share no place; `more` of them.
std::string by_turns(const std::string& more, const std::string& order) {
  return R"(spec turns;
zone hall = rectangle (0 m, 0 m) to (40 m, 14 m);
zone east = rectangle (14 m, 0 m) to (24 m, 14 m);
zone west = rectangle (0 m, 0 m) to (12 m, 14 m);
zone yard = rectangle (100 m, 0 m) to (112 m, 14 m);
robot Cart {
  body    radius 30 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 3 cm   max_age 50 ms;
  sense   velocity : vector error 3 cm/s max_age 50 ms;
  output  push : acceleration;
  latency 20 ms;
}
fleet c : Cart;
input night : bool max_age 1 s;
controller tour : advanced for Cart extern;
controller to_east : safe for Cart = retreat within east speed 0.3 m/s;
controller to_west : safe for Cart = retreat within west speed 0.3 m/s;
controller to_hall : safe for Cart = retreat within hall speed 0.3 m/s;
controller to_yard : safe for Cart = retreat within yard speed 0.3 m/s;
monitor nights for r : Cart { "R1" always night implies r inside east; recover to_east; }
monitor days for r : Cart { "R2" always not night implies r inside west; recover to_west; }
)" + more +
         "decision lead for Cart { advanced tour; period 50 ms; priority nights > days" + order +
         "; acknowledge to_east may break days \"day comes while it is in the east\"; }\n";
}

TEST_F(AtOnce, WhereInputsExcludeEachOtherOnlyOneOfThemAsksForAPlace) {
  proved(by_turns("", ""));
  const auto given_back = [&](const char* key, const std::string& value) {
    return [=](Json& c) {
      if (c["claim"] == "at_once") c[key] = value;
      return true;
    };
  };
  expect_denied("joint return", given_back("alone", "nights;days"), "need not be true");
  expect_denied("joint return", given_back("inputs", "night.0=1"), "need not be true");
  expect_denied(
      "joint return",
      [](Json& c) {
        if (c["claim"] == "at_once") c["inputs"] = "night.0=1", c["alone"] = "";
        return true;
      },
      "nothing is said of a zone");
  expect_denied("joint return", given_back("monitor", "nights"), "no claim `at_once`");
  Json twice = report_;
  for (Json& o : twice["decisions"][0]["obligations"]) {
    if (o["obligation"] != "joint return") continue;
    Json other;
    for (const Json& c : o["claims"]) {
      if (c["claim"] == "at_once") other = c;
    }
    const bool by_night = other["alone"] == "days";
    other["alone"] = by_night ? "nights" : "days";
    other["inputs"] = by_night ? "night.0=0" : "night.0=1";
    o["claims"].push_back(other);
  }
  write("certificates/verification.json", twice.dump());
  EXPECT_EQ(recheck_sealed_anew().status, exit_violation);
}

TEST_F(AtOnce, WhatThreeSayIsTriedInSets) {
  const std::string storms =
      R"(input storm : bool max_age 1 s;
monitor storms for r : Cart { "R3" always storm implies r inside yard; recover to_yard; }
)";
  const Outcome with = judged(by_turns(storms, " > storms"));
  EXPECT_EQ(statuses(with.out, "joint return", ""), Statuses{"proved"}) << with.out;
  // of which one asks always, and shares no place with either
  const std::string fence =
      R"(monitor fence for r : Cart { "R3" always r inside yard; recover to_yard; }
)";
  const Outcome without = judged(by_turns(fence, " > fence"));
  EXPECT_EQ(statuses(without.out, "joint return", ""), Statuses{"unknown"}) << without.out;
  const std::string wide =
      R"(monitor fence for r : Cart { "R3" always r inside hall; recover to_hall; }
)";
  const Outcome around = judged(by_turns(wide, " > fence"));
  EXPECT_EQ(statuses(around.out, "joint return", ""), Statuses{"proved"}) << around.out;
}

// Two monitors of a robot in one of these zones, and a third one that is within the west.
std::string in_the_west(const std::string& one, const std::string& two) {
  std::string text = by_turns(
      "monitor third for r : Cart { \"R3\" always r inside west; recover to_west; }\n", " > third");
  text = edited(text, "night implies r inside east; recover to_east;", one);
  text = edited(text, "not night implies r inside west; recover to_west;", two);
  return edited(text, "; acknowledge to_east may break days \"day comes while it is in the east\"",
                "");
}
TEST_F(AtOnce, WhatOneSideOfAnOrIsFoundForIsNotTrueByAnotherOne) {
  for (const auto& [one, two] :
       {// its condition by night or in the east, and by day alone the other one asks for no place
        std::pair("r inside hall; recover to_hall; return when night or r inside east;",
                  "not night or r inside yard; recover to_yard;"),
        // no such age is ever read, nor is anything else said of inputs
        std::pair("age(night) > 2 s or r inside yard; recover to_yard;",
                  "r inside hall; recover to_hall;"),
        // a place within a side
        std::pair("not night or (r inside east and r inside hall); recover to_east;",
                  "night or r inside yard; recover to_yard;")}) {
    const Outcome o = judged(in_the_west(one, two));
    ASSERT_EQ(statuses(o.out, "joint return", "").size(), 1U) << one << o.out << o.err;
    EXPECT_NE(statuses(o.out, "joint return", ""), Statuses{"proved"}) << one << o.out;
  }
}
// Slow enough at rest, whatever inputs are, it asks for no place; only with some of them it does.
TEST_F(AtOnce, WhoIsSlowEnoughAtRestWhateverInputsAreAsksForNoPlace) {
  const auto page = [](const std::string& slow) {
    return in_the_west("r inside yard or (" + slow + "); recover to_yard;",
                       "r inside hall; recover to_hall;");
  };
  const auto together = [this]() -> Json& {
    auto& all = report_["decisions"][0]["obligations"];
    return *std::ranges::find_if(all,
                                 [](const Json& o) { return o["obligation"] == "joint return"; });
  };
  const std::vector<std::string> written{"--attack", "1", "-o", "certificates"};
  verified(page("if night then r.speed <= 0.6 m/s else r.speed <= 0.8 m/s"), written);
  report_ = Json::parse(read("certificates/verification.json"));
  const Json whatever_told = together();
  EXPECT_EQ(whatever_told["status"], "proved") << whatever_told;
  // some inputs, or less than a robot at rest may become until a recovery acts (0.28 m/s)
  for (const char* const some :
       {"night and r.speed <= 0.6 m/s", "if night then r.speed <= 0.6 m/s else r inside east",
        "if night then r.speed <= 0.25 m/s else r.speed <= 0.26 m/s", "r.speed <= 0.25 m/s"}) {
    verified(page(some), written);
    report_ = Json::parse(read("certificates/verification.json"));
    EXPECT_NE(together()["status"], "proved") << some << together();
    together() = whatever_told;
    write("certificates/verification.json", report_.dump());
    EXPECT_EQ(recheck_sealed_anew().status, exit_violation) << some;
  }
}
// What is an `and` within an `or` is no choice of one of several zones.
TEST_F(AtOnce, NoPlaceIsFoundForWhatIsNoChoice) {
  const Outcome o = judged(in_the_west(
      "(r inside yard and r inside hall) or (r inside yard and r inside east); recover to_yard;",
      "r inside hall; recover to_hall;"));
  for (const auto& [kind, monitor] :
       {std::pair("joint return", ""), std::pair("satisfiable", "nights")}) {
    ASSERT_EQ(statuses(o.out, kind, monitor).size(), 1U) << kind << o.out << o.err;
    EXPECT_NE(statuses(o.out, kind, monitor), Statuses{"proved"}) << kind << o.out;
  }
}
// An `or` of inputs and what robots sense asks for inputs that make it true by themselves, where
// they are spoken of elsewhere, but beside a limit that a robot at rest is seen to keep.
TEST_F(AtOnce, AnOrIsTrueByItsInputsOrAtRest) {
  const auto page = [](const std::string& asked, const std::string& least = "20") {
    const std::string in = std::string(off_walls) + " and ";
    return asking(in + "load <= 60; recover back; return when " + asked,
                  in + "load >= " + least + "; recover back");
  };
  proved(page("load <= 50 or clearance(r, hall) >= 2 m"));
  expect_denied(
      "joint return",
      [](Json& c) {
        if (c["claim"] == "at_once") c["inputs"] = "load.0=55";
        return true;
      },
      "inputs and places that are not at once");
  // 0.13 m/s may be seen of who stands
  for (const char* const slow : {"r.speed <= 0.2 m/s", "0.2 m/s > r.speed"}) {
    proved(page(std::string("load <= 15 or ") + slow));
  }
  const auto joint_of = [](Json& report) -> Json& {
    return *std::ranges::find_if(report["decisions"][0]["obligations"], [](const Json& each) {
      return each["obligation"] == "joint return";
    });
  };
  const Json kept = joint_of(report_);
  for (const char* const open :
       {"load <= 15 or r.speed <= 0.03 m/s", "load <= 15 or r.speed >= 0.2 m/s",
        "load <= 15 or clearance(r, hall) >= 2 m", "not (load > 15 and r.speed > 0.03 m/s)",
        "not previously (load > 15 and r.speed > 0.03 m/s)"}) {
    const Outcome o = verified(page(open), {"--attack", "1", "-o", "certificates"});
    report_ = Json::parse(read("certificates/verification.json"));
    EXPECT_NE(joint_of(report_)["status"], "proved") << open << o.out;
    joint_of(report_) = kept;
    write("certificates/verification.json", report_.dump());
    const Outcome forged = recheck_sealed_anew();
    EXPECT_EQ(forged.status, exit_violation) << open;
    EXPECT_NE((forged.out + forged.err).find("inputs and places that are not at once"),
              std::string::npos)
        << open << forged.out;
  }
}
// What the language has for numbers and ages of inputs, a recheck reads as well.
TEST_F(AtOnce, ChoicesOfNumbersAndAgesAreRead) {
  const std::string in = std::string(off_walls) + " and ", back = "; recover back";
  proved(asking(in + "load <= (if permit then 60 else 21)" + back,
                in + "load >= 40" + back + "; return when age(load) <= 1 s"));
  for (const char* const wrong : {"load.0=45;permit.0=0", "load.0=70;permit.0=1"}) {
    expect_denied(
        "joint return",
        [&](Json& c) {
          if (c["claim"] == "at_once") c["inputs"] = wrong;
          return true;
        },
        "not all that is asked for need be true");
  }
}
// So far apart no two robots are in one zone.
TEST_F(AtOnce, DistancesThatInputsAskForAreNotTakenForGranted) {
  std::string text = in_the_west(
      "not night or (forall q : Cart, q != r : distance(r, q) >= 100 m); recover to_hall;",
      "night or r inside yard; recover to_yard;");
  text = edited(text, "fleet c : Cart;", "fleet c : Cart[2];");
  text = edited(text, "  output  push", "  hears   other robots max_age 100 ms;\n  output  push");
  const Outcome o = judged(text);
  ASSERT_EQ(statuses(o.out, "joint return", "").size(), 1U) << o.out << o.err;
  EXPECT_NE(statuses(o.out, "joint return", ""), Statuses{"proved"}) << o.out;
}

}  // namespace
}  // namespace rtac::driver::test
