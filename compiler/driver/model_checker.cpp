#include "compiler/driver/model_checker.h"

#include <fstream>
#include <set>
#include <string>
#include <utility>

#include "compiler/driver/files.h"
#include "compiler/driver/process.h"

namespace rtac::driver {
namespace {

using protocol::Answer;

// What takes more is not known (docs/protocol.md says how much takes how long).
constexpr int seconds_max = 20, compiler_seconds_max = 120;  // for one claim, and before all
constexpr const char* memory_mb_max = "2000";
// Steps of a run. The stack for the most takes as long to clear as a small model to search.
constexpr const char* depth_first = "-m20000";
constexpr const char* depth_max = "-m1000000";
// A run that breaks a claim is told shorter where there is a short one.
constexpr const char* depth_of_story = "-m400";

// Millions of states: worth the time of the compiler, and in no need of a search that is too deep.
// Where recoveries are coordinated, fewer monitors have as many.
bool is_large(const protocol::Model& model) {
  return model.monitors > (model.coordinated ? 2 : 5);
}

class Checker {
 public:
  explicit Checker(const protocol::Model& model) : model_(model) {}

  std::vector<Answer> run() {
    std::string problem = folder_.problem().empty() ? build() : folder_.problem();
    std::vector<Answer> answers;
    for (const std::string& claim : model_.claim_names) {
      answers.push_back(problem.empty() ? ask(claim)
                                        : Answer{Answer::Kind::unknown, claim, problem});
      if (too_long_) problem = "spin is not asked, since it has not ended before";
    }
    return answers;
  }

 private:
  [[nodiscard]] std::string said() const { return read_file(path("said")).value_or(""); }
  [[nodiscard]] std::string path(const std::string& name) const {
    return folder_.path() + "/" + name;
  }
  [[nodiscard]] bool is_there(const std::string& name) const {
    return std::ifstream(path(name)).good();
  }
  // In the folder: spin and what it makes write where they stand.
  ProgramResult shell(const std::string& command, int seconds = seconds_max + 2) const {
    return run_within(seconds, {"sh", "-c", "cd \"$0\" && " + command, folder_.path()},
                      path("said"));
  }
  static std::string not_ended(const std::string& program, int seconds) {
    return program + " has not ended within " + std::to_string(seconds) + " s";
  }
  [[nodiscard]] std::string build() const {
    std::ofstream(path("m.pml"), std::ios::binary) << model_.text();
    const ProgramResult made = shell("spin -a m.pml");
    if (!made.started) {
      return made.problem == no_timeout ? made.problem
                                        : "`spin` is not installed (`apt-get install spin`)";
    }
    if (made.timed_out) return not_ended("spin", seconds_max);
    if (made.status != 0) return "spin does not read the model: " + told(said());
    if (!is_there("pan.c")) return "spin makes nothing of the model: " + told(said());
    // in two steps, of which a compiler that keeps what it has compiled can leave out the first
    const ProgramResult compiled =
        shell("${CC:-cc} -w -DMEMLIM=" + std::string(memory_mb_max) +
                  (is_large(model_) ? " -O2" : " -O0") + " -c pan.c && ${CC:-cc} -o pan pan.o",
              compiler_seconds_max);
    if (compiled.timed_out) return not_ended("the C compiler", compiler_seconds_max);
    if (compiled.started && compiled.status == 0 && is_there("pan")) return "";
    return "no C compiler (`$CC` or `cc`) works: " + told(said());
  }
  ProgramResult search(const char* depth, const std::string& claim) const {
    // it ends by itself, too, when this program has been killed
    return shell("timeout " + std::to_string(seconds_max) + " ./pan -a -w20 " + depth + " -N " +
                 claim);
  }
  [[nodiscard]] Answer ask(const std::string& claim) {
    constexpr const char* too_deep = "max search depth too small";
    ProgramResult result = search(is_large(model_) ? depth_max : depth_first, claim);
    if (!is_large(model_) && said().find(too_deep) != std::string::npos) {
      result = search(depth_max, claim);
    }
    const std::string text = said();
    const auto has = [&](const char* part) { return text.find(part) != std::string::npos; };
    if (!result.started || result.timed_out) {
      too_long_ = true;
      return {Answer::Kind::unknown, claim, not_ended("spin", seconds_max)};
    }
    if (has("errors: 0") && !has(too_deep) && !has("Search not completed")) {
      return {Answer::Kind::holds, claim};
    }
    if (!has("errors: 0") && has("errors: ")) {
      return {Answer::Kind::broken, claim, "", who_takes_turns(claim)};
    }
    return {Answer::Kind::unknown, claim, "spin has run out of memory or depth"};
  }
  // Who drives in the cycle of a run that breaks the claim.
  [[nodiscard]] std::set<std::string> who_takes_turns(const std::string& claim) const {
    (void)search(depth_of_story, claim);
    (void)shell("spin -t -T -B m.pml");
    const std::string text = said(), mark = "START OF CYCLE";
    std::size_t at = text.find(mark);
    std::set<std::string> names;
    while (at != std::string::npos) {
      at = text.find("` drives", at + 1);
      if (at == std::string::npos) break;
      const std::size_t begin = text.rfind('`', at - 1);
      names.insert(text.substr(begin + 1, at - begin - 1));
    }
    return names;
  }

  const protocol::Model& model_;
  TemporaryFolder folder_;
  bool too_long_ = false;  // as large as it is, the next claim takes as long
};

}  // namespace

std::vector<Answer> check_model(const protocol::Model& model) {
  return Checker(model).run();
}
std::vector<Answer> check_small_model(const protocol::Model& model) {
  return is_large(model) ? std::vector<Answer>() : check_model(model);
}

}  // namespace rtac::driver
