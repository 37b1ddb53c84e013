// `rtac sim`: robots under attack, in virtual time.
#pragma once

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

#include "compiler/driver/compile.h"
#include "compiler/driver/options.h"
#include "compiler/driver/process.h"

namespace rtac::driver {

// Compiles the decisions of the module and starts `rtac-sim`, a program of its own, with them and
// with a manifest of everything else; its output goes to `out`, its exit code is returned.
int simulate(const Options& options, Compilation& c, std::ostream& out);

// `runs` of each decision that can be simulated, as `rtac sim` plays them, and for each a line on
// how much of the time its advanced controller had, and how far that is from what is predicted.
int simulate_shares(const std::string& runs, const Options& options, Compilation& c,
                    std::ostream& out);

// How the agents of a run move, and when they count: as the simulator has them; or they stand,
// which is none of the ways that it has, and one that they are free to choose; or they count as
// well while a robot stands, who is not to blame for one that walks up to it, unless that is what
// is refuted.
enum class Agents { as_declared, stand, walk_up };

// The compiled decisions of a module, for as many calls of `rtac-sim` as it takes.
class Simulator {
 public:
  // Takes the module. exit_clean, or a diagnostic says what is wrong.
  int build(const Options& options, Compilation& c);
  // Starts it with these flags besides. exit_clean and exit_violation: it did what it was asked
  // for; otherwise a diagnostic, or an internal error, says what is wrong.
  int run(const std::vector<std::string>& flags, Compilation& c, std::string& said,
          Agents agents = Agents::as_declared);
  // Those of a recorded run; as declared, too, where that is none.
  [[nodiscard]] Agents agents_of(const std::string& trace) const;
  // What is predicted of the decisions, as flags of `rtac-sim`.
  [[nodiscard]] const std::vector<std::string>& predicted() const { return predicted_; }
  // Of its own, removed with the simulator.
  [[nodiscard]] const std::string& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
  std::vector<std::string> predicted_;
  std::array<std::string, 3> sums_;  // of the manifests, by how agents move
};

}  // namespace rtac::driver
