// The command line as scripts see it: exit codes, which stream says what, what is written.
#include <fcntl.h>
#include <sys/stat.h>

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

// A number below zero is no flag, and a file without a line is no diagnostic.
TEST_F(CommandLine, UsageErrorsSayWhatWasMeant) {
  const Outcome bytes = rtac({"check", "good.rta", "--max-bytes", "-1"});
  EXPECT_EQ(bytes.status, 2);
  EXPECT_NE(bytes.err.find("`-1` is no number of bytes"), std::string::npos) << bytes.err;
  EXPECT_NE(bytes.err.find("`--max-bytes 4096`"), std::string::npos) << bytes.err;
  for (const std::string flag : {"--runs", "--seed", "--jobs"}) {
    const Outcome below = rtac({"sim", "good.rta", flag, "-3"});
    EXPECT_EQ(below.status, 2);
    EXPECT_NE(below.err.find("`-3` is no number for `" + flag + "`"), std::string::npos)
        << below.err;
  }
  const Outcome line = rtac({"explain", "good.rta"});
  EXPECT_EQ(line.status, 2);
  EXPECT_NE(line.err.find("`good.rta` is a file, without a line"), std::string::npos) << line.err;
  EXPECT_NE(line.err.find("give FILE:LINE, such as `good.rta:1`"), std::string::npos) << line.err;
}

// Before anything is read or printed.
TEST_F(CommandLine, NoRunsAtAllAreRefusedFirst) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"explain", "good.rta:1", "--simulate", "0"}, {"sim", "good.rta", "--runs", "00"}}) {
    const Outcome o = rtac(words);
    EXPECT_EQ(o.status, 2);
    EXPECT_EQ(o.out, "");
    EXPECT_NE(o.err.find("simulates nothing"), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("`" + words[2] + " 1` works"), std::string::npos) << o.err;
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
  // one line feed at the end, as every file of text has
  EXPECT_EQ(o.err.find_last_not_of('\n') + 2, o.err.size());
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

// What people have at hand finds a page; what only holds its number does not.
TEST_F(CommandLine, ADiagnosticIsFoundByItsNumberAsItIsPrinted) {
  const std::string page = rtac({"explain", "4011"}).out;
  EXPECT_EQ(page.find("# 4011"), 0U) << page;
  for (const std::string topic : {"E4011", "[4011]", "error[4011]", "too_many_edges"}) {
    EXPECT_EQ(rtac({"explain", topic}).out, page) << topic;
  }
  for (const std::string topic : {"4011x", "x4011", "40 11", "4011]]"}) {
    EXPECT_EQ(rtac({"explain", topic}).status, 2) << topic;
  }
}

// Every command has a page of its own, with what it takes, examples, and what its exit codes mean.
TEST_F(CommandLine, EveryCommandHasItsHelp) {
  for (const std::string command :
       {"check", "build", "replay", "sim", "verify", "zones", "protocol", "fmt", "explain"}) {
    const Outcome page = rtac({"help", command});
    EXPECT_EQ(page.status, 0);
    EXPECT_EQ(page.out.find("usage: rtac " + command), 0U) << page.out;
    for (const std::string& part : std::vector<std::string>{
             "\nExamples:\n  rtac " + command, "\nExit codes:\n  0  ", "  70 a bug of rtac\n"}) {
      EXPECT_NE(page.out.find(part), std::string::npos) << part << page.out;
    }
    EXPECT_EQ(rtac({command, "--help"}).out, page.out);
    EXPECT_EQ(rtac({command, "a", "-h"}).out, page.out);
    EXPECT_NE(rtac({"help"}).out.find("rtac " + command), std::string::npos);
  }
  EXPECT_EQ(rtac({"help", "fly"}).status, 2);
}

// A flag that a command takes and its page does not name would be found by nobody.
TEST_F(CommandLine, TheHelpNamesEveryFlag) {
  const std::string flags[] = {"--format",   "--namespace", "--depfile", "--print-after",
                               "--dump-ast", "--dump-spec", "--dump-ir", "--max-bytes",
                               "-Werror",    "--engine",    "--monitor", "--check",
                               "--recheck",  "--scenario",  "--trace"};
  for (const std::string command :
       {"check", "build", "replay", "sim", "verify", "zones", "protocol", "fmt"}) {
    const std::string page = rtac({"help", command}).out;
    for (const std::string& flag : flags) {
      const bool writes = flag == "--depfile";  // `check` knows it to say that it writes nothing
      if (command == "check" && writes) continue;
      const std::string said = rtac({command, flag, "x", "y"}).err;
      const bool taken = said.find("has no flag `" + flag + "`") == std::string::npos;
      const bool named = page.find("\n  " + flag) != std::string::npos;
      EXPECT_EQ(named, taken) << command << " " << flag;
    }
  }
}

TEST_F(CommandLine, EveryPassCanBePrinted) {
  for (const std::string pass :
       {"expand_lookahead", "share_values", "analyse_ranges", "find_vacuous"}) {
    EXPECT_NE(rtac({"check", "good.rta", "--print-after", pass}).out.find("zone_reach room"),
              std::string::npos);
  }
}

TEST_F(CommandLine, TheNamespaceIsTheAuthorsChoice) {
  ASSERT_EQ(rtac({"build", "good.rta", "-o", "out", "--namespace", "mine"}).status, 0);
  EXPECT_NE(read("out/good.h").find("namespace mine {"), std::string::npos);
  ASSERT_EQ(rtac({"build", "good.rta", "-o", "out"}).status, 0);
  EXPECT_NE(read("out/good.h").find("namespace fence_study {"), std::string::npos);
  for (const std::string name : {"1a", "a b", "namespace", "std", "a::b", "a-b", "time"}) {
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

// The first value would silently lose, and with it, for example, the place of the files.
TEST_F(CommandLine, AFlagWithAValueStandsOnce) {
  for (const std::string flag : {"-o", "--depfile", "--namespace", "--print-after", "--format"}) {
    const Outcome o = rtac({"build", "good.rta", "-o", "out", flag, "one", flag, "two"});
    EXPECT_EQ(o.status, 2) << flag;
    EXPECT_NE(o.err.find("`" + flag + "` is given twice"), std::string::npos) << o.err;
  }
  EXPECT_FALSE(fs::exists("out"));
}

TEST_F(CommandLine, AFlagIsNoValueOfAnother) {
  const Outcome o = rtac({"build", "good.rta", "-o", "--depfile", "d"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("`./--depfile`"), std::string::npos) << o.err;
  EXPECT_EQ(rtac({"build", "good.rta", "-o", ""}).status, 2);
  EXPECT_EQ(rtac({"build", "good.rta", "-o", "out", "--namespace="}).status, 2);
  EXPECT_FALSE(fs::exists("out"));
}

TEST_F(CommandLine, BehindTwoDashesAnEqualsSignBelongsToTheName) {
  write("--a=b.rta", drone_spec());
  EXPECT_EQ(rtac({"check", "--", "--a=b.rta"}).status, 0);
}

TEST_F(CommandLine, HelpMayBeAskedForAnywhere) {
  EXPECT_EQ(rtac({"check", "--help"}).status, 0);
  EXPECT_EQ(rtac({"build", "good.rta", "-h"}).status, 0);
  EXPECT_EQ(rtac({"check", "--", "--help"}).status, 2);  // a file of that name
  EXPECT_EQ(rtac({"version", "now"}).status, 2);
}

// The dependencies must not destroy what they name.
TEST_F(CommandLine, TheDependencyFileIsNeitherSpecificationNorOutput) {
  const std::string before = read("good.rta");
  for (const std::string path : {"good.rta", "./out/../good.rta", "out/good.h"}) {
    EXPECT_EQ(rtac({"build", "good.rta", "-o", "out", "--depfile", path}).status, 2) << path;
  }
  EXPECT_EQ(read("good.rta"), before);
  EXPECT_FALSE(fs::exists("out"));
}

TEST_F(CommandLine, ThePictureOfZonesGoesWhereItIsToldTo) {
  const Outcome shown = rtac({"zones", "good.rta", "-o", "-"});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(shown.out.find("<svg xmlns"), 0U);
  EXPECT_NE(shown.out.find("good.rta:"), std::string::npos);
  const Outcome written = rtac({"zones", "good.rta", "-o", "room.svg"});
  EXPECT_EQ(written.status, 0) << written.err;
  EXPECT_EQ(written.out, "");
  EXPECT_EQ(read("room.svg"), shown.out);
}

TEST_F(CommandLine, ThePictureOfZonesOverwritesNoSpecification) {
  const std::string before = read("good.rta");
  EXPECT_EQ(rtac({"zones", "good.rta", "-o", "./good.rta"}).status, 2);
  EXPECT_EQ(read("good.rta"), before);
  EXPECT_EQ(rtac({"zones", "good.rta"}).status, 2);
  EXPECT_EQ(rtac({"zones", "good.rta", "-o", "good.rta/x.svg"}).status, 2);
  EXPECT_EQ(rtac({"zones", "faulty.rta", "-o", "faulty.svg"}).status, 1);
  EXPECT_FALSE(fs::exists("faulty.svg"));
}

TEST_F(CommandLine, WithoutZonesThereIsNoPicture) {
  write("door.rta",
        "spec door;\nperiod 1 s;\ninput p : bool;\nmonitor m { \"R1: p\" always p; }\n");
  const Outcome o = rtac({"zones", "door.rta", "-o", "door.svg"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("has no zone to draw"), std::string::npos) << o.err;
  EXPECT_FALSE(fs::exists("door.svg"));
}

// Text of an author could end an element, or the picture.
TEST_F(CommandLine, ThePictureOfZonesIsWellFormed) {
  std::string spec = edited(drone_spec(), "zone room =",
                            "zone a = circle (1 m, 1 m) radius 1 m "
                            "/* <g> & \"x\" */ & "
                            "circle (1 m, 2 m) radius 1 m;\nzone room =");
  write("odd.rta", spec);
  const Outcome o = rtac({"zones", "odd.rta", "-o", "-"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.out.find("<g> &"), std::string::npos);
  EXPECT_EQ(o.out.substr(o.out.size() - 7), "</svg>\n");
}

// Under the outlines of all zones that are drawn after it, each one still has an edge of its own.
TEST_F(CommandLine, ThePictureOfZonesShowsAllWithOneBoundary) {
  std::string spec = "spec s;\nperiod 1 s;\n";
  for (const char name : std::string("abcdefgh")) {
    spec += std::string("zone ") + name + " = rectangle (0 m, 0 m) to (5 m, 5 m);\n";
  }
  write("same.rta", spec +
                        "input p : point in 0 .. 9 m;\n"
                        "monitor m { \"R1\" always p inside a; }\n");
  const Outcome o = rtac({"zones", "same.rta", "-o", "-"});
  EXPECT_EQ(o.status, 0) << o.err;
  std::vector<double> widths;
  const std::string before = "fill-opacity=\"0.12\" stroke=\"#", width = "stroke-width=\"";
  const std::size_t legend = o.out.find("</g>");
  for (std::size_t at = 0; (at = o.out.find(before, at)) < legend; ++at) {
    widths.push_back(std::stod(o.out.substr(o.out.find(width, at) + width.size(), 4)));
  }
  ASSERT_EQ(widths.size(), 8U);
  for (std::size_t i = 1; i < widths.size(); ++i) EXPECT_GT(widths[i - 1], widths[i] + 0.5);
  EXPECT_LE(widths.front(), 8);
}

TEST_F(CommandLine, TheModelsOfDecisionsGoIntoAFolder) {
  const Outcome o = rtac({"protocol", "good.rta", "-o", "models"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.out + o.err, "");
  const std::string model = read("models/fly.pml");
  EXPECT_EQ(model.find("/* Switching protocol of the decision `fly` for Drone, every 50 ms"), 0U);
  EXPECT_NE(model.find("walls: SR-1: "), std::string::npos);
  EXPECT_NE(model.find("\nltl no_livelock {"), std::string::npos);
  EXPECT_EQ(rtac({"protocol", "good.rta"}).status, 2);
  EXPECT_EQ(rtac({"protocol", "good.rta", "-o", "good.rta/x"}).status, 2);
  EXPECT_EQ(rtac({"protocol", "faulty.rta", "-o", "none"}).status, 1);
  EXPECT_FALSE(fs::exists("none"));
}

// Text of an author could end a comment of the model.
TEST_F(CommandLine, ARequirementStaysInTheCommentOfTheModel) {
  write("odd.rta", edited(drone_spec(), "SR-1: the drone", "SR-1: */ the drone"));
  ASSERT_EQ(rtac({"protocol", "odd.rta", "-o", "models"}).status, 0);
  EXPECT_NE(read("models/fly.pml").find("SR-1: * / the drone"), std::string::npos);
}

TEST_F(CommandLine, WithoutDecisionsThereIsNoProtocol) {
  write("door.rta",
        "spec door;\nperiod 10 ms;\ninput open : bool;\n"
        "monitor shut { \"R1: shut\" always not open; }\n");
  const Outcome o = rtac({"protocol", "door.rta", "-o", "models"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("`door` has no decision"), std::string::npos) << o.err;
  EXPECT_FALSE(fs::exists("models"));
}

TEST_F(CommandLine, ANameThatIsTooLongIsReported) {
  const std::string name(5000, 'a');
  const Outcome read = rtac({"check", name});
  EXPECT_EQ(read.status, 2);
  EXPECT_NE(read.err.find("too long"), std::string::npos);
  EXPECT_EQ(rtac({"build", "good.rta", "-o", name}).status, 2);
}

// Renaming onto a device or a link, as for a plain file, would replace it.
TEST_F(CommandLine, SpecialFilesAreWrittenToAndLinksFollowed) {
  ASSERT_EQ(mkfifo("pipe", 0600), 0);
  const int reader = open("pipe", O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  fs::create_symlink("deps", "link");
  EXPECT_EQ(rtac({"build", "good.rta", "-o", "out", "--depfile", "pipe"}).status, 0);
  EXPECT_TRUE(fs::is_fifo("pipe"));
  char byte = 0;
  EXPECT_EQ(::read(reader, &byte, 1), 1);
  close(reader);
  EXPECT_EQ(rtac({"build", "good.rta", "-o", "out", "--depfile", "link"}).status, 0);
  EXPECT_TRUE(fs::is_symlink("link"));
  EXPECT_NE(read("deps").find("good.rta"), std::string::npos);
}

}  // namespace
}  // namespace rtac::driver::test
