#include "compiler/syntax/format_breaks.h"

namespace rtac::syntax {
namespace {

std::optional<BreakClass> class_of_word(const Piece& piece) {
  if (piece.is_name) return std::nullopt;
  switch (piece.kind) {
    case T::THEN:
    case T::ELSE:
    case T::IN:
    case T::ERROR:
    case T::MAX_AGE:
    case T::RESOLUTION:
    case T::CHECKED:
    case T::UNCHECKED:
    case T::FEATURE:
    case T::AXES:
    case T::INCLUSIONS:
    case T::EXCLUSIONS:
    case T::FLAT:
    case T::TIMELESS:
    case T::SCHEDULED:
    case T::HEIGHTS:
    case T::AROUND:
    case T::DURING:
      return BreakClass::part;
    case T::FOR:
    case T::SINCE:
    case T::WITHIN:
      return BreakClass::temporal;
    case T::HOLE:
      return BreakClass::hole;
    default:
      return std::nullopt;
  }
}

std::optional<BreakClass> class_of(const Piece& piece) {
  switch (piece.kind) {
    case T::IFF:
      return BreakClass::iff;
    case T::IMPLIES:
      return BreakClass::implies;
    case T::XOR:
      return BreakClass::logical_xor;
    case T::OR:
      return BreakClass::logical_or;
    case T::AND:
      return BreakClass::logical_and;
    case T::LESS:
    case T::LESS_EQUAL:
    case T::GREATER:
    case T::GREATER_EQUAL:
    case T::EQUAL:
    case T::NOT_EQUAL:
    case T::INSIDE:
      return BreakClass::comparison;
    case T::PIPE:
      return BreakClass::zone_union;
    case T::AMPERSAND:
      return BreakClass::zone_intersection;
    case T::PLUS:
      return BreakClass::sum;
    case T::MINUS:
      return piece.is_unary ? std::nullopt : std::optional{BreakClass::sum};
    case T::STAR:
    case T::SLASH:
      return BreakClass::product;
    default:
      return class_of_word(piece);
  }
}

// Heads of quantifiers and of `let` whose body has not begun.
class OpenHeads {
 public:
  // True when `piece` ends a head: a line may begin behind it.
  bool ends_with(const Piece& piece, int depth) {
    const bool opens = piece.kind == T::FORALL || piece.kind == T::EXISTS || piece.kind == T::LET;
    if (opens) heads_.push_back({piece.kind, depth, 0});
    if (heads_.empty() || heads_.back().depth != depth) return false;
    Head& head = heads_.back();
    const bool ends =
        head.kind == T::LET ? piece.kind == T::IN : piece.kind == T::COLON && ++head.colons == 2;
    if (ends) heads_.pop_back();
    return ends;
  }
  [[nodiscard]] bool inside(int depth) const {
    return !heads_.empty() && heads_.back().depth == depth;
  }

 private:
  struct Head {
    TokenKind kind;
    int depth;
    int colons;
  };
  std::vector<Head> heads_;
};

}  // namespace

std::vector<std::optional<Break>> breaks_of(const std::vector<Piece>& pieces, std::size_t begin,
                                            std::size_t end) {
  std::vector<std::optional<Break>> result(end - begin);
  OpenHeads heads;
  int depth = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const TokenKind kind = pieces[i].kind;
    const bool closes = kind == T::RIGHT_PAREN || kind == T::RIGHT_BRACKET;
    if (closes) --depth;
    const bool after_comma = i > begin && pieces[i - 1].kind == T::COMMA;
    const bool in_head = heads.inside(depth);
    if (after_comma && !in_head) result[i - begin] = Break{depth, BreakClass::comma};
    const std::optional<BreakClass> own = class_of(pieces[i]);
    if (own && !(in_head && kind == T::IN)) result[i - begin] = Break{depth, *own};
    const bool defines = kind == T::ASSIGN && depth == 0 && !in_head;
    const bool head_ends = heads.ends_with(pieces[i], depth) || defines;
    if (head_ends && i + 1 < end) result[i + 1 - begin] = Break{depth, BreakClass::reach};
    if (kind == T::LEFT_PAREN || kind == T::LEFT_BRACKET) ++depth;
  }
  return result;
}

}  // namespace rtac::syntax
