// What several monitors say of inputs, and ask for to let go: whether it can be so at once.
#include "compiler/analysis/limits.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/sema/visit.h"
#include "compiler/support/words.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {

analysis::SeenAtRest seen_at_rest(const Subject& s, const ir::Motion& motion) {
  constexpr long ppm = 1'000'000;
  return {Rational(static_cast<long>(analysis::shown_speed_mmps(s.decision, motion)), 1000),
          Rational(static_cast<long>(analysis::shown_full_ppm(s.decision.body)), ppm)};
}

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

// As far as a monitor looks ahead; none: it does not.
std::optional<analysis::SeenAtRest> ahead_at_rest(const Subject& s, std::size_t k) {
  const ir::Lookahead& ahead = s.decision.monitors[k].lookahead;
  if (!ahead.duration) return std::nullopt;
  analysis::SeenAtRest seen = seen_at_rest(s, s.decision.motions.front());
  seen.speed =
      Rational(static_cast<long>(analysis::fastest_from_rest(s.decision, ahead.duration_us)), 1000);
  return seen;
}
// What is told, or asks for no more than a robot at rest has.
bool is_choice_at_rest(const sema::Spec& spec, const sema::Expr& e) {
  return (sema::speaks_of_speed(e) || sema::speaks_of_charge(e)) && analysis::is_told(spec, e);
}
// What monitors say and ask for to return.
struct Said {
  std::vector<analysis::ToHold> all;
  std::vector<const sema::Expr*> alone;  // what inputs have to make true by themselves
  std::string names, torn;               // of monitors; `torn`: of one with an `or` of both
  bool without_places = false;
  bool is_needed =
      false;  // else each can be so by itself, as is asked of what is said (satisfiable)
};
Said said_by(const Subject& s, std::optional<std::size_t> only) {
  Said found;
  std::vector<const sema::Expr*> plain;
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    if (only && k != *only) continue;
    const sema::Monitor& m = s.monitor(k);
    found.names += (found.names.empty() ? "" : ", ") + quoted(m.name);
    if (s.told.contains(k)) {
      found.alone.push_back(m.always.get());
      found.without_places = true;
    } else {
      found.all.push_back({m.always.get(), ahead_at_rest(s, k)});
      plain.push_back(m.always.get());
      found.is_needed = found.is_needed || is_choice_at_rest(s.spec, *m.always);
    }
    if (!m.return_when) continue;
    found.all.push_back({m.return_when.get(), seen_at_rest(s, s.decision.motions[k + 1])});
    plain.push_back(m.return_when.get());
    found.is_needed = found.is_needed || analysis::is_told(s.spec, *m.return_when);
    // which side of an `or` a place has been found for, and which inputs, need not be the same
    const auto at_rest = [&](const sema::Expr& part) { return is_kept_at_rest(s, k, part); };
    const auto parts = analysis::torn_parts(s.spec, *m.return_when, at_rest);
    found.alone.insert(found.alone.end(), parts.begin(), parts.end());
    if (found.torn.empty() && !parts.empty()) found.torn = m.name;
  }
  found.is_needed =
      found.is_needed || !found.alone.empty() || analysis::share_inputs(s.spec, plain);
  return found;
}

// Inputs may allow what is asked for of speeds and charges, and a robot at rest has not got it.
Obligation not_at_rest(const Subject& s, std::optional<std::size_t> only, const std::string& names,
                       analysis::CanBeTold can, Obligation o) {
  const bool never = can == analysis::CanBeTold::no;
  o.status = never ? Status::refuted : Status::unknown;
  o.method = never ? "interval arithmetic" : "no proof";
  std::int64_t mmps = 0;
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    if (only && k != *only) continue;
    const auto ahead = ahead_at_rest(s, k);
    if (!ahead || !sema::speaks_of_speed(*s.monitor(k).always)) continue;
    mmps = std::max<std::int64_t>(mmps, ceil_to_int(Rational(ahead->speed * 1000)));
  }
  o.because = std::string(never ? "there are no inputs" : "no inputs were found") +
              " with which a robot at rest is slow enough, and charged, for what is said by " +
              names + ", and asked for to return";
  if (mmps > 0) {
    const std::string least = to_decimal(Rational(static_cast<long>(mmps), 1000)) + " m/s";
    o.because += ": it may be taken for one of " + least;
    o.repair = "limits of at least " + least + " for some inputs are needed";
  }
  return o;
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
  Said said = said_by(s, only);
  if (!said.is_needed) return o;
  const analysis::Told told = analysis::told_at_once(s.spec, said.all, said.alone);
  if (told.can == analysis::CanBeTold::yes) {
    Claim claim{"at_once", {{"decision", s.decision.name}, {"inputs", values_of(s, told.inputs)}}};
    if (only) claim.values["monitor"] = s.decision.monitors[*only].name;
    if (said.without_places) claim.values["alone"] = names_of_told(s);
    if (!told.inputs.empty()) o.because += ", with " + told_text(s.spec, told.inputs);
    o.claims.push_back(std::move(claim));
    return o;
  }
  o.claims.clear();
  o.place_mm = {};
  if (!said.torn.empty()) {
    o.status = Status::unknown;
    o.method = "no proof";
    o.because = "`return when` of " + quoted(said.torn) +
                " asks for inputs on one side of an `or`, and for something else on another, and "
                "no inputs were found that make it true by themselves";
    o.repair = "a `return when` without that `or` is needed";
    return o;
  }
  for (analysis::ToHold& each : said.all) each.at_rest.reset();
  if (analysis::told_at_once(s.spec, said.all, said.alone).can == analysis::CanBeTold::yes) {
    return not_at_rest(s, only, said.names, told.can, std::move(o));
  }
  const bool never = told.can == analysis::CanBeTold::no;  // whatever was so before
  o.status = never ? Status::refuted : Status::unknown;
  o.method = never ? "interval arithmetic" : "no proof";
  o.because = std::string(never ? "no inputs are seen to make" : "no inputs were found that make") +
              " true at once what is said by " + said.names + ", and asked for to return";
  o.repair = "conditions that do not exclude each other are needed";
  return o;
}

}  // namespace rtac::verify
