// Contracts as text, of functions by their names:
//
//   == NAME             what follows is the contract of a function, a clause a line or more
//   !! REASON           it is taken for granted, for that reason (compiler/docs/kernel_proof.md)
//   -- loop N           of its Nth loop
//   -- before TEXT      assertions, each before the next; before the first line that begins so
//   -- at end           assertions where the function ends
//   == after NAME       what follows stands behind the declaration of that type, table or macro
//
// Lines that begin with `/*? FUNCTION */` are of kernels that define the function, those with
// `/*? !FUNCTION */` of those that do not. Lines that begin with # are comments. `KERNEL_` stands
// for the prefix of what a kernel declares.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rtac::contract {

using Lines = std::vector<std::string>;

struct Function {
  std::string held;  // why it is taken for granted; empty: it is proved
  Lines contract;
  std::map<int, Lines> loops;
  std::vector<std::pair<std::string, Lines>> before;  // beginning of the line, assertions
  Lines at_end;
};
struct Notes {
  std::map<std::string, Function> functions;
  std::map<std::string, Lines> after;
};

// What `text` says of this kernel.
std::string notes_for(const std::string& text, const std::string& kernel);
// Adds what `text` says, with `prefix` for KERNEL_.
void read_notes(const std::string& text, const std::string& prefix, Notes& notes);

}  // namespace rtac::contract
