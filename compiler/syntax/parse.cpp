#include "compiler/syntax/parse.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "compiler/syntax/builder.h"
#include "compiler/syntax/decimal_comma.h"
#include "compiler/syntax/lexer.h"
#include "compiler/syntax/lookalike.h"
#include "compiler/syntax/repair.h"

namespace rtac::syntax {
namespace {

using diag::Code;

constexpr std::size_t kPathBytesMax = 4096;  // paths in messages are not cut

bool is_first_in_column(const Token& token, const SourceManager& sources) {
  const std::size_t begin = token.range.begin;
  return begin == 0 || sources.text(token.range.file)[begin - 1] == '\n';
}

bool expects_operand(TokenKind before) {
  return before == T::ASSIGN || before == T::PIPE || before == T::AMPERSAND || before == T::MINUS ||
         before == T::LEFT_PAREN || before == T::COMMA || before == T::INSIDE;
}

// Most words that start items are reserved: one at the start of a line starts an item whatever is
// still open. So a missing `}` costs no more than its own item. The others may be names and words
// of clauses too: they start an item behind a whole one, outside of braces, where no blank is in
// front of them; an indented one may be a clause of an item that ended too early by a mistake.
bool starts_stretch(const std::vector<Token>& tokens, std::size_t index, int brace_depth,
                    const SourceManager& sources) {
  const Word* word = find_word(tokens[index].kind);
  if (index == 0 || !tokens[index].first_on_line || !word) return false;
  const TokenKind before = tokens[index - 1].kind;
  // a zone of a file: `zone z =` on the line above; a type: `input fence :` there
  const bool within = (word->kind == T::IMPORT && expects_operand(before)) ||
                      (word->kind == T::ZONE && before == T::COLON && index + 1 < tokens.size() &&
                       tokens[index + 1].kind == T::LEFT_BRACKET);
  if (word->word_kind == WordKind::item) return !within;
  return word->word_kind == WordKind::soft && brace_depth == 0 &&
         (before == T::SEMICOLON || before == T::RIGHT_BRACE) &&
         is_first_in_column(tokens[index], sources);
}

// Is the last `}` that of the first `{`?
bool spec_is_closed(const std::vector<Token>& tokens) {
  int depth = 0;
  for (std::size_t i = 2; i + 2 < tokens.size(); ++i) {
    if (tokens[i].kind == T::LEFT_BRACE) ++depth;
    if (tokens[i].kind == T::RIGHT_BRACE && --depth == 0) return false;
  }
  return depth == 1;
}

// `spec a { ... }`: a specification is a whole file.
void mend_spec_braces(std::vector<Token>& tokens, diag::Engine& diagnostics) {
  const bool has_braces = tokens.size() > 4 && tokens[0].kind == T::SPEC &&
                          tokens[1].kind == T::IDENT && tokens[2].kind == T::LEFT_BRACE &&
                          tokens[tokens.size() - 2].kind == T::RIGHT_BRACE &&
                          spec_is_closed(tokens);
  if (!has_braces) return;
  const auto close = tokens.end() - 2;
  const SourceRange before{tokens[2].range.file, tokens[1].range.end, tokens[2].range.end};
  diagnostics.report({Code::unexpected_token,
                      tokens[2].range,
                      "a specification has no braces around its items",
                      "expected `;`",
                      {},
                      {},
                      {{before, ";"}, {close->range, ""}}});
  tokens[2].kind = T::SEMICOLON;
  tokens.erase(close);
}

// Each stretch ends with an END at the place of what follows it.
std::vector<std::vector<Token>> split_items(const std::vector<Token>& tokens,
                                            const SourceManager& sources) {
  std::vector<std::vector<Token>> stretches(1);
  int brace_depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (starts_stretch(tokens, i, brace_depth, sources)) {
      stretches.back().push_back({T::END, tokens[i].range});
      stretches.emplace_back();
      brace_depth = 0;
    }
    if (tokens[i].kind == T::LEFT_BRACE) ++brace_depth;
    if (tokens[i].kind == T::RIGHT_BRACE && brace_depth > 0) --brace_depth;
    stretches.back().push_back(tokens[i]);
  }
  return stretches;
}

void report_spec_place(const Name& name, std::string message, std::string label,
                       diag::Engine& diagnostics) {
  diagnostics.report({Code::spec_misplaced,
                      name.range,
                      std::move(message),
                      std::move(label),
                      {},
                      "one line `spec NAME;` at the start of the file given to `rtac` works",
                      {}});
}

void add_attempt(Attempt attempt, File& file, diag::Engine& diagnostics) {
  for (Name& name : attempt.specs) {
    if (file.spec) {
      report_spec_place(name, "a file has one `spec` line", "a second name", diagnostics);
    } else if (!file.items.empty()) {
      report_spec_place(name, "the `spec` line stands behind an item",
                        "move it to the start of the file", diagnostics);
    }
    if (!file.spec) file.spec = std::move(name);
  }
  for (Item& item : attempt.items) file.items.push_back(std::move(item));
  append(file.zone_files, std::move(attempt.zone_files));
  file.loss.names.merge(attempt.loss.names);
  file.loss.items = file.loss.items || attempt.loss.items;
  file.loss.rest = file.loss.rest || attempt.loss.rest;
}

bool touches(const SourceRange& item, const SourceRange& place) {
  return place.begin <= item.end && place.end >= item.begin;
}

// What is written for another sign or word is as good as right, and a `;` has one place. What else
// is missing or too much may have its place elsewhere, and what has another help is mended by a
// guess.
bool is_surely_mended(const diag::Diagnostic& mistake) {
  const bool is_guess =
      mistake.code == Code::unexpected_token || mistake.code == Code::unclosed_bracket;
  return !is_guess && !mistake.fixits.empty() && mistake.help.empty();
}

void mark_damage(const diag::Engine& found, const std::vector<SourceRange>& silent_edits,
                 File& file) {
  std::vector<SourceRange> places = silent_edits;
  for (const diag::Diagnostic& each : found.all()) {
    if (each.range && !is_surely_mended(each)) places.push_back(*each.range);
    file.loss.rest = file.loss.rest || each.code == Code::nesting_too_deep ||
                     each.code == Code::unterminated_comment || each.code == Code::file_not_text ||
                     each.code == Code::hidden_character;
  }
  file.loss.rest = file.loss.rest || found.error_count() > kErrorsMax;
  for (Item& item : file.items) {
    item.damaged = std::any_of(places.begin(), places.end(), [&](const SourceRange& place) {
      return touches(item.range, place);
    });
  }
}

// In the order of the text, and no more than a reader would work through.
void forward(const diag::Engine& found, FileId file, diag::Engine& diagnostics) {
  std::vector<const diag::Diagnostic*> ordered;
  for (const diag::Diagnostic& diagnostic : found.all()) ordered.push_back(&diagnostic);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto* a, const auto* b) { return a->range->begin < b->range->begin; });
  const bool too_many = ordered.size() > static_cast<std::size_t>(kErrorsMax);
  if (too_many) ordered.resize(kErrorsMax);
  for (const diag::Diagnostic* diagnostic : ordered) diagnostics.report(*diagnostic);
  if (!too_many) return;
  const SourceRange last = *ordered.back()->range;
  diagnostics.report({Code::too_many_errors,
                      SourceRange{file, last.begin, last.end},
                      "more than " + std::to_string(kErrorsMax) + " syntax errors in one file",
                      "the rest of the file is not reported",
                      {},
                      "mend the first ones, which may be the cause of others, and run again",
                      {}});
}

class ProgramParser {
 public:
  ProgramParser(SourceManager& sources, diag::Engine& diagnostics,
                std::vector<std::string>& dependencies)
      : sources_(sources), diagnostics_(diagnostics), dependencies_(dependencies) {}

  Program run(FileId root) {
    known_.insert(identity(sources_.path(root)));
    dependencies_.push_back(sources_.path(root));
    visit(root, nullptr);
    return std::move(program_);
  }

 private:
  struct Opened {
    std::string identity;
    std::string path;
  };

  // Two paths of one file are one identity.
  static std::string identity(const std::string& path) {
    std::error_code failed;
    const auto canonical = std::filesystem::weakly_canonical(path, failed);
    return failed ? path : canonical.string();
  }

  void visit(FileId id, const Text* import) {
    open_.push_back({identity(sources_.path(id)), sources_.path(id)});
    const int errors_before = diagnostics_.error_count();
    File file = parse_file(id, sources_, diagnostics_);
    check_spec(file, import, diagnostics_.error_count() > errors_before);
    for (const Item& item : file.items) {
      if (const auto* node = std::get_if<ImportItem>(&item.node)) follow(node->path, id);
    }
    for (const Text& written : file.zone_files) read_zones(written, id);
    program_.files.push_back(std::move(file));
    open_.pop_back();
  }

  void check_spec(const File& file, const Text* import, bool has_errors) {
    if (import && file.spec) {
      report_spec_place(*file.spec, "an imported file has no `spec` line",
                        "only the root file is a specification", diagnostics_);
    }
    if (import || file.spec || has_errors) return;
    diagnostics_.report({Code::missing_spec_name,
                         SourceRange{file.id, 0, 0},
                         "the specification has no name",
                         "expected `spec NAME;` here",
                         {},
                         {},
                         {{SourceRange{file.id, 0, 0}, "spec my_spec;\n"}}});
  }

  [[nodiscard]] std::string path_from(FileId importer, const std::string& written) const {
    const std::filesystem::path base = std::filesystem::path{sources_.path(importer)}.parent_path();
    return (base / written).lexically_normal().string();
  }

  // A pipe that nobody writes to would be waited for without end, and none can be read again.
  static bool is_stored(const std::string& path, std::string& why) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status) ||
        std::filesystem::is_directory(status)) {
      return true;  // what is not there, or not to be read, is told by reading it
    }
    why = "it is a pipe or a device, not a stored file";
    return false;
  }

  // A file is read once, however many zones are taken from it.
  void read_zones(const Text& import, FileId importer) {
    if (import.range.begin == import.range.end) return;  // it is missing, and was reported
    const std::string path = path_from(importer, import.text);
    std::shared_ptr<const std::string> text;
    for (const ZoneFile& known : program_.zone_files) {
      if (known.importer == importer && known.written == import.text) return;
      if (known.path == path) text = known.text;
    }
    if (!text) {
      std::string why;
      std::optional<std::string> read = is_stored(path, why) ? read_file(path, why) : std::nullopt;
      if (!read) {
        report_unreadable(import, path, why);
        return;
      }
      if (std::find(dependencies_.begin(), dependencies_.end(), path) == dependencies_.end()) {
        dependencies_.push_back(path);
      }
      text = std::make_shared<const std::string>(std::move(*read));
    }
    program_.zone_files.push_back({importer, import.text, path, std::move(text)});
  }

  void report_unreadable(const Text& import, const std::string& path, const std::string& why) {
    std::error_code error;
    const bool is_there = std::filesystem::is_regular_file(path, error);
    diagnostics_.report({Code::import_not_found,
                         import.range,
                         "cannot read the imported file " + quote(path, kPathBytesMax),
                         why,
                         {},
                         is_there ? "a file of at most 64 MiB that can be read works"
                                  : "the path is relative to the directory of the importing file",
                         {}});
  }

  // `import "field.geojson";` instead of `zone field = import "field.geojson";`
  bool report_zones(const Text& import) {
    static const std::set<std::string> endings{".geojson", ".json", ".wkt",
                                               ".kml",     ".plan", ".waypoints"};
    const std::filesystem::path path{import.text};
    if (endings.count(path.extension().string()) == 0) return false;
    program_.import_failed = true;
    diagnostics_.report({Code::unexpected_token,
                         import.range,
                         quote(import.text, kPathBytesMax) + " is a file of zones, not of items",
                         "has no name here",
                         {},
                         "declare a zone of it: `zone field = import \"" + import.text + "\";`",
                         {}});
    return true;
  }

  void follow(const Text& import, FileId importer) {
    if (import.range.begin == import.range.end) {  // it is missing, and was reported
      program_.import_failed = true;
      return;
    }
    if (report_zones(import)) return;
    const std::string path = path_from(importer, import.text);
    const std::string id = identity(path);
    if (std::any_of(open_.begin(), open_.end(),
                    [&](const Opened& file) { return file.identity == id; })) {
      program_.import_failed = true;
      report_cycle(import, id);
      return;
    }
    if (!known_.insert(id).second) return;
    std::string why;
    const std::optional<FileId> loaded =
        is_stored(path, why) ? sources_.load(path, why) : std::nullopt;
    if (!loaded) {
      program_.import_failed = true;
      report_unreadable(import, path, why);
      return;
    }
    dependencies_.push_back(path);
    visit(*loaded, &import);
  }

  void report_cycle(const Text& import, const std::string& id) {
    const auto first = std::find_if(open_.begin(), open_.end(),
                                    [&](const Opened& file) { return file.identity == id; });
    std::string chain = quote(first->path, kPathBytesMax);
    for (auto file = first + 1; file != open_.end(); ++file) {
      chain +=
          (file == first + 1 ? " imports " : ", which imports ") + quote(file->path, kPathBytesMax);
    }
    chain += (first + 1 == open_.end() ? " imports " : ", which imports ") +
             quote(first->path, kPathBytesMax);
    diagnostics_.report({Code::import_cycle,
                         import.range,
                         "files import each other in a circle",
                         "this file is still being read",
                         {{std::nullopt, std::move(chain)}},
                         "move what both need into a third file",
                         {}});
  }

  SourceManager& sources_;
  diag::Engine& diagnostics_;
  std::vector<std::string>& dependencies_;
  Program program_;
  std::set<std::string> known_;
  std::vector<Opened> open_;
};

}  // namespace

File parse_file(FileId file, const SourceManager& sources, diag::Engine& diagnostics) {
  diag::Engine found;
  File result;
  result.id = file;
  std::vector<SourceRange> silent_edits;
  std::vector<Token> tokens = tokenize(file, sources, found);
  mend_spec_braces(tokens, found);
  mend_decimal_commas(tokens, sources, found);
  for (auto& stretch : split_items(tokens, sources)) {
    Attempt attempt = parse_with_repair(std::move(stretch), sources, found);
    append(silent_edits, std::move(attempt.silent_edits));
    add_attempt(std::move(attempt), result, found);
  }
  mark_damage(found, silent_edits, result);
  forward(found, file, diagnostics);
  return result;
}

Program parse_program(FileId root, SourceManager& sources, diag::Engine& diagnostics,
                      std::vector<std::string>& dependencies) {
  return ProgramParser{sources, diagnostics, dependencies}.run(root);
}

}  // namespace rtac::syntax
