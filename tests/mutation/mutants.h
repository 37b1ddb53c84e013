// Seeded mistakes in what the compiler emits: each stands for a rule that somebody may get wrong in
// the compiler, and is made in the text of a generated kernel.
#pragma once

#include <string>
#include <vector>

namespace rtac::mutation {

struct Mutant {
  const char* name;
  const char* pattern;      // ECMAScript
  const char* replacement;  // $1, $2, ...: groups
};
const std::vector<Mutant>& mutants();
// In what tells verdicts alone; what both entries share is among the others.
const std::vector<Mutant>& verdict_mutants();

// All places that match; the same text when none does.
std::string mutated(const Mutant& mutant, const std::string& kernel);

// Monitors in which the mistakes show at limits that a random formula rarely meets. They speak of
// the inputs of tests/differential/generator.h.
std::vector<std::string> witnesses();

}  // namespace rtac::mutation
