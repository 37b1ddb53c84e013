// From words to options; what is wrong with them is a text for the user.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rtac::driver {

enum class Command {
  check,
  build,
  replay,
  sim,
  verify,
  zones,
  protocol,
  format,
  explain,
  help,
  version
};
enum class Format { text, json, sarif };
enum class EngineKind { kernel, interp };

// What the monitors of a module, or those of one robot, may remember unless `--max-bytes` says
// otherwise: more than robots spare, and less than would fill the machine of a developer.
inline constexpr std::uint64_t state_bytes_max_default = std::uint64_t{256} << 20;

struct Options {
  Command command = Command::help;
  std::string spec;                     // path, or "-" for standard input
  std::string trace;                    // of `replay`: path, or "-"
  std::vector<std::string> help_flags;  // of the command that `help` is about
  std::string topic;  // of `help`: a command; of `explain`: number or name of a diagnostic,
  std::string line;   // or a line of `spec`, when `topic` is empty: digits
  std::string part;   // of `explain`: the line is of this file, which `spec` imports
  std::vector<std::string> files;  // of `fmt`: paths, or "-"
  std::string output;              // directory of `build` and `protocol`; of `zones`: path, or "-"
  std::string depfile;             // may be empty
  std::string name_space;          // may be empty: the name of the specification
  Format format = Format::text;
  bool colour = false;
  bool dump_ast = false, dump_spec = false, dump_ir = false;
  std::string print_after;  // name of a pass
  bool werror = false;
  bool only_check = false;  // of `fmt`
  bool offers = true;       // false: reports need not say with which numbers it would work
  EngineKind engine = EngineKind::kernel;        // of `replay`
  std::string monitor;                           // of `replay`; empty: all
  std::optional<std::uint64_t> state_bytes_max;  // memory that the monitors may take
  // Of `sim`; empty: its defaults.
  std::string scenario, seed, runs, jobs, adversary;
  std::string trace_out;      // where a run with a violation is written
  std::string recorded;       // a run that is played again
  std::string simulated;      // of `explain`: so many runs tell the share of advanced controllers
  std::string recheck;        // of `verify`: the directory of certificates
  std::string attack_s;       // of `verify`: so long runs are sought that show what is refuted
  std::string mutant;         // of `build`, `sim` and measures: a deliberately unsound variant
  bool conservatism = false;  // of `verify`: measure it
  bool contracts = false;     // of `build`: the kernel with contracts, too
};

struct UsageError {
  std::string message, help;  // what is wrong, what would work
};
std::variant<Options, UsageError> parse_options(const std::vector<std::string>& arguments);

}  // namespace rtac::driver
