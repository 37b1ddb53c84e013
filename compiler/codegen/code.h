// A small model of generated source text: lines, blocks and comments, printed at the end with one
// layout. Generators build nodes; nothing else knows about indentation.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "compiler/support/rational.h"

namespace rtac::codegen {

class Code {
 public:
  // One line; an empty text is a blank line.
  Code& line(std::string text);
  Code& blank() { return line(""); }
  // Wrapped to the width of the file, in /* */ or // form.
  Code& comment(std::string text);
  // `head {`, the body one level deeper, `tail`; without a tail another block goes on: `} else`.
  Code& block(std::string head, const std::function<void(Code&)>& body, std::string tail = "}");
  // What another one holds.
  Code& append(Code other);
  // Text that is laid out already.
  Code& text(std::string laid_out);

  enum class Style { c, cpp };  // of comments
  [[nodiscard]] std::string print(Style style) const;

 private:
  struct Line {
    std::string text;
  };
  struct Comment {
    std::string text;
  };
  struct Laid {
    std::string text;
  };
  struct Block;
  using Node = std::variant<Line, Comment, Laid, std::shared_ptr<Block>>;
  struct Block {
    std::string head, tail;
    std::vector<Node> body;
  };
  static void print(const std::vector<Node>& nodes, Style style, int depth, std::string& out);

  std::vector<Node> nodes_;
};

// `start(a, b)`, one parameter below the other where they do not fit a line.
std::string signature(const std::string& start, const std::vector<std::string>& parameters);
// One line, or several that break behind commas and && and ||, and before the branches of ?:.
void wrapped(Code& out, const std::string& text);
// A C or C++ string literal, quotes included.
std::string quoted(const std::string& text);
// An integer constant.
std::string num(std::int64_t value);
// A double literal that reads back as the nearest double of the exact value.
std::string real(const Rational& value);

}  // namespace rtac::codegen
