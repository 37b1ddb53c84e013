// The contract of what switches between the monitors of a decision, with the assertions by which it
// is proved. What holds in general stands in acsl/mode.acsl; here each monitor is named: provers do
// not lead a fact about all of them past a write to one, but see at once, for a number as index,
// that another is written to.
#include "compiler/contract/clauses.h"

namespace rtac::contract {
namespace {

std::string is_ok(std::size_t k) {
  const std::string at = "monitors[" + number(k) + "]";
  return "monitor_ok(" + at + ".engaged, " + at + ".dwell, dwell)";
}

// By rule 10, of what was there before.
std::string engages(std::size_t k) {
  const std::string at = "monitors[" + number(k) + "]";
  return "engages(\\at(" + at + ".engaged, Pre), \\at(" + at + ".dwell, Pre), &checks[" +
         number(k) + "], first, elapsed, dwell)";
}

std::string is_found(std::size_t k) {
  return "(monitors[" + number(k) + "].engaged != 0 <==> " + engages(k) + ")";
}

std::string same_as(std::size_t k, const std::string& label) {
  const std::string at = "monitors[" + number(k) + "]";
  return at + ".engaged == \\at(" + at + ".engaged, " + label + ") && " + at + ".dwell == \\at(" +
         at + ".dwell, " + label + ")";
}

// That `name` is one of the indices.
std::string one_of(const std::string& name, std::size_t count) {
  std::string out;
  for (std::size_t k = 0; k < count; ++k) {
    out += (k == 0 ? "" : " || ") + name + " == " + number(k);
  }
  return out;
}

const char* const all_ok =
    "\\forall integer j; 0 <= j < count ==> monitor_ok(monitors[j].engaged, monitors[j].dwell, "
    "dwell)";

// One monitor after the other: those that were asked, and those that still are as they were.
std::string asking_loop(std::size_t count) {
  Clauses invariants = {"0 <= k <= count"}, after;
  for (std::size_t k = 0; k < count; ++k) {
    const std::string at = number(k);
    invariants.insert(invariants.end(), {is_ok(k), "k <= " + at + " ==> " + same_as(k, "Pre"),
                                         "k > " + at + " ==> " + is_found(k)});
    for (std::size_t other = 0; other < count; ++other) {
      if (other != k) after.push_back("k == " + at + " ==> " + same_as(other, "LoopCurrent"));
    }
    after.push_back("k == " + at + " ==> " + is_found(k) + " && " + is_ok(k));
  }
  return "-- loop 1\n" + joined("loop invariant", invariants) +
         "loop assigns k, monitors[0 .. count - 1];\nloop variant count - k;\n"
         "-- before monitor_step(\n" +
         joined("assert",
                {one_of("k", count), "monitor_ok(monitors[k].engaged, monitors[k].dwell, dwell)"}) +
         "-- before }\n" + joined("assert", {one_of("k", count)}) + joined("assert", after);
}

// Nobody is engaged, and one that is not safer takes over.
std::string taking_over(std::size_t count) {
  Clauses before, after;
  for (std::size_t k = 0; k < count; ++k) {
    const std::string at = number(k), found = "monitors[" + at + "].engaged == ";
    before.push_back(found + "0 && " + is_ok(k) + " && !" + engages(k));
    after.push_back("open == " + at + " ==> " + found + "1 && monitors[" + at + "].dwell == 0");
    for (std::size_t other = 0; other < count; ++other) {
      if (other == k) continue;
      after.push_back("open == " + at + " ==> monitors[" + number(other) + "].engaged == 0 && " +
                      is_ok(other));
    }
    after.push_back("!" + engages(k));
  }
  before.push_back(one_of("open", count));
  after.insert(after.end(), {"monitors[open].engaged != 0", all_ok});
  return "-- before const KERNEL_finding found\n" + joined("assert", before) +
         "-- before return open + 1\n" + joined("assert", after);
}

}  // namespace

std::string looked_well(std::size_t k) {
  const std::string at = "checks[" + number(k) + "]";
  return at + ".ahead.lo >= 0 || " + at + ".safer.lo >= 0";
}

std::string switching_contract(std::size_t count) {
  Clauses needs = {"count == " + number(count)}, found;
  for (std::size_t k = 0; k < count; ++k) {
    const std::string at = number(k);
    needs.push_back("\\valid(monitors + " + at + ") && \\valid_read(checks + " + at + ")");
    for (std::size_t other = 0; other < count; ++other) {
      needs.push_back("\\separated(monitors + " + at + ", checks + " + number(other) + ")");
    }
    found.push_back(is_found(k) + " && " + is_ok(k));
  }
  found.emplace_back(all_ok);
  return "== mode_step\n" + joined("requires", needs) + asking_loop(count) +
         "-- before k = first_engaged(\n" + joined("assert", found) + taking_over(count);
}

}  // namespace rtac::contract
