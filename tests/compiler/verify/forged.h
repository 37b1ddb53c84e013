// Reports in which somebody has written what is not so, sealed anew.
#pragma once

#include <string>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {

class Forged : public Verify {
 protected:
  void prove(const std::string& text) {
    const Outcome o = verified(text, {"-o", "certificates"});
    ASSERT_EQ(o.status, exit_clean) << o.out << o.err;
    report_ = Json::parse(read("certificates/verification.json"));
  }
  Json& entry(const std::string& kind, const std::string& monitor) {
    for (Json& o : report_["decisions"][0]["obligations"]) {
      if (o["obligation"] == kind && o.value("monitor", "") == monitor) return o;
    }
    ADD_FAILURE() << kind << " of " << monitor;
    return report_;
  }
  Json& claim_of(const std::string& kind, const std::string& monitor, const std::string& what) {
    for (Json& c : entry(kind, monitor)["claims"]) {
      if (c["claim"] == what) return c;
    }
    ADD_FAILURE() << report_.dump(2);
    return report_;
  }
  void expect_changed(Json& claim, const std::string& key, const Json& value,
                      const std::string& why) {
    SCOPED_TRACE(key);
    const Json before = claim;
    claim[key] = value;
    expect_noticed(why);
    claim = before;
  }
  void expect_noticed(const std::string& why) {
    write("certificates/verification.json", report_.dump());
    const Outcome o = recheck_sealed_anew();
    EXPECT_EQ(o.status, exit_violation) << o.out;
    EXPECT_NE(o.out.find(why), std::string::npos) << o.out;
  }
  void expect_noticed_in(const std::string& file, const std::string& from, const std::string& to,
                         const std::string& why) {
    write("certificates/sources/" + file, edited(read("certificates/sources/" + file), from, to));
    expect_noticed(why);
  }
  Json report_;
};

}  // namespace rtac::driver::test
