// What is fuzzed: each function takes any bytes and returns what went wrong, empty when nothing
// did. Crashes, leaks and endless loops are for the sanitizers and the fuzzer to see. Imports are
// not followed: a text must not make the fuzzer read files.
#pragma once

#include <string>
#include <string_view>

namespace rtac::fuzz {

// Tokens stand in order and within the text.
std::string run_lexer(std::string_view text);
// A text with a mistake is refused with a place in it; one without is the same tree when it is
// printed or formatted and read again.
std::string run_parser(std::string_view text);
// Either a checked specification that can be printed, or errors that say where and what works.
std::string run_check(std::string_view text);
// The whole compiler: what is accepted becomes code, and the reference interpreter can run it.
std::string run_compiler(std::string_view text);
// Every reader of zone files: areas that hold what areas.h promises, or a failure with its place.
std::string run_zones(std::string_view text);

}  // namespace rtac::fuzz
