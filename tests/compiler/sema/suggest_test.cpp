// Suggestions name the likely word, never a far-fetched one.
#include "compiler/sema/suggest.h"

#include <gtest/gtest.h>

namespace rtac::sema {
namespace {

TEST(Suggest, CountsEdits) {
  EXPECT_EQ(edit_distance("free", "free"), 0);
  EXPECT_EQ(edit_distance("fre", "free"), 1);
  EXPECT_EQ(edit_distance("frea", "free"), 1);
  EXPECT_EQ(edit_distance("trun", "turn"), 1) << "a swap of neighbours is one slip";
  EXPECT_EQ(edit_distance("Free", "fREE"), 0) << "capitals do not count";
  EXPECT_EQ(edit_distance("abc", "xyz"), 3);
}

TEST(Suggest, FindsTheNearest) {
  EXPECT_EQ(nearest("fre", {"arena", "free", "fence"}), "free");
  EXPECT_EQ(nearest("turn_bak", {"go_charge", "turn_back"}), "turn_back");
  EXPECT_EQ(nearest("ab", {"ac", "ad"}), "ac") << "the first of equals";
}

TEST(Suggest, IsSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest("somewhere", {"arena", "free"}), std::nullopt);
  EXPECT_EQ(nearest("q", {"r"}), std::nullopt) << "one letter is no basis for a guess";
}

TEST(Suggest, ListsWhatThereIs) {
  EXPECT_EQ(did_you_mean("fre", {"free"}, "zones"), "did you mean `free`?");
  EXPECT_EQ(did_you_mean("x", {"a", "b", "c"}, "zones"), "the zones are `a`, `b` and `c`");
  EXPECT_EQ(did_you_mean("x", {}, "zones"), "there are no zones");
}

}  // namespace
}  // namespace rtac::sema
