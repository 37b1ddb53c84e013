// Who may take over from whom: what the model of the switching protocol knows of the recoveries of
// a decision.
#pragma once

#include <string>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/ir/table_map.h"
#include "compiler/protocol/protocol.h"
#include "compiler/sema/spec.h"

namespace rtac::verify {

protocol::Subject protocol_subject(const ir::Decision& decision);

// Of each decision of a module.
std::vector<protocol::Arbitration> turns_of(const sema::Spec& spec, const ir::Module& module,
                                            const ir::TableMap& tables);

}  // namespace rtac::verify
