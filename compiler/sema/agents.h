// Agents: what moves by itself and obeys no decision.
#pragma once

#include "compiler/sema/context.h"
#include "compiler/syntax/ast.h"

namespace rtac::sema {

// The agents that are declared, with the inputs that stand for them. The inputs that are declared
// as such have been checked.
void check_agents(Context& context);

// The agent of this name, or of this number in a group; otherwise reports what is wrong.
std::optional<AgentId> resolve_agent(Context& context, const syntax::Name& name,
                                     const syntax::Expr* number);

}  // namespace rtac::sema
