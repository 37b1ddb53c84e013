// What `rtac verify -o DIR` leaves for others to check: the report with its claims, the
// specification with what it imports, and the lemmas that claims name. `--recheck DIR` needs
// nothing else.
#pragma once

#include <iosfwd>
#include <map>
#include <string>

#include "compiler/driver/compile.h"
#include "compiler/driver/options.h"
#include "compiler/verify/obligation.h"

namespace rtac::driver {

// By name: SMT scripts, every answer to which has to be `unsat`.
const std::map<std::string, const char*>& lemma_texts();

// Writes all files or none; what went wrong, or nothing.
std::string write_certificates(const Compilation& c, const verify::Report& report,
                               const std::string& folder);

// 0: every proof is one, and every obligation is proved or acknowledged. 3: a proof is none, or the
// report refutes an obligation. 4: z3 was not there, or did not answer in time, or the report
// leaves an obligation unknown.
int recheck_certificates(const Options& options, Compilation& c, std::ostream& out);

}  // namespace rtac::driver
