// The whole analysis once more, of the specification with another number in it: no number is
// offered as help that has not been tried so.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// An error, a monitor that finds nothing, or a place that nothing leads back from, by its code and
// where it is.
struct Fault {
  diag::Code code{};
  FileId file{};
  std::uint32_t begin = 0;
  std::string open{};  // no report, but an obligation that is not shown, of what stands there
  auto operator<=>(const Fault&) const = default;
};
struct Faults {
  std::set<Fault> all;
  bool derived = true;   // there is something of which it could be shown
  bool complete = true;  // what is not shown is among them
  bool remarks = true;   // and what is no error: the ways of recoveries were looked at
  // That it took to find them (effort.h): by the reports alone, or with what is shown.
  std::int64_t effort = 0, effort_of_shown = 0;
};
Fault fault_of(diag::Code code, const std::optional<SourceRange>& range);
Faults faults_of(const diag::Engine& diagnostics);

// A number of the specification, in steps of a grid.
struct Dial {
  std::string name;                         // of no other number
  std::int64_t written = 0;                 // what it is, or the step before that
  std::int64_t far = 0;                     // the last one that is tried
  std::function<bool(std::int64_t)> write;  // false: other checks would refuse it
  std::function<void()> restore;
  bool of_zone = false;  // they are evaluated anew
  bool coarse = false;   // each trial takes long: to a share of the number is near enough
};

class Trials {
 public:
  // Of the reports alone, whether to ask what is not shown, too, which takes longer.
  using Worth = std::function<bool(const Faults&)>;
  // What is asked of a run; ways of recoveries take most of its time, and lead to remarks alone.
  struct Ask {
    bool same_zones = false;  // as they are written
    bool remarks = true;
    Worth worth;
  };
  // What is wrong with `spec` as it is at the moment.
  using Run = std::function<Faults(const Ask& ask)>;
  Trials(sema::Spec& spec, Run run) : spec_(spec), run_(std::move(run)) {}
  // Of numbers, not by what is shown with them, which takes ten times as long.
  void go_by_reports_alone() { reports_alone_ = true; }
  [[nodiscard]] bool by_reports_alone() const { return reports_alone_; }
  // Whether some number was not tried, or what is shown with it, for want of time: where none was
  // found since, one may work all the same.
  [[nodiscard]] bool ran_out() const { return ran_out_; }
  // To be changed, and to be as it was afterwards.
  [[nodiscard]] sema::Spec& spec() const { return spec_; }
  // Of the specification as it is written.
  void tables_are(const ir::TableMap& tables) { zones_ = tables.zones; }
  // The zone that a table has been made of; none: a slab alone.
  [[nodiscard]] std::optional<sema::ZoneId> zone_of(ir::ZoneIndex table) const;

  // The number nearest to the written one with which `fault` is gone, nothing is wrong or no longer
  // shown that was right, and no more is wrong, or not shown of the same monitor, than with others
  // that are farther off: of several errors with one cause it mends all, if any does. Looked for
  // from `guess` on. none: none of those that were tried is such a one. `all_of`: nor is one with
  // which an error of places (5007, 5016) is left that begins in there.
  std::optional<std::int64_t> nearest(const Dial& dial, std::int64_t guess, const Fault& fault,
                                      const std::optional<SourceRange>& all_of = {});
  // The errors that were left, or came, with the first number of the last search that found none:
  // "4007: a zone is empty"; "": it was not tried, or for what is not shown.
  [[nodiscard]] std::string left_last() const;
  // How much is not shown with a number that was found.
  [[nodiscard]] std::ptrdiff_t left_with(const std::string& dial, std::int64_t steps) const;
  // " (which leaves P2b open)": what is not shown with it of the monitor that `fault` is about; and
  // that there was no time for numbers nearer to the written one. "": all is, or nobody has asked.
  [[nodiscard]] std::string leaves(const std::string& dial, std::int64_t steps,
                                   const Fault& fault) const;
  // Whether all that is not shown there was not shown before either.
  bool shows_no_less(const Faults& found);

 private:
  // What a number is looked for, and whether by what is shown with it, or by reports alone.
  struct Goal {
    Fault fault;
    std::optional<SourceRange> all_of;
    bool shown = false;
  };
  std::optional<std::int64_t> least_wrong(const Dial& dial, std::int64_t guess, const Goal& goal);
  std::optional<std::int64_t> looked_for(const Dial& dial, std::int64_t guess, const Goal& goal);
  const Faults& as_written(bool shown);
  // nullptr: not tried
  [[nodiscard]] const Faults* known_of(const std::string& dial, std::int64_t steps) const;
  // nullptr: refused, or too many; or what is asked of it is not known
  const Faults* with(const Dial& dial, std::int64_t steps, const Goal& goal, const Worth& worth,
                     std::int64_t most_effort);
  // Whether it is not too much to ask what is shown.
  [[nodiscard]] bool may_show() const;
  bool mends(const Faults& found, const Goal& goal);
  bool cannot_be_shown(const Dial& dial, std::int64_t steps);
  // What is wrong with a number that it does not mend.
  [[nodiscard]] std::set<diag::Code> wrong_with(const Faults& found, const Goal& goal);
  // What is not shown of the monitor that a fault is about, or of none.
  [[nodiscard]] std::vector<std::string> open_at(const Faults& found, const Fault& fault) const;

  sema::Spec& spec_;
  Run run_;
  std::vector<std::optional<ir::ZoneIndex>> zones_;  // by ZoneId
  bool reports_alone_ = false, ran_out_ = false;
  int runs_ = 0, shown_ = 0;
  std::int64_t effort_ = 0, effort_of_shown_ = 0;
  std::optional<Faults> as_written_;
  bool asked_ = false;  // what is not shown of it
  std::set<diag::Code> left_;
  std::set<std::pair<std::string, std::int64_t>> rough_;  // nearer ones may work, too
  std::map<std::pair<std::string, std::int64_t>, std::optional<Faults>> known_;
};

// What is said where no number was found: `none`, if all were tried.
std::string as_tried(const Trials* trials, std::string none);

}  // namespace rtac::analysis
