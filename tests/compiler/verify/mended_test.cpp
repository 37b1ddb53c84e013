// Each specification that is refuted, with the change that its lines `// mended: FROM => TO` name:
// everything is proved or acknowledged. The certificates of that, put under the specification as it
// was and sealed anew, are denied.
#include <string>
#include <utility>
#include <vector>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

struct Page {
  std::string broken, mended;
};
// Both without the lines that say how; each place is changed once.
Page page_of(const std::string& text) {
  const std::string mark = "// mended: ", arrow = " => ";
  std::vector<std::pair<std::string, std::string>> changes;
  Page page;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(arrow);
    if (!line.starts_with(mark)) {
      page.broken += line + "\n";
    } else if (at == std::string::npos) {
      ADD_FAILURE() << "no `=>`: " << line;
    } else {
      changes.emplace_back(line.substr(mark.size(), at - mark.size()),
                           line.substr(at + arrow.size()));
    }
  }
  EXPECT_FALSE(changes.empty()) << "no line begins with `" << mark << "`";
  page.mended = page.broken;
  for (const auto& [from, to] : changes) page.mended = edited(page.mended, from, to);
  return page;
}

class Mended : public Verify, public ::testing::WithParamInterface<std::string> {};

TEST_P(Mended, IsProvedAndSaysNothingOfWhatItWas) {
  for (const char* shared : {"battery.rta", "parts.rta", "space_parts.rta"}) {
    write(shared, read(refuted_folder() + shared));
  }
  const Page page = page_of(read(refuted_folder() + GetParam() + ".rta"));
  const Outcome o = verified(page.mended, {"-o", "certificates"});
  ASSERT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  write("certificates/sources/spec.rta", page.broken);
  const Outcome denied = recheck_sealed_anew();
  EXPECT_EQ(denied.status, exit_violation) << denied.out << denied.err;
}

INSTANTIATE_TEST_SUITE_P(Specs, Mended, ::testing::ValuesIn(refuted_names()),
                         [](const auto& spec) { return spec.param; });

}  // namespace
}  // namespace rtac::driver::test
