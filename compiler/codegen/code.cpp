#include "compiler/codegen/code.h"

#include <sstream>
#include <string_view>

namespace rtac::codegen {
namespace {

constexpr std::size_t width = 100;

// A text of the author must neither end our comment nor seem to start another one, and what ends a
// line must not join it with the next.
void tame(std::string& word) {
  for (const char* const mark : {"*/", "/*"}) {
    for (std::size_t at; (at = word.find(mark)) != std::string::npos;) word.insert(at + 1, 1, ' ');
  }
  const bool joins =
      word.back() == '\\' || (word.size() >= 3 && word.compare(word.size() - 3, 3, "?\?/") == 0);
  if (joins) word += '.';
}

void print_comment(const std::string& text, Code::Style style, const std::string& indent,
                   std::string& out) {
  const std::string open = style == Code::Style::c ? "/* " : "// ";
  const std::string next = style == Code::Style::c ? " * " : "// ";
  std::istringstream words(text);
  std::string line = indent + open, word;
  bool first = true;
  while (words >> word) {
    tame(word);
    if (!first && line.size() + 1 + word.size() + 3 > width) {
      out += line + "\n";
      line = indent + next;
      first = true;
    }
    line += (first ? "" : " ") + word;
    first = false;
  }
  out += line + (style == Code::Style::c ? " */\n" : "\n");
}

}  // namespace

Code& Code::line(std::string text) {
  nodes_.push_back(Line{std::move(text)});
  return *this;
}

Code& Code::comment(std::string text) {
  nodes_.push_back(Comment{std::move(text)});
  return *this;
}

Code& Code::text(std::string laid_out) {
  nodes_.push_back(Laid{std::move(laid_out)});
  return *this;
}

Code& Code::append(Code other) {
  for (Node& node : other.nodes_) nodes_.push_back(std::move(node));
  return *this;
}

Code& Code::block(std::string head, const std::function<void(Code&)>& body, std::string tail) {
  Code inner;
  body(inner);
  auto block = std::make_shared<Block>();
  block->head = std::move(head);
  block->tail = std::move(tail);
  block->body = std::move(inner.nodes_);
  nodes_.push_back(std::move(block));
  return *this;
}

std::string Code::print(Style style) const {
  std::string out;
  print(nodes_, style, 0, out);
  return out;
}

void Code::print(const std::vector<Node>& nodes, Style style, int depth, std::string& out) {
  const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
  for (const Node& node : nodes) {
    if (const auto* line = std::get_if<Line>(&node)) {
      const bool flush = line->text.empty() || line->text[0] == '#';
      out += (flush ? "" : indent) + line->text + "\n";
    } else if (const auto* comment = std::get_if<Comment>(&node)) {
      print_comment(comment->text, style, indent, out);
    } else if (const auto* laid = std::get_if<Laid>(&node)) {
      out += laid->text;
    } else {
      const Block& block = *std::get<std::shared_ptr<Block>>(node);
      out += indent + block.head + " {\n";
      print(block.body, style, depth + 1, out);
      if (!block.tail.empty()) out += indent + block.tail + "\n";
    }
  }
}

std::string signature(const std::string& start, const std::vector<std::string>& parameters) {
  constexpr std::size_t head_width = 98;  // and ` {`
  std::string head = start + "(";
  const std::string pad(head.size(), ' ');
  std::size_t used = head.size();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string part = parameters[i] + (i + 1 < parameters.size() ? "," : ")");
    const bool fits = used + 1 + part.size() <= head_width;
    if (i > 0) head += fits ? " " : "\n" + pad;
    used = (fits ? used + 1 : pad.size()) + part.size();
    head += part;
  }
  return head;
}

namespace {
// Behind the next place where a line may break; what is looked at is passed once.
std::size_t next_break(std::string_view text, std::size_t from) {
  for (std::size_t at = from; at < text.size(); ++at) {
    const std::string_view rest = text.substr(at, 4);
    if (rest.substr(0, 2) == ", ") return at + 2;
    if (rest == " && " || rest == " || ") return at + 4;
    if (rest.substr(0, 3) == " ? " || rest.substr(0, 3) == " : ") return at + 1;
  }
  return text.size();
}
}  // namespace

void wrapped(Code& out, const std::string& text) {
  constexpr std::size_t text_width = 96;
  std::string line;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = next_break(text, from);
    const std::string part = text.substr(from, to - from);
    if (!line.empty() && line.size() + part.size() > text_width) {
      line.pop_back();
      out.line(line);
      line = "    ";
    }
    line += part;
    from = to;
  }
  out.line(line);
}

std::string quoted(const std::string& text) {
  static const char* const digits = "01234567";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    // two question marks could start a trigraph
    if (c == '"' || c == '\\' || (c == '?' && out.back() == '?')) {
      out += std::string("\\") + c;
    } else if (byte < 32 || byte == 127) {
      out += std::string("\\") + digits[byte >> 6] + digits[(byte >> 3) & 7] + digits[byte & 7];
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string num(std::int64_t value) {
  return std::to_string(value);
}

std::string real(const Rational& value) {
  const std::string text = to_decimal(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

}  // namespace rtac::codegen
