// What `rtac build` writes: everything or nothing, the same bytes each time, nothing of this
// machine.
#include <clocale>
#include <cstdlib>
#include <regex>

#include "compiler/driver/files.h"
#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

class Outputs : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("good.rta", drone_spec());
    write("faulty.rta", edited(drone_spec(), "10 cm;\n  ahead", "10;\n  ahead"));
    write("late.rta", edited(drone_spec(), "100 ms, 2", "2 s, 2"));  // found by the last phases
  }
};

TEST_F(Outputs, AreTheSixFilesOfTheModule) {
  ASSERT_EQ(rtac({"build", "good.rta", "-o", "a/b/out"}).status, 0);
  for (const char* name : {"good.h", "good.cpp", "good_kernel.h", "good_kernel.c", "good_system.h",
                           "good_manifest.json"}) {
    EXPECT_FALSE(read(fs::path("a/b/out") / name).empty()) << name;
  }
  EXPECT_EQ(listing().size(), 3u + 6u);  // no temporary files
}

TEST_F(Outputs, AKindNamedLikeAKeywordHasOneNameInTheWholeModule) {
  std::string text = drone_spec();
  for (std::size_t at = 0; (at = text.find("Drone", at)) != std::string::npos; at += 4) {
    text.replace(at, 5, "main");
  }
  write("main.rta", text);
  ASSERT_EQ(rtac({"build", "main.rta", "-o", "out"}).status, 0);
  const std::string source = read("out/main.cpp");
  EXPECT_NE(source.find("rtac::RobotLimits limits_of_main_ ="), std::string::npos);
  EXPECT_EQ(std::regex_search(source, std::regex("limits_of_main\\b")), false);
}

TEST_F(Outputs, AFileNameThatNoIncludeCanSpellIsRefused) {
  for (const std::string name : {"a\"b.rta", "a\\b.rta", "a\nb.rta"}) {
    write(name, drone_spec());
    const Outcome o = rtac({"build", name, "-o", "out"});
    EXPECT_EQ(o.status, 2) << name;
    EXPECT_NE(o.err.find("error[9001]"), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("rename the specification"), std::string::npos) << o.err;
    EXPECT_FALSE(fs::exists("out"));
    EXPECT_EQ(rtac({"check", name}).status, 0);
  }
}

TEST_F(Outputs, AFaultySpecificationWritesNothing) {
  for (const std::string spec : {"faulty.rta", "late.rta"}) {
    const auto before = listing();
    EXPECT_EQ(rtac({"build", spec, "-o", "out", "--depfile", "out/d"}).status, 1);
    EXPECT_FALSE(fs::exists("out")) << spec;
    EXPECT_EQ(listing(), before);
  }
}

TEST_F(Outputs, AFaultySpecificationLeavesOldOutputsAsTheyAre) {
  ASSERT_EQ(rtac({"build", "good.rta", "-o", "out"}).status, 0);
  const std::string old = read("out/good_kernel.c");
  write("out/good.h", "// kept");
  const auto before = listing();
  write("good.rta", read("late.rta"));
  EXPECT_EQ(rtac({"build", "good.rta", "-o", "out"}).status, 1);
  EXPECT_EQ(read("out/good_kernel.c"), old);
  EXPECT_EQ(read("out/good.h"), "// kept");
  EXPECT_EQ(listing(), before);
}

TEST_F(Outputs, APlaceThatCannotBeWrittenIsToldAndLeftClean) {
  write("file", "text");
  fs::create_directories("taken/good_system.h");
  write("taken/good.h", "// old");
  const auto before = listing();
  for (const std::string place : {"file", "file/below", "taken", "/dev/full", "/proc/rtac_out"}) {
    const Outcome o = rtac({"build", "good.rta", "-o", place});
    EXPECT_EQ(o.status, 2) << place;
    EXPECT_NE(o.err.find("error[9003]"), std::string::npos) << o.err;
    EXPECT_NE(o.err.find(place), std::string::npos) << o.err;
  }
  EXPECT_EQ(listing(), before);
  EXPECT_EQ(read("taken/good.h"), "// old");
}

// What cannot be renamed back is written first.
TEST_F(Outputs, AFullDeviceBehindALinkLeavesNoOtherFile) {
  fs::create_directories("out");
  fs::create_symlink("/dev/full", "out/good.cpp");
  const auto before = listing();
  const Outcome o = rtac({"build", "good.rta", "-o", "out"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("cannot write `/dev/full`"), std::string::npos) << o.err;
  EXPECT_EQ(listing(), before);
}

// A generated `stdint.h` would be found by every `#include <stdint.h>` of its folder.
TEST_F(Outputs, AFileNameThatHidesAHeaderIsRefused) {
  for (const std::string stem : {"stdint", "math", "string", "stddef", "Signal", "unistd"}) {
    write(stem + ".rta", drone_spec());
    const Outcome o = rtac({"build", stem + ".rta", "-o", "out"});
    EXPECT_EQ(o.status, 2) << stem;
    EXPECT_NE(o.err.find("would hide the header `<"), std::string::npos) << o.err;
    EXPECT_FALSE(fs::exists("out"));
    EXPECT_EQ(rtac({"check", stem + ".rta"}).status, 0);
  }
}

TEST_F(Outputs, AHeaderOfTheRuntimeIsHiddenInAFolderOfItsNameOnly) {
  write("zone.rta", drone_spec());
  EXPECT_EQ(rtac({"build", "zone.rta", "-o", "out"}).status, 0);
  const Outcome o = rtac({"build", "zone.rta", "-o", "out/rtac/"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("would hide the header `\"rtac/zone.h\"`"), std::string::npos) << o.err;
}

TEST_F(Outputs, ADependencyFileThatCannotBeWrittenStopsTheWholeBuild) {
  const Outcome o = rtac({"build", "good.rta", "-o", "out", "--depfile", "good.rta/d"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("error[9003]"), std::string::npos) << o.err;
  for (const std::string& name : listing()) EXPECT_EQ(name.find("out/"), std::string::npos) << name;
}

TEST_F(Outputs, TheDependencyFileNamesEveryImportAndEscapesBlanks) {
  write("my parts/robot $1.rta", spec_text("tests/golden/parts/drone.rta"));
  std::string text = drone_spec();
  const std::string part = spec_text("tests/golden/parts/drone.rta");
  text.erase(text.find(part), part.size());
  write("main spec.rta", edited(text, "spec fence_study;\n",
                                "spec fence_study;\nimport \"my parts/robot $1.rta\";\n"));
  const Outcome o = rtac({"build", "main spec.rta", "-o", "out dir", "--depfile", "out dir/d"});
  ASSERT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(read("out dir/d"),
            "out\\ dir/main\\ spec_kernel.h: \\\n  main\\ spec.rta \\\n"
            "  my\\ parts/robot\\ $$1.rta\n");
}

struct Place {
  const char *folder, *language, *zone, *home;
};

// The binary would see these through the environment; in process they are set for real.
std::string built_in(const Place& place, const std::string& spec) {
  fs::create_directories(place.folder);
  const fs::path before = fs::current_path();
  fs::current_path(place.folder);
  setenv("LANG", place.language, 1);
  setenv("LC_ALL", place.language, 1);
  setenv("TZ", place.zone, 1);
  setenv("HOME", place.home, 1);
  std::setlocale(LC_ALL, "");
  const Outcome o = rtac({"build", spec, "-o", "out"});
  EXPECT_EQ(o.status, 0) << o.err;
  std::string all;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator("out")) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) all += file.filename().string() + "\n" + read(file);
  fs::current_path(before);
  std::setlocale(LC_ALL, "C");
  return all;
}

TEST_F(Outputs, AreTheSameBytesFromAnyFolderAndLanguageAndWithoutPathsOrDates) {
  const std::string spec =
      std::string(RTAC_SOURCE_DIR) + "/specs/robot_delivery/robot_delivery.rta";
  const std::string one = built_in({"one", "C", "UTC", "/"}, spec);
  const std::string two = built_in({"two/deeper", "de_DE.UTF-8", "Asia/Tokyo", "/nowhere"}, spec);
  EXPECT_EQ(one, two);
  for (const std::string& trace : {std::string(RTAC_SOURCE_DIR), folder_.string()}) {
    EXPECT_EQ(one.find(trace), std::string::npos) << trace;
  }
  const std::regex date("20[0-9][0-9]-[0-9][0-9]|[0-9][0-9]:[0-9][0-9]:[0-9][0-9]");
  std::smatch found;
  EXPECT_FALSE(std::regex_search(one, found, date)) << found.str();
}

TEST_F(Outputs, AreReplacedAsAWhole) {
  write("a", "old a");
  EXPECT_EQ(write_all({{"a", "new a"}, {"b", "new b"}}), "");
  EXPECT_EQ(read("a"), "new a");
  EXPECT_EQ(read("b"), "new b");
  fs::create_directories("d");
  EXPECT_NE(write_all({{"a", "newer a"}, {"d", "text"}}), "");
  EXPECT_EQ(read("a"), "new a");
}

}  // namespace
}  // namespace rtac::driver::test
