// Runs the model checker `spin` in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "compiler/driver/compile.h"
#include "compiler/protocol/protocol.h"
#include "compiler/verify/turns.h"

namespace rtac::protocol::test {

namespace fs = std::filesystem;

inline std::string said_by(const std::string& command) {
  std::string said;
  std::FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return "cannot be started";
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
    said.append(part.data(), n);
  }
  (void)pclose(pipe);
  return said;
}

class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "rtac_protocol_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string run(const std::string& command) const {
    return said_by("cd " + path_ + " && " + command);
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(fs::path(path_) / name, std::ios::binary) << text;
  }
  [[nodiscard]] bool has(const std::string& name) const {
    return fs::exists(fs::path(path_) / name);
  }

 private:
  std::string path_;
};

// A model whose claims are asked one by one.
class Checker {
 public:
  explicit Checker(const std::string& model) {
    folder_.write("m.pml", model);
    said_ = folder_.run("spin -a m.pml && cc -O0 -w -DMEMLIM=1024 -o pan pan.c");
  }
  // "holds", the story of a run that breaks it, a short one if there is, or what went wrong.
  std::string ask(const std::string& claim) {
    const std::string found = search("200000", claim);
    const bool complete = found.find("max search depth too small") == std::string::npos &&
                          found.find("Search not completed") == std::string::npos;
    if (complete && found.find("errors: 0") != std::string::npos) return "holds";
    if (!folder_.has("m.pml.trail")) return said_ + found;
    const std::string story = told();
    for (const char* const steps : {"100", "400"}) {
      (void)search(steps, claim);
      if (folder_.has("m.pml.trail")) return told();
    }
    return story;
  }

 private:
  [[nodiscard]] std::string search(const std::string& steps, const std::string& claim) const {
    return folder_.run("./pan -a -m" + steps + " -N " + claim);
  }
  [[nodiscard]] std::string told() const {
    const std::string story = folder_.run("spin -t -T -B m.pml");
    (void)folder_.run("rm -f m.pml.trail");
    return story;
  }
  Folder folder_;
  std::string said_;
};

// The text with one place replaced, which has to be there, once.
inline std::string planted(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  EXPECT_EQ(text.find(from, at + 1), std::string::npos) << from << " is there twice";
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// Of all pairs, but of those that the specification acknowledges.
inline Arbitration assumed(const ir::Decision& d) {
  const std::size_t count = d.monitors.size();
  Table rows(count, std::vector<bool>(count, true));
  for (const ir::Acknowledgement& a : d.acknowledgements) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        if (d.monitors[i].recovery.name == a.recovery && d.monitors[j].name == a.monitor) {
          rows[i][j] = false;
        }
      }
    }
  }
  return {rows, rows};
}
inline Model model_of(const ir::Decision& d, const Arbitration& arbitration) {
  return protocol_model(verify::protocol_subject(d), arbitration, "test.rta");
}

// The decision of a specification, by its path in the repository.
inline ir::Decision decision_of(const std::string& spec, const std::string& name) {
  driver::Options options;
  options.command = driver::Command::check;
  options.spec = std::string(RTAC_SOURCE_DIR) + "/" + spec;
  driver::Compilation c;
  std::ostringstream out;
  driver::compile(options, out, c);
  EXPECT_FALSE(c.diagnostics.has_errors()) << spec;
  for (ir::Decision& d : c.module->decisions) {
    if (d.name == name) return std::move(d);
  }
  ADD_FAILURE() << spec << " has no decision " << name;
  return {};
}

}  // namespace rtac::protocol::test
