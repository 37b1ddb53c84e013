// Words that names of members and what they say consist of, whatever way they are written. Internal
// to this folder.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace rtac::geometry::import {

bool is_letter(char c);
bool is_digit(char c);

// In small letters: `maxAltitude_m`: `max`, `altitude` and `m`.
std::vector<std::string> words_of(std::string_view name);
std::string joined(const std::vector<std::string>& words);

// A run of digits, or of letters in small ones: `FL95` are `fl` and `95`.
struct Piece {
  std::string text;
  bool digits = false;
  std::string between;  // it and the piece before it
  [[nodiscard]] bool is_number(std::size_t least, std::size_t most) const {
    return digits && least <= text.size() && text.size() <= most;
  }
};
std::vector<Piece> pieces_of(std::string_view text);

template <std::size_t n>
bool has_part(const std::string& text, const std::array<std::string_view, n>& parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](std::string_view part) { return text.find(part) != std::string::npos; });
}

template <std::size_t n>
bool is_one_of(std::string_view word, const std::array<std::string_view, n>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

template <std::size_t n>
bool has_word(const std::vector<std::string>& words,
              const std::array<std::string_view, n>& wanted) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word) { return is_one_of(word, wanted); });
}

}  // namespace rtac::geometry::import
