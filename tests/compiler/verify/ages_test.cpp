// How old samples are that monitors ask for: one number of each signal, which whatever is said of
// it has to suit at once, and no more of it than what is read allows.
#include "tests/compiler/verify/told_testing.h"

namespace rtac::driver::test {
namespace {

class Ages : public OfToldInputs {
 protected:
  static std::string page(const std::string& property, const std::string& more = "") {
    return of_a_rover(R"(input permit : bool max_age 2 s;
input held   : bool max_age inf;
input every  : bool;
)",
                      property, more);
  }
  static std::string returning(const std::string& property, const std::string& when) {
    return page(property, "return when " + when + ";");
  }
};

TEST_F(Ages, OneThatSamplesHaveIsFoundOnBothSides) {
  for (const char* property :
       {"age(r.position) <= 50 ms", "age(r.position) <= 20 ms", "age(r.velocity) >= 30 ms",
        "age(r.position) >= 20 ms and age(r.position) <= 21 ms", "age(permit) <= 0.5 s",
        "age(permit) <= 0.5 s and permit", "age(permit) >= 2 s and permit",
        "age(held) >= 100 s and held", "age(every) <= 50 ms and every", "age(every) >= 20 ms",
        "historically[0 s, 1 s] (age(permit) <= 1 s)"}) {
    EXPECT_EQ(can_be(true, page(in(property))), "yes") << property;
  }
  for (const char* property : {"age(r.position) <= 20 ms", "age(permit) <= 0.5 s", "permit"}) {
    EXPECT_EQ(can_be(false, page(property)), "yes") << property;
  }
}

TEST_F(Ages, OneThatNoSampleHasThatIsReadIsNone) {
  for (const char* property :
       {"age(r.position) >= 5 s", "age(r.velocity) < 0 s", "age(permit) < 0 s", "age(held) < 0 s",
        "permit and age(permit) >= 3 s", "permit and not (age(permit) <= 2 s)",
        "(permit iff held) and age(permit) >= 3 s"}) {
    EXPECT_EQ(can_be(true, page(in(property))), "no") << property;
  }
}

// `age` is that of the newest sample, also when it is too old to count.
TEST_F(Ages, OfWhatNobodyReadsAnyAgeIsPossible) {
  EXPECT_EQ(can_be(true, page(in("age(permit) >= 3 s"))), "open");
  EXPECT_EQ(can_be(true, page(in("age(r.velocity) >= 5 s"))), "open");
  EXPECT_EQ(can_be(false, page("age(permit) <= 3 s")), "open");
  // what has to come every tick counts for sure when it is new
  EXPECT_EQ(can_be(true, page(in("every and age(every) >= 10 ms"))), "open");
}

TEST_F(Ages, SeveralAreOfOneSample) {
  EXPECT_EQ(can_be(true, page(in("age(permit) <= 0.5 s and age(permit) >= 1 s and permit"))), "no");
  EXPECT_EQ(can_be(true, page(in("age(r.position) <= 20 ms and age(r.position) >= 30 ms"))), "no");
  for (const char* property :
       {"r inside hall or age(permit) <= 1 s or age(permit) >= 0.5 s",
        "r inside hall or age(permit) >= 0 s", "r inside hall or age(r.position) >= 0 s"}) {
    EXPECT_EQ(can_be(false, page(property)), "no") << property;
  }
}

// No older than is declared, whatever a certificate says.
TEST_F(Ages, AnAgeInACertificateIsOneThatCounts) {
  const std::string text = page(in("age(permit) >= 1 s"));
  EXPECT_TRUE(accepts("permit.1=3/2", true, text));
  for (const char* inputs : {"permit.1=3", "permit.1=-1", "permit.1=1/2", "permit.2=1", ""}) {
    EXPECT_FALSE(accepts(inputs, true, text)) << inputs;
  }
  EXPECT_FALSE(accepts("every.0=1;every.1=1/100", true, page(in("every and age(every) >= 0 s"))));
  EXPECT_TRUE(accepts("", true, page(in("age(r.position) <= 20 ms"))));
  EXPECT_FALSE(accepts("", true, page(in("age(r.position) >= 5 s"))));
  EXPECT_FALSE(
      accepts("", true, page(in("age(r.position) <= 20 ms and age(r.position) >= 30 ms"))));
}

TEST_F(Ages, WhatIsProvedIsFoundAgainAndAgesThatNoSampleHasAreDenied) {
  const std::string told =
      "satisfiable of `fence`: told: with those inputs the property need not be";
  const std::string at_once = "at_once: with those inputs not all that is asked for need be true";
  const std::string young = in("age(permit) <= 0.5 s and age(r.position) <= 20 ms");
  expect_denied(
      returning(young, "age(permit) >= 0.2 s and age(r.position) >= 10 ms"),
      {{returning(in("age(permit) < 0 s and age(r.position) <= 20 ms"), "age(permit) >= 0 s"),
        told},
       {returning(young, "age(permit) >= 1 s"), "P2b of `fence`: " + at_once},
       {returning(young, "age(r.position) >= 30 ms"), "joint return: " + at_once}});
  expect_denied(page("r inside hall"),
                {{returning("r inside hall", "age(r.position) >= 5 s"),
                  "P2b of `fence`: it rests on no claim `at_once`"},
                 {page(in("age(r.position) >= 5 s")),
                  "satisfiable of `fence`: nothing that its robot may sense makes it so"}});
}

TEST_F(Ages, WhatNoSampleHasIsRefuted) {
  expect("refuted", "satisfiable", "fence", page(in("age(r.position) >= 5 s")));
  expect("refuted", "P2b", "fence", returning("r inside hall", "age(r.position) >= 5 s"));
  expect("refuted", "joint return", "", returning("r inside hall", "age(held) < 0 s"));
  expect("refuted", "P2b", "fence", returning(in("age(permit) <= 0.5 s"), "age(permit) >= 1 s"));
  // of a velocity that nobody reads
  expect("unknown", "P2b", "fence", returning("r inside hall", "age(r.velocity) >= 5 s"));
}

// On one side of an `or`, beside a place: that side need not be so where the place is found.
TEST_F(Ages, ASideOfAnOrIsNotSoByAnotherAge) {
  const Outcome o = verified(returning(in("age(r.position) >= 30 ms"),
                                       "age(r.position) <= 20 ms or clearance(r, hall) >= 20 m"),
                             {"--attack", "1", "--format", "json"});
  EXPECT_NE(statuses(o.out, "P2b", "fence"), Statuses{"proved"}) << o.out;
  EXPECT_NE(statuses(o.out, "joint return", ""), Statuses{"proved"}) << o.out;
}

}  // namespace
}  // namespace rtac::driver::test
