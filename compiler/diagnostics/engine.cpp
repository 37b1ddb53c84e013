#include "compiler/diagnostics/engine.h"

#include <algorithm>
#include <utility>

namespace rtac::diag {

const std::vector<CodeInfo>& all_codes() {
  static const std::vector<CodeInfo> codes{
#define RTAC_DIAGNOSTIC(number, name, severity, title) \
  {Code::name, #name, Severity::severity, title},
#include "compiler/diagnostics/codes.def"
#undef RTAC_DIAGNOSTIC
  };
  return codes;
}

const char* name(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::note:
      break;
  }
  return "note";
}

const CodeInfo& info(Code code) {
  const auto& codes = all_codes();
  return *std::find_if(codes.begin(), codes.end(),
                       [code](const CodeInfo& entry) { return entry.code == code; });
}

void Engine::report(Diagnostic diagnostic) {
  // Without a range two reports are the same only when they say the same: two missing files are two
  // mistakes.
  const SourceRange at = diagnostic.range.value_or(SourceRange{});
  const bool is_new = known_
                          .emplace(diagnostic.code, diagnostic.range.has_value(), at.file, at.begin,
                                   at.end, diagnostic.range ? std::string{} : diagnostic.message)
                          .second;
  if (!is_new) return;
  if (info(diagnostic.code).severity == Severity::error) ++errors_;
  all_.push_back(std::move(diagnostic));
}

void Engine::add_note(Code code, std::string text) {
  const auto last = std::find_if(all_.rbegin(), all_.rend(),
                                 [code](const Diagnostic& d) { return d.code == code; });
  if (last != all_.rend()) last->notes.push_back({std::nullopt, std::move(text)});
}

}  // namespace rtac::diag
