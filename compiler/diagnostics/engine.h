// Diagnostics: collected here, rendered elsewhere (render.h). Wording rules: lower case, no full
// stop, back-ticks around source text; the message says what is, the help says what would work.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "compiler/support/source.h"

namespace rtac::diag {

// One enumerator per line of the .def tables; the value is the public number (E1001 -> 1001).
enum class Code : int {
#define RTAC_DIAGNOSTIC(number, name, severity, title) name = number,
#include "compiler/diagnostics/codes.def"
#undef RTAC_DIAGNOSTIC
};

enum class Severity { error, warning, note };
// "error", "warning", "note"
const char* name(Severity severity);

struct CodeInfo {
  Code code;
  const char* name;   // "unknown_unit"
  Severity severity;  // default severity
  const char* title;  // one line for listings
};
const std::vector<CodeInfo>& all_codes();
const CodeInfo& info(Code code);

struct Note {
  std::optional<SourceRange> range;
  std::string text;
};

struct FixIt {
  SourceRange range;  // empty range = insertion
  std::string replacement;
};

struct Diagnostic {
  Code code;
  std::optional<SourceRange> range;  // none: about the command line or the environment
  std::string message;
  std::string label;  // shown behind the caret
  std::vector<Note> notes;
  std::string help;
  std::vector<FixIt> fixits;
  // Of a monitor that the range does not lie in, and of another one's recovery that breaks it.
  std::string monitor{}, recovery{};
};

class Engine {
 public:
  // Reports are kept in order; the same code at the same range is kept once.
  void report(Diagnostic diagnostic);
  // To the last report with that code, when there is one.
  void add_note(Code code, std::string text);
  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] int error_count() const { return errors_; }
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }

 private:
  // Code, place if there is one, else the message.
  using Identity = std::tuple<Code, bool, FileId, std::uint32_t, std::uint32_t, std::string>;
  std::vector<Diagnostic> all_;
  std::set<Identity> known_;
  int errors_ = 0;
};

}  // namespace rtac::diag
