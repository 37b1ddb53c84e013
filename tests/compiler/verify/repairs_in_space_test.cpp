// What is offered of heights works, to the last, and no less does.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

class RepairsInSpace : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  // Proved, and accepted by a recheck.
  static bool works(const std::string& text) {
    return verified(text, {"-o", "proofs"}).status == exit_clean &&
           rtac({"verify", "--recheck", "proofs"}).status == exit_clean;
  }
  // The number between the two.
  static double between(const std::string& text, const std::string& before,
                        const std::string& after) {
    const std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << text;
    if (at == std::string::npos) return 0;
    const std::size_t begin = at + before.size();
    return std::stod(text.substr(begin, text.find(after, begin) - begin));
  }
  static std::string m(double metres) { return std::to_string(metres) + " m"; }
};

TEST_F(RepairsInSpace, ABandThatIsTooLowIsToldHowMuchItHasToGrow) {
  const auto page = [](const std::string& band) {
    return "spec band;\nzone yard = rectangle (0 m, 0 m) to (40 m, 30 m);\n"
           "zone plain = prism (yard) from 20 m to 21 m;\nzone band = " +
           band + ";\n" + a_quad +
           "controller back : safe for Quad = retreat within band speed 0.5 m/s;\n"
           "monitor fence for r : Quad { \"R1\" always r inside band; recover back; }\n"
           "decision fly for Quad { advanced policy; period 50 ms; priority fence; }\n";
  };
  const Outcome o = verified(page("plain"));
  EXPECT_EQ(o.status, exit_violation) << o.out;
  const double by = between(o.err, "`grow(band, ", " m)` in place of `band`");
  EXPECT_TRUE(works(page("grow(plain, " + m(by) + ")"))) << by;
  EXPECT_FALSE(works(page("grow(plain, " + m(0.95 * by) + ")"))) << by;
}

// What a zone of the plane leaves of one with height is as high as that: written so, it works.
TEST_F(RepairsInSpace, AZoneOfThePlaneIsOfferedAsHighAsTheOther) {
  const auto page = [](const std::string& inner, const std::string& monitors,
                       const std::string& order) {
    return "spec plot;\n"
           "zone air = prism (rectangle (0 m, 0 m) to (60 m, 40 m)) from 0 m to 30 m;\n"
           "zone plot = rectangle (0 m, 0 m) to (60 m, 40 m);\nzone inner = " +
           inner + ";\n" + a_quad +
           "controller flat : safe for Quad = retreat within inner speed 0.5 m/s;\n"
           "controller level : safe for Quad = retreat within plot speed 0.5 m/s;\n" +
           monitors + "decision fly for Quad { advanced policy; period 50 ms; priority " + order +
           "; }\n";
  };
  const std::string over =
      "monitor over for r : Quad { \"R1\" always clearance(r, plot) >= 2 m; recover ";
  const std::string air =
      "monitor air_only for r : Quad { \"R2\" always r inside air; recover flat; }\n";
  const std::string left = "air & prism (shrink(plot, 2 m)) from 0 m to 30 m";
  const std::string its_own = over + "flat; }\n", another = over + "level; }\n" + air;
  const Outcome own = verified(edited(page("air", its_own, "over"), "inner speed", "air speed"));
  EXPECT_EQ(own.status, exit_inconclusive) << own.out << own.err;
  EXPECT_NE(own.err.find("works, such as `" + left + "`"), std::string::npos) << own.err;
  EXPECT_TRUE(works(page(left, its_own, "over")));
  const Outcome other =
      verified(edited(page("air", another, "air_only > over"), "inner speed", "air speed"));
  EXPECT_EQ(other.status, exit_inconclusive) << other.out << other.err;
  EXPECT_NE(other.err.find("that is `" + left + "` works"), std::string::npos) << other.err;
}

// Who is found above where it lands waits there, and above the limit for ever.
TEST_F(RepairsInSpace, ALandingAboveItsLimitIsToldHowLowItHasToEnd) {
  const auto page = [](const std::string& height, const std::string& always) {
    return "spec low;\n" + a_quad + "controller down : safe for Quad = land to " + height +
           " speed 0.5 m/s;\nmonitor low for r : Quad { \"R1\" always " + always +
           "; recover down; }\n"
           "decision fly for Quad { advanced policy; period 50 ms; priority low; }\n";
  };
  const std::string limit = "r.position.z <= 6 m";
  const Outcome o = verified(page("10 m", limit), {"-o", "proofs"});
  EXPECT_EQ(o.status, exit_violation) << o.out;
  const Outcome shown = rtac({"sim", "spec.rta", "--replay", "proofs/violation.trace"});
  EXPECT_EQ(shown.status, exit_violation) << shown.out << shown.err;
  const double to = between(o.out, "`land to ", " m` in `down` works");
  EXPECT_TRUE(works(page(m(to), limit))) << to;
  EXPECT_FALSE(works(page(m(1.05 * to), limit))) << to;
  // at rest it is slow enough, wherever that is
  EXPECT_TRUE(works(page("10 m", limit + " or r.speed <= 2 m/s")));
}

// A landing for which inputs ask, and which leaves two zones, has to end above what both leave out.
TEST_F(RepairsInSpace, ALandingThatInputsAskForEndsAboveAllThatIsKeptOff) {
  const auto page = [](const std::string& land) {
    return "spec hut;\n"
           "zone air = prism (rectangle (0 m, 0 m) to (60 m, 40 m)) from 0 m to 40 m;\n"
           "zone hut = prism (rectangle (25 m, 15 m) to (35 m, 25 m)) from 0 m to 6 m;\n"
           "zone away = air - grow(hut, 1 m);\n" +
           std::string(a_quad) + "input link : bool max_age 1 s;\n" +
           "controller down : safe for Quad = land to " + land +
           " speed 0.5 m/s;\n"
           "controller off : safe for Quad = retreat within away speed 0.5 m/s;\n"
           "monitor lost for r : Quad { \"R1\" always once[0 s, 2 s] link; recover down; }\n"
           "monitor walls for r : Quad { \"R2\" always r inside air; recover off; }\n"
           "monitor roof for r : Quad { \"R3\" always distance(r, hut) >= 1 m; recover off; }\n"
           "decision fly for Quad { advanced policy; period 50 ms;"
           " priority roof > walls > lost; }\n";
  };
  const Outcome o = verified(page("0.5 m"));
  EXPECT_NE(o.status, exit_clean) << o.out << o.err;
  const double least = between(o.out, "what works: `land to ", " m` in `down` works");
  EXPECT_TRUE(works(page(m(least)))) << least;
  EXPECT_FALSE(works(page(m(0.95 * least)))) << least;
}

// Who goes back on its height and who lands take over from each other where neither has what the
// other one asks: in a zone up to the limit the former leads down to it.
TEST_F(RepairsInSpace, AZoneUpToALimitOfHeightIsOffered) {
  const auto page = [](const std::string& within, const std::string& fence,
                       const std::string& order) {
    return "spec plot;\nzone plot = rectangle (0 m, 0 m) to (60 m, 40 m);\nzone low = " + within +
           ";\n" + a_quad +
           "controller down : safe for Quad = land to 1 m speed 0.6 m/s;\n"
           "controller back : safe for Quad = retreat within low speed 0.8 m/s;\n"
           "monitor roof for r : Quad { \"R1\" always r.position.z <= 50 m; recover down; }\n"
           "monitor over for r : Quad { \"R2\" always " +
           fence +
           "; recover back; }\n"
           "decision fly for Quad { advanced policy; period 50 ms; priority " +
           order + "; }\n";
  };
  const std::pair<const char*, const char*> fences[] = {
      {"r inside plot", "prism (plot) from 0 m to 50 m"},
      {"clearance(r, plot) >= 1 m", "prism (shrink(plot, 1 m)) from 0 m to 50 m"}};
  for (const auto& [fence, offered] : fences) {
    for (const char* order : {"roof > over", "over > roof"}) {
      const Outcome o = verified(edited(page("plot", fence, order), "within low", "within plot"));
      EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
      const std::string text = "`back` within a zone that is `" + std::string(offered) + "` works";
      EXPECT_NE(o.out.find(text), std::string::npos) << o.out;
      EXPECT_TRUE(RepairsInSpace::works(page(offered, fence, order))) << fence << order;
    }
  }
}

// Of a zone without an end, too, whose rest of the plane is as high as the limit.
TEST_F(RepairsInSpace, AllButAZoneOfThePlaneIsNoHigherThanALimit) {
  const Outcome o = verified(
      "spec pit;\nzone pit = rectangle (0 m, 0 m) to (8 m, 8 m);\n"
      "zone free = complement(pit);\n" +
          a_quad +
          "controller down : safe for Quad = land to 1 m speed 0.6 m/s;\n"
          "controller back : safe for Quad = retreat within free speed 0.8 "
          "m/s;\nmonitor roof for r : Quad { \"R1\" always r.position.z <= "
          "50 m; recover down; }\nmonitor off for r : Quad { \"R2\" always r "
          "inside free; recover back; }\ndecision fly for Quad { advanced "
          "policy; period 50 ms; priority roof > off; }\n",
      {"--attack", "1"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
}

// Its hold leads it, and a brake that is spent does not follow.
TEST_F(RepairsInSpace, WhoFallsBehindItsHoldIsToldHowFastItMayBeLed) {
  const auto page = [](const std::string& speed) {
    return "spec behind;\nzone air = prism (rectangle (0 m, 0 m) to (40 m, 30 m)) from 0 m to 30 "
           "m;\n" +
           edited(a_quad, "brake >= 2", "brake >= 0.5") +
           "controller back : safe for Quad = retreat within air speed " + speed +
           ";\nmonitor fence for r : Quad { \"R1\" always r inside air; recover back; }\n"
           "decision fly for Quad { advanced policy; period 50 ms; priority fence; }\n";
  };
  const Outcome o = verified(page("1 m/s"));
  EXPECT_EQ(o.status, exit_inconclusive) << o.out;
  const double most = between(o.out, "a speed of `back` of ", " m/s works");
  EXPECT_TRUE(works(page(std::to_string(most) + " m/s"))) << most;
  EXPECT_FALSE(works(page(std::to_string(1.05 * most) + " m/s"))) << most;
}

}  // namespace
}  // namespace rtac::driver::test
