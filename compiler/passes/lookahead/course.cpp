// `ahead command`: under the commands that are known the robot reaches less than under any control;
// either bound suffices (theory, look-ahead under the commanded input).
#include <utility>

#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {

using namespace ir;

ValueId or_course(Expansion& expansion, ValueId any_control, Op course, const Atom& atom) {
  expansion.judges_commands();
  const ValueId known = add(atom.to, std::move(course), atom.source);
  return add(atom.to, Or{any_control, known}, atom.source);
}

}  // namespace rtac::passes::lookahead
