#include "compiler/syntax/format.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/syntax/format_entries.h"
#include "compiler/syntax/lexer.h"
#include "compiler/syntax/parse.h"

namespace rtac::syntax {
namespace {

class Writer {
 public:
  explicit Writer(const std::vector<Piece>& pieces) : pieces_(pieces), widths_(pieces) {}

  std::string run() {
    add(entries_of(pieces_), Level::file, 0);
    const Piece& end = pieces_.back();
    add_trailing(lines_, end.before);
    add_own_lines(lines_, end.before, 0);
    align_comments();
    return join();
  }

 private:
  void add(const std::vector<Entry>& entries, Level level, std::size_t indent) {
    const std::vector<StatementLayout> layouts =
        layouts_of(pieces_, widths_, entries, level, indent);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Piece& first = pieces_[entries[i].begin];
      add_trailing(lines_, first.before);
      add_own_lines(lines_, first.before, indent);
      const std::size_t line = lines_.size();
      const bool on_one_line = entries[i].is_block && add_inline(entries[i], layouts[i], level);
      if (!on_one_line) {
        append(layouts[i]);
        if (entries[i].is_block) add_block(entries[i], indent);
      }
      // a comment that ends its line was taken with the statement before
      lines_[line].blank_before = entries[i].blank_before && first.first_on_line;
    }
  }

  void append(const StatementLayout& layout) {
    for (Line& line : lines_of(pieces_, widths_, layout)) lines_.push_back(std::move(line));
  }

  // Bounds stay on one line however long it is: they are read as one.
  bool add_inline(const Entry& entry, StatementLayout layout, Level level) {
    if (!is_inline(pieces_, entry)) return false;
    layout.end = entry.close + 1;
    layout.begin_of_body = layout.end;
    std::vector<Line> lines = lines_of(pieces_, widths_, layout);
    const bool fits =
        lines.size() == 1 && lines.front().indent + width_of(lines.front().code) <= kLineWidthMax;
    if (!fits && level != Level::robot) return false;
    for (Line& line : lines) lines_.push_back(std::move(line));
    return true;
  }

  void add_block(const Entry& entry, std::size_t indent) {
    const std::size_t first = lines_.size();
    add(entry.children, level_in(pieces_, entry), indent + kIndent);
    const Piece& close = pieces_[entry.close];
    add_trailing(lines_, close.before);
    add_own_lines(lines_, close.before, indent + kIndent);
    if (lines_.size() > first) lines_[first].blank_before = false;
    Line line;
    line.indent = indent;
    line.code = text_of(close);
    lines_.push_back(std::move(line));
  }

  // Comments behind neighbouring lines stay under each other where the author put them so.
  void align_comments() {
    for (std::size_t begin = 0; begin < lines_.size();) {
      std::size_t end = begin + 1;
      while (end < lines_.size() && continues_column(end)) ++end;
      std::size_t widest = 0;
      for (std::size_t i = begin; i < end; ++i) widest = std::max(widest, width(lines_[i]));
      for (std::size_t i = begin; i < end && !lines_[i].comment.empty(); ++i) {
        lines_[i].code.append(widest - width(lines_[i]) + kIndent, ' ');
        lines_[i].code += lines_[i].comment;
      }
      begin = end;
    }
  }
  [[nodiscard]] bool continues_column(std::size_t line) const {
    const Line& before = lines_[line - 1];
    const Line& here = lines_[line];
    return !before.comment.empty() && !here.comment.empty() && !here.blank_before &&
           here.code.find('\n') == std::string::npos &&
           before.comment_column == here.comment_column;
  }
  // Of what stands on the line of the comment: code may hold comments of several lines.
  static std::size_t width(const Line& line) {
    const std::size_t line_end = line.code.rfind('\n');
    return line_end == std::string::npos ? line.indent + width_of(line.code)
                                         : width_of(line.code.substr(line_end + 1));
  }

  std::string join() {
    std::string result;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (i > 0 && lines_[i].blank_before) result += '\n';
      result += std::string(lines_[i].indent, ' ') + lines_[i].code + '\n';
    }
    return result;
  }

  const std::vector<Piece>& pieces_;
  const PieceWidths widths_;
  std::vector<Line> lines_;
};

bool is_same_token(const Token& a, std::string_view text_a, const Token& b,
                   std::string_view text_b) {
  return a.kind == b.kind && text_a.substr(a.range.begin, a.range.end - a.range.begin) ==
                                 text_b.substr(b.range.begin, b.range.end - b.range.begin);
}

// Does the text still say the same? Blanks alone can change that: a unit is one only on the line
// of its number.
bool says_the_same(const std::vector<Token>& tokens, std::string_view text,
                   const std::string& formatted) {
  SourceManager sources;
  diag::Engine ignored;
  const FileId file = sources.add("formatted", formatted);
  const std::vector<Token> after = tokenize(file, sources, ignored);
  return std::equal(
      tokens.begin(), tokens.end(), after.begin(), after.end(),
      [&](const Token& a, const Token& b) { return is_same_token(a, text, b, formatted); });
}

}  // namespace

std::optional<std::string> format(FileId file, const SourceManager& sources,
                                  diag::Engine& diagnostics) {
  const int errors_before = diagnostics.error_count();
  parse_file(file, sources, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  const std::vector<Token> tokens = tokenize(file, sources, diagnostics);
  const std::string_view text = sources.text(file);
  std::string result = Writer{pieces_of(text, tokens)}.run();
  if (!says_the_same(tokens, text, result)) return std::string{text};
  return result;
}

}  // namespace rtac::syntax
