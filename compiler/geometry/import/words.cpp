#include "compiler/geometry/import/words.h"

#include <cctype>

namespace rtac::geometry::import {
namespace {

bool is_capital(char c) {
  return std::isupper(static_cast<unsigned char>(c)) != 0;
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
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
    starts = false;
  }
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word;
  return text;
}

}  // namespace rtac::geometry::import
