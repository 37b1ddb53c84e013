// At most n others: whoever does not surely fail the condition on everything within reach counts.
#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {

using namespace ir;

Expanded count(Expansion& expansion, const Atom& atom) {
  const auto* limit = std::get_if<Const>(&atom.from[atom.compare.a].op);
  const auto* others = std::get_if<CountOthers>(&atom.from[atom.compare.b].op);
  if (limit == nullptr || others == nullptr) {
    return expansion.refuse(atom.source,
                            "at least so many robots cannot be looked ahead, at most can", atom.to);
  }
  expansion.decides_in(Unit::robots);
  expansion.counting(true);
  auto body = std::make_unique<Block>();
  const ValueId fails = expansion.negated(*others->body, others->body->result, *body);
  body->result = add(*body, Not{fails}, atom.source);
  expansion.counting(false);
  const ValueId most =
      add_quantity(atom.to, Const{limit->value}, Unit::robots, atom.from[atom.compare.a].source);
  const ValueId counted = add_quantity(atom.to, CountOthers{std::move(body)}, Unit::robots,
                                       atom.from[atom.compare.b].source);
  return add(atom.to, AtLeast{most, counted, atom.compare.strict}, atom.source);
}

}  // namespace rtac::passes::lookahead
