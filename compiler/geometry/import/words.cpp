#include "compiler/geometry/import/words.h"

#include <cctype>
#include <utility>

namespace rtac::geometry::import {
namespace {

bool is_capital(char c) {
  return std::isupper(static_cast<unsigned char>(c)) != 0;
}

char small(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

}  // namespace

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  bool starts = true;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i])) {
      starts = true;
      continue;
    }
    const bool turns = i > 0 && is_capital(name[i]) && !is_capital(name[i - 1]);
    if (starts || turns) words.emplace_back();
    words.back() += small(name[i]);
    starts = false;
  }
  return words;
}

std::vector<Piece> pieces_of(std::string_view text) {
  std::vector<Piece> pieces;
  std::string between;
  char before = ' ';
  for (const char c : text) {
    const bool digit = is_digit(c), letter = is_letter(c);
    if (!digit && !letter) {
      between += c;
    } else {
      if (digit ? !is_digit(before) : !is_letter(before)) {
        pieces.push_back({"", digit, std::move(between)});
        between.clear();
      }
      pieces.back().text += small(c);
    }
    before = c;
  }
  return pieces;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word;
  return text;
}

}  // namespace rtac::geometry::import
