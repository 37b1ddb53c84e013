// What a specification costs: time to compile it, code, tables and memory of its kernel.
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "drone_surveillance_kernel.h"
#include "robot_delivery_kernel.h"
#include "tests/bench/benchmarks.h"

namespace rtac::bench {
namespace {

struct Subject {
  const char* name;
  const char* spec;
  const char* object;  // of its kernel
  std::size_t state_bytes, in_bytes;
};
constexpr std::array<Subject, 2> subjects{{
    {"robot_delivery", RTAC_SPEC_DELIVERY, RTAC_OBJECT_DELIVERY,
     sizeof(robot_delivery_plan_executor_state), sizeof(robot_delivery_plan_executor_in)},
    {"drone_surveillance", RTAC_SPEC_DRONE, RTAC_OBJECT_DRONE,
     sizeof(drone_surveillance_plan_executor_state), sizeof(drone_surveillance_plan_executor_in)},
}};

// A directory of its own, gone at the end.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "rtac_bench_XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string quoted(const std::string& text) {
  return "'" + text + "'";
}

bool compile_ms(const Subject& subject, int repetitions, std::vector<double>& times) {
  const Scratch scratch;
  if (scratch.path().empty()) return false;
  const std::string command = quoted(RTAC_COMPILER) + " build " + quoted(subject.spec) + " -o " +
                              quoted(scratch.path()) + " > /dev/null";
  const std::string silent = command + " 2> /dev/null";  // of its notes, not of what goes wrong
  for (int i = 0; i <= repetitions; ++i) {
    const auto from = std::chrono::steady_clock::now();
    if (std::system(silent.c_str()) != 0) {
      (void)std::system(command.c_str());  // and says why
      return false;
    }
    const auto to = std::chrono::steady_clock::now();
    // the first run fills the caches of the file system
    if (i > 0) times.push_back(std::chrono::duration<double, std::milli>(to - from).count());
  }
  return true;
}

// Code and constant tables of an object file, as `size` finds them.
bool object_bytes(const char* object, double& code, double& tables) {
  const std::string command = "LC_ALL=C size -A -d " + quoted(object);
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return false;
  char line[300], section[200];
  double bytes = 0;
  code = tables = 0;
  while (std::fgets(line, sizeof line, pipe) != nullptr) {
    if (std::sscanf(line, "%199s %lf", section, &bytes) != 2) continue;
    const auto is = [&](const char* prefix) {
      return std::strncmp(section, prefix, std::strlen(prefix)) == 0;
    };
    if (is(".text")) code += bytes;
    if (is(".rodata") || is(".data")) tables += bytes;
  }
  return pclose(pipe) == 0 && code > 0;
}

}  // namespace

bool measure_compiler(const Effort& effort, Report& report) {
  report.section("Compiler and kernels");
  for (const Subject& subject : subjects) {
    const std::string name = subject.name;
    std::vector<double> times;
    double code = 0, tables = 0;
    if (!compile_ms(subject, effort.compile_repetitions, times)) {
      std::fprintf(stderr, "rtac_bench: cannot compile %s\n", subject.spec);
      return false;
    }
    if (!object_bytes(subject.object, code, tables)) {
      std::fprintf(stderr, "rtac_bench: cannot read the sizes of %s\n", subject.object);
      return false;
    }
    report.add("compile_" + name, name + ": rtac build", spread_of(times), "ms", 1);
    report.add("code_" + name, name + ": machine code of the kernel", code, "bytes", 0);
    report.add("tables_" + name, name + ": tables of the kernel", tables, "bytes", 0);
    report.add("state_" + name, name + ": state of a decision",
               static_cast<double>(subject.state_bytes), "bytes", 0);
    report.add("input_" + name, name + ": inputs of a decision",
               static_cast<double>(subject.in_bytes), "bytes", 0);
  }
  return true;
}

}  // namespace rtac::bench
