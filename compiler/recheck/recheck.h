// Checks what `rtac verify` has written, from the specification and from the claims alone: every
// obligation is there, what is called acknowledged is acknowledged, and what is called proved rests
// on the claims that it needs, each of which is true. What is called refuted or unknown claims
// nothing: it is told, and never counts as shown. Knows nothing of how claims were found.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/protocol/protocol.h"
#include "compiler/sema/spec.h"
#include "compiler/support/source.h"

namespace rtac::recheck {

// nullopt: true; else why it is not, or why nobody can tell.
struct Doubt {
  bool refuted = true;
  std::string why;
};
using ProveLemma = std::function<std::optional<Doubt>(const std::string& name)>;
// That the model that was written is this one, and that its claims hold.
using ProveModel = std::function<std::optional<Doubt>(const protocol::Model& model)>;
struct Provers {
  ProveLemma lemma;
  ProveModel model;
};

struct Outcome {
  int obligations = 0, claims = 0;
  std::vector<std::string> failed, open;      // what is wrong, and what nobody could tell
  std::vector<std::string> refuted, unknown;  // obligations that the report leaves so
};
// `report`: the text of verification.json.
Outcome recheck(const sema::Spec& spec, const SourceManager& sources, const std::string& report,
                const Provers& provers);

}  // namespace rtac::recheck
