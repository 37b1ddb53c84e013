// The canonical text of the IR: `--dump-ir`, goldens.
#pragma once

#include <string>

#include "compiler/ir/module.h"

namespace rtac::ir {

std::string print(const Module& module);
// "position": as specifications and generated code say it.
const char* word_of(Sensed signal);
// Ends with a line break; values are indented by `indent`. `watch`: whose inputs and parameters the
// block uses; null: none.
std::string print(const Module& module, const Watch* watch, const Block& block,
                  const std::string& indent);

}  // namespace rtac::ir
