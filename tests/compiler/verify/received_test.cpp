// Zones that are received: what holds of any zone that stays as it is is proved, and what depends
// on where it is stays open.
#include <algorithm>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

std::string site_with(const std::string& property, const std::string& order,
                      const std::string& more = "") {
  return R"(spec yard;
zone yard = rectangle (0 m, 0 m) to (10 m, 8 m);
input closed : zone[32] max_age inf;
robot Cart {
  body radius 0.25 m;
  motion unicycle { speed <= 1 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; turn_accel <= 8 rad/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  sense heading : angle error 2 deg max_age 100 ms;
  output drive : twist;
  latency 30 ms;
}
fleet c : Cart;
controller policy : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
controller back : safe for Cart = retreat within yard speed 0.3 m/s;
monitor fence for r : Cart { "R1: in the yard" always r inside yard; recover back; }
monitor nofly for r : Cart { "R2: out of what is closed" always )" +
         property + R"(; recover stop; hold when violated "who closes it lets it out"; }
decision gate for Cart { advanced policy; period 50 ms; priority )" +
         order + "; " + more + "}\n";
}
const char* const stays_out = "distance(r, closed) >= 20 cm";

class ReceivedZones : public Verify {};

TEST_F(ReceivedZones, WhatDependsOnWhereTheyAreIsUnknown) {
  const Outcome o = verified(site_with(stays_out, "nofly > fence"), {"--format", "json"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  for (const char* const kind : {"P1a", "P2a", "P3"}) {
    EXPECT_EQ(statuses(o.out, kind, "nofly"), Statuses{"proved"}) << kind;
  }
  EXPECT_EQ(statuses(o.out, "P2b", "nofly"), Statuses{"acknowledged"});
  EXPECT_EQ(statuses(o.out, "satisfiable", "nofly"), Statuses{"unknown"});
  EXPECT_EQ(statuses(o.out, "not vacuous", "nofly"), Statuses{"unknown"});
  EXPECT_EQ(statuses(o.out, "joint return", ""), Statuses{"unknown"});
  EXPECT_NE(o.out.find("as long as the zone that was received stays as it is"), std::string::npos);
  EXPECT_NE(o.out.find("does not change meanwhile is assumed"), std::string::npos);
  // who moves is overruled, and who stops keeps both
  EXPECT_EQ(statuses(o.out, "C", "nofly"), Statuses{"proved"});
  EXPECT_EQ(statuses(o.out, "C", "fence"), Statuses{"proved"});
  EXPECT_NE(o.out.find("`nofly` ranks higher"), std::string::npos) << o.out;
}

TEST_F(ReceivedZones, WhatIsProvedIsFoundAgain) {
  const Outcome o = verified(site_with(stays_out, "nofly > fence"), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_inconclusive) << again.out << again.err;
  EXPECT_NE(again.out.find("0 not proved, 0 unknown"), std::string::npos) << again.out;
}

// Nobody looks after what ranks lower than a recovery that moves.
TEST_F(ReceivedZones, WhoMovesMayBreakThem) {
  const Outcome refused = verified(site_with(stays_out, "fence > nofly"));
  EXPECT_EQ(refused.status, exit_spec_errors) << refused.out;
  EXPECT_NE(refused.err.find("`back` may enter it"), std::string::npos) << refused.err;
  const Outcome kept_in = verified(site_with("r inside closed", "fence > nofly"));
  EXPECT_NE(kept_in.err.find("`back` may leave it"), std::string::npos) << kept_in.err;
  const Outcome accepted = verified(
      site_with(stays_out, "fence > nofly", "acknowledge back may break nofly \"it is slow\"; "),
      {"--format", "json"});
  EXPECT_EQ(accepted.status, exit_inconclusive) << accepted.out << accepted.err;
  EXPECT_EQ(statuses(accepted.out, "C", "nofly"), Statuses{"acknowledged"}) << accepted.out;
}

// It is enough to stand, wherever the zone is: nothing of that depends on it.
TEST_F(ReceivedZones, WhoMayBeNearSlowlyIsGivenBackAtRest) {
  std::string text = site_with(std::string(stays_out) + " or r.speed <= 0.85 m/s", "nofly > fence");
  text = edited(text, " hold when violated \"who closes it lets it out\";", "");
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "P2b", "nofly"), Statuses{"proved"}) << o.out;
  EXPECT_EQ(statuses(o.out, "C", "nofly"), Statuses{"proved"}) << o.out;  // `back` is as slow
}

TEST_F(ReceivedZones, OnlyTheBrakeRecoversForThem) {
  const Outcome o =
      verified(edited(site_with(stays_out, "nofly > fence"), "recover stop;", "recover back;"));
  EXPECT_EQ(o.status, exit_spec_errors) << o.out << o.err;
  EXPECT_NE(o.err.find("error[3043]"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("`back` recovers for a zone that is received"), std::string::npos) << o.err;
}

TEST_F(ReceivedZones, AreAmongTheAssumptions) {
  write("spec.rta", site_with(stays_out, "nofly > fence"));
  const Outcome check = rtac({"check", "spec.rta"});
  EXPECT_EQ(check.status, exit_clean) << check.err;
  EXPECT_NE(check.out.find("zone closed is received: at most 32 edges, 135168 bytes of tables"),
            std::string::npos)
      << check.out;
  EXPECT_NE(
      check.out.find("assumed: closed does not change before a robot that looks at it stands"),
      std::string::npos)
      << check.out;
  ASSERT_EQ(rtac({"build", "spec.rta", "-o", "generated"}).status, exit_clean);
  const Json manifest = Json::parse(read("generated/spec_manifest.json"));
  const auto& all = manifest["assumptions"];
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Json& a) {
    return a["bound"] == "closed stays as it is" && a["checked_by"] == "UNCHECKED";
  })) << all;
}

TEST_F(ReceivedZones, AreNotPlayed) {
  write("spec.rta", site_with(stays_out, "nofly > fence"));
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  const Outcome o = rtac({"sim", "spec.rta"});
  ::unsetenv("RTAC_SIM");
  EXPECT_EQ(o.status, exit_inconclusive) << o.out;
  EXPECT_NE(o.err.find("error[9008]"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("asks for the zone `closed`, which is received while it runs"),
            std::string::npos)
      << o.err;
}

}  // namespace
}  // namespace rtac::driver::test
