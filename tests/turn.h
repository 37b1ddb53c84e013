// Tests that take long may take turns: with RTAC_TURN=1/4 in the environment, they look at every
// fourth of their cases, from the second on; without it at all of them. On the integration machine
// the commit chooses the turn (.ci/run).
#pragma once

#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace rtac::test {

// Whether the case of this number is looked at. Throws what it cannot read: no case is passed over
// by mistake.
inline bool is_due(std::size_t number) {
  const char* const written = std::getenv("RTAC_TURN");
  if (written == nullptr || *written == '\0') return true;
  const std::string text = written;
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) throw std::invalid_argument("RTAC_TURN=" + text);
  const unsigned long turn = std::stoul(text), turns = std::stoul(text.substr(slash + 1));
  if (turn >= turns) throw std::invalid_argument("RTAC_TURN=" + text);
  return number % turns == turn;
}

}  // namespace rtac::test
