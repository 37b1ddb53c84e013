// Whether the recovery of one monitor keeps what another one says (theory, arbitration: the matrix
// C[i][j]; language rule 12). Several monitors share one output, so that whoever drives decides for
// all of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/decided.h"
#include "compiler/analysis/recoveries.h"
#include "compiler/analysis/recoveries_in_space.h"
#include "compiler/analysis/zone_trials.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

enum class Keeping {
  kept,     // by the recovery itself, braking in and standing included
  guarded,  // the other monitor ranks higher: it is judged under the recovery's own motion in every
            // tick, and its recovery takes over in time
  broken,   // the recovery may lead to where it is false, and nobody takes over in time
  coordinated,  // the same, but for a recovery that does, by `coordinate`
};
// What a report may offer: another order of the monitors, by their ranks as they are declared,
// monitors that let go without more, a monitor whose recovery brakes and holds instead, one that
// recovers as another one does, a recovery that lands higher, by its monitor and in mm, or larger
// numbers of the energy clause, in s and m.
struct Change {
  std::vector<std::size_t> order{}, without_return{};
  std::optional<std::size_t> stands{};
  std::optional<std::pair<std::size_t, std::size_t>> follows{};
  std::optional<std::pair<std::size_t, std::int64_t>> lands{};
  std::optional<Rational> held{}, detour{};
  bool operator==(const Change&) const = default;
};
// That the recovery moves in what all of `parts` have in common instead of `from`.
struct Within {
  std::string help;  // "": what they have in common, as it is written
  ir::ZoneIndex from{};
  std::vector<ZonePart> parts;
};
struct Entry {
  Keeping keeping = Keeping::kept;
  std::string why;                 // in words, with numbers
  std::string help;                // of what is broken: what would work
  std::optional<Change> change{};  // what that is, to be tried before it is offered
  std::vector<Within> within{};    // or one of these, in that order
  // Of what is broken under `coordinate`: monitors, the first of them this one, the last one for
  // the second time. The recovery of each does not keep the next.
  std::vector<std::size_t> conflict{};
  // It is guarded as inputs may ask for less speed than the recovery has (paces.h), and kept while
  // they do not.
  bool while_told = false;
  // The judged monitor stands still for what inputs say alone, and the recovery drives on: broken
  // where that ranks higher, and kept where it ranks lower.
  bool silences = false;
  // Of what is coordinated: inputs and others alone break it, to which its own recovery is the
  // answer.
  bool answered = false;
  // It is broken by a recovery that takes charge for as long as nobody else lets it end.
  bool unending = false;
  // Or by one that only brakes, and may not be given back where it stands.
  bool stands = false;
};
// One row for the recovery of each monitor, one column for the property of each.
using Arbitration = std::vector<std::vector<Entry>>;

Arbitration arbitration_of(const sema::RobotKind& kind, const ir::Module& module,
                           const ir::Decision& decision, const ExactZone& exact,
                           const ExactSolid& solid);

// Under `coordinate` a recovery drives that keeps the longest prefix of the order, and what has
// failed counts as kept where that is proved (docs/language.md, rule 12.1). So j is kept, whoever
// drives, exactly when among j and the monitors above it no circle of recoveries that do not keep
// each other is led to from j: of any of them that have failed at once, j among them, one has a
// recovery that keeps them all, and it or one as good drives.
// The circle as in Entry::conflict; empty: there is none. unkept[i][j]: it is not proved that the
// recovery of i keeps j.
std::vector<std::size_t> conflict_of(const std::vector<std::vector<bool>>& unkept, std::size_t j);

// Which recoveries do not keep each other, in words; "": the entry has no conflict.
std::string conflict_text(const ir::Decision& decision, const Entry& entry);

// Fills the matrices of decisions: the whole of one that coordinates; with `priority` of monitors
// that rank above the recovery's own, and which it keeps by itself, so that it drives on though
// they engage (rule 10). Where no decision by priority has any, theirs are empty.
void fill_keeps(const sema::Spec& spec, ir::Module& module, const ExactZone& exact,
                const ExactSolid& solid, const HowItLies& lies);

// The errors of the specification with a change of one of its decisions, what is not shown of it,
// and whether a monitor waits there for a return condition that may never come about.
struct Tried {
  std::vector<diag::Diagnostic> errors;
  Faults left{};
  bool waits = false;
};
using Try = std::function<Tried(std::size_t decision, const Change&)>;

// 6005: a recovery that breaks what a monitor says and that nobody else keeps, unless that is
// acknowledged.
void check_arbitration(const sema::Spec& spec, const ir::Module& module, const ExactZone& exact,
                       const ExactSolid& solid, const Try& attempt, Trials* trials,
                       diag::Engine& diagnostics);

}  // namespace rtac::analysis
