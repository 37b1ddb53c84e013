#include <algorithm>

#include "compiler/diagnostics/characters.h"
#include "compiler/diagnostics/excerpt.h"
#include "compiler/diagnostics/render.h"

namespace rtac::diag {
namespace {

constexpr const char* kBold = "\x1b[1m";
constexpr const char* kRed = "\x1b[1;31m";
constexpr const char* kYellow = "\x1b[1;33m";
constexpr const char* kBlue = "\x1b[1;34m";
constexpr const char* kGreen = "\x1b[1;32m";
constexpr const char* kCyan = "\x1b[1;36m";
constexpr const char* kReset = "\x1b[0m";

std::string trim_right(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

// An insertion brings the blanks around it; a reader does not need them.
std::string trim_blanks(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n");
  if (begin == std::string::npos) return text;
  return text.substr(begin, text.find_last_not_of(" \n") - begin + 1);
}

// "write `10 m`" and "did you mean `cm`?" show what their fix-its ` m` and `cm` give.
bool is_shown(const std::string& help, const FixIt& fixit) {
  if (fixit.replacement.empty()) return false;
  // whole lines cannot be shown within one
  if (trim_blanks(fixit.replacement).find('\n') != std::string::npos) return !help.empty();
  const bool is_operator = fixit.replacement.find_first_not_of("<>=!") == std::string::npos;
  return help.find(fixit.replacement + (is_operator ? "" : "`")) != std::string::npos;
}

class TextRenderer {
 public:
  TextRenderer(const SourceManager& sources, bool colour) : sources_(sources), colour_(colour) {}

  void add(const Diagnostic& diagnostic) {
    if (!out_.empty()) out_ += '\n';
    add_headline(diagnostic);
    indent_ = 2;
    const bool has_tail =
        !diagnostic.notes.empty() || !diagnostic.help.empty() || !diagnostic.fixits.empty();
    if (diagnostic.range) add_snippet(*diagnostic.range, diagnostic, has_tail);
    for (const Note& note : diagnostic.notes) add_note(note);
    if (!diagnostic.help.empty()) add_help(diagnostic.help);
    for (const FixIt& fixit : diagnostic.fixits) {
      if (!is_shown(diagnostic.help, fixit)) add_help(describe(fixit));
    }
  }

  void add_counts(const Engine& engine) {
    std::string counts;
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
      const auto number = std::count_if(
          engine.all().begin(), engine.all().end(),
          [&](const Diagnostic& each) { return info(each.code).severity == severity; });
      if (number == 0) continue;
      if (!counts.empty()) counts += ", ";
      counts += count(static_cast<std::size_t>(number), name(severity));
    }
    out_ += '\n' + counts + '\n';
  }

  std::string take() { return std::move(out_); }

 private:
  static std::string count(std::size_t number, const char* what) {
    return std::to_string(number) + ' ' + what + (number == 1 ? "" : "s");
  }

  [[nodiscard]] std::string paint(const char* style, const std::string& text) const {
    return colour_ ? style + text + kReset : text;
  }

  static const char* severity_colour(const Diagnostic& diagnostic) {
    const Severity severity = info(diagnostic.code).severity;
    return severity == Severity::error ? kRed : severity == Severity::warning ? kYellow : kCyan;
  }

  void add_headline(const Diagnostic& diagnostic) {
    const std::string number = std::to_string(static_cast<int>(diagnostic.code));
    const std::string kind = name(info(diagnostic.code).severity) + ('[' + number + ']');
    out_ += paint(severity_colour(diagnostic), kind) +
            paint(kBold, ": " + printable(diagnostic.message));
    out_ += '\n';
  }

  void add_place(const SourceRange& range) {
    const LineColumn place = sources_.position(range.file, range.begin);
    out_ += std::string(indent_, ' ') + paint(kBlue, "-->") + ' ' +
            printable(sources_.path(range.file)) + ':' + std::to_string(place.line) + ':' +
            std::to_string(place.column) + '\n';
  }

  void add_snippet(const SourceRange& range, const Diagnostic& diagnostic, bool has_tail) {
    const Excerpt excerpt = make_excerpt(range, sources_);
    const std::string number = std::to_string(sources_.position(range.file, range.begin).line);
    indent_ = number.size();
    const std::string gutter = std::string(indent_ + 1, ' ') + '|';
    std::string marks(excerpt.carets, '^');
    if (!diagnostic.label.empty()) marks += ' ' + printable(diagnostic.label);
    add_place(range);
    out_ += paint(kBlue, gutter) + '\n';
    out_ += paint(kBlue, number + " |") + trim_right(' ' + excerpt.line) + '\n';
    out_ += paint(kBlue, gutter) + std::string(excerpt.column + 1, ' ') +
            paint(severity_colour(diagnostic), marks) + '\n';
    if (has_tail) out_ += paint(kBlue, gutter) + '\n';
  }

  void add_note(const Note& note) {
    out_ += paint(kCyan, "note") + ": " + printable(note.text) + '\n';
    if (note.range) add_place(*note.range);
  }

  void add_help(const std::string& text) {
    out_ += paint(kGreen, "help") + ": " + printable(text) + '\n';
  }

  [[nodiscard]] std::string describe(const FixIt& fixit) const {
    if (fixit.replacement.empty()) {
      return "remove `" + trim_blanks(std::string{sources_.text(fixit.range)}) + '`';
    }
    const bool inserts = fixit.range.begin == fixit.range.end;
    return (inserts ? "insert `" : "write `") + trim_blanks(fixit.replacement) + '`';
  }

  const SourceManager& sources_;
  bool colour_;
  std::string out_;
  std::size_t indent_ = 2;  // of `-->`: as wide as the line number above it
};

}  // namespace

std::string render_text(const Engine& engine, const SourceManager& sources, bool colour) {
  if (engine.all().empty()) return {};
  TextRenderer renderer{sources, colour};
  for (const Diagnostic& diagnostic : engine.all()) renderer.add(diagnostic);
  renderer.add_counts(engine);
  return renderer.take();
}

}  // namespace rtac::diag
