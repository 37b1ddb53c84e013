// The command line as scripts see it: exit codes, which stream says what, what is written.
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

class CommandLine : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("good.rta", drone_spec());
    write("faulty.rta", edited(edited(drone_spec(), "10 cm;\n  ahead", "10;\n  ahead"),
                               "recover back_off", "recover backoff"));
    write("warning.rta",
          edited(drone_spec(), "2 waypoints;", "2 waypoints, points only unsound \"why\";"));
  }
};

TEST_F(CommandLine, AGoodSpecificationExitsWith0AndSaysOnlyWhatWasDerived) {
  const Outcome o = rtac({"check", "good.rta"});
  EXPECT_EQ(o.status, 0);
  EXPECT_NE(o.out.find("monitor walls: looks 100 ms ahead"), std::string::npos) << o.out;
  EXPECT_EQ(o.err, "");
}

TEST_F(CommandLine, SeveralErrorsAreReportedInOneRunWithFileLineAndColumn) {
  const Outcome o = rtac({"check", "faulty.rta"});
  EXPECT_EQ(o.status, 1);
  EXPECT_EQ(o.out, "");
  EXPECT_NE(o.err.find("error[3001]"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("error[2006]"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("--> faulty.rta:22:33"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("2 errors\n"), std::string::npos) << o.err;
}

TEST_F(CommandLine, HelpGoesToStdoutAndUsageErrorsToStderr) {
  for (const std::string word : {"help", "--help", "-h"}) {
    const Outcome o = rtac({word});
    EXPECT_EQ(o.status, 0);
    EXPECT_NE(o.out.find("rtac build SPEC -o DIR"), std::string::npos);
    EXPECT_EQ(o.err, "");
  }
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {}, {"frob"}, {"check"}, {"check", "good.rta", "--frob"}, {"build", "good.rta"}}) {
    const Outcome o = rtac(words);
    EXPECT_EQ(o.status, 2);
    EXPECT_EQ(o.out, "");
    EXPECT_NE(o.err.find("error[9001]"), std::string::npos) << o.err;
  }
}

TEST_F(CommandLine, WhatCannotBeReadIsAUsageError) {
  write("file", "text");
  fs::create_directories("folder");
  for (const std::string path : {"missing.rta", "folder", "file/below.rta"}) {
    const Outcome o = rtac({"check", path});
    EXPECT_EQ(o.status, 2) << path;
    EXPECT_NE(o.err.find("error[9002]: cannot read `" + path + "`: "), std::string::npos) << o.err;
  }
}

TEST_F(CommandLine, AnEmptyArgumentIsNoFileName) {
  EXPECT_EQ(rtac({"check", ""}).status, 2);
  EXPECT_EQ(rtac({""}).status, 2);
}

TEST_F(CommandLine, WordsBehindTwoDashesAreFileNames) {
  write("--good.rta", drone_spec());
  EXPECT_EQ(rtac({"check", "--", "--good.rta"}).status, 0);
  EXPECT_EQ(rtac({"check", "--good.rta"}).status, 2);
}

TEST_F(CommandLine, AFlagAndItsValueMayBeOneWord) {
  const Outcome one = rtac({"check", "good.rta", "--print-after=share_values"});
  const Outcome two = rtac({"check", "good.rta", "--print-after", "share_values"});
  EXPECT_EQ(one.status, 0);
  EXPECT_EQ(one.out, two.out);
  EXPECT_NE(one.out.find("module fence_study"), std::string::npos);
}

TEST_F(CommandLine, WarningsDoNotFailUnlessTheyAreToldTo) {
  const Outcome o = rtac({"check", "warning.rta"});
  EXPECT_EQ(o.status, 0);
  EXPECT_NE(o.err.find("warning[5010]"), std::string::npos);
  EXPECT_EQ(rtac({"check", "warning.rta", "-Werror"}).status, 1);
  EXPECT_EQ(rtac({"build", "warning.rta", "-o", "out", "-Werror"}).status, 1);
  EXPECT_FALSE(fs::exists("out"));
}

TEST_F(CommandLine, JsonIsOneValidDocumentWithPlaces) {
  const Outcome o = rtac({"check", "faulty.rta", "--format", "json"});
  EXPECT_EQ(o.status, 1);
  const auto all = nlohmann::json::parse(o.err, nullptr, false);
  ASSERT_TRUE(all.is_array()) << o.err;
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0]["location"]["file"], "faulty.rta");
  EXPECT_EQ(all[0]["location"]["begin"]["line"], 22);
  EXPECT_EQ(nlohmann::json::parse(rtac({"check", "good.rta", "--format=json"}).err, nullptr, false),
            nlohmann::json::array());
  const auto unread =
      nlohmann::json::parse(rtac({"check", "none", "--format", "json"}).err, nullptr, false);
  ASSERT_EQ(unread.size(), 1u);
  EXPECT_TRUE(unread[0]["location"].is_null());
}

TEST_F(CommandLine, JsonStaysValidForTextThatIsNot) {
  write("bytes.rta", "spec a;\nzone \"\x80\xff\x01\\ z = \xc3;\n");
  const Outcome o = rtac({"check", "bytes.rta", "--format", "json"});
  EXPECT_EQ(o.status, 1);
  EXPECT_TRUE(nlohmann::json::parse(o.err, nullptr, false).is_array()) << o.err;
}

TEST_F(CommandLine, ADumpReplacesTheSummary) {
  for (const std::string flag : {"--dump-ast", "--dump-spec", "--dump-ir"}) {
    const Outcome o = rtac({"check", "good.rta", flag});
    EXPECT_EQ(o.status, 0);
    EXPECT_FALSE(o.out.empty());
    EXPECT_EQ(o.out.find("looks 100 ms ahead"), std::string::npos);
  }
}

TEST_F(CommandLine, EveryPassCanBePrinted) {
  for (const std::string pass : {"expand_lookahead", "share_values", "analyse_ranges"}) {
    EXPECT_NE(rtac({"check", "good.rta", "--print-after", pass}).out.find("zone_reach room"),
              std::string::npos);
  }
}

TEST_F(CommandLine, TheNamespaceIsTheAuthorsChoice) {
  ASSERT_EQ(rtac({"build", "good.rta", "-o", "out", "--namespace", "mine"}).status, 0);
  EXPECT_NE(read("out/good.h").find("namespace mine {"), std::string::npos);
  ASSERT_EQ(rtac({"build", "good.rta", "-o", "out"}).status, 0);
  EXPECT_NE(read("out/good.h").find("namespace fence_study {"), std::string::npos);
  for (const std::string name : {"1a", "a b", "namespace", "std", "a::b", "a-b"}) {
    EXPECT_EQ(rtac({"build", "good.rta", "-o", "o", "--namespace", name}).status, 2) << name;
  }
  EXPECT_FALSE(fs::exists("o"));
}

TEST_F(CommandLine, AnyFileNameGivesCodeThatIsWellFormed) {
  write("2 my-spec.v1.rta", drone_spec());
  ASSERT_EQ(rtac({"build", "2 my-spec.v1.rta", "-o", "out"}).status, 0);
  const std::string header = read("out/2 my-spec.v1_kernel.h");
  EXPECT_NE(header.find("#ifndef _2_MY_SPEC_V1_KERNEL_H\n"), std::string::npos)
      << header.substr(0, 600);
}

}  // namespace
}  // namespace rtac::driver::test
