// What several monitors say of inputs, and ask for to let go: whether it can be so at once.
#include "compiler/support/words.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {

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
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    if (only && k != *only) continue;
    const sema::Monitor& m = s.monitor(k);
    (s.told.contains(k) ? alone : said).push_back(m.always.get());
    if (m.return_when) said.push_back(m.return_when.get());
    names += (names.empty() ? "" : ", ") + quoted(m.name);
  }
  // which side of an `or` a place has been found for, and which inputs, need not be the same
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    const sema::Monitor& m = s.monitor(k);
    if ((only && k != *only) || !m.return_when) continue;
    std::vector<const sema::Expr*> all = said;
    all.insert(all.end(), alone.begin(), alone.end());
    for (const sema::InputId input : analysis::beside_places(s.spec, *m.return_when)) {
      if (analysis::is_said_once(s.spec, all, input)) continue;
      o.status = Status::unknown;
      o.method = "no proof";
      o.because = "`return when` of " + quoted(m.name) + " asks for " + quoted(s.spec[input].name) +
                  " on one side of an `or`, for something else on another, and that input is "
                  "spoken of elsewhere, too";
      o.repair = "a `return when` without that `or` is needed";
      o.claims.clear();
      o.place_mm = {};
      return o;
    }
  }
  // else each can be so by itself
  if (alone.empty() && !analysis::share_inputs(s.spec, said)) return o;
  const analysis::Told told = analysis::told_at_once(s.spec, said, alone);
  if (told.can == analysis::CanBeTold::yes) {
    Claim claim{"at_once", {{"decision", s.decision.name}, {"inputs", values_of(s, told.inputs)}}};
    if (only) claim.values["monitor"] = s.decision.monitors[*only].name;
    if (!alone.empty()) claim.values["alone"] = names_of_told(s);
    if (!told.inputs.empty()) o.because += ", with " + told_text(s.spec, told.inputs);
    o.claims.push_back(std::move(claim));
    return o;
  }
  const bool never = told.can == analysis::CanBeTold::no;  // whatever was so before
  o.status = never ? Status::refuted : Status::unknown;
  o.method = never ? "interval arithmetic" : "no proof";
  o.because = std::string(never ? "no inputs are seen to make" : "no inputs were found that make") +
              " true at once what is said by " + names + ", and asked for to return";
  o.repair = "conditions that do not exclude each other are needed";
  o.claims.clear();
  o.place_mm = {};
  return o;
}

}  // namespace rtac::verify
