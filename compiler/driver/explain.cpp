#include "compiler/driver/explain.h"

#include <algorithm>
#include <optional>
#include <ostream>
#include <vector>

#include "compiler/driver/driver.h"
#include "compiler/sema/suggest.h"

namespace rtac::driver {
namespace {

std::string number_of(const diag::CodeInfo& info) {
  return std::to_string(static_cast<int>(info.code));
}

// "3001", "E3001", "error[3001]" and "unknown_unit" are what people have at hand.
const diag::CodeInfo* find(const std::string& topic) {
  const auto& all = diag::all_codes();
  const auto named = std::find_if(all.begin(), all.end(),
                                  [&](const diag::CodeInfo& info) { return topic == info.name; });
  if (named != all.end()) return &*named;
  std::string digits = topic;
  for (const std::string prefix : {"error", "warning", "note", "[", "E", "e"}) {
    if (digits.rfind(prefix, 0) == 0) digits.erase(0, prefix.size());
  }
  if (!digits.empty() && digits.back() == ']') digits.pop_back();
  const auto numbered = std::find_if(all.begin(), all.end(), [&](const diag::CodeInfo& info) {
    return digits == number_of(info);
  });
  return numbered == all.end() ? nullptr : &*numbered;
}

std::string suggestion(const std::string& topic) {
  std::vector<std::string> names;
  for (const diag::CodeInfo& info : diag::all_codes()) {
    names.emplace_back(info.name);
    names.push_back(number_of(info));
  }
  const auto near = sema::nearest(topic, names);
  return near ? "did you mean `" + *near + "`?"
              : "the number stands in brackets behind `error`, such as `error[3001]`";
}

}  // namespace

std::string page_about(diag::Code code) {
  const auto page = pages().find(std::to_string(static_cast<int>(code)));
  return page == pages().end() ? "" : page->second;
}

int explain(const Options& options, diag::Engine& diagnostics, std::ostream& out) {
  const diag::CodeInfo* const info = find(options.topic);
  if (info == nullptr) {
    diagnostics.report({diag::Code::usage,
                        std::nullopt,
                        "no diagnostic is called `" + options.topic + "`",
                        "",
                        {},
                        suggestion(options.topic),
                        {}});
    return exit_usage;
  }
  if (const std::string page = page_about(info->code); !page.empty()) {
    out << page;
    return exit_clean;
  }
  diagnostics.report(
      {diag::Code::no_page,
       std::nullopt,
       "no page about " + number_of(*info) + " (" + info->name + ") is built into this program",
       "",
       {},
       std::string("it says: ") + info->title,
       {}});
  return exit_usage;
}

}  // namespace rtac::driver
