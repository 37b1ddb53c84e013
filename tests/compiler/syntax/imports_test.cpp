// Imports: relative to their file, each file once, importers after what they import.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "tests/compiler/syntax/syntax_test_util.h"

namespace rtac::syntax {
namespace {

class Imports : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    directory_ =
        std::filesystem::path{testing::TempDir()} / (std::string("rtac_imports_") + test->name());
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directories(directory_ / "lib");
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream{directory_ / name, std::ios::binary} << text;
  }
  void parse(const std::string& name) {
    std::string why;
    const auto root = sources_.load((directory_ / name).string(), why);
    ASSERT_TRUE(root) << why;
    program_ = parse_program(*root, sources_, engine_, dependencies_);
    diag::expect_help(engine_);
  }
  [[nodiscard]] std::vector<std::string> order() const {
    std::vector<std::string> result;
    for (const File& file : program_.files) result.push_back(relative(sources_.path(file.id)));
    return result;
  }
  [[nodiscard]] std::string relative(const std::string& path) const {
    return std::filesystem::path{path}.lexically_relative(directory_).string();
  }
  [[nodiscard]] std::string messages() const {
    std::string text = diag::render_text(engine_, sources_, false);
    const std::string prefix = directory_.string() + '/';
    for (std::size_t at = 0; (at = text.find(prefix)) != std::string::npos;) {
      text.erase(at, prefix.size());
    }
    return text;
  }

  std::filesystem::path directory_;
  SourceManager sources_;
  diag::Engine engine_;
  Program program_;
  std::vector<std::string> dependencies_;
};
class ImportCode : public Imports {};

TEST_F(Imports, ComeBeforeTheirImportersAndOnce) {
  // A diamond: both branches import `base.rta`, by two spellings of its path.
  write("root.rta", "spec r;\nimport \"lib/left.rta\";\nimport \"lib/right.rta\";\n");
  write("lib/left.rta", "import \"base.rta\";\n");
  write("lib/right.rta", "import \"../lib/./base.rta\";\n");
  write("lib/base.rta", "zone z = a;\n");
  parse("root.rta");
  EXPECT_EQ(messages(), "");
  EXPECT_EQ(order(), (std::vector<std::string>{"lib/base.rta", "lib/left.rta", "lib/right.rta",
                                               "root.rta"}));
  std::vector<std::string> read;
  for (const std::string& path : dependencies_) read.push_back(relative(path));
  EXPECT_EQ(read, (std::vector<std::string>{"root.rta", "lib/left.rta", "lib/base.rta",
                                            "lib/right.rta"}));
}

// Files of zones are read with the others, once each, from the folder of who names them.
TEST_F(Imports, OfZonesAreReadAndNamedAsDependencies) {
  write("root.rta",
        "spec r;\nimport \"lib/zones.rta\";\nzone a = import \"x.geojson\" feature \"a\";\n"
        "zone b =\n  import \"x.geojson\" feature \"b\" | import \"./x.geojson\";\n");
  write("lib/zones.rta", "zone c = import \"../x.geojson\" - import \"y.wkt\" in m;\n");
  write("x.geojson", "{}");
  write("lib/y.wkt", "POLYGON EMPTY");
  parse("root.rta");
  EXPECT_EQ(messages(), "");
  std::vector<std::string> read;
  for (const std::string& path : dependencies_) read.push_back(relative(path));
  EXPECT_EQ(read,
            (std::vector<std::string>{"root.rta", "lib/zones.rta", "x.geojson", "lib/y.wkt"}));
  std::set<const std::string*> texts;
  for (const ZoneFile& file : program_.zone_files) texts.insert(file.text.get());
  EXPECT_EQ(program_.zone_files.size(), 4U);
  EXPECT_EQ(texts.size(), 2U);
}

TEST_F(Imports, OfZonesThatCannotBeReadAreReportedAtThePath) {
  write("root.rta", "spec r;\nzone a = import \"no/such.geojson\";\nzone b = import \"lib\";\n");
  parse("root.rta");
  EXPECT_EQ(messages(), R"(error[1019]: cannot read the imported file `no/such.geojson`
 --> root.rta:2:17
  |
2 | zone a = import "no/such.geojson";
  |                 ^^^^^^^^^^^^^^^^^ No such file or directory
  |
help: the path is relative to the directory of the importing file

error[1019]: cannot read the imported file `lib`
 --> root.rta:3:17
  |
3 | zone b = import "lib";
  |                 ^^^^^ Is a directory
  |
help: the path is relative to the directory of the importing file

2 errors
)");
}

// Nobody writes to the pipe: opening it would never end.
TEST_F(Imports, OfPipesAreRefused) {
  ASSERT_EQ(mkfifo((directory_ / "pipe").c_str(), 0600), 0);
  write("root.rta", "spec r;\nimport \"pipe\";\nzone a = import \"pipe\";\n");
  parse("root.rta");
  EXPECT_EQ(engine_.error_count(), 2);
  EXPECT_NE(messages().find("it is a pipe or a device, not a stored file"), std::string::npos);
}

TEST_F(Imports, ReportMistakesOfAllFiles) {
  write("root.rta", "spec r;\nimport \"a.rta\";\nzone b = ;\n");
  write("a.rta", "zone c = ;\n");
  parse("root.rta");
  EXPECT_EQ(engine_.error_count(), 2);
}

TEST_F(Imports, HaveNoSpecLine) {
  write("root.rta", "spec r;\nimport \"a.rta\";\n");
  write("a.rta", "spec a;\n");
  parse("root.rta");
  EXPECT_EQ(messages(), R"(error[1018]: an imported file has no `spec` line
 --> a.rta:1:6
  |
1 | spec a;
  |      ^ only the root file is a specification
  |
help: one line `spec NAME;` at the start of the file given to `rtac` works

1 error
)");
}

TEST_F(Imports, RootNeedsASpecLine) {
  write("root.rta", "zone a = b;\n");
  parse("root.rta");
  EXPECT_EQ(messages(), R"(error[1017]: the specification has no name
 --> root.rta:1:1
  |
1 | zone a = b;
  | ^ expected `spec NAME;` here
  |
help: insert `spec my_spec;`

1 error
)");
}

TEST_F(ImportCode, import_not_found) {
  write("root.rta", "spec r;\nimport \"lib/nope.rta\";\n");
  parse("root.rta");
  EXPECT_EQ(messages(), R"(error[1019]: cannot read the imported file `lib/nope.rta`
 --> root.rta:2:8
  |
2 | import "lib/nope.rta";
  |        ^^^^^^^^^^^^^^ No such file or directory
  |
help: the path is relative to the directory of the importing file

1 error
)");
}

TEST_F(ImportCode, import_cycle) {
  write("root.rta", "spec r;\nimport \"a.rta\";\n");
  write("a.rta", "import \"b.rta\";\n");
  write("b.rta", "import \"a.rta\";\n");
  parse("root.rta");
  EXPECT_EQ(messages(), R"(error[1020]: files import each other in a circle
 --> b.rta:1:8
  |
1 | import "a.rta";
  |        ^^^^^^^ this file is still being read
  |
note: `a.rta` imports `b.rta`, which imports `a.rta`
help: move what both need into a third file

1 error
)");
  EXPECT_EQ(order(), (std::vector<std::string>{"b.rta", "a.rta", "root.rta"}));
}

}  // namespace
}  // namespace rtac::syntax
