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

TEST_F(Verify, UnsoundLookAheadIsAcknowledged) {
  const Outcome o = verified(
      edited(drone_spec(), "ahead   100 ms", "ahead   20 ms unsound \"to see what happens\""),
      {"--format", "json"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "P3", "walls"), Statuses{"acknowledged"});
  EXPECT_EQ(statuses(o.out, "P1a", "walls"), Statuses{"acknowledged"});
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
  } mistakes[] = {{"limits", "period_us", 1},          {"limits", "radius_mm", -1},
                  {"limits", "position_error_mm", -1}, {"limits", "velocity_error_mmps", -1},
                  {"limits", "position_age_us", -1},   {"limits", "velocity_age_us", -1},
                  {"limits", "latency_us", -1},        {"limits", "speed_mmps", -1},
                  {"limits", "accel_mmps2", -1},       {"limits", "brake_mmps2", 1},
                  {"limits", "disturbance_mmps2", -1}, {"limits", "brake_lag_ms", -1},
                  {"limits", "hold_mm", -15},          {"horizon", "lookahead_us", -60'000},
                  {"horizon", "horizon_us", -1},       {"return", "extra_us", -60'000},
                  {"return", "dwell_ticks", -2},       {"place", "x_mm", 2'200},
                  {"place", "clearance_mm", -60},      {"ways", "return_mm", -60}};
  for (const auto& m : mistakes) {
    const Outcome o = rechecked_with(changed(m.claim, m.key, m.by));
    EXPECT_EQ(o.status, exit_violation) << m.claim << "." << m.key << "\n" << o.out << o.err;
  }
}

TEST_F(Recheck, AMutatedLemmaIsNoticed) {
  const fs::path lemma = "certificates/lemmas/disc.smt2";
  write(lemma, read(lemma) + "\n(assert false)\n");
  EXPECT_EQ(rechecked().status, exit_violation);
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

// Nobody has acknowledged anything.
TEST_F(Recheck, AnAcknowledgementIsInTheSpecification) {
  for (Json& o : report_["decisions"][0]["obligations"]) o["status"] = "acknowledged";
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
