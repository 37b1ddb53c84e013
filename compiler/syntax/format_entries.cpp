#include "compiler/syntax/format_entries.h"

#include <algorithm>
#include <functional>
#include <map>

namespace rtac::syntax {
namespace {

// Longer words do not push their neighbours to the right: `controller`, `acknowledge`.
constexpr std::size_t kWordColumnMax = 8;
// Names beyond this width do not either.
constexpr std::size_t kNameColumnMax = 24;

std::vector<Entry> read_entries(const std::vector<Piece>& pieces, std::size_t& at) {
  std::vector<Entry> entries;
  while (pieces[at].kind != T::END && pieces[at].kind != T::RIGHT_BRACE) {
    Entry entry;
    entry.begin = at;
    entry.blank_before = pieces[at].blank_before;
    const bool is_text = pieces[at].kind == T::STRING;
    while (!is_text && pieces[at].kind != T::END && pieces[at].kind != T::RIGHT_BRACE &&
           pieces[at].kind != T::SEMICOLON && pieces[at].kind != T::LEFT_BRACE) {
      ++at;
    }
    entry.is_block = pieces[at].kind == T::LEFT_BRACE;
    if (is_text || entry.is_block || pieces[at].kind == T::SEMICOLON) ++at;
    entry.end = at;
    if (entry.is_block) {
      entry.children = read_entries(pieces, at);
      entry.close = at;
      if (pieces[at].kind != T::END) ++at;
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

// First piece of that kind outside of brackets; `end` when there is none.
std::size_t find_outside(const std::vector<Piece>& pieces, std::size_t begin, std::size_t end,
                         TokenKind kind) {
  int depth = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const TokenKind here = pieces[i].kind;
    if (here == kind && depth == 0) return i;
    if (here == T::LEFT_PAREN || here == T::LEFT_BRACKET) ++depth;
    if (here == T::RIGHT_PAREN || here == T::RIGHT_BRACKET) --depth;
  }
  return end;
}

class Aligner {
 public:
  Aligner(const std::vector<Piece>& pieces, const PieceWidths& widths,
          const std::vector<Entry>& entries, Level level, std::size_t indent)
      : pieces_(pieces), widths_(widths), entries_(entries), level_(level), indent_(indent) {}

  std::vector<StatementLayout> run() {
    for (const Entry& entry : entries_) layouts_.push_back(layout_of(entry));
    if (level_ == Level::file) {
      align_runs();
    } else {
      align_words(0, entries_.size(), width_of_words());
    }
    if (level_ == Level::robot) align_cells();
    return std::move(layouts_);
  }

 private:
  [[nodiscard]] TokenKind first(const Entry& entry) const { return pieces_[entry.begin].kind; }

  [[nodiscard]] StatementLayout layout_of(const Entry& entry) const {
    StatementLayout layout;
    layout.begin = entry.begin;
    layout.end = entry.end;
    layout.indent = indent_;
    layout.begin_of_body = std::min(body_of(entry), entry.end);
    layout.operators_hang = first(entry) == T::ZONE;
    layout.wraps = first(entry) != T::AHEAD;
    return layout;
  }

  [[nodiscard]] std::size_t body_of(const Entry& entry) const {
    if (entry.is_block) return entry.end;
    if (level_ == Level::monitor || level_ == Level::decision) {
      const bool two_words = first(entry) == T::RETURN;
      return entry.begin + (two_words ? 2 : 1);
    }
    if (level_ != Level::file) return level_ == Level::list ? entry.begin : entry.end;
    switch (first(entry)) {
      case T::ZONE:
      case T::SITE:
      case T::PARAM:
        return find_outside(pieces_, entry.begin, entry.end, T::ASSIGN) + 1;
      case T::FUN:
      case T::FLEET:
      case T::AGENT:
      case T::INPUT:
      case T::ASSUME:
      case T::SCALE:
      case T::GRID:
      case T::FRAME:
      case T::ORIGIN:
      case T::CLOCK:
      case T::PERIOD:
        return entry.begin + 1;
      default:
        return entry.end;
    }
  }

  // ---- columns of words: the first piece of each entry

  // Robots, monitors and decisions look alike whatever clauses they have.
  [[nodiscard]] std::size_t width_of_words() const {
    constexpr std::size_t robot_width = 8, decision_width = 8, monitor_width = 7;
    switch (level_) {
      case Level::robot:
        return robot_width;
      case Level::decision:
        return decision_width;
      case Level::monitor:
        return is_watch() ? 0 : monitor_width;
      case Level::list:
        return longest_word(0, entries_.size(), kNameColumnMax);
      case Level::file:
        break;
    }
    return 0;
  }

  // A monitor that only judges.
  [[nodiscard]] bool is_watch() const {
    const bool only_judges =
        std::all_of(entries_.begin(), entries_.end(), [this](const Entry& entry) {
          return first(entry) == T::STRING || first(entry) == T::ALWAYS;
        });
    return only_judges && !has_subject();
  }
  [[nodiscard]] bool has_subject() const {
    // the head of the block ends in front of the first clause: monitor m for r : Kind {
    if (entries_.empty() || entries_.front().begin < 2) return false;
    const std::size_t before_brace = entries_.front().begin - 2;
    return before_brace > 0 && pieces_[before_brace - 1].kind == T::COLON;
  }

  [[nodiscard]] std::size_t longest_word(std::size_t begin, std::size_t end,
                                         std::size_t limit) const {
    std::size_t result = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t width = width_of(pieces_[entries_[i].begin].text);
      if (width <= limit) result = std::max(result, width);
    }
    return result;
  }

  void align_words(std::size_t begin, std::size_t end, std::size_t width) {
    for (std::size_t i = begin; i < end; ++i) {
      const Entry& entry = entries_[i];
      const std::size_t own = width_of(pieces_[entry.begin].text);
      const bool is_list = first(entry) == T::STRING || (level_ == Level::list && !is_bound(entry));
      if (own > width || is_list) continue;
      layouts_[i].blanks[entry.begin + 1] = width - own + 1;
    }
  }

  [[nodiscard]] bool is_bound(const Entry& entry) const {
    const TokenKind second = pieces_[entry.begin + 1].kind;
    return second == T::LESS_EQUAL || second == T::GREATER_EQUAL;
  }

  // ---- runs of items without an empty line between them

  [[nodiscard]] bool joins_run(std::size_t i) const {
    const TokenKind kind = first(entries_[i]);
    return (!entries_[i].is_block || kind == T::ENUM) && kind != T::SPEC && kind != T::IMPORT;
  }

  [[nodiscard]] bool follows_gap(std::size_t i) const {
    const auto& comments = pieces_[entries_[i].begin].before;
    return entries_[i].blank_before ||
           std::any_of(comments.begin(), comments.end(),
                       [](const Comment& comment) { return comment.blank_before; });
  }

  void align_runs() {
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= entries_.size(); ++i) {
      const bool same_run =
          i < entries_.size() && joins_run(i) && joins_run(i - 1) && !follows_gap(i);
      if (same_run) continue;
      if (joins_run(begin)) {
        align_words(begin, i, longest_word(begin, i, kWordColumnMax));
        align_separators(begin, i);
      }
      begin = i;
    }
  }

  // The `=` or `:` of neighbours of one sort.
  void align_separators(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end;) {
      std::size_t behind = i + 1;
      while (behind < end && first(entries_[behind]) == first(entries_[i])) ++behind;
      align_column(i, behind, [this](const Entry& entry) { return separator_of(entry); });
      i = behind;
    }
  }

  [[nodiscard]] std::size_t separator_of(const Entry& entry) const {
    switch (first(entry)) {
      case T::ZONE:
      case T::SITE:
        return find_outside(pieces_, entry.begin, entry.end, T::ASSIGN);
      case T::CONTROLLER:
      case T::INPUT:
      case T::PARAM:
      case T::FLEET:
      case T::AGENT:
        return find_outside(pieces_, entry.begin, entry.end, T::COLON);
      default:
        return entry.end;
    }
  }

  // Puts the pieces that `find` tells under each other; what is in front begins behind the word.
  void align_column(std::size_t begin, std::size_t end,
                    const std::function<std::size_t(const Entry&)>& find) {
    std::size_t widest = 0;
    const auto width = [&](const Entry& entry) {
      return widths_.width(entry.begin + 1, find(entry));
    };
    const auto takes_part = [&](const Entry& entry) {
      return find(entry) < entry.end && width(entry) <= kNameColumnMax;
    };
    for (std::size_t i = begin; i < end; ++i) {
      if (takes_part(entries_[i])) widest = std::max(widest, width(entries_[i]));
    }
    for (std::size_t i = begin; i < end; ++i) {
      const Entry& entry = entries_[i];
      if (takes_part(entry)) layouts_[i].blanks[find(entry)] = widest - width(entry) + 1;
    }
  }

  // ---- signals of robots: columns of `error`, `max_age` and `tracking`

  [[nodiscard]] bool is_signal(const Entry& entry) const {
    const TokenKind kind = first(entry);
    return kind == T::SENSE || kind == T::HEARS || kind == T::INPUT || kind == T::OUTPUT;
  }

  // The pieces that begin the cells behind the first.
  [[nodiscard]] std::vector<std::size_t> cells_of(const Entry& entry) const {
    std::vector<std::size_t> result;
    for (std::size_t i = entry.begin + 1; i < entry.end; ++i) {
      const TokenKind kind = pieces_[i].kind;
      const bool begins = kind == T::ERROR || kind == T::MAX_AGE || kind == T::TRACKING;
      if (begins && !pieces_[i].is_name) result.push_back(i);
    }
    return result;
  }

  [[nodiscard]] std::size_t cell_width(std::size_t entry, std::size_t begin,
                                       std::size_t end) const {
    std::size_t result = widths_.width(begin, end);
    for (const auto& [piece, count] : layouts_[entry].blanks) {
      if (piece > begin && piece < end) result += count - widths_.blanks(piece);
    }
    return result;
  }

  void align_names_of(TokenKind kind) {
    std::size_t widest = 0;
    for (const Entry& entry : entries_) {
      if (first(entry) == kind) widest = std::max(widest, width_of(pieces_[entry.begin + 1].text));
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (first(entries_[i]) != kind) continue;
      const std::size_t name = entries_[i].begin + 1;
      layouts_[i].blanks[name + 1] = widest - width_of(pieces_[name].text) + 1;
    }
  }

  void align_cells() {
    for (const TokenKind kind : {T::SENSE, T::INPUT, T::OUTPUT}) align_names_of(kind);
    std::map<std::size_t, std::size_t> widest;  // of the cells that another one follows
    const auto visit = [&](auto&& action) {
      for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (!is_signal(entries_[i])) continue;
        std::size_t begin = entries_[i].begin + 1;
        const std::vector<std::size_t> cells = cells_of(entries_[i]);
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
          action(i, cell, cell_width(i, begin, cells[cell]), cells[cell]);
          begin = cells[cell];
        }
      }
    };
    visit([&](std::size_t, std::size_t cell, std::size_t width, std::size_t) {
      widest[cell] = std::max(widest[cell], width);
    });
    visit([&](std::size_t i, std::size_t cell, std::size_t width, std::size_t next) {
      layouts_[i].blanks[next] = widest[cell] - width + kIndent;
    });
  }

  const std::vector<Piece>& pieces_;
  const PieceWidths& widths_;
  const std::vector<Entry>& entries_;
  const Level level_;
  const std::size_t indent_;
  std::vector<StatementLayout> layouts_;
};

}  // namespace

std::vector<Entry> entries_of(const std::vector<Piece>& pieces) {
  std::size_t at = 0;
  return read_entries(pieces, at);
}

Level level_in(const std::vector<Piece>& pieces, const Entry& block) {
  switch (pieces[block.begin].kind) {
    case T::ROBOT:
      return Level::robot;
    case T::MONITOR:
      return Level::monitor;
    case T::DECISION:
      return Level::decision;
    default:
      return Level::list;
  }
}

bool is_inline(const std::vector<Piece>& pieces, const Entry& entry) {
  for (std::size_t i = entry.end; i <= entry.close; ++i) {
    const bool has_line_comment =
        std::any_of(pieces[i].before.begin(), pieces[i].before.end(),
                    [](const Comment& comment) { return comment.place != CommentPlace::inside; });
    if (pieces[i].first_on_line || has_line_comment) return false;
  }
  return true;
}

std::vector<StatementLayout> layouts_of(const std::vector<Piece>& pieces, const PieceWidths& widths,
                                        const std::vector<Entry>& entries, Level level,
                                        std::size_t indent) {
  return Aligner{pieces, widths, entries, level, indent}.run();
}

}  // namespace rtac::syntax
