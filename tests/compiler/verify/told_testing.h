// What inputs make of a property, as `verify` searches for it and as a recheck reads it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compiler/analysis/told.h"
#include "compiler/driver/compile.h"
#include "compiler/recheck/told.h"
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {

class OfToldInputs : public Verify {
 protected:
  // Of a robot in a hall, with inputs; what may have the monitor let go is in `more`.
  static std::string of_a_rover(const std::string& inputs, const std::string& property,
                                const std::string& more) {
    return "spec told;\nzone hall = rectangle (0 m, 0 m) to (6 m, 5 m);\n" + inputs + a_rover +
           R"(controller back : safe for Rover = retreat within hall speed 0.3 m/s;
monitor fence for r : Rover { "R1" always )" +
           property + "; recover back; " + more + R"( }
decision go for Rover { advanced drive; period 50 ms; priority fence; }
)";
  }
  static std::string in(const std::string& property) { return "r inside hall and " + property; }
  // Of a page, whose first monitor is judged, with what it says or else asks for to return.
  static std::unique_ptr<Compilation> checked(const std::string& text) {
    write("spec.rta", text);
    Options options;
    options.spec = "spec.rta";
    auto c = std::make_unique<Compilation>();
    check_only(options, *c);
    EXPECT_TRUE(c->spec) << text;
    return c;
  }
  // "yes": with inputs that a recheck accepts; "denied": with others.
  static std::string can_be(bool value, const std::string& text) {
    const auto c = checked(text);
    if (!c->spec) return "";
    const sema::Expr& e = *c->spec->monitors.front().always;
    const auto how = value ? analysis::ToldHow::seen : analysis::ToldHow::exactly;
    const analysis::Told told = analysis::told_to_be(*c->spec, e, value, how);
    if (told.can == analysis::CanBeTold::no) return "no";
    if (told.can == analysis::CanBeTold::open) return "open";
    recheck::ToldInputs inputs;
    for (const auto& each : told.inputs) inputs[{each.input, each.component}] = each.value;
    return recheck::told_makes(*c->spec, e, inputs, value) ? "yes" : "denied";
  }
  // Of inputs as a claim has them.
  static bool accepts(const std::string& inputs, bool value, const std::string& text) {
    const auto c = checked(text);
    const auto read = c->spec ? recheck::told_inputs(*c->spec, inputs) : std::nullopt;
    return read && recheck::told_makes(*c->spec, *c->spec->monitors.front().always, *read, value);
  }
  static void expect_proved(const std::string& text) {
    const Outcome o = verified(text, {"-o", "certificates"});
    EXPECT_EQ(o.status, exit_clean) << text << o.out << o.err;
    const Outcome again = recheck_sealed_anew();
    EXPECT_EQ(again.status, exit_clean) << text << again.out << again.err;
  }
  static void expect(const std::string& status, const std::string& kind, const std::string& monitor,
                     const std::string& text) {
    const Outcome o = verified(text, {"--attack", "1", "--format", "json"});
    EXPECT_EQ(statuses(o.out, kind, monitor), Statuses{status}) << text << o.out << o.err;
  }
  // The certificates of another page, in which somebody has written these instead.
  static void expect_denied(const std::string& honest,
                            const std::vector<std::pair<std::string, std::string>>& pages) {
    expect_proved(honest);
    for (const auto& [text, why] : pages) {
      write("certificates/sources/spec.rta", text);
      const Outcome o = recheck_sealed_anew();
      EXPECT_EQ(o.status, exit_violation) << text << o.out;
      EXPECT_NE(o.out.find(why), std::string::npos) << text << o.out;
    }
  }
};

}  // namespace rtac::driver::test
