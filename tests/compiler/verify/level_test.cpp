// Who goes back within a prism keeps its height between the ends of it: a limit of height that
// leaves room beyond either end is kept, and no other one.
#include "tests/compiler/verify/forged.h"

namespace rtac::driver::test {
namespace {

class Level : public Forged {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  static std::string page(const std::string& limit, const std::string& recovery = "retreat") {
    return "spec sky;\nzone sky = prism (rectangle (0 m, 0 m) to (60 m, 50 m)) from 2 m to 40 "
           "m;\n" +
           a_quad + "controller back : safe for Quad = " + recovery +
           " within sky speed 0.8 m/s;\n"
           "controller stop : safe for Quad = brake_and_hold;\n"
           "monitor cage for r : Quad { \"R1\" always r inside sky; recover back; }\n"
           "monitor level for r : Quad { \"R2\" always " +
           limit +
           "; recover stop; hold when violated \"pilot\"; }\n"
           "decision fly for Quad { advanced policy; period 50 ms; priority cage > level; }\n";
  }
  static std::string below(double z) { return "r.position.z <= " + std::to_string(z) + " m"; }
  static std::string above(double z) { return "r.position.z >= " + std::to_string(z) + " m"; }
  static std::string status(const std::string& text, const std::string& kind,
                            const std::string& monitor) {
    const Outcome o = verified(text, {"--format", "json", "--attack", "1"});
    const auto found = statuses(o.out, kind, monitor);
    return found.size() == 1 ? found.front() : o.out + o.err;
  }
  static std::string kept(const std::string& text) { return status(text, "C", "level"); }
};

TEST_F(Level, WhoGoesBackInAPrismIsLedOffItsEndsAndNoFurther) {
  for (const char* recovery : {"retreat", "loiter"}) {
    EXPECT_EQ(kept(page(below(8), recovery)), "proved") << recovery;
    EXPECT_EQ(kept(page(above(34), recovery)), "proved") << recovery;
    EXPECT_NE(kept(page(below(2.5), recovery)), "proved") << recovery;
    EXPECT_NE(kept(page(above(39.5), recovery)), "proved") << recovery;
  }
}

// What is asked before control returns may lead to another height.
TEST_F(Level, NotWhereControlReturnsElsewhere) {
  const std::string high =
      edited(page(below(8)), "recover back;",
             "recover back; return when clearance(r, complement(sky)) >= 9 m;");
  EXPECT_NE(kept(high), "proved");
}

// Too near to the floor, or to the ceiling, for any place where all give control back.
TEST_F(Level, ALimitInTheWayOfAllIsToldHowMuchMoreItHasToLeave) {
  const auto needed = [](const std::string& text, const std::string& which) {
    const Outcome o = verified(text, {"--attack", "1"});
    const std::string before = "a limit of height of `level` that is ",
                      after = " m " + which + " is needed";
    const std::size_t at = o.out.find(before), end = o.out.find(after);
    EXPECT_NE(end, std::string::npos) << o.out;
    return end == std::string::npos ? 0 : std::stod(o.out.substr(at + before.size()));
  };
  const double up = needed(page(below(3.5)), "higher"), down = needed(page(above(39)), "lower");
  EXPECT_EQ(status(page(below(3.5 + up)), "joint return", ""), "proved") << up;
  EXPECT_EQ(status(page(below(3.5 + 0.95 * up)), "joint return", ""), "refuted") << up;
  EXPECT_EQ(status(page(above(39 - down)), "joint return", ""), "proved") << down;
  EXPECT_EQ(status(page(above(39 - 0.95 * down)), "joint return", ""), "refuted") << down;
}

// Of its own monitor: control is given back where it rests, if the limit leaves no more than the
// radius of the body of the prism beyond it.
TEST_F(Level, ItsOwnLimitMayLieARadiusInside) {
  const auto own = [](double low, double high) {
    return edited(page(above(low) + " and " + below(high)),
                  "recover stop; hold when violated \"pilot\"", "recover back");
  };
  const Outcome o = verified(own(2.3, 39.7), {"-o", "proofs"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(rtac({"verify", "--recheck", "proofs"}).status, exit_clean);
  const Outcome less = verified(own(2.3, 39.6), {"--attack", "1"});
  EXPECT_EQ(less.status, exit_inconclusive) << less.out << less.err;
  EXPECT_NE(less.err.find("a ceiling of at most 39.9 m works"), std::string::npos) << less.err;
  EXPECT_EQ(verified(edited(own(2.3, 39.6), "to 40 m", "to 39.9 m")).status, exit_clean);
}

TEST_F(Level, ItsOwnLimitFurtherInsideIsDenied) {
  const std::string text = "it may come to rest at a height where control is not given back";
  prove(edited(page(below(39.8)), "recover stop; hold when violated \"pilot\"", "recover back"));
  expect_noticed_in("spec.rta", below(39.8), below(39.5), text);
}

TEST_F(Level, ALimitNearAnEndIsDenied) {
  const std::string text = "C of `level` while `back` drives: `back` may go beyond";
  prove(page(below(8)));
  expect_noticed_in("spec.rta", below(8), below(3), text);
  // the fastest step counts
  const std::string steps = "sequence retreat within sky speed 2 m/s for 30 s then retreat";
  prove(page(below(12), steps));
  expect_noticed_in("spec.rta", below(12), below(5.5), text);
  // who loiters looks for more room
  prove(page(below(8), "loiter"));
  expect_noticed_in("spec.rta", below(8), below(4), text);
  prove(page(above(34)));
  expect_noticed_in("spec.rta", above(34), above(39), text);
}

}  // namespace
}  // namespace rtac::driver::test
