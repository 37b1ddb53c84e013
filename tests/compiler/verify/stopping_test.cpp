// What brakes above a battery lets go at rest, where that fulfils all that it brakes for: it lasts,
// and drives, no longer than a stop.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

struct Cart {
  std::string motion =
      "unicycle { speed <= 1 m/s; turn <= 1 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; "
      "turn_accel <= 10 rad/s^2; }";
  std::string output = "twist", held = "20 s", detour = "2 m";
  std::string calm = "c.speed <= 0.8 m/s", priority = "calm > charged";
};
std::string page(const Cart& cart) {
  return "spec calm;\nzone yard = rectangle (0 m, 0 m) to (8 m, 8 m);\n"
         "zone ward = rectangle (0 m, 0 m) to (4 m, 4 m);\n"
         "input night : bool max_age 1 s;\nrobot Cart {\n  body radius 10 cm;\n  motion " +
         cart.motion + R"(
  sense position : point  error 1 cm   max_age 100 ms;
  sense heading  : angle  error 2 deg  max_age 100 ms;
  sense velocity : vector error 1 cm/s max_age 100 ms;
  sense battery  : ratio  error 1 %    max_age 2 s;
  latency 20 ms;
  output drive : )" +
         cart.output +
         ";\n  energy { drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; charge >= 1 %/s at "
         "home; held <= " +
         cart.held + "; detour <= " + cart.detour + R"(; }
}
fleet one : Cart;
site home = (5 m, 5 m);
controller explore : advanced for Cart extern;
controller stop    : safe for Cart = brake_and_hold;
controller go_home : safe for Cart = route to home within yard speed 0.2 m/s;
monitor calm    for c : Cart { "SR-1: calm" always )" +
         cart.calm + R"(; recover stop; }
monitor charged for c : Cart { "SR-2: home again" always c.battery >= energy_to(home) + 5 %; recover go_home; }
decision drive for Cart { advanced explore; period 50 ms; priority )" +
         cart.priority + "; }\n";
}
Cart of_a_point_mass() {
  Cart cart;
  cart.motion = "point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }";
  cart.output = "acceleration";
  return cart;
}

class Stopping : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  static Json lasts() {
    const Json report = Json::parse(read("shown/verification.json"));
    for (const Json& o : report["decisions"][0]["obligations"]) {
      for (const Json& c : o.value("claims", Json::array())) {
        if (c["claim"] == "lasts") return c;
      }
    }
    return {};
  }
  static bool works(const std::string& text) {
    return verified(text, {"-o", "shown"}).status == exit_clean &&
           rtac({"verify", "--recheck", "shown"}).status == exit_clean;
  }
};

TEST_F(Stopping, AStopAboveABatteryEnds) {
  for (const Cart& robot : {Cart(), of_a_point_mass()}) {
    for (const char* calm : {"c.speed <= 0.8 m/s", "night implies c.speed <= 0.75 m/s",
                             "distance(c, ward) <= 20 cm implies c.speed <= 0.75 m/s"}) {
      Cart cart = robot;
      cart.calm = calm;
      EXPECT_TRUE(works(page(cart))) << calm << robot.output;
      EXPECT_FALSE(lasts().empty()) << calm;
    }
  }
}

// What a charge has to pay for in advance is told, and no less does.
TEST_F(Stopping, AChargeThatPaysForLessIsToldHowMuchItTakes) {
  Cart cart;
  cart.held = "1 s", cart.detour = "10 cm";
  const Outcome o = verified(page(cart));
  const std::string held = "`held <= ", detour = "`detour <= ";
  const std::size_t s = o.err.rfind(held), m = o.err.rfind(detour);
  ASSERT_NE(s, std::string::npos) << o.err;
  ASSERT_NE(m, std::string::npos) << o.err;
  const double most_s = std::stod(o.err.substr(s + held.size()));
  const double most_m = std::stod(o.err.substr(m + detour.size()));
  const auto with = [&](double part) {
    Cart other;
    other.held = std::to_string(part * most_s) + " s";
    other.detour = std::to_string(most_m) + " m";
    return page(other);
  };
  EXPECT_TRUE(works(with(1))) << o.err;
  EXPECT_FALSE(works(with(0.95))) << o.err;
}

// It never lasts longer than is told.
TEST_F(Stopping, RunsEndWithinTheTimeOfAStop) {
  for (Cart cart : {Cart(), of_a_point_mass()}) {
    ASSERT_TRUE(works(page(cart)));
    const double held_s = std::stod(lasts()["held_us"].get<std::string>()) / 1e6;
    EXPECT_LE(held_s, 10);
    cart.priority = "calm";
    write("spec.rta", page(cart));
    write("s.json", R"({"duration_s": 90, "runs": 24, "seed": 7, "return_within_s": )" +
                        std::to_string(held_s) + "}");
    const Outcome run = rtac({"sim", "spec.rta", "--scenario", "s.json"});
    EXPECT_EQ(run.status, exit_clean) << held_s << run.out << run.err;
  }
}

TEST_F(Stopping, WhatIsNotFulfilledAtRestHasNoEnd) {
  Cart cart;
  cart.calm = "clearance(c, yard) >= 20 cm";
  std::string text = edited(page(cart), "recover stop;", "recover stop; hold when violated \"x\";");
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "C", "charged"), Statuses{"refuted"}) << o.out;
  cart.calm = "c.speed <= 0.8 m/s and night";
  EXPECT_FALSE(works(page(cart)));
}

TEST_F(Stopping, ALessEndIsNoticed) {
  ASSERT_TRUE(works(page({})));
  const std::string source = read("shown/sources/spec.rta");
  const Json report = Json::parse(read("shown/verification.json"));
  const auto denied = [](const std::string& why) {
    const Outcome o = recheck_sealed_anew("shown");
    EXPECT_EQ(o.status, exit_violation) << o.out;
    EXPECT_NE((o.out + o.err).find(why), std::string::npos) << why << "\n" << o.out << o.err;
  };
  for (const auto& [key, why] : {std::pair("held_us", "it may last longer"),
                                 std::pair("driven_mm", "it may drive further")}) {
    Json forged = report;
    for (Json& o : forged["decisions"][0]["obligations"]) {
      if (!o.contains("claims")) continue;
      for (Json& c : o["claims"]) {
        if (c["claim"] != "lasts") continue;
        c[key] = std::to_string(std::stoll(c[key].get<std::string>()) - 1'000);
        if (std::string(key) == "driven_mm") c[key] = "1";
      }
    }
    write("shown/verification.json", forged.dump());
    denied(why);
  }
  write("shown/verification.json", report.dump());
  for (const auto& [from, to, why] :
       {std::tuple("c.speed <= 0.8 m/s", "clearance(c, yard) >= 20 cm", "given back at rest"),
        std::tuple("c.speed <= 0.8 m/s", "night and c.speed <= 0.8 m/s", "given back at rest"),
        std::tuple("held <= 20 s", "held <= 1 s", "lasts longer than `held`")}) {
    write("shown/sources/spec.rta", edited(source, from, to));
    denied(why);
  }
}

// Pushes and errors that turn around keep a point mass moving where it holds its place: a limit
// that it keeps at rest alone need not let it go.
TEST_F(Stopping, WhoIsKeptMovingIsNotGivenBackAtRest) {
  const auto windy = [](const std::string& limit) {
    Cart cart = of_a_point_mass();
    cart.motion =
        "point { speed <= 1 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; disturbance <= 0.06 m/s^2; }";
    cart.calm = "c.speed <= " + limit;
    return page(cart);
  };
  const Outcome o = verified(windy("0.694 m/s"), {"--format", "json", "--attack", "1"});
  EXPECT_EQ(statuses(o.out, "P2b", "calm"), Statuses{"unknown"}) << o.out;
  const std::string before = "a limit of ";
  const std::size_t at = o.out.find(before);
  ASSERT_NE(at, std::string::npos) << o.out;
  const double works_at = std::stod(o.out.substr(at + before.size()));
  EXPECT_TRUE(works(windy(std::to_string(works_at) + " m/s"))) << works_at;
  const double held_s = std::stod(lasts()["held_us"].get<std::string>()) / 1e6;
  const std::string alone =
      edited(windy(std::to_string(works_at) + " m/s"), "priority calm > charged", "priority calm");
  write("spec.rta", alone);
  for (const char* adversary : {"gusts", "unequal-samples", "wandering-samples"}) {
    write("s.json",
          R"({"duration_s": 120, "runs": 20, "return_within_s": )" + std::to_string(held_s) + "}");
    const Outcome run = rtac({"sim", "spec.rta", "--scenario", "s.json", "--adversary", adversary});
    EXPECT_EQ(run.status, exit_clean) << adversary << held_s << run.out << run.err;
  }
}

}  // namespace
}  // namespace rtac::driver::test
