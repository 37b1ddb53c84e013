// What inputs have been decides: `since` and `within ... of` as they are defined, of inputs that
// stay for as long as it looks back; and of what nobody reads nothing is proved.
#include "tests/compiler/verify/told_testing.h"

namespace rtac::driver::test {
namespace {

class OfThePast : public OfToldInputs {
 protected:
  static std::string page(const std::string& property, const std::string& more = "") {
    return of_a_rover(R"(input open, locked, shut, bell : bool max_age 1 s;
input x : real in 0 .. 9 max_age 1 s;
input p, q : point in 0 .. 9 m max_age 1 s;
)",
                      property, more);
  }
  static std::string returning(const std::string& when) {
    return page("r inside hall", "return when " + when + ";");
  }
};
const std::string never_since = "(locked since[0 s, 1 s] open) and not locked and not open";

TEST_F(OfThePast, WhatInputsThatStayMakeSoIsFoundOnBothSides) {
  for (const char* property :
       {"(locked since[0 s, 1 s] open)", "(locked since[100 ms, 1 s] open)",
        "(locked since[0 s, 1 s] open) and not locked", "not (locked since open)",
        "(locked within 1 s of open)", "not (locked within 1 s of open)",
        "(locked within 1 s of open) and open", "(open for 1 s)", "not (open for 1 s)",
        "once[50 ms, 1 s] open and locked", "historically[0 s, 1 s] not open",
        "previously open and open", "mean[0 s, 1 s](x) <= 5"}) {
    EXPECT_EQ(can_be(true, page(in(property))), "yes") << property;
    EXPECT_EQ(can_be(false, page("r inside hall or " + std::string(property))), "yes") << property;
  }
}

TEST_F(OfThePast, SinceItIsSoNowOrItIsSince) {
  EXPECT_EQ(can_be(true, page(in(never_since))), "no");
  // it began before now, and lasts
  EXPECT_EQ(can_be(true, page(in("(locked since[50 ms, 1 s] open) and not locked"))), "no");
  // whoever is open now is locked since it was
  EXPECT_EQ(can_be(false, page("r inside hall or (locked since[0 s, 1 s] open) or not open")),
            "no");
  // with those that stay, though it might have been open before
  EXPECT_EQ(can_be(true, page(in("(locked since[0 s, 1 s] open) and not open"))), "open");
}

TEST_F(OfThePast, AMissShowsOnlyAsLongAsItIsNotSo) {
  EXPECT_EQ(can_be(true, page(in("not (locked within 1 s of open) and locked"))), "no");
  EXPECT_EQ(can_be(false, page("r inside hall or (locked within 1 s of open) or not locked")),
            "no");
}

// That of a longer time is that of a shorter one, too.
TEST_F(OfThePast, WhatHasLastedLongerHasLasted) {
  EXPECT_EQ(can_be(true, page(in("(open for 100 ms) and not (open for 50 ms)"))), "open");
}

TEST_F(OfThePast, ARecheckReadsTheSame) {
  const std::string since = page(in("(locked since[0 s, 1 s] open)"));
  EXPECT_TRUE(accepts("locked.0=0;open.0=1", true, since));
  EXPECT_FALSE(accepts("locked.0=1;open.0=0", true, since));
  const std::string before = page(in("(locked since[50 ms, 1 s] open)"));
  EXPECT_TRUE(accepts("locked.0=1;open.0=1", true, before));
  EXPECT_FALSE(accepts("locked.0=0;open.0=1", true, before));
  const std::string miss = page(in("not (locked within 1 s of open)"));
  EXPECT_TRUE(accepts("locked.0=0;open.0=1", true, miss));
  EXPECT_FALSE(accepts("locked.0=1;open.0=1", true, miss));
  EXPECT_FALSE(accepts("locked.0=0;open.0=0", true, miss));
  for (const char* locked : {"0", "1"}) {
    for (const char* open : {"0", "1"}) {
      const std::string all = "locked.0=" + std::string(locked) + ";open.0=" + open;
      EXPECT_FALSE(accepts(all, true, page(in(never_since)))) << all;
    }
  }
  EXPECT_FALSE(accepts("open.0=1", true, page(in("not (open for 100 ms)"))));
}

// A number that nobody reads makes nothing so: neither how often it was, nor how far two points
// are.
TEST_F(OfThePast, WhatNobodyReadsIsOpen) {
  for (const char* property :
       {"count[0 s, 1 s](open) >= 100", "rate[0 s, 1 s](x) >= 100 1/s", "sqrt(x) >= 10",
        "distance(p, q) >= 100 m", "r.speed <= sqrt(x) * 1 m/s"}) {
    EXPECT_EQ(can_be(true, page(in(property))), "open") << property;
  }
  const std::string other = "sense velocity", hears = "hears other robots max_age 100 ms;\n  ";
  const auto two = [&](const std::string& property) {
    return edited(edited(page(in(property)), other, hears + other), "fleet r1", "fleet r2, r1");
  };
  // of no others it would be so
  EXPECT_EQ(can_be(true, two("(forall o : Rover, o != r : distance(r, o) >= 1 m and open)")),
            "yes");
  EXPECT_EQ(can_be(true, two("(forall o : Rover, o != r : distance(r, o) >= 1 m and open) "
                             "and not open")),
            "open");
  EXPECT_EQ(can_be(true, two("count(o : Rover, o != r : distance(r, o) <= 1 m and open) >= 1")),
            "open");
}

TEST_F(OfThePast, WhatIsProvedIsFoundAgainAndWhatNeverWasIsDenied) {
  const std::string before = "(locked since[0 s, 1 s] open)", not_told = "told: with those inputs ";
  expect_denied(
      page(in(before + " and not locked and not (shut within 1 s of bell)")),
      {{page(in(before + " and not locked and not open and not (shut within 1 s of bell)")),
        "satisfiable of `fence`: " + not_told + "the property need not be true"},
       {page(in(before + " and not (shut within 1 s of bell) and shut")),
        "satisfiable of `fence`: " + not_told + "the property need not be true"}});
  expect_denied(page("r inside hall or " + before),
                {{page("r inside hall or " + before + " or not open"),
                  "not vacuous of `fence`: " + not_told + "the property need not be false"}});
  const std::string at_once = "at_once: with those inputs not all that is asked for need be true";
  expect_denied(returning(before), {{returning(never_since), "P2b of `fence`: " + at_once},
                                    {returning(never_since), "joint return: " + at_once}});
}

TEST_F(OfThePast, WhatNeverWasIsRefutedAndWhatNobodyReadsIsUnknown) {
  expect("refuted", "satisfiable", "fence", page(in(never_since)));
  expect("refuted", "P2b", "fence", returning(never_since));
  expect("refuted", "joint return", "", returning(never_since));
  expect("refuted", "not vacuous", "fence",
         page("r inside hall or (locked since[0 s, 1 s] open) or not open"));
  for (const char* kind : {"satisfiable", "P2b"}) {
    expect("unknown", kind, "fence", page(in("sqrt(x) >= 10")));
  }
  expect("unknown", "joint return", "", page(in("sqrt(x) >= 10")));
  expect("unknown", "P2b", "fence", returning("count[0 s, 1 s](open) >= 100"));
}

}  // namespace
}  // namespace rtac::driver::test
