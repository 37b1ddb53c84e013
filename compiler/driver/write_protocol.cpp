#include "compiler/driver/write_protocol.h"

#include <string>
#include <utility>
#include <vector>

#include "compiler/driver/driver.h"
#include "compiler/driver/files.h"
#include "compiler/protocol/protocol.h"
#include "compiler/verify/turns.h"

namespace rtac::driver {
namespace {

int refuse(Compilation& c, diag::Code code, std::string message, std::string help) {
  c.diagnostics.report({code, std::nullopt, std::move(message), "", {}, std::move(help), {}});
  return exit_usage;
}

}  // namespace

int write_protocol(const Options& options, Compilation& c) {
  const bool piped = options.spec == "-";
  const std::string source =
      piped ? "standard input" : options.spec.substr(options.spec.find_last_of('/') + 1);
  std::vector<OutputFile> files;
  const auto turns = verify::turns_of(*c.spec, *c.module, c.tables);
  for (std::size_t n = 0; n < turns.size(); ++n) {
    const ir::Decision& d = c.module->decisions[n];
    const auto model = protocol::protocol_model(verify::protocol_subject(d), turns[n], source);
    files.push_back({options.output + "/" + d.name + ".pml", model.text()});
  }
  if (files.empty()) {
    return refuse(c, diag::Code::usage,
                  "`" + c.spec->name + "` has no decision, and so no protocol",
                  "a `decision` switches between controllers; `rtac check` says what monitors do");
  }
  std::string problem = write_all(files);
  if (problem.empty()) return exit_clean;
  return refuse(c, diag::Code::cannot_write, std::move(problem),
                "give a directory that can be written after `-o`");
}

}  // namespace rtac::driver
