// `rtac verify --recheck`: what is proved is found once more, and what was changed is noticed.
#include <algorithm>
#include <cctype>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

class Recheck : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ASSERT_EQ(verified(drone_spec(), {"-o", "certificates"}).status, exit_clean);
    report_ = Json::parse(read("certificates/verification.json"));
  }
  void write_delivery() {
    const std::string text = spec_text("specs/robot_delivery/robot_delivery.rta");
    ASSERT_EQ(verified(text, {"-o", "certificates"}).status, exit_clean);
    report_ = Json::parse(read("certificates/verification.json"));
  }
  static Outcome rechecked() { return recheck_sealed_anew(); }
  Outcome rechecked_with(const Json& report) {
    write("certificates/verification.json", report.dump(2));
    return rechecked();
  }
  // Changes the value of a claim by so much, everywhere.
  Json changed(const std::string& claim, const std::string& key, std::int64_t by) {
    Json report = report_;
    int found = 0;
    for (Json& o : report["decisions"][0]["obligations"]) {
      for (Json& c : o["claims"]) {
        if (c["claim"] != claim) continue;
        c[key] = std::to_string(std::stoll(c[key].get<std::string>()) + by);
        ++found;
      }
    }
    EXPECT_GT(found, 0) << claim << "." << key;
    return report;
  }
  Json report_;
};

// Each file as it was written, whatever in it a claim speaks of.
TEST_F(Recheck, ABrokenSealIsNoticed) {
  const std::vector<std::string> words = {"verify", "--recheck", "certificates"};
  ASSERT_EQ(rtac(words).status, exit_clean);
  const std::string seals = read("certificates/seals");
  for (const std::string file :
       {"verification.json", "sources/spec.rta", "lemmas/capsule.smt2", "specification"}) {
    const std::string before = read("certificates/" + file);
    ASSERT_FALSE(before.empty()) << file;
    write("certificates/" + file, before + "\n");
    const Outcome o = rtac(words);
    EXPECT_EQ(o.status, exit_violation) << file << o.out << o.err;
    EXPECT_NE(o.out.find("`" + file + "` is not what was written"), std::string::npos) << o.out;
    write("certificates/" + file, before);
  }
  write("certificates/seals", "");
  EXPECT_EQ(rtac(words).status, exit_violation);
  // a line that was taken out
  for (const std::string file : {"sources/spec.rta", "lemmas/capsule.smt2", "models/fly.pml"}) {
    const std::size_t at = seals.find("  " + file + "\n");
    ASSERT_NE(at, std::string::npos) << seals;
    const std::size_t begin = seals.rfind('\n', at) + 1;  // of the first line: 0
    write("certificates/seals", seals.substr(0, begin) + seals.substr(seals.find('\n', at) + 1));
    const Outcome less = rtac(words);
    EXPECT_EQ(less.status, exit_violation) << less.out;
    EXPECT_NE(less.out.find("`" + file + "` is not what was written"), std::string::npos);
  }
  write("certificates/seals", seals);
  EXPECT_EQ(rtac(words).status, exit_clean);
}

TEST_F(Recheck, NothingIsLeftOfWhatCannotBeWritten) {
  fs::create_directories("full/verification.json");
  const Outcome o = verified(drone_spec(), {"-o", "full"});
  EXPECT_EQ(o.status, exit_usage) << o.out << o.err;
  EXPECT_NE(o.err.find("`full/verification.json` is a directory"), std::string::npos) << o.err;
  EXPECT_EQ(std::distance(fs::directory_iterator("full"), fs::directory_iterator()), 1);
}

TEST_F(Recheck, AReportOfSomethingElseIsNone) {
  const auto noticed = [&](const std::string& text, const std::string& why) {
    write("certificates/verification.json", text);
    const Outcome o = rechecked();
    EXPECT_EQ(o.status, exit_violation) << o.out;
    EXPECT_NE(o.out.find(why), std::string::npos) << o.out;
  };
  const std::string none = "verification.json is no report of `rtac verify`";
  const std::string text = report_.dump();
  noticed(edited(text, "\"complete\":true", "\"complete\":false"), none);
  noticed(edited(text, "\"status\":\"proved\"", "\"status\":\"refuted\",\"status\":\"proved\""),
          none);
  Json report = report_;
  report["spec"] = "perfectly_safe";
  noticed(report.dump(), "verification.json is about `perfectly_safe`");
  report = report_;
  report["decisions"][0]["robot"] = "Tank";
  noticed(report.dump(), "`fly` is about another robot");
}

TEST_F(Recheck, WhatIsProvedIsFoundOnceMore) {
  const Outcome o = rechecked();
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

// How long others keep a recovery waiting is no proof, and all the rest of it has to be one.
TEST_F(Recheck, WhatIsDeclaredIsNotProvedAndRestsOnItsClaims) {
  write_delivery();
  const auto with = [&](const std::string& method, const auto& change) {
    Json report = report_;
    int found = 0;
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["method"] != method) continue;
      change(o);
      ++found;
    }
    EXPECT_GT(found, 0) << method;
    return rechecked_with(report);
  };
  const Outcome proved = with("declared", [](Json& o) { o["status"] = "proved"; });
  EXPECT_EQ(proved.status, exit_violation) << proved.out;
  EXPECT_NE(proved.out.find("is declared, and not proved"), std::string::npos) << proved.out;
  // a claim that is true and beside the point changes nothing of that
  const Json higher = {{"claim", "outranks"},
                       {"decision", report_["decisions"][0]["decision"]},
                       {"higher", "collision"},
                       {"lower", "battery"}};
  const Outcome outranked = with("declared", [&](Json& o) {
    if (o["obligation"] != "P2a") return;
    o["status"] = "proved";
    o["claims"].push_back(higher);
  });
  EXPECT_EQ(outranked.status, exit_violation) << outranked.out;
  EXPECT_NE(outranked.out.find("is declared, and not proved"), std::string::npos) << outranked.out;
  const Outcome empty = with("declared", [](Json& o) { o["claims"] = Json::array(); });
  EXPECT_EQ(empty.status, exit_violation) << empty.out;
  // what is accepted in so many words is not looked at, and so lends itself to no other proof
  const Json claim = {{"claim", "limits"}};
  const Outcome more = with("acknowledged", [&](Json& o) { o["claims"] = Json::array({claim}); });
  EXPECT_EQ(more.status, exit_violation) << more.out;
}

// Every bound, a little to the unsafe side.
TEST_F(Recheck, AMutatedBoundIsNoticed) {
  const struct {
    const char *claim, *key;
    std::int64_t by;
  } mistakes[] = {{"limits", "period_us", 1},
                  {"limits", "radius_mm", -1},
                  {"limits", "position_error_mm", -1},
                  {"limits", "velocity_error_mmps", -1},
                  {"limits", "position_age_us", -1},
                  {"limits", "velocity_age_us", -1},
                  {"limits", "latency_us", -1},
                  {"limits", "speed_mmps", -1},
                  {"limits", "accel_mmps2", -1},
                  {"limits", "brake_mmps2", 1},
                  {"limits", "disturbance_mmps2", -1},
                  {"limits", "brake_lag_ms", -1},
                  {"limits", "hold_mm", -4},
                  {"limits", "brake_lag_ms", 20},
                  {"limits", "brake_lag_permille", 1},
                  {"limits", "hold_mm", 20},
                  {"horizon", "lookahead_us", -60'000},
                  {"horizon", "horizon_us", -1},
                  {"return", "extra_us", -1},
                  {"return", "extra_us", 1},
                  {"ways", "extra_us", -50'000},
                  {"place", "extra_us", -50'000},
                  {"return", "dwell_ticks", -1},
                  {"return", "dwell_ticks", 1},
                  {"place", "x_mm", 2'200},
                  {"place", "clearance_mm", -60},
                  {"seen", "clearance_mm", -60},
                  {"seen", "x_mm", 2'400},
                  {"ways", "return_mm", -60},
                  {"ways", "route_mm", -60},
                  {"ways", "cell_mm", -10},
                  {"ways", "cell_mm", 10},
                  {"ways", "cells_x_mm", -1},
                  {"ways", "cells_y_mm", -100}};
  for (const auto& m : mistakes) {
    const Outcome o = rechecked_with(changed(m.claim, m.key, m.by));
    EXPECT_EQ(o.status, exit_violation) << m.claim << "." << m.key << "\n" << o.out << o.err;
  }
}

// In a current that a weak brake hardly holds a boat against, what is left of it in whole
// millimetres makes bounds much wider: that is no mistake.
TEST_F(Recheck, WhatIsRoundedForAWeakBrakeIsNoMistake) {
  const std::string boat = R"(spec weak;
zone free = rectangle (0 m, 0 m) to (400 m, 400 m);
robot Boat {
  body radius 30 cm;
  motion point { speed <= 0.5 m/s; accel <= 0.08 m/s^2; brake >= 0.0209 m/s^2; disturbance <= 0.0101 m/s^2; }
  sense position : point error 2 cm max_age 80 ms;
  sense velocity : vector error 1 mm/s max_age 80 ms;
  output thrust : acceleration;
  latency 30 ms;
}
fleet boat : Boat;
controller nav : advanced for Boat extern;
controller back : safe for Boat = brake_and_hold;
monitor m for c : Boat { "R2: stays in" always c inside free;  recover back; hold when violated "towed"; }
decision drive for Boat { advanced nav; period 50 ms; priority m; }
)";
  // what its thrust is off by pushes it as much
  const std::string off = edited(edited(boat, " disturbance <= 0.0101 m/s^2;", ""),
                                 ": acceleration;", ": acceleration error 0.0101 m/s^2;");
  for (const std::string& page : {boat, off}) {
    ASSERT_EQ(verified(page, {"-o", "certificates"}).status, exit_clean);
    const Outcome again = rtac({"verify", "--recheck", "certificates"});
    EXPECT_EQ(again.status, exit_clean) << again.out;
  }
}

// Where nothing is declared and a look-ahead is the least that works, a step may be late by a tenth
// of the period: no horizon leaves that out, and no look-ahead is longer than the least.
TEST_F(Recheck, AStepThatIsLateIsReckonedWith) {
  const std::string least = edited(drone_spec(), "ahead   100 ms, 2 waypoints;", "");
  ASSERT_EQ(verified(least, {"-o", "certificates"}).status, exit_clean);
  report_ = Json::parse(read("certificates/verification.json"));
  for (const char* const key : {"horizon_us", "lookahead_us"}) {
    const std::int64_t by = std::string(key) == "lookahead_us" ? 1 : -1;
    EXPECT_EQ(rechecked_with(changed("horizon", key, by)).status, exit_violation) << key;
  }
  EXPECT_EQ(rechecked_with(changed("limits", "jitter_us", -1)).status, exit_violation);
}

// What a unicycle keeps free at rest is for grids and for what steering leaves beside a leg.
TEST_F(Recheck, TheRoomOfAHoldIsFoundOnceMore) {
  write_delivery();
  const auto hold_mm = [&] {
    for (const Json& o : report_["decisions"][0]["obligations"]) {
      for (const Json& c : o.value("claims", Json::array())) {
        if (c["claim"] == "limits") return std::stoll(c["hold_mm"].get<std::string>());
      }
    }
    return 0LL;
  };
  const long long as_declared = hold_mm();
  EXPECT_GE(as_declared, 10);
  for (const std::int64_t by : {std::int64_t{-1}, std::int64_t{-as_declared}}) {
    EXPECT_EQ(rechecked_with(changed("limits", "hold_mm", by)).status, exit_violation) << by;
  }
  EXPECT_EQ(rechecked_with(changed("lasts", "route_mm", -60)).status, exit_violation);
}

// In a park robots look for their ways over wider cells, and so does who checks them.
TEST_F(Recheck, WaysInAWideZoneAreFoundOnceMore) {
  const std::string park = edited(drone_spec(), "(5 m, 5 m)", "(250 m, 190 m)");
  ASSERT_EQ(verified(park, {"-o", "certificates"}).status, exit_clean);
  EXPECT_EQ(read("certificates/verification.json").find("\"cell_mm\": \"100\""), std::string::npos);
  const Outcome o = rechecked();
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

// Out of the corners of a rhombus no way leads over cells, and legs do.
TEST_F(Recheck, LegsStraightOutOfACornerAreFoundOnceMore) {
  const std::string yard = edited(drone_spec(), "rectangle (0 m, 0 m) to (5 m, 5 m)",
                                  "polygon [(0 m, 0 m), (10 m, 2 m), (12 m, 12 m), (2 m, 10 m)]");
  ASSERT_EQ(verified(yard, {"-o", "certificates"}).status, exit_clean);
  report_ = Json::parse(read("certificates/verification.json"));
  const Outcome o = rechecked();
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  for (const auto& [key, by] : {std::pair("return_mm", 6'000), std::pair("return_mm", -60),
                                std::pair("cell_mm", 10), std::pair("cells_x_mm", 5)}) {
    EXPECT_EQ(rechecked_with(changed("ways", key, by)).status, exit_violation) << key;
  }
}

TEST_F(Recheck, AMutatedLemmaIsNoticed) {
  const fs::path lemma = "certificates/lemmas/disc.smt2";
  write(lemma, read(lemma) + "\n(assert false)\n");
  EXPECT_EQ(rechecked().status, exit_violation);
}

// A convex hall, or one with a loft on top of it: legs lead back from everywhere. A tower beside
// the loft that is not reached straight up is another matter, and so is one that is too low.
TEST_F(Recheck, RobotsInSpaceAreProvedWhereSlabsLeadToAConvexOne) {
  const std::string stacked = spec_text("tests/campaign/specs/templates/retreat_space.rta");
  const std::string shed = spec_text("tests/campaign/specs/templates/space.rta");
  const auto of = [&](const std::string& text) {
    write("space.rta", text);
    const Outcome o = verified(stacked, {"--format", "json", "-o", "certificates"});
    EXPECT_EQ(statuses(o.out, "joint return", ""), Statuses{"proved"});
    return statuses(o.out, "P2b", "fence");
  };
  const std::string loft = "to (5 m, 9 m)) from 6 m to 10 m";
  EXPECT_EQ(of(edited(shed, "crane;",
                      "crane - prism (rectangle (0 m, 0 m) to (5 m, 1 m)) from 8 m "
                      "to 9 m;")),
            Statuses{"unknown"});
  EXPECT_EQ(of(edited(shed, loft, "to (5 m, 10 m)) from 6 m to 10 m")), Statuses{"proved"});
  EXPECT_EQ(of(edited(shed, loft, "to (5 m, 10 m)) from 6 m to 7 m")), Statuses{"unknown"});
  EXPECT_EQ(of(edited(shed, loft, "to (5 m, 9 m)) from 6 m to 7 m")), Statuses{"proved"});
  EXPECT_EQ(of(shed), Statuses{"proved"});
  EXPECT_EQ(rechecked().status, exit_clean);
  report_ = Json::parse(read("certificates/verification.json"));
  EXPECT_EQ(rechecked_with(changed("legs", "clearance_mm", 800)).status, exit_violation);
  EXPECT_EQ(rechecked_with(changed("legs", "to_0", -1)).status, exit_violation);
  EXPECT_EQ(rechecked_with(changed("legs", "z_mm_0", -2'000)).status, exit_violation);
  EXPECT_EQ(rechecked_with(changed("legs", "x_mm_2", 9'000)).status, exit_violation);
}
// Around a pillar and a corner the nearest places with room are in sight; from a wing that is too
// narrow for any they are not, and that place is named.
TEST_F(Recheck, RobotsInSpaceAreProvedWhereRoomIsInSight) {
  const std::string level = spec_text("tests/campaign/specs/templates/retreat_space.rta");
  const std::string shed = spec_text("tests/campaign/specs/templates/space.rta");
  const auto p2b = [&](const std::string& wing) {
    const std::string text = edited(
        edited(shed, "(5 m, 9 m)) from 6 m to 10 m", wing + ") from 0 m to 6 m"), "3.5 m", "6 m");
    write("space.rta", text);
    const Json report =
        Json::parse(verified(level, {"--format", "json", "-o", "certificates"}).out);
    for (const Json& each : report["decisions"][0]["obligations"]) {
      if (each["obligation"] == "P2b") return each;
    }
    return Json();
  };
  const Json narrow = p2b("(15 m, 1 m)");
  EXPECT_EQ(narrow["status"], "unknown");
  EXPECT_NE(narrow["because"].get<std::string>().find("from near (9."), std::string::npos)
      << narrow;
  EXPECT_EQ(p2b("(14 m, 4 m)")["status"], "proved");
  EXPECT_EQ(rechecked().status, exit_clean);
  report_ = Json::parse(read("certificates/verification.json"));
  for (const auto& [key, by] : {std::pair{"aim_mm", 2'000},
                                {"route_mm", -600},
                                {"cell_mm_of_0", 100},
                                {"cells_x_mm_of_0", 50}}) {
    EXPECT_EQ(rechecked_with(changed("legs", key, by)).status, exit_violation) << key;
  }
}

// Beside a pillar, in a wind: legs keep more than control is given back with, and who has that
// already takes none.
TEST_F(Recheck, WhoHasRoomInSpaceTakesNoLeg) {
  write("pillar.rta", R"(spec pillar;
zone air = prism (rectangle (0 m, 0 m) to (20 m, 20 m)) from 0 m to 30 m
         - prism (circle (10 m, 10 m) radius 1 m) from 0 m to 30 m;
robot Quad {
  body radius 20 cm;
  motion point { speed <= 2 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; disturbance <= 0.2 m/s^2; }
  sense position : point3 error 5 cm max_age 50 ms;
  sense velocity : vector3 error 5 cm/s max_age 50 ms;
  output push : acceleration;
  latency 20 ms;
}
fleet one : Quad;
controller pilot : advanced for Quad extern;
controller back : safe for Quad = retreat within air speed 0.5 m/s;
monitor fence for q : Quad { "SR-1: in" always q inside air; recover back; }
decision fly for Quad { advanced pilot; period 50 ms; priority fence; }
)");
  ASSERT_EQ(rtac({"verify", "pillar.rta", "-o", "certificates"}).status, exit_clean);
  EXPECT_EQ(rechecked().status, exit_clean);
  report_ = Json::parse(read("certificates/verification.json"));
  for (const auto& [key, by] :
       {std::pair{"aim_mm", -400}, {"route_mm", -600}, {"cells_x_mm_of_0", 50}}) {
    EXPECT_EQ(rechecked_with(changed("legs", key, by)).status, exit_violation) << key;
  }
}

TEST_F(Recheck, RobotsInSpaceAreProvedInAConvexHall) {
  const std::string annex =
      "\n          | prism (rectangle (0 m, 0 m) to (5 m, 9 m)) from 6 m to 10 m";
  const std::string stacked = spec_text("tests/golden/space_recoveries/spec.rta");
  const std::string slow = edited(stacked, " > calm > slow > rules", " > calm > slow");
  ASSERT_EQ(verified(edited(slow, annex, ""), {"-o", "certificates"}).status, exit_clean);
  EXPECT_EQ(rechecked().status, exit_clean);
  report_ = Json::parse(read("certificates/verification.json"));
  for (const char* const claim : {"legs", "place"}) {
    EXPECT_EQ(rechecked_with(changed(claim, "clearance_mm", 5'000)).status, exit_violation)
        << claim;
  }
  EXPECT_EQ(rechecked_with(changed("height", "z_mm", 6'000)).status, exit_violation);
  EXPECT_EQ(rechecked_with(changed("height", "gap_mm", -400)).status, exit_violation);
}
// What is only too high is not any more on the way down: a landing leads out of it. Not where it
// ends too high, and not out of what is too low.
TEST_F(Recheck, ALandingLeadsOutOfWhatIsTooHigh) {
  const std::string text = R"(spec mast;
zone shaft = prism (rectangle (0 m, 0 m) to (20 m, 20 m)) from 0 m to 60 m;
robot Quad {
  body radius 30 cm;
  motion point { speed <= 3 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense position : point3 error 5 cm max_age 50 ms;
  sense velocity : vector3 error 5 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 20 ms;
}
fleet q : Quad;
controller policy : advanced for Quad extern;
controller down : safe for Quad = land to 2 m speed 0.5 m/s;
monitor roof for r : Quad { "R1: below 50 m" always r.position.z <= 50 m; recover down; }
decision fly for Quad { advanced policy; period 50 ms; priority roof; }
)";
  ASSERT_EQ(verified(text, {"-o", "certificates"}).status, exit_clean);
  EXPECT_EQ(rechecked().status, exit_clean);
  report_ = Json::parse(read("certificates/verification.json"));
  EXPECT_EQ(rechecked_with(changed("landing", "land_mm", -1)).status, exit_violation);
  EXPECT_EQ(rechecked_with(changed("landing", "land_mm", 48'000)).status, exit_violation);
  EXPECT_EQ(rechecked_with(changed("landing", "gap_mm", -600)).status, exit_violation);
  const Outcome high =
      verified(edited(text, "land to 2 m", "land to 49.9 m"), {"--format", "json"});
  EXPECT_EQ(statuses(high.out, "P2b", "roof"), Statuses{"unknown"}) << high.out << high.err;
  const Outcome low = verified(edited(text, "<= 50 m", ">= 5 m"));
  EXPECT_EQ(low.status, exit_violation);
  EXPECT_NE(low.err.find("error[5017]: `down` only goes down"), std::string::npos) << low.err;
}

TEST_F(Recheck, AMutatedModelIsNoticed) {
  write_delivery();
  const std::string path = "certificates/models/fly.pml";
  const std::string text = read(path);
  write(path, edited(text, "!surrender && before != 0 && open != NOBODY", "false"));
  EXPECT_EQ(rechecked().status, exit_violation);
  write(path, edited(text, "#define PROMISES 1", "#define PROMISES 0"));
  EXPECT_EQ(rechecked().status, exit_violation);
  std::filesystem::remove(path);
  EXPECT_EQ(rechecked().status, exit_violation);
}
// What the model takes for granted has to be shown elsewhere.
TEST_F(Recheck, AnEntryOfTheModelThatNobodyProvesIsNoticed) {
  write_delivery();
  for (const char* const table : {"keeps", "settles"}) {
    Json report = report_;
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] != "switching") continue;
      std::string rows = o["claims"][0][table];
      ASSERT_NE(rows.find('0'), std::string::npos) << table;
      rows[rows.find('0')] = '1';
      o["claims"][0][table] = rows;
    }
    EXPECT_EQ(rechecked_with(report).status, exit_violation) << table;
  }
}
TEST_F(Recheck, WhatIsLeftOutIsNoticed) {
  for (std::size_t i = 0; i < report_["decisions"][0]["obligations"].size(); ++i) {
    Json report = report_;
    const std::string kind = report["decisions"][0]["obligations"][i]["obligation"];
    if (kind == "not vacuous") continue;  // says nothing about safety
    report["decisions"][0]["obligations"].erase(i);
    EXPECT_EQ(rechecked_with(report).status, exit_violation) << kind;
    const Json& claims = report_["decisions"][0]["obligations"][i]["claims"];
    for (std::size_t k = 0; k < claims.size(); ++k) {
      report = report_;
      report["decisions"][0]["obligations"][i]["claims"].erase(k);
      EXPECT_EQ(rechecked_with(report).status, exit_violation) << kind << " " << claims[k];
    }
  }
}

// A certificate cannot be carried over to a property that no robot can break.
TEST_F(Recheck, APropertyThatIsNeverFalseIsNoticed) {
  write("certificates/sources/spec.rta",
        edited(read("certificates/sources/spec.rta"), "always  clearance(d, room)",
               "always  d.speed <= 90 m/s or clearance(d, room)"));
  const Outcome o = rechecked();
  EXPECT_EQ(o.status, exit_violation);
  EXPECT_NE((o.out + o.err).find("never false"), std::string::npos) << o.out << o.err;
}

// Who only claims to stay in a zone may be anywhere in it, beside its boundary as well.
TEST_F(Verify, AClaimKeepsWhatEachOfItsPlacesKeeps) {
  const std::string claimed =
      edited(edited(drone_spec(), "= retreat within room speed 0.3 m/s",
                    "extern keeps inside inner speed <= 0.5 m/s"),
             "monitor walls", "zone inner = shrink(room, 10 cm);\nmonitor walls");
  const std::string text =
      edited(claimed, "recover back_off;", "recover back_off; hold when violated \"staff\";");
  const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
  EXPECT_EQ(statuses(o.out, "P2a", "walls"), Statuses{"proved"}) << o.out << o.err;
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
  for (const auto& [to, why] : {std::pair{"shrink(room, 9 cm)", "it is not contained"},
                                {"room & room", "it is not contained"}}) {
    write("certificates/sources/spec.rta", edited(text, "shrink(room, 10 cm)", to));
    const Outcome forged = recheck_sealed_anew();
    EXPECT_EQ(forged.status, exit_violation) << to;
    EXPECT_NE((forged.out + forged.err).find(why), std::string::npos) << forged.out << forged.err;
  }
  // however it is written
  const std::string asked = "clearance(d, room) >= 10 cm";
  for (const char* const more :
       {"clearance(d, room) >= 11 cm", "2 * clearance(d, room) >= 22 cm",
        "clearance(d, room) - 11 cm >= 0 m", "clearance(d, room) >= most"}) {
    const std::string named =
        edited(text, "zone inner", "param most : length in 0 m .. 11 cm = 0 m;\nzone inner");
    write("certificates/sources/spec.rta", edited(named, asked, more));
    const Outcome forged = recheck_sealed_anew();
    EXPECT_EQ(forged.status, exit_violation) << more;
    EXPECT_NE((forged.out + forged.err).find("keeps so far from `room`"), std::string::npos)
        << more << forged.out << forged.err;
  }
  write("certificates/sources/spec.rta", edited(text, "inside inner", "inside room"));
  const Outcome own = recheck_sealed_anew();
  EXPECT_NE((own.out + own.err).find("nothing says that `back_off` keeps so far from `room`"),
            std::string::npos)
      << own.out << own.err;
}

// What is proved of one obligation does not stand for another one.
TEST_F(Recheck, ClaimsOfAnotherKindAreNoProof) {
  const auto with_claims_of = [&](const std::string& kind, const std::string& elsewhere) {
    Json report = report_, claims;
    for (const Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == elsewhere) claims = o["claims"];
    }
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == kind) o["claims"] = claims;
    }
    return rechecked_with(report).status;
  };
  EXPECT_EQ(with_claims_of("satisfiable", "P1b"), exit_violation);
  EXPECT_EQ(with_claims_of("joint return", "satisfiable"), exit_violation);
  EXPECT_EQ(with_claims_of("P2b", "P1b"), exit_violation);
}
// Nor does nothing at all.
TEST_F(Recheck, WhereNoZoneIsAskedForThatIsClaimed) {
  const std::string calm =
      edited(edited(drone_spec(), "clearance(d, room) >= 10 cm", "d.speed <= 0.5 m/s"),
             "ahead   100 ms, 2 waypoints;", "");
  const Outcome o = verified(calm, {"--format", "json", "-o", "certificates"});
  ASSERT_EQ(statuses(o.out, "joint return", ""), Statuses{"proved"}) << o.out << o.err;
  Json report = Json::parse(read("certificates/verification.json"));
  for (Json& each : report["decisions"][0]["obligations"]) {
    if (each["obligation"] == "joint return") each["claims"] = Json::array();
  }
  EXPECT_EQ(rechecked_with(report).status, exit_violation);
}
// Of an external recovery it is not known where it leads, whatever is claimed.
TEST_F(Recheck, NothingShowsWhereAnExternalRecoveryLeads) {
  write("certificates/sources/spec.rta",
        edited(edited(drone_spec(), "= retreat within room speed 0.3 m/s",
                      "extern keeps inside inner speed <= 0.5 m/s"),
               "monitor walls", "zone inner = shrink(room, 10 cm);\nmonitor walls"));
  const Outcome o = rechecked();
  EXPECT_EQ(o.status, exit_violation);
  EXPECT_NE((o.out + o.err).find("of where `back_off` leads nothing is known"), std::string::npos)
      << o.out << o.err;
}
// How much further ahead the return looks is not what some other entry says.
TEST_F(Recheck, TheReturnLooksAsFarAsIsDeclared) {
  // from rest it may reach 0.269 m/s before a recovery acts, a period of the return included
  const std::string calm = edited(
      edited(edited(drone_spec(), "speed 0.3 m/s", "speed 0.2 m/s"), "decision fly",
             "monitor calm for d : Drone { \"SR-2: slow\" always d.speed <= 0.35 m/s; recover "
             "back_off; }\ndecision fly"),
      "priority walls;", "priority walls > calm;");
  ASSERT_EQ(verified(calm, {"-o", "certificates"}).status, exit_clean);
  write("certificates/sources/spec.rta",
        edited(calm, "d.speed <= 0.35 m/s", "d.speed <= 0.25 m/s"));
  Json report = Json::parse(read("certificates/verification.json"));
  for (Json& o : report["decisions"][0]["obligations"]) {
    if (o["obligation"] != "P3") continue;
    o["status"] = "unknown";
    for (Json& c : o["claims"]) {
      if (c["claim"] == "return") c["extra_us"] = "-100000";
    }
  }
  const Outcome o = rechecked_with(report);
  EXPECT_EQ(o.status, exit_violation);
  EXPECT_NE((o.out + o.err).find("P2b of `calm`"), std::string::npos) << o.out << o.err;
}

// Nobody has acknowledged anything.
TEST_F(Recheck, AnAcknowledgementIsInTheSpecification) {
  for (Json& o : report_["decisions"][0]["obligations"]) o["status"] = "acknowledged";
  EXPECT_EQ(rechecked_with(report_).status, exit_violation);
}

// What is accepted of a recovery and its own monitor hides no proof; of speeds, at which no proof
// of it looks, it is accepted.
TEST_F(Recheck, AnAcknowledgementHidesNoProof) {
  const auto with = [](const std::string& text, const std::string& recovery) {
    return edited(text, "priority walls;",
                  "priority walls; acknowledge " + recovery + " may break walls \"a test\";");
  };
  const std::vector<std::string> words = {"--format", "json", "-o", "certificates"};
  const Outcome kept = verified(with(drone_spec(), "back_off"), words);
  EXPECT_EQ(kept.status, exit_clean) << kept.out << kept.err;
  EXPECT_EQ(statuses(kept.out, "P2a", "walls"), Statuses{"proved"});
  EXPECT_EQ(statuses(kept.out, "P2b", "walls"), Statuses{"proved"});
  EXPECT_NE(kept.err.find("6008"), std::string::npos) << kept.err;
  EXPECT_EQ(rechecked().status, exit_clean);

  const std::string slow = edited(edited(drone_spec(), "clearance(d, room) >= 10 cm;",
                                         "clearance(d, room) >= 10 cm and d.speed <= 0.5 m/s;"),
                                  "within room speed 0.3 m/s", "within room speed 0.7 m/s");
  const Outcome fast = verified(with(slow, "back_off"), words);
  EXPECT_EQ(statuses(fast.out, "P2a", "walls"), Statuses{"acknowledged"}) << fast.err;
  EXPECT_EQ(fast.err.find("6008"), std::string::npos) << fast.err;
}

// An obligation that a report leaves open ends as it does in `rtac verify`, and is told by name.
TEST_F(Recheck, WhatTheReportLeavesOpenIsNeverClean) {
  const struct {
    std::string status;
    int code;
    std::string sums;
  } cases[] = {{"unknown", exit_inconclusive, "leaves 0 obligations refuted and 1 unknown"},
               {"refuted", exit_violation, "leaves 1 obligations refuted and 0 unknown"}};
  for (const auto& each : cases) {
    Json report = report_;
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == "not vacuous") o["status"] = each.status;
    }
    const Outcome o = rechecked_with(report);
    EXPECT_EQ(o.status, each.code) << o.out << o.err;
    EXPECT_NE(o.out.find(each.status + ", as the report says: fly, not vacuous of `walls`"),
              std::string::npos)
        << o.out;
    EXPECT_NE(o.out.find("0 not proved, 0 unknown; the report " + each.sums), std::string::npos)
        << o.out;
  }
}
// Nor is what it does not speak of, or speaks of in a second place that nobody looks at.
TEST_F(Recheck, AReportSpeaksOfEachDecisionOnce) {
  Json twice = report_;
  twice["decisions"].push_back(twice["decisions"][0]);
  EXPECT_EQ(rechecked_with(twice).status, exit_violation);
  Json more = report_;
  more["decisions"].push_back({{"decision", "land"}, {"obligations", Json::array()}});
  EXPECT_EQ(rechecked_with(more).status, exit_violation);
  Json strange = report_;
  strange["decisions"][0]["obligations"][0]["obligation"] = "P9";
  strange["decisions"][0]["obligations"].push_back(report_["decisions"][0]["obligations"][0]);
  EXPECT_EQ(rechecked_with(strange).status, exit_violation);
  Json less = report_;
  Json& all = less["decisions"][0]["obligations"];
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i]["obligation"] == "not vacuous") all.erase(i);
  }
  EXPECT_EQ(rechecked_with(less).status, exit_violation);
}

// Two zones that overlap, and the room around both: coordinated, with what has to be acknowledged.
std::string two_sides(bool both) {
  std::string more = R"(
zone west  = rectangle (0.2 m, 0.2 m) to (3.5 m, 4.8 m);
controller go_west  : safe for Drone = retreat within west speed 0.3 m/s;
monitor in_west  for d : Drone { "SR-2: in the west" always d inside west; recover go_west; }
)";
  if (both) {
    more += R"(zone south = rectangle (0.1 m, 0.1 m) to (4.9 m, 3.5 m);
controller go_south : safe for Drone = retreat within south speed 0.3 m/s;
monitor in_south for d : Drone { "SR-3: in the south" always d inside south; recover go_south; }
)";
  }
  return edited(drone_spec(), "decision fly", more + "decision fly");
}
class RecheckCoordinated : public Recheck {
 protected:
  void write_certificates(const std::string& clause) {
    const std::string text =
        edited(two_sides(clause.find("south") != std::string::npos), "priority walls;", clause);
    const Outcome o = verified(text, {"-o", "certificates"});
    ASSERT_EQ(o.status, exit_clean) << o.out << o.err;
    report_ = Json::parse(read("certificates/verification.json"));
  }
  // What is claimed of a monitor while a recovery drives.
  Json& pair(const std::string& monitor, const std::string& recovery) {
    for (Json& o : report_["decisions"][0]["obligations"]) {
      if (o["obligation"] == "C" && o["monitor"] == monitor && o["recovery"] == recovery) return o;
    }
    ADD_FAILURE() << monitor << " " << recovery;
    return report_;
  }
};

TEST_F(RecheckCoordinated, TheProofIsFoundOnceMore) {
  write_certificates("coordinate walls > in_west;");
  EXPECT_EQ(pair("in_west", "back_off")["method"], "coordination");
  const Outcome o = rechecked();
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}
// Without it, a zone would have to lie in the other one.
TEST_F(RecheckCoordinated, AProofThatIsLeftOutIsNoticed) {
  write_certificates("coordinate walls > in_west;");
  Json& claims = pair("in_west", "back_off")["claims"];
  claims.erase(claims.size() - 1);
  EXPECT_EQ(rechecked_with(report_).status, exit_violation);
}
// By priority nobody coordinates.
TEST_F(RecheckCoordinated, ItTakesADecisionThatCoordinates) {
  write_certificates("priority in_west > walls;");
  for (Json& c : pair("in_west", "back_off")["claims"]) {
    if (c["claim"] != "outranks") continue;
    c = {
        {"claim", "coordinated"}, {"decision", "fly"}, {"driving", "walls"}, {"judged", "in_west"}};
  }
  EXPECT_EQ(rechecked_with(report_).status, exit_violation);
}
// In a circle nobody keeps what the report says that somebody does.
TEST_F(RecheckCoordinated, ACircleIsNoticed) {
  write_certificates(
      "coordinate walls > in_west > in_south; acknowledge back_off may break in_south \"a test\"; "
      "acknowledge go_west may break in_south \"a test\";");
  EXPECT_EQ(rechecked().status, exit_clean);
  Json& forged = pair("in_south", "go_west");
  EXPECT_EQ(forged["status"], "acknowledged");
  forged["status"] = "proved";
  forged["claims"] = Json::array({{{"claim", "coordinated"},
                                   {"decision", "fly"},
                                   {"driving", "in_west"},
                                   {"judged", "in_south"}}});
  EXPECT_EQ(rechecked_with(report_).status, exit_violation);
}

TEST_F(Recheck, NoReportIsAnError) {
  write("certificates/verification.json", "{");
  EXPECT_EQ(rechecked().status, exit_violation);
  fs::remove("certificates/verification.json");
  EXPECT_EQ(rechecked().status, exit_usage);
}

// Whatever is proved, of any kind of decision, is found once more.
class RecheckCases : public Verify, public ::testing::WithParamInterface<const char*> {};
TEST_P(RecheckCases, WhatIsProvedIsFoundOnceMore) {
  const std::string spec = std::string(RTAC_SOURCE_DIR) + "/tests/" + GetParam() + ".rta";
  const Outcome o = rtac({"verify", spec, "-o", "certificates"});
  ASSERT_NE(o.out.find(" proved, "), std::string::npos) << o.out << o.err;
  const Outcome again = recheck_sealed_anew();
  EXPECT_NE(again.out.find(" 0 not proved"), std::string::npos) << again.out << again.err;
}
INSTANTIATE_TEST_SUITE_P(
    Specs, RecheckCases,
    ::testing::Values("golden/agents/spec", "golden/ahead_command/spec", "golden/claims/spec",
                      "golden/coordinated/spec", "golden/external_recovery/spec",
                      "golden/fleet_of_three/spec", "golden/or_of_zones/spec",
                      "golden/plan_only/spec", "golden/point_fleet_yield/spec",
                      "golden/robot_facts/spec", "golden/shared_recovery/spec",
                      "golden/waypoints_only/spec", "golden/bad_5001_too_short/spec",
                      "golden/bad_5034_landing/spec", "campaign/specs/legs", "campaign/specs/fuel",
                      "campaign/specs/attic"),
    [](const auto& of) {
      std::string name = of.param;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
      return name;
    });

// Numbers off the grid of the kernel are rounded to the safe side, and are those of the page.
TEST_F(Recheck, NumbersOffTheGridAreThoseOfThePage) {
  const auto page = [](const std::string& radius, const std::string& motion,
                       const std::string& error, const std::string& period) {
    const bool wheels = motion.find("turn") != std::string::npos;
    return "spec odd;\nzone hall = rectangle (0 m, 0 m) to (14 m, 12 m);\nrobot Bot {\n  body "
           "radius " +
           radius + ";\n  motion " + motion + "\n  sense position : point error " + error +
           " max_age 66.66667 ms;\n  sense heading : angle error 2 deg max_age 50 ms;\n"
           "  sense velocity : vector error 1.3 cm/s max_age 33.33333 ms;\n  output drive : " +
           (wheels ? "twist" : "acceleration") +
           ";\n  latency 12.3456 ms;\n}\nfleet b : Bot;\n"
           "controller ai : advanced for Bot extern;\n"
           "controller back : safe for Bot = retreat within hall speed 0.3 m/s;\n"
           "monitor m for x : Bot { \"R\" always x inside hall; recover back; }\n"
           "decision go for Bot { advanced ai; period " +
           period + "; priority m; }\n";
  };
  const std::string point =
      "point { speed <= 0.9333 m/s; accel <= 1.1117 m/s^2; brake >= 1.2345 m/s^2; }";
  const auto wheels = [](const std::string& speed, const std::string& turn) {
    return "unicycle { speed <= " + speed + "; turn <= " + turn +
           "; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 10 rad/s^2; }";
  };
  for (const auto& [radius, motion, error, period] :
       {std::tuple(std::string("30.5 mm"), point, "2 cm", "50 ms"),
        std::tuple(std::string("0.1234 m"), point, "0.7 mm", "17 ms"),
        std::tuple(std::string("12.34 cm"), wheels("1 m/s", "60 deg/s"), "2 cm", "50 ms"),
        std::tuple(std::string("20 cm"), wheels("0.9333 m/s", "1.0471 rad/s"), "2 cm", "20 ms"),
        std::tuple(std::string("0.3333 m"), wheels("1 m/s", "2 rad/s"), "33.3 mm", "50 ms")}) {
    const Outcome o = verified(page(radius, motion, error, period), {"-o", "odd"});
    ASSERT_EQ(o.status, exit_clean) << radius << motion << o.out << o.err;
    const Outcome again = rtac({"verify", "--recheck", "odd"});
    EXPECT_EQ(again.status, exit_clean) << radius << motion << again.out;
  }
}

}  // namespace
}  // namespace rtac::driver::test
