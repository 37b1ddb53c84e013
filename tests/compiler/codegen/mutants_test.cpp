// Deliberately unsound variants: marked in every file, documented, and never without effect.
#include <algorithm>

#include "compiler/codegen/mutate.h"
#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

class Mutants : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("spec.rta", drone_spec());
  }
};

TEST_F(Mutants, SaySoInEveryFile) {
  ASSERT_EQ(rtac({"build", "spec.rta", "-o", "out", "--mutate", "no-radius"}).status, 0);
  for (const char* name : {"spec_kernel.h", "spec_kernel.c", "spec.h", "spec.cpp", "spec_system.h",
                           "spec_manifest.json"}) {
    EXPECT_NE(read(std::string("out/") + name).find("DELIBERATELY UNSOUND"), std::string::npos)
        << name;
  }
  const std::string manifest = read("out/spec_manifest.json");
  EXPECT_NE(manifest.find("\"mutant\": \"no-radius\""), std::string::npos);
  EXPECT_EQ(manifest.find("\"sound\": true"), std::string::npos);
}

TEST_F(Mutants, WithoutOneNothingIsMarked) {
  ASSERT_EQ(rtac({"build", "spec.rta", "-o", "out"}).status, 0);
  EXPECT_EQ(read("out/spec_kernel.c").find("UNSOUND"), std::string::npos);
  EXPECT_EQ(read("out/spec_manifest.json").find("mutant"), std::string::npos);
}

// An edit that no longer finds its text would leave a sound decision, and a test that never fails.
TEST_F(Mutants, OneThatChangesNothingIsRefused) {
  const Outcome o = rtac({"build", "spec.rta", "-o", "out", "--mutate", "stale-charge"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("`stale-charge` changes nothing"), std::string::npos) << o.err;
  EXPECT_TRUE(!fs::exists("out") || fs::is_empty("out"));
}

TEST_F(Mutants, UnknownOnesAreRefusedWithTheList) {
  const Outcome o = rtac({"build", "spec.rta", "-o", "out", "--mutate", "half"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("`half-look-ahead`"), std::string::npos) << o.err;
}

TEST_F(Mutants, EachIsDocumented) {
  const std::string page = spec_text("compiler/docs/simulation.md");
  for (const codegen::Mutant& m : codegen::mutants()) {
    EXPECT_NE(page.find("| `" + std::string(m.name) + "` | " + m.about + " |"), std::string::npos)
        << m.name;
  }
  EXPECT_GE(codegen::mutants().size(), 15u);
}

// Each is killed in tests/campaign; that of plans is one of its own.
TEST_F(Mutants, EachHasAnAttack) {
  const std::string table = spec_text("tests/campaign/kills.cpp");
  for (const codegen::Mutant& m : codegen::mutants()) {
    EXPECT_NE(table.find("{\"" + std::string(m.name) + "\","), std::string::npos) << m.name;
  }
}

}  // namespace
}  // namespace rtac::driver::test
