// Each field of each kind of claim in the certificates of both case studies, changed to the unsafe
// side: --recheck notices, but for what is listed with its reason.
#include <map>
#include <set>

#include "tests/compiler/verify/testing.h"
#include "tests/turn.h"

namespace rtac::driver::test {
namespace {

// Fields of which one side alone is unsafe, and why the other one is not; both are of all others.
enum class Unsafe { less, more };
const std::map<std::string, Unsafe>& one_sided() {
  static const std::map<std::string, Unsafe> fields = {
      // clearer ways are harder to find
      {"ways.route_mm", Unsafe::less},
      {"ways.return_mm", Unsafe::less},
      {"lasts.route_mm", Unsafe::less},
      // whoever is held for longer, or drives further, spends more
      {"lasts.held_us", Unsafe::less},
      {"lasts.driven_mm", Unsafe::less},
      // and who sets out nearer to the wall has further to go
      {"lasts.starts_mm", Unsafe::more},
      // places that are clearer do as well
      {"place.clearance_mm", Unsafe::less},
      {"seen.clearance_mm", Unsafe::less}};
  return fields;
}

// Fields that may be true as well where they are changed a little, by how much they are not, and
// why.
std::int64_t wrong_by(const std::string& name, std::int64_t value) {
  static const std::map<std::string, std::int64_t> coarse = {
      // other places are clear enough, too
      {"seen.x_mm", 20'000},
      {"seen.y_mm", 20'000},
      {"place.x_mm", 20'000},
      {"place.y_mm", 20'000},
      {"returned.x_mm", 20'000},
      {"returned.y_mm", 20'000},
      // bounds of numbers that have been rounded before
      {"limits.brake_lag_ms", 20},
      {"limits.hold_mm", 20},
      // held against a lower bound, which leaves out what the kernel rounds up
      {"place.clearance_mm", 60},
      {"seen.clearance_mm", 60},
      {"ways.return_mm", 60}};
  const auto at = coarse.find(name);
  return at != coarse.end() ? at->second : std::max<std::int64_t>(1, std::abs(value) / 20);
}

class Mutated : public Verify {
 protected:
  void prove(const std::string& text) {
    const Outcome o = verified(text, {"-o", "certificates"});
    ASSERT_EQ(o.status, exit_clean) << o.out << o.err;
    report_ = Json::parse(read("certificates/verification.json"));
  }
  // Whether the field of one claim, with that value, is noticed.
  bool noticed(Json& field, const std::string& value) {
    const Json before = field;
    field = value;
    write("certificates/verification.json", report_.dump());
    field = before;
    return recheck_sealed_anew().status != exit_clean;
  }
  void change(const std::string& name, Json& field) {
    const std::string text = field.get<std::string>();
    std::int64_t value = 0;
    try {
      value = std::stoll(text);
    } catch (const std::invalid_argument&) {
      EXPECT_TRUE(noticed(field, "nosuch")) << name;
      return;
    }
    const std::int64_t by = wrong_by(name, value);
    const auto with = [&](std::int64_t n) { return noticed(field, std::to_string(n)); };
    const auto side = one_sided().find(name);
    const bool less = side == one_sided().end() || side->second == Unsafe::less;
    const bool more = side == one_sided().end() || side->second == Unsafe::more;
    if (less) {
      EXPECT_TRUE(with(value - by)) << name << " " << value;
      EXPECT_TRUE(with(-value - 1)) << name << " " << value;
    }
    if (more) {
      EXPECT_TRUE(with(value + by)) << name << " " << value;
    }
  }
  // The first claim that has it stands for all.
  void change_each() {
    std::set<std::string> seen;
    for (Json& o : report_["decisions"][0]["obligations"]) {
      if (!o.contains("claims")) continue;
      for (Json& c : o["claims"]) {
        const std::string kind = c["claim"];
        for (auto& [key, field] : c.items()) {
          const std::string name = kind + "." + key;
          if (key == "claim" || !seen.insert(name).second) continue;
          if (!rtac::test::is_due(seen.size())) continue;
          change(name, field);
        }
      }
    }
    EXPECT_GT(seen.size(), 30U);
  }
  Json report_;
};

TEST_F(Mutated, EachFieldOfTheDelivery) {
  prove(spec_text("specs/robot_delivery/robot_delivery.rta"));
  change_each();
}
TEST_F(Mutated, EachFieldOfTheSurveillance) {
  write("quadrotor.rta", spec_text("specs/drone_surveillance/quadrotor.rta"));
  prove(spec_text("specs/drone_surveillance/drone_surveillance.rta"));
  change_each();
}

}  // namespace
}  // namespace rtac::driver::test
