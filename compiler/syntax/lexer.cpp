#include "compiler/syntax/lexer.h"

#include <string_view>

#include "compiler/syntax/lexer_sink.h"

namespace rtac::syntax {

void scan(std::string_view text, LexerSink& sink);  // lexer.ll

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Bytes of the UTF-8 character at the start of `text`; 0 when it is malformed, too long for its
// value, a surrogate or NUL.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned lead = byte(0);
  if (lead == 0) return 0;
  if (lead < 0x80U) return 1;
  if (lead >= 0xC2U && lead < 0xE0U) return continues(1) ? 2 : 0;
  if (lead >= 0xE0U && lead < 0xF0U) {
    const bool overlong = lead == 0xE0U && byte(1) < 0xA0U;
    const bool surrogate = lead == 0xEDU && byte(1) >= 0xA0U;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0U && lead < 0xF5U) {
    const bool overlong = lead == 0xF0U && byte(1) < 0x90U;
    const bool too_large = lead == 0xF4U && byte(1) >= 0x90U;
    return continues(1) && continues(2) && continues(3) && !overlong && !too_large ? 4 : 0;
  }
  return 0;
}

std::size_t find_malformed(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = character_length(text.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return std::string_view::npos;
}

void report_not_text(FileId file, std::size_t at, bool is_nul, diag::Engine& diagnostics) {
  const auto offset = static_cast<std::uint32_t>(at);
  diagnostics.report({diag::Code::file_not_text,
                      SourceRange{file, offset, offset + 1},
                      "the file is not UTF-8 text",
                      is_nul ? "a zero byte" : "this byte is no part of a UTF-8 character",
                      {},
                      "save the file as UTF-8 text",
                      {}});
}

}  // namespace

std::vector<Token> tokenize(FileId file, const SourceManager& sources, diag::Engine& diagnostics) {
  const std::string_view text = sources.text(file);
  const auto end = static_cast<std::uint32_t>(text.size());
  const Token bad_end{T::END, {file, end, end}, {}, true, true};
  const std::size_t malformed = find_malformed(text);
  if (malformed != std::string_view::npos) {
    report_not_text(file, malformed, text[malformed] == '\0', diagnostics);
    return {bad_end};
  }
  const std::size_t skipped = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  LexerSink sink{file, skipped, diagnostics};
  scan(text.substr(skipped), sink);
  std::vector<Token> tokens = sink.take();
  if (tokens.empty() || tokens.back().kind != T::END) tokens.push_back(bad_end);
  return tokens;
}

}  // namespace rtac::syntax
