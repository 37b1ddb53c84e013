// What is proved of a robot that rests is so of a robot that rests: it is no slower, and no fuller,
// than it is seen to be, and what inputs, parameters or ages are taken to say they can say.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

// Both with the same certificates: those of the first one are put under the second one.
struct Pair {
  const char *so, *not_so;
};

class AtRest : public Verify {
 protected:
  static std::string room_with(const std::string& always, const std::string& when,
                               const std::string& recover = "back") {
    return R"(spec rest;
zone room = rectangle (0 m, 0 m) to (9 m, 9 m);
zone west = rectangle (0 m, 0 m) to (4 m, 9 m);
zone east = rectangle (5 m, 0 m) to (9 m, 9 m);
)" + a_rover +
           R"(input x : real [m] in 0 .. 3 m max_age 1 s;
input p : bool max_age 1 s;
param lim : real [m] in 1 m .. 3 m = 2 m;
controller back : safe for Rover = retreat within room speed 0.3 m/s;
controller stop : safe for Rover = brake_and_hold;
monitor asked for r : Rover { "R1" always )" +
           always + "; recover " + recover + ";" +
           (when.empty() ? "" : " return when " + when + ";") +
           R"( }
decision go for Rover { advanced drive; period 50 ms; priority asked; }
)";
  }
  static std::string status(const Outcome& o, const std::string& kind, const std::string& monitor) {
    const Statuses found = statuses(o.out, kind, monitor);
    return found.size() == 1 ? found.front() : o.out + o.err;
  }
  // `kind` is proved of the first one, and its certificate says nothing of the second one, of which
  // it is not.
  static void expect_told_apart(const std::string& so, const std::string& not_so,
                                const std::string& kind, const std::string& monitor,
                                const std::string& doubt) {
    const Outcome good = verified(so, {"--attack", "1", "--format", "json", "-o", "certificates"});
    EXPECT_EQ(status(good, kind, monitor), "proved") << so;
    const std::string whole = recheck_sealed_anew().out;
    EXPECT_EQ(whole.find(doubt), std::string::npos) << so << whole;
    const Outcome bad = verified(not_so, {"--attack", "1", "--format", "json"});
    EXPECT_NE(status(bad, kind, monitor), "proved") << not_so;
    write("certificates/sources/spec.rta", not_so);
    const Outcome forged = recheck_sealed_anew();
    EXPECT_NE(forged.status, exit_clean) << not_so;
    EXPECT_NE(forged.out.find(doubt), std::string::npos) << not_so << forged.out;
  }
};

constexpr const char* at_once = "with those inputs not all that is asked for need be true";
constexpr const char* at_a_place = "it need not be true at any place that is claimed";

// From rest the look-ahead reaches more than 0.1 m/s, which no input allows.
TEST_F(AtRest, ALimitThatNoInputLiftsIsNone) {
  const Pair pairs[] = {
      {"r.speed <= 1 m/s or x >= 5 m", "r.speed <= 10 cm/s or x >= 5 m"},
      {"r.speed <= 1 m/s or lim >= 5 m", "r.speed <= 10 cm/s or lim >= 5 m"},
      {"(p implies r.speed <= 1 m/s) and (not p implies r.speed <= 2 m/s)",
       "(p implies r.speed <= 10 cm/s) and (not p implies r.speed <= 11 cm/s)"},
  };
  for (const Pair& each : pairs) {
    expect_told_apart(room_with(each.so, "", "stop"), room_with(each.not_so, "", "stop"), "P2b",
                      "asked", at_once);
  }
  // but where it does, the robot waits for it
  EXPECT_EQ(verified(room_with("r.speed <= 10 cm/s or x >= 2 m", "", "stop")).status, exit_clean);
}
TEST_F(AtRest, ALimitThatNoInputLiftsIsNoneOfSeveralMonitors) {
  std::string text = room_with("p implies r.speed <= 10 cm/s", "", "stop");
  text = edited(text, "decision go",
                "monitor other for r : Rover { \"R2\" always not p implies r.speed <= 11 cm/s; "
                "recover stop; }\ndecision go");
  text = edited(text, "priority asked", "priority asked > other");
  expect_told_apart(edited(edited(text, "10 cm/s", "1 m/s"), "11 cm/s", "1 m/s"), text,
                    "joint return", "", at_once);
}

// Who gives back when something is so, or else when inputs say so, has to be told.
TEST_F(AtRest, WhatIsToldInsteadCanBeTold) {
  const Pair pairs[] = {
      {"clearance(r, room) >= 10 m or x >= 2 m", "clearance(r, room) >= 10 m or x >= 5 m"},
      {"not (r.speed <= 10 cm/s) or x >= 2 m", "not (r.speed <= 10 cm/s) or x >= 5 m"},
      {"r.speed <= 1 mm/s or previously x >= 2 m", "r.speed <= 1 mm/s or previously x >= 5 m"},
      {"clearance(r, room) >= 10 m or lim >= 1 m", "clearance(r, room) >= 10 m or lim >= 2 m"},
      {"not (clearance(r, room) >= 40 cm and x <= 2 m)",
       "not (clearance(r, room) >= 40 cm and x <= 5 m)"},
  };
  for (const Pair& each : pairs) {
    for (const char* const kind : {"P2b", "joint return"}) {
      expect_told_apart(
          room_with("r inside room", each.so), room_with("r inside room", each.not_so), kind,
          kind == std::string("P2b") ? "asked" : "",
          "`return when` of `asked` may ask for inputs and places that are not at once");
    }
  }
  for (const char* const when : {"clearance(r, room) >= 10 m or age(r.position) >= 1 s",
                                 "clearance(r, room) >= 10 m or count[0 s, 100 ms](p) >= 5"}) {
    const Outcome o = verified(room_with("r inside room", when), {"--format", "json"});
    EXPECT_EQ(status(o, "P2b", "asked"), "unknown") << when;
  }
  // what a witness has is what makes it true
  const Outcome o = verified(room_with("r inside room", "p or clearance(r, room) >= 10 m"));
  EXPECT_NE(o.out.find("with p\n"), std::string::npos) << o.out;
}

TEST_F(AtRest, NothingIsSeenThatIsNeverSo) {
  const Pair pairs[] = {
      {"r.speed <= 1 m/s or r.speed <= 0.9 m/s", "r.speed <= 1 mm/s or r.speed <= 2 mm/s"},
      {"r.speed <= 1 m/s or x >= 5 m", "r.speed <= 1 mm/s or x >= 5 m"},
  };
  for (const Pair& each : pairs) {
    const std::string so = room_with(each.so, "", "stop"), no = room_with(each.not_so, "", "stop");
    (void)verified(so, {"-o", "certificates"});
    EXPECT_EQ(recheck_sealed_anew().out.find("satisfiable"), std::string::npos) << so;
    EXPECT_NE(status(verified(no, {"--attack", "1", "--format", "json"}), "satisfiable", "asked"),
              "proved");
    write("certificates/sources/spec.rta", no);
    EXPECT_NE(recheck_sealed_anew().out.find("satisfiable"), std::string::npos) << no;
  }
}
// Of zones that have nothing in common, both sides of an `or`.
TEST_F(AtRest, APlaceIsInTheZonesOfOneSide) {
  const Pair pairs[] = {
      {"r inside room and (r inside west or r inside east or x >= 5 m)",
       "r inside room and ((r inside west and r inside east) or x >= 5 m)"},
  };
  for (const Pair& each : pairs) {
    expect_told_apart(room_with(each.so, ""), room_with(each.not_so, ""), "satisfiable", "asked",
                      at_a_place);
  }
  const Outcome o = verified(
      room_with("(p implies (r inside west and r inside east)) and (not p implies (r inside west "
                "and r inside east))",
                ""),
      {"--attack", "1", "--format", "json"});
  EXPECT_EQ(status(o, "satisfiable", "asked"), "unknown");
}
TEST_F(AtRest, APlanIsInTheZonesOfOneSide) {
  const auto planned = [](const std::string& always) {
    std::string text = edited(room_with("r inside room", ""), "  output thrust",
                              "  input plan : path[16] tracking <= 10 cm;\n  output thrust");
    text.erase(text.find("monitor asked"));
    return text +
           "controller dream : advanced for Rover extern;\n"
           "controller careful : safe for Rover extern;\n"
           "monitor way for r : Rover { \"R2\" always " +
           always +
           "; }\ndecision choose for Rover { advanced dream; safe careful; on plan; priority way; "
           "}\n";
  };
  const std::string one = planned("r.plan inside west or r.plan inside east");
  for (const char* const none :
       {"(r.plan inside west and r.plan inside east) or (r.plan inside east and r.plan inside "
        "west)",
        "(r.plan inside west or r.plan inside east) and r.plan inside room - west - east"}) {
    expect_told_apart(one, planned(none), "satisfiable", "way", at_a_place);
  }
}

// More than a full battery is seen with comes about nowhere, whatever inputs say.
TEST_F(AtRest, NoBatteryIsSeenFullerThanAFullOne) {
  const auto charged = [](const std::string& always) {
    std::string text = room_with("r inside room and " + always, "", "home");
    text =
        edited(text, "  output thrust",
               "  sense battery : ratio error 1 % max_age 1 s;\n  energy { drive <= 0.1 %/m; idle "
               "<= 0.005 %/s; drain <= 0.1 %/s; charge >= 1 %/s at dock; held <= 30 s; detour <= "
               "5 m; }\n  output thrust");
    text = edited(text, "controller back", "site dock = (2 m, 2 m);\ncontroller back");
    return edited(text, "controller stop",
                  "controller home : safe for Rover = route to dock within room speed 0.3 "
                  "m/s;\ncontroller stop");
  };
  expect_told_apart(charged("(r.battery >= energy_to(dock) + 20 % or x >= 5 m)"),
                    charged("(r.battery >= energy_to(dock) + 99 % or x >= 5 m)"), "P2b", "asked",
                    at_once);
  const Outcome o =
      verified(charged("(p implies r.battery >= 99.9 %) and (not p implies r.battery >= 99.8 %)"),
               {"--attack", "1", "--format", "json"});
  EXPECT_EQ(status(o, "P2b", "asked"), "refuted");
  EXPECT_EQ(status(o, "satisfiable", "asked"), "refuted");
}

// What inputs may say instead is no reason to end where a zone comes.
TEST_F(AtRest, AZoneThatComesIsWhereItIsWhateverIsTold) {
  const auto timed = [](const std::string& always) {
    std::string text = room_with(always, "", "home");
    text = edited(text, "spec rest;", "spec rest;\nclock utc;");
    text = edited(text, "controller back",
                  "zone lessons = rectangle (6 m, 0 m) to (9 m, 9 m) during 00:00 .. 23:50;\nsite "
                  "dock = (7.5 m, 4.5 m);\ncontroller back");
    return edited(text, "controller stop",
                  "controller home : safe for Rover = route to dock within room speed 0.3 "
                  "m/s;\ncontroller stop");
  };
  for (const char* const always :
       {"distance(r, lessons) >= 30 cm", "distance(r, lessons) >= 30 cm or x >= 5 m"}) {
    const Outcome o = verified(timed(always), {"--attack", "1"});
    EXPECT_NE(o.err.find("error[5030]"), std::string::npos) << always << o.err;
  }
}

// Who stands still makes no room for others.
TEST_F(AtRest, RobotsThatAreCountedDoNotPart) {
  const std::string text = edited(
      edited(room_with("count(q : Rover, q != r : distance(r, q) <= 50 cm) <= 0", "", "stop"),
             "fleet r1", "fleet r1, r2"),
      "  output thrust", "  hears other robots max_age 100 ms;\n  output thrust");
  const Outcome o = verified(text, {"--attack", "1", "--format", "json"});
  EXPECT_EQ(status(o, "P2b", "asked"), "unknown");
}

// A recovery that inputs alone ask for has to come to where its condition holds, by a way.
TEST_F(AtRest, WhoIsAskedToComeToAPlaceIsLedThere) {
  const auto asked = [](const std::string& zone) {
    const std::string text =
        edited(room_with("not p", "not p and clearance(r, hall) >= 30 cm"), "controller back",
               "zone hall = " + zone + ";\ncontroller back");
    return edited(text, "retreat within room", "retreat within hall");
  };
  const std::string one = "rectangle (0 m, 0 m) to (9 m, 9 m)";
  expect_told_apart(
      asked(one),
      asked(one + " | rectangle (8 m, 4 m) to (12 m, 4.4 m) | rectangle (12 m, 4 m) to "
                  "(12.6 m, 8 m)"),
      "P2b", "asked", "P2b of `asked`");
  EXPECT_EQ(verified(asked(one), {"-o", "certificates"}).status, exit_clean);
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
}

}  // namespace
}  // namespace rtac::driver::test
