// `rtac verify`: what is proved, acknowledged, unknown and refuted, and its exit codes.
#include <nlohmann/json.hpp>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

using Json = nlohmann::json;

class Verify : public InFolder {
 protected:
  static Outcome verified(const std::string& text, std::vector<std::string> more = {}) {
    write("spec.rta", text);
    std::vector<std::string> words = {"verify", "spec.rta"};
    words.insert(words.end(), more.begin(), more.end());
    return rtac(words);
  }
  // The statuses of one kind of obligation, of a monitor.
  static std::vector<std::string> statuses(const std::string& json, const std::string& kind,
                                           const std::string& monitor) {
    std::vector<std::string> found;
    const Json report = Json::parse(json);
    for (const Json& d : report["decisions"]) {
      for (const Json& o : d["obligations"]) {
        if (o["obligation"] == kind && o.value("monitor", "") == monitor) {
          found.push_back(o["status"]);
        }
      }
    }
    return found;
  }
};
using Statuses = std::vector<std::string>;

TEST_F(Verify, TheDroneIsProved) {
  const Outcome o = verified(drone_spec());
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_NE(o.out.find(" 0 acknowledged, 0 unknown, 0 refuted"), std::string::npos) << o.out;
}

// Both case studies: everything is proved, or acknowledged in the specification.
TEST_F(Verify, TheCaseStudiesAreProvedOrAcknowledged) {
  for (const char* study : {"robot_delivery", "drone_surveillance"}) {
    const std::string path =
        std::string(RTAC_SOURCE_DIR) + "/specs/" + study + "/" + study + ".rta";
    const Outcome o = rtac({"verify", path});
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  }
}

TEST_F(Verify, WithoutItsAcknowledgementTheDeliveryIsRefuted) {
  const std::string text = edited(
      spec_text("specs/robot_delivery/robot_delivery.rta"),
      "  acknowledge give_way may break battery \"held at most 60 s; the reserve covers it\";\n",
      "");
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "C", "battery"), (Statuses{"refuted", "proved"})) << o.out;
}

// What no choice avoids stays refuted, and the report names the recoveries.
TEST_F(Verify, CoordinatedRecoveriesThatDoNotKeepEachOtherAreRefuted) {
  std::string text = edited(drone_spec(), "decision fly", R"(
zone north = rectangle (0 m, 1 m) to (5 m, 9 m);
controller go_north : safe for Drone = retreat within north speed 0.3 m/s;
monitor up for d : Drone { "SR-2: in the north" always d inside north; recover go_north; }
decision fly)");
  text = edited(text, "priority walls;", "coordinate walls > up;");
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "C", "up"), Statuses{"refuted"}) << o.out;
  EXPECT_EQ(statuses(o.out, "C", "walls"), Statuses{"proved"}) << o.out;
  EXPECT_NE(o.out.find("`go_north` is not shown to keep `walls`"), std::string::npos) << o.out;
}

TEST_F(Verify, UnsoundLookAheadIsAcknowledged) {
  const Outcome o = verified(
      edited(drone_spec(), "ahead   100 ms", "ahead   20 ms unsound \"to see what happens\""),
      {"--format", "json"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "P3", "walls"), Statuses{"acknowledged"});
  EXPECT_EQ(statuses(o.out, "P1a", "walls"), Statuses{"acknowledged"});
}

// Two halls and a gate, in which robots cannot get round each other: it is named, with its width
// and what would do. Without the gate nothing is narrow, and that robots find a way is not shown.
TEST_F(Verify, WhereRobotsCannotPassIsNamed) {
  const auto because = [this](const std::string& zone) {
    const std::string text = "spec halls;\nzone floor = " + zone + R"(;
robot Cart {
  body radius 0.2 m;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 1 cm max_age 100 ms;
  sense velocity : vector error 1 cm/s max_age 100 ms;
  hears other robots max_age 200 ms;
  output drive : acceleration;
  latency 20 ms;
}
fleet a, b : Cart;
controller pilot : advanced for Cart extern;
controller give_way : safe for Cart = yield within floor speed 0.3 m/s order id;
controller back : safe for Cart = retreat within floor speed 0.3 m/s;
monitor apart for r : Cart { "R1: apart" always forall q : Cart, q != r : distance(r, q) >= 20 cm; recover give_way; }
monitor fence for r : Cart { "R2: on the floor" always r inside floor; recover back; }
decision go for Cart { advanced pilot; period 100 ms; priority apart > fence; }
)";
    const Outcome o = verified(text, {"--format", "json"});
    EXPECT_EQ(o.status, exit_inconclusive) << o.err;
    const Json report = Json::parse(o.out);
    for (const Json& each : report["decisions"][0]["obligations"]) {
      if (each["obligation"] == "P2b" && each["monitor"] == "apart") {
        return each["because"].get<std::string>();
      }
    }
    return std::string();
  };
  const std::string gated = because(
      "rectangle (0 m, 0 m) to (20 m, 20 m) | rectangle (30 m, 0 m) to (50 m, 20 m)"
      " | rectangle (19 m, 8 m) to (31 m, 12 m)");
  EXPECT_EQ(gated.find("robots that meet near (30 m, 10 m) in `floor`"), 0U) << gated;
  EXPECT_NE(gated.find("it is about 3.84 m wide there"), std::string::npos) << gated;
  const std::string open = because("rectangle (0 m, 0 m) to (40 m, 40 m)");
  EXPECT_NE(open.find("has no narrow passage"), std::string::npos) << open;
  const std::string aisle = because("rectangle (0 m, 0 m) to (40 m, 5 m)");
  EXPECT_NE(aisle.find("it is 5 m wide at most"), std::string::npos) << aisle;
}

// Mistakes that no obligation is about are those of `rtac check`.
TEST_F(Verify, OtherMistakesAreErrors) {
  const Outcome o = verified(edited(drone_spec(), "clearance", "clearence"));
  EXPECT_EQ(o.status, exit_spec_errors);
  EXPECT_EQ(o.out, "");
}

TEST_F(Verify, WarningsCountWhereTheyAreAskedFor) {
  const std::string text = edited(drone_spec(), "decision fly",
                                  "param unused : length in 1 m .. 2 m = 1 m;\ndecision fly");
  EXPECT_EQ(verified(text).status, exit_clean);
  EXPECT_EQ(verified(text, {"-Werror"}).status, exit_spec_errors);
}

// Two halves of a room are no room: on their seam a body is in neither.
TEST_F(Verify, TheSeamOfTwoZonesIsNotProved) {
  const std::string halves = R"(
zone west = rectangle (0 m, 0 m) to (2.5 m, 5 m);
zone east = rectangle (2.5 m, 0 m) to (5 m, 5 m);
monitor side for d : Drone { "SR-2: on a side" always d inside west or d inside east; recover back_off; }
decision fly)";
  std::string text = edited(drone_spec(), "decision fly", halves);
  text = edited(text, "priority walls;", "priority side > walls;");
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "P2a", "side"), Statuses{"unknown"}) << o.out;
  EXPECT_EQ(statuses(o.out, "C", "side"), Statuses{"unknown"}) << o.out;  // the same recovery
}

// Each of two monitors could be satisfied, and never both.
// `back_off` may leave the inner zone, whose own recovery leads back to where `walls` still waits
// for its `return when`.
TEST_F(Verify, RecoveriesThatTakeOverFromEachOtherAreNotProvedToEnd) {
  const std::string two = edited(
      edited(
          drone_spec(), "decision fly",
          "zone inner = shrink(room, 30 cm);\n"
          "controller inwards : safe for Drone = retreat within inner speed 0.3 m/s;\n"
          "monitor middle for d : Drone { \"SR-9: it stays in the middle\" always d inside inner; "
          "ahead 100 ms; recover inwards; }\ndecision fly"),
      "priority walls", "priority middle > walls");
  const Outcome settled = verified(two, {"--format", "json"});
  EXPECT_EQ(statuses(settled.out, "switching", ""), Statuses{"proved"}) << settled.out;
  const Outcome waits = verified(
      edited(two, "recover back_off;", "recover back_off; return when clearance(d, room) >= 1 m;"),
      {"--format", "json"});
  EXPECT_EQ(waits.status, exit_inconclusive) << waits.out << waits.err;
  EXPECT_EQ(statuses(waits.out, "switching", ""), Statuses{"unknown"}) << waits.out;
  EXPECT_NE(waits.out.find("take over from each other for ever"), std::string::npos) << waits.out;
}
TEST_F(Verify, WithoutAModelCheckerNothingIsSaidOfSwitching) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  const Outcome o = verified(drone_spec(), {"--format", "json"});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "switching", ""), Statuses{"unknown"}) << o.out;
}
TEST_F(Verify, ZonesThatShareNoRoomHaveNoJointReturn) {
  std::string text = edited(drone_spec(), "decision fly", R"(
zone far_room = rectangle (4.6 m, 0 m) to (9.6 m, 5 m);
controller go_far : safe for Drone = retreat within far_room speed 0.3 m/s;
monitor far for d : Drone { "SR-2: over there" always d inside far_room; recover go_far; }
decision fly)");
  text = edited(text, "priority walls;",
                "priority far > walls; acknowledge go_far may break walls \"a test\";");
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "joint return", ""), Statuses{"refuted"}) << o.out;
  EXPECT_EQ(statuses(o.out, "C", "walls"), Statuses{"acknowledged"}) << o.out;
}

// ---- certificates: found once more by other means

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
  static Outcome rechecked() { return rtac({"verify", "--recheck", "certificates"}); }
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

TEST_F(Recheck, WhatIsProvedIsFoundOnceMore) {
  const Outcome o = rechecked();
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
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
                  {"limits", "hold_mm", -15},
                  {"horizon", "lookahead_us", -60'000},
                  {"horizon", "horizon_us", -1},
                  {"return", "extra_us", -60'000},
                  {"return", "dwell_ticks", -2},
                  {"place", "x_mm", 2'200},
                  {"place", "clearance_mm", -60},
                  {"ways", "return_mm", -60},
                  {"ways", "cell_mm", -10},
                  {"ways", "cell_mm", 10},
                  {"ways", "cells_x_mm", 5},
                  {"ways", "cells_y_mm", -100}};
  for (const auto& m : mistakes) {
    const Outcome o = rechecked_with(changed(m.claim, m.key, m.by));
    EXPECT_EQ(o.status, exit_violation) << m.claim << "." << m.key << "\n" << o.out << o.err;
  }
}

// In a park robots look for their ways over wider cells, and so does who checks them.
TEST_F(Recheck, WaysInAWideZoneAreFoundOnceMore) {
  const std::string park = edited(drone_spec(), "(5 m, 5 m)", "(250 m, 190 m)");
  ASSERT_EQ(verified(park, {"-o", "certificates"}).status, exit_clean);
  EXPECT_EQ(read("certificates/verification.json").find("\"cell_mm\": \"100\""), std::string::npos);
  const Outcome o = rechecked();
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

TEST_F(Recheck, AMutatedLemmaIsNoticed) {
  const fs::path lemma = "certificates/lemmas/disc.smt2";
  write(lemma, read(lemma) + "\n(assert false)\n");
  EXPECT_EQ(rechecked().status, exit_violation);
}

// A convex hall: a leg leads back from everywhere. An annex on top of it is another matter.
TEST_F(Recheck, RobotsInSpaceAreProvedInAConvexHall) {
  const std::string annex =
      "\n          | prism (rectangle (0 m, 0 m) to (5 m, 9 m)) from 6 m to 10 m";
  const std::string stacked = spec_text("tests/golden/space_recoveries/spec.rta");
  const Outcome unknown = verified(stacked, {"--format", "json"});
  EXPECT_EQ(unknown.status, exit_inconclusive) << unknown.err;
  EXPECT_EQ(statuses(unknown.out, "P2b", "walls"), Statuses{"unknown"});
  EXPECT_EQ(statuses(unknown.out, "joint return", ""), Statuses{"proved"});
  ASSERT_EQ(verified(edited(stacked, annex, ""), {"-o", "certificates"}).status, exit_clean);
  EXPECT_EQ(rechecked().status, exit_clean);
  report_ = Json::parse(read("certificates/verification.json"));
  for (const char* const claim : {"legs", "place"}) {
    EXPECT_EQ(rechecked_with(changed(claim, "clearance_mm", 5'000)).status, exit_violation)
        << claim;
  }
  EXPECT_EQ(rechecked_with(changed("height", "z_mm", 6'000)).status, exit_violation);
  EXPECT_EQ(rechecked_with(changed("height", "gap_mm", -400)).status, exit_violation);
}
TEST_F(Recheck, AMutatedModelIsNoticed) {
  write_delivery();
  const std::string path = "certificates/models/plan_executor.pml";
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
    report = report_;
    report["decisions"][0]["obligations"][i]["claims"] = Json::array();
    EXPECT_EQ(rechecked_with(report).status, exit_violation) << kind;
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

// Nobody has acknowledged anything.
TEST_F(Recheck, AnAcknowledgementIsInTheSpecification) {
  for (Json& o : report_["decisions"][0]["obligations"]) o["status"] = "acknowledged";
  EXPECT_EQ(rechecked_with(report_).status, exit_violation);
}

// Two zones that overlap, and the room around both: coordinated, with what has to be acknowledged.
std::string two_sides(bool both) {
  std::string more = R"(
zone west  = rectangle (0 m, 0 m) to (3.5 m, 5 m);
controller go_west  : safe for Drone = retreat within west speed 0.3 m/s;
monitor in_west  for d : Drone { "SR-2: in the west" always d inside west; recover go_west; }
)";
  if (both) {
    more += R"(zone south = rectangle (0 m, 0 m) to (5 m, 3.5 m);
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

}  // namespace
}  // namespace rtac::driver::test
