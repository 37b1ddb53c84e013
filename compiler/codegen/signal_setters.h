// The methods of a generated class that take plain inputs and parameters: of the monitors without a
// robot, and of decisions.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "compiler/codegen/code.h"
#include "compiler/codegen/names.h"
#include "compiler/codegen/watch.h"
#include "compiler/ir/module.h"

namespace rtac::codegen {

class SignalSetters {
 public:
  struct Places {
    std::string type;       // the class
    std::string in, state;  // what leads to the members of the kernel: `in_.`, `state_.`
  };
  // `taken`: methods and members that the class has anyway.
  SignalSetters(const ir::Watch& watch, const Names& names, Places places,
                std::set<std::string> taken);

  void declare(Code& body) const;
  void define(Code& out) const;
  // Parameters start with their first values.
  void first_values(Code& body) const;
  // The lines of `reset`, which forget everything, but not how tight a parameter is.
  void keep_params(Code& body, const std::function<void()>& reset) const;

 private:
  // What a method takes, and how a component of that is said.
  struct Setter {
    std::string name, type;
    std::vector<std::string> values;  // by component
    std::string edges_most;           // constant of a zone that is received
  };
  // Names of methods differ from each other and from those that every class has.
  std::string method(const std::string& name);
  Setter setter(std::size_t channel);
  void declare_constants(Code& body) const;
  void define_input(std::size_t index, Code& out) const;
  void define_param(std::size_t k, Code& out) const;

  const ir::Watch& watch_;
  const Names& names_;
  const WatchNames members_;
  const Places places_;
  std::set<std::string> taken_;
  std::vector<Setter> setters_;
  std::vector<std::string> params_;
  std::string latitude_, longitude_;  // constants, where zones are received
};

// The enumerations that inputs of the module have, each once.
void print_choices(const ir::Module& module, const Names& names, Code& out);

}  // namespace rtac::codegen
