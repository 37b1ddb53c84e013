#include "compiler/codegen/generate.h"

#include "compiler/codegen/kernel.h"
#include "compiler/codegen/manifest.h"
#include "compiler/codegen/names.h"
#include "compiler/codegen/system.h"

namespace rtac::codegen {

std::vector<GeneratedFile> generate(const ir::Module& module, const sema::Spec& spec,
                                    Naming naming) {
  if (naming.space.empty()) naming.space = legal(module.name);
  const std::string& stem = naming.stem;
  const Names names(module, spec);
  return {
      {stem + "_kernel.h", kernel_header(module, names, stem, naming.source)},
      {stem + "_kernel.c", kernel_source(module, names, stem, naming.source)},
      {stem + ".h", wrapper_header(module, spec, names, naming)},
      {stem + ".cpp", wrapper_source(module, spec, names, naming)},
      {stem + "_system.h", system_header(module, spec, names, naming)},
      {stem + "_manifest.json", manifest(module, spec, naming)},
  };
}

}  // namespace rtac::codegen
