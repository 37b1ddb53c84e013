// What several monitors say of inputs, and ask for to let go: whether it can be so at once.
#include "compiler/analysis/limits.h"
#include "compiler/support/words.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

// A limit of its own speed, `r.speed <= c`, that whoever has come to rest is seen to keep, driven
// by the recovery of monitor `k`.
bool is_kept_at_rest(const Subject& s, std::size_t k, const sema::Expr& e) {
  using Op = sema::CompareOp;
  const auto* const compare = std::get_if<sema::Compare>(&e.node);
  if (compare == nullptr) return false;
  const bool at_most = compare->op == Op::less || compare->op == Op::less_equal;
  const bool strict = compare->op == Op::less || compare->op == Op::greater;
  const auto* const speed =
      std::get_if<sema::SignalRef>(&(at_most ? compare->left : compare->right)->node);
  const auto* const most =
      std::get_if<sema::Constant>(&(at_most ? compare->right : compare->left)->node);
  if (speed == nullptr || most == nullptr || speed->signal != sema::Signal::speed ||
      speed->subject != sema::Subject::self) {
    return false;
  }
  const Rational shown_mmps(
      static_cast<long>(analysis::shown_speed_mmps(s.decision, s.decision.motions[k + 1])));
  const Rational most_mmps = most->value * 1000;
  return strict ? shown_mmps < most_mmps : shown_mmps <= most_mmps;
}

}  // namespace

std::string values_of(const Subject& s, const std::vector<analysis::ToldInput>& told) {
  std::string all;
  for (const analysis::ToldInput& each : told) {
    all += (all.empty() ? "" : ";") + s.spec[each.input].name + "." +
           std::to_string(each.component) + "=" + each.value.get_str();
  }
  return all;
}

std::string names_of_told(const Subject& s) {
  std::string all;
  for (const std::size_t k : s.told) {
    all += (all.empty() ? "" : ";") + s.decision.monitors[k].name;
  }
  return all;
}

Obligation told_at_once(const Subject& s, std::optional<std::size_t> only, Obligation o) {
  if (o.status != Status::proved) return o;
  std::vector<const sema::Expr*> said, alone;
  std::string names;
  bool asks_to_return = false;
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    if (only && k != *only) continue;
    const sema::Monitor& m = s.monitor(k);
    (s.told.contains(k) ? alone : said).push_back(m.always.get());
    if (m.return_when) {
      said.push_back(m.return_when.get());
      asks_to_return = asks_to_return || !analysis::inputs_in(s.spec, *m.return_when).empty();
    }
    names += (names.empty() ? "" : ", ") + quoted(m.name);
  }
  std::vector<const sema::Expr*> all = said;
  all.insert(all.end(), alone.begin(), alone.end());
  const bool is_without_places = !alone.empty();
  // which side of an `or` a place has been found for, and which inputs, need not be the same: those
  // have to make it true by themselves
  std::string torn;
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    const sema::Monitor& m = s.monitor(k);
    if ((only && k != *only) || !m.return_when) continue;
    const auto at_rest = [&](const sema::Expr& part) { return is_kept_at_rest(s, k, part); };
    const auto parts = analysis::torn_parts(s.spec, *m.return_when, all, at_rest);
    alone.insert(alone.end(), parts.begin(), parts.end());
    if (torn.empty() && !parts.empty()) torn = m.name;
  }
  // else each can be so by itself, as is asked of what is said (satisfiable)
  if (alone.empty() && !asks_to_return && !analysis::share_inputs(s.spec, said)) return o;
  const analysis::Told told = analysis::told_at_once(s.spec, said, alone);
  if (told.can == analysis::CanBeTold::yes) {
    Claim claim{"at_once", {{"decision", s.decision.name}, {"inputs", values_of(s, told.inputs)}}};
    if (only) claim.values["monitor"] = s.decision.monitors[*only].name;
    if (is_without_places) claim.values["alone"] = names_of_told(s);
    if (!told.inputs.empty()) o.because += ", with " + told_text(s.spec, told.inputs);
    o.claims.push_back(std::move(claim));
    return o;
  }
  o.claims.clear();
  o.place_mm = {};
  if (!torn.empty()) {
    o.status = Status::unknown;
    o.method = "no proof";
    o.because = "`return when` of " + quoted(torn) +
                " asks for inputs on one side of an `or`, for something else on another, and those "
                "inputs are spoken of elsewhere, too";
    o.repair = "a `return when` without that `or` is needed";
    return o;
  }
  const bool never = told.can == analysis::CanBeTold::no;  // whatever was so before
  o.status = never ? Status::refuted : Status::unknown;
  o.method = never ? "interval arithmetic" : "no proof";
  o.because = std::string(never ? "no inputs are seen to make" : "no inputs were found that make") +
              " true at once what is said by " + names + ", and asked for to return";
  o.repair = "conditions that do not exclude each other are needed";
  return o;
}

}  // namespace rtac::verify
