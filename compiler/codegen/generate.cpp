#include "compiler/codegen/generate.h"

#include <utility>

#include "compiler/codegen/kernel.h"
#include "compiler/codegen/manifest.h"
#include "compiler/codegen/mutate.h"
#include "compiler/codegen/names.h"
#include "compiler/codegen/system.h"

namespace rtac::codegen {

std::vector<GeneratedFile> generate(ir::Module module, const sema::Spec& spec, Naming naming) {
  // C has no namespaces: the name of the module prefixes what the kernel declares. A namespace of
  // the user's choice takes its place, and tells the kernel's header from that of another module of
  // the same specification.
  const std::string& stem = naming.stem;
  std::string guard = stem;
  if (naming.space.empty()) {
    naming.space = legal_namespace(module.name);
  } else {
    module.name = naming.space;
    guard.insert(0, naming.space + "_");
  }
  const Names names(module, spec);
  std::string kernel = kernel_source(module, names, stem, naming.source);
  if (const Mutant* const mutant = find_mutant(naming.mutant); mutant != nullptr) {
    // Every file says where it comes from.
    naming.source += " with " + mark_of(*mutant);
    const auto decides = [&] {
      return kernel_source(module, names, stem, naming.source) +
             system_header(module, spec, names, naming);
    };
    const std::string sound = decides();
    mutate(*mutant, module);
    if (mutate(*mutant, decides()) == sound) return {};
    kernel = mutate(*mutant, kernel_source(module, names, stem, naming.source));
  }
  return {
      {stem + "_kernel.h", kernel_header(module, names, guard, naming.source)},
      {stem + "_kernel.c", std::move(kernel)},
      {stem + ".h", wrapper_header(module, spec, names, naming)},
      {stem + ".cpp", wrapper_source(module, spec, names, naming)},
      {stem + "_system.h", system_header(module, spec, names, naming)},
      {stem + "_manifest.json", manifest(module, spec, naming)},
  };
}

}  // namespace rtac::codegen
