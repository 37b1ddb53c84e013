#include "compiler/syntax/format_pieces.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rtac::syntax {
namespace {

// Two words of one clause, the second of which is no name although it follows no operand.
constexpr std::array<std::pair<TokenKind, TokenKind>, 5> kWordPairs{{{T::BODY, T::RADIUS},
                                                                     {T::RETURN, T::WHEN},
                                                                     {T::HEARS, T::OTHER},
                                                                     {T::OTHER, T::ROBOTS},
                                                                     {T::ROBOTS, T::MAX_AGE}}};

bool ends_operand(const Piece& piece) {
  switch (piece.kind) {
    case T::NUMBER:
    case T::MOMENT:
    case T::UNIT:
    case T::STRING:
    case T::RIGHT_PAREN:
    case T::RIGHT_BRACKET:
    case T::TRUE:
    case T::FALSE:
    case T::EXCLUSIONS:  // the end of `import "file" exclusions`, or a name
    case T::SCHEDULED:   // as well
      return true;
    default:
      return piece.is_name;
  }
}

// A word of the language is a name where an operand or a declared name is due: neither at the start
// of a clause nor behind an operand.
bool is_name(const std::vector<Piece>& pieces, TokenKind kind) {
  if (kind == T::IDENT) return true;
  const Word* word = find_word(kind);
  const bool may_be =
      word && (word->word_kind == WordKind::soft || word->word_kind == WordKind::clause);
  if (!may_be || pieces.empty()) return false;
  const Piece& before = pieces.back();
  const bool first =
      before.kind == T::SEMICOLON || before.kind == T::LEFT_BRACE || before.kind == T::RIGHT_BRACE;
  const bool paired = std::find(kWordPairs.begin(), kWordPairs.end(),
                                std::pair{before.kind, kind}) != kWordPairs.end();
  return !first && !(paired && !before.is_name) && !ends_operand(before);
}

std::string trimmed(std::string_view text) {
  std::string result;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    const std::size_t last = line.find_last_not_of(" \t\r");
    line = line.substr(0, last == std::string_view::npos ? 0 : last + 1);
    if (begin > 0) result += '\n';
    result += line;
    begin = end + 1;
  }
  return result;
}

// The blanks and comments between two tokens.
class Gap {
 public:
  Gap(std::string_view text, std::size_t begin, std::size_t end) : text_(text) {
    std::size_t at = begin;
    while (at < end) {
      const std::string_view rest = text.substr(at, end - at);
      if (rest.starts_with("//") || rest.starts_with("/*")) {
        const bool to_line_end = rest[1] == '/';
        const std::size_t close = rest.find(to_line_end ? "\n" : "*/", 2);
        const std::size_t length =
            close == std::string_view::npos ? rest.size() : close + (to_line_end ? 0U : 2U);
        comments_.push_back({at, length, breaks_});
        breaks_ = 0;
        at += length;
      } else {
        if (rest.front() == '\n') ++breaks_;
        ++at;
      }
    }
  }

  // The line ends between the last comment, or the token before, and the token behind.
  [[nodiscard]] int breaks() const { return breaks_; }

  // `at_edge`: the gap is the first or the last of the file.
  [[nodiscard]] std::vector<Comment> comments(bool first, bool last) const {
    std::vector<Comment> result;
    int before = first ? 1 : 0;
    int behind = breaks_ + (last ? 1 : 0);
    for (const Found& found : comments_) behind += found.breaks;
    for (const Found& found : comments_) {
      before += found.breaks;
      behind -= found.breaks;
      result.push_back({trimmed(text_.substr(found.begin, found.length)), place(before, behind),
                        found.breaks > 1, column(found.begin)});
    }
    return result;
  }

 private:
  struct Found {
    std::size_t begin, length;
    int breaks;  // line ends in front of it
  };

  static CommentPlace place(int before, int behind) {
    if (behind == 0) return CommentPlace::inside;
    return before == 0 ? CommentPlace::trailing : CommentPlace::own_line;
  }

  [[nodiscard]] std::size_t column(std::size_t at) const {
    const std::size_t line_end = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
    const std::size_t line = line_end == std::string_view::npos ? 0 : line_end + 1;
    return width_of(text_.substr(line, at - line));
  }

  std::string_view text_;
  std::vector<Found> comments_;
  int breaks_ = 0;
};

// A comment on the line of its token has the empty line above it, which is that of the token.
bool is_below_empty_line(const Comment& comment) {
  return comment.place == CommentPlace::inside && comment.blank_before;
}

}  // namespace

std::vector<Piece> pieces_of(std::string_view text, const std::vector<Token>& tokens) {
  std::vector<Piece> pieces;
  // what stands in front of the first token on its line is at most a byte order mark
  std::size_t end = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  for (const Token& token : tokens) {
    const Gap gap{text, end, token.range.begin};
    Piece piece;
    piece.kind = token.kind;
    piece.text = text.substr(token.range.begin, token.range.end - token.range.begin);
    piece.is_name = is_name(pieces, token.kind);
    piece.is_unary = token.kind == T::MINUS && (pieces.empty() || !ends_operand(pieces.back()));
    piece.first_on_line = token.first_on_line;
    piece.before = gap.comments(pieces.empty(), token.kind == T::END);
    piece.blank_before = gap.breaks() > 1 ||
                         std::any_of(piece.before.begin(), piece.before.end(), is_below_empty_line);
    pieces.push_back(std::move(piece));
    end = token.range.end;
  }
  return pieces;
}

bool needs_blank(const Piece& before, const Piece& piece, const Piece& next) {
  if (!piece.before.empty()) return true;
  switch (piece.kind) {
    case T::SEMICOLON:
    case T::COMMA:
    case T::RIGHT_PAREN:
    case T::RIGHT_BRACKET:
      return false;
    case T::DOT:
      return before.kind == T::NUMBER;  // `5.` would be a number
    case T::LEFT_PAREN:
      if (before.is_name || before.kind == T::RIGHT_BRACKET) return false;
      break;
    case T::LEFT_BRACKET: {
      if (before.is_name) return next.kind == T::UNIT;  // `real [m/s]`, but `temps[2]`
      const bool is_past =
          before.kind == T::ONCE || before.kind == T::HISTORICALLY || before.kind == T::SINCE;
      if (is_past || before.kind == T::ZONE || ends_operand(before)) return false;
      break;
    }
    default:
      break;
  }
  const bool opened =
      before.kind == T::LEFT_PAREN || before.kind == T::LEFT_BRACKET || before.kind == T::DOT;
  if (opened) return false;
  return !before.is_unary || piece.kind == T::MINUS;
}

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

}  // namespace rtac::syntax
