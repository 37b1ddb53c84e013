// From the text of a specification to derived numbers and diagnostics.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "compiler/analysis/derive.h"
#include "compiler/driver/compile.h"
#include "tests/compiler/driver/testing.h"

namespace rtac::analysis::test {

using driver::test::drone_spec;
using driver::test::edited;
using driver::test::spec_text;

// Compiles a text; a folder of the test holds it.
inline std::unique_ptr<driver::Compilation> compiled(const std::string& text, bool offers = true) {
  const auto path = driver::test::fs::temp_directory_path() /
                    ("rtac_analysis_" + std::to_string(getpid()) + ".rta");
  driver::test::write(path, text);
  driver::Options options;
  options.spec = path.string();
  options.offers = offers;
  std::ostringstream out;
  auto c = std::make_unique<driver::Compilation>();
  driver::compile(options, out, *c);
  driver::test::fs::remove(path);
  EXPECT_EQ(c->internal_error, "");
  return c;
}

// Where errors are asked for, and not the numbers with which it would work.
inline std::unique_ptr<driver::Compilation> without_offers(const std::string& text) {
  return compiled(text, false);
}

inline std::string reports(const driver::Compilation& c) {
  std::string all;
  for (const auto& d : c.diagnostics.all()) {
    all += std::to_string(static_cast<int>(d.code)) + " " + d.message + " [" + d.label + "] (" +
           d.help + ")\n";
  }
  return all;
}
inline bool has(const driver::Compilation& c, diag::Code code) {
  for (const auto& d : c.diagnostics.all()) {
    if (d.code == code) return true;
  }
  return false;
}

// The number before `unit` that follows `before` in the help of the first report of `code`.
inline std::string number_in_help(const driver::Compilation& c, diag::Code code,
                                  const std::string& before, const std::string& unit) {
  for (const auto& d : c.diagnostics.all()) {
    if (d.code != code) continue;
    const std::size_t from = d.help.find(before);
    const std::size_t to = d.help.find(" " + unit, from);
    if (from == std::string::npos || to == std::string::npos) break;
    const std::size_t begin = from + before.size();
    return d.help.substr(begin, to - begin);
  }
  ADD_FAILURE() << "no number between `" << before << "` and `" << unit << "` in\n" << reports(c);
  return "0";
}

// A rover with a dock.
inline std::string rover_spec() {
  return spec_text("tests/golden/bad_4008_site_outside/spec.rta");
}

}  // namespace rtac::analysis::test
