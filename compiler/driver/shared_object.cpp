#include "compiler/driver/shared_object.h"

#include <dlfcn.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "compiler/driver/files.h"
#include "compiler/driver/process.h"

namespace rtac::driver {
namespace {

// $CC may name a compiler with arguments.
std::vector<std::string> compiler() {
  const char* const chosen = std::getenv("CC");
  std::istringstream words(chosen == nullptr ? "" : chosen);
  std::vector<std::string> command{std::istream_iterator<std::string>(words), {}};
  if (command.empty()) command.emplace_back("cc");
  return command;
}

constexpr int object_seconds_max = 600;  // of the largest tables, on a slow machine

// Empty when all is well.
std::string compile(const std::string& folder) {
  std::vector<std::string> command = compiler();
  const std::string name = command.front();
  for (const char* word : {"-std=c99", "-O1", "-shared", "-fPIC", "-o"}) command.emplace_back(word);
  command.push_back(folder + "/kernel.so");
  command.push_back(folder + "/glue.c");
  const std::string log = folder + "/log";
  const ProgramResult compiled = run_within(object_seconds_max, command, log);
  if (!compiled.started) {
    return "the C compiler `" + name + "` cannot be started: " + compiled.problem;
  }
  if (compiled.timed_out) {
    return "`" + name + "` has not ended within " + std::to_string(object_seconds_max) + " s";
  }
  const std::string said = told(read_file(log).value_or(""));
  if (compiled.status != 0) {
    return "`" + name + "` does not compile the generated kernel: " + said;
  }
  if (std::ifstream(folder + "/kernel.so").good()) return "";
  return "`" + name + "` makes nothing of the generated kernel: " + said;
}

}  // namespace

SharedObject::SharedObject(const std::string& path) : handle_(::dlopen(path.c_str(), RTLD_NOW)) {}
SharedObject::SharedObject(SharedObject&& other) noexcept
    : handle_(std::exchange(other.handle_, nullptr)) {}
SharedObject::~SharedObject() {
  if (handle_ != nullptr) ::dlclose(handle_);
}
void* SharedObject::symbol(const char* name) const {
  return ::dlsym(handle_, name);
}

std::string compile_object(const std::vector<OutputFile>& files, const std::string& glue,
                           const std::string& folder) {
  std::vector<OutputFile> sources{{folder + "/glue.c", glue}};
  for (const OutputFile& file : files) sources.push_back({folder + "/" + file.path, file.text});
  if (std::string problem = write_all(sources); !problem.empty()) return problem;
  return compile(folder);
}

BuiltObject build_object(const std::vector<OutputFile>& files, const std::string& glue) {
  const TemporaryFolder folder;
  if (!folder.problem().empty()) return {std::nullopt, folder.problem()};
  if (std::string problem = compile_object(files, glue, folder.path()); !problem.empty()) {
    return {std::nullopt, problem};
  }
  SharedObject object(folder.path() + "/kernel.so");
  if (!object) return {std::nullopt, std::string("the kernel cannot be loaded: ") + ::dlerror()};
  return {std::move(object), ""};
}

}  // namespace rtac::driver
