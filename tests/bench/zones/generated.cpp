#include "tests/bench/zones/generated.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>

#include "compiler/codegen/kernel_library.h"
#include "compiler/driver/files.h"
#include "compiler/driver/process.h"
#include "compiler/driver/shared_object.h"

namespace rtac::bench {
namespace {

constexpr const char* specification = R"(// A place against a zone that was read from a file.
spec fenced;
period 100 ms;
zone fence = import "fence.wkt" in m;
input place : point in -500000 .. 500000 m max_age 500 ms;
monitor within { "Z-1" always place inside fence; }
monitor clear { "Z-2" always clearance(place, fence) >= 5 m; }
)";

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string first_line(const std::string& path) {
  const std::string text = content(path);
  return text.substr(0, text.find('\n'));
}

// The first word behind `before`, which ends at a blank.
std::string word_after(const std::string& text, const std::string& before) {
  const std::size_t at = text.find(before);
  if (at == std::string::npos) return "";
  const std::size_t from = at + before.size();
  return text.substr(from, text.find(' ', from) - from);
}

// Of the library of the kernel, what this kernel does not have: it asks nothing about legs.
std::string missing_library(const std::string& kernel) {
  std::set<std::string> wanted{"inside_zone", "boundary_gap_lo", "segment_boundary_lo"};
  // Zones of many edges are of another kind.
  if (kernel.find("*cells") != std::string::npos) wanted.insert("cells");
  const std::string all = codegen::kernel_library(wanted, "fenced");
  std::string missing;
  for (std::size_t from = 0; from < all.size();) {  // parts end in an empty line
    const std::size_t end = std::min(all.find("\n\n", from), all.size());
    const std::string part = all.substr(from, end - from);
    from = end + 2;
    // Known by its first line of code: the rest may depend on what else the kernel needs.
    const std::size_t code = std::min(part.find("typedef "), part.find("static "));
    if (code == std::string::npos) continue;
    const std::string head = part.substr(code, part.find('\n', code) - code);
    if (kernel.find(head) == std::string::npos) missing += part + "\n\n";
  }
  return missing;
}

// All places in a loop, in the same file as the kernel: its functions are used as a step uses them.
std::string glue(const std::string& kernel) {
  const std::string zone = word_after(kernel, "static const zone ");
  if (zone.empty()) return "";
  const std::string loop = "  int64_t sum = 0, i;\n  for (i = from; i < end; ++i) {\n";
  const std::string head = "(const int32_t *p, int64_t from, int64_t end) {\n" + loop;
  const std::string tail = "  }\n  return sum;\n}\n";
  return "#include \"fenced_kernel.c\"\n" + missing_library(kernel) +  //
         "int64_t ask_inside" + head +                                 //
         "    sum += inside_zone(&" + zone + ", vec_of(p[2 * i], p[2 * i + 1]));\n" + tail +
         "int64_t ask_clearance" + head +  //
         "    sum += boundary_gap_lo(&" + zone + ", vec_of(p[2 * i], p[2 * i + 1]));\n" + tail +
         "int64_t ask_leg" + head +                                //
         "    const int64_t gap = segment_boundary_lo(&" + zone +  //
         ", vec_of(p[4 * i], p[4 * i + 1]), vec_of(p[4 * i + 2], p[4 * i + 3]));\n"
         "    sum += gap > 0 ? gap : 0;\n" +
         tail;
}

using Ask = std::int64_t (*)(const std::int32_t*, std::int64_t, std::int64_t);

struct Loaded {
  driver::SharedObject object;
  Ask asks[3];
};

Contender contender_of(const std::shared_ptr<Loaded>& loaded, Question question,
                       const std::vector<GridPlace>& places) {
  const auto kept = std::make_shared<std::vector<GridPlace>>(places);
  static_assert(sizeof(GridPlace) == 2 * sizeof(std::int32_t));
  const Ask ask = loaded->asks[static_cast<std::size_t>(question)];
  return {"rtac", [loaded, ask, kept](std::size_t first, std::size_t end) {
            return static_cast<double>(ask(&kept->data()->x_mm, static_cast<std::int64_t>(first),
                                           static_cast<std::int64_t>(end)));
          }};
}

std::shared_ptr<Loaded> load(const std::string& path) {
  const auto loaded = std::make_shared<Loaded>(Loaded{driver::SharedObject(path), {}});
  if (!loaded->object) return nullptr;
  const char* const names[] = {"ask_inside", "ask_clearance", "ask_leg"};
  for (std::size_t i = 0; i < 3; ++i) loaded->asks[i] = loaded->object.function<Ask>(names[i]);
  return loaded;
}

// Bytes of constant data, as `size` finds them.
double constant_bytes(const std::string& object) {
  std::FILE* const pipe = popen(("LC_ALL=C size -A -d '" + object + "'").c_str(), "r");
  if (pipe == nullptr) return 0;
  char line[300], section[200];
  double all = 0, bytes = 0;
  while (std::fgets(line, sizeof line, pipe) != nullptr) {
    if (std::sscanf(line, "%199s %lf", section, &bytes) != 2) continue;
    if (std::strncmp(section, ".rodata", 7) == 0 || std::strncmp(section, ".data", 5) == 0) {
      all += bytes;
    }
  }
  pclose(pipe);
  return all;
}

}  // namespace

std::unique_ptr<Generated> generate(const Outline& outline, std::string& problem) {
  const driver::TemporaryFolder folder;
  problem = folder.problem();
  if (!problem.empty()) return nullptr;
  const std::string at = folder.path() + "/";
  problem = driver::write_all(
      {{at + "fence.wkt", well_known_text(outline)}, {at + "fenced.rta", specification}});
  if (!problem.empty()) return nullptr;
  auto made = std::make_unique<Generated>();
  if (!measure_program({RTAC_COMPILER, "build", at + "fenced.rta", "-o", folder.path()}, at + "log",
                       made->rtac)) {
    problem = "rtac does not compile it: " + first_line(at + "log");
    return nullptr;
  }
  const std::string text = glue(content(at + "fenced_kernel.c"));
  problem = text.empty() ? "its kernel has no zone" : driver::write_all({{at + "glue.c", text}});
  if (!problem.empty()) return nullptr;
  // As an application compiles its kernel.
  if (!measure_program({"cc", "-std=c99", "-O2", "-w", "-shared", "-fPIC", "-o", at + "fenced.so",
                        at + "glue.c"},
                       at + "log", made->c_compiler)) {
    problem = "cc does not compile its kernel: " + first_line(at + "log");
    return nullptr;
  }
  made->table_bytes = constant_bytes(at + "fenced.so");
  const std::shared_ptr<Loaded> loaded = load(at + "fenced.so");
  if (!loaded) {
    problem = "its kernel cannot be loaded";
    return nullptr;
  }
  made->contender = [loaded](Question question, const std::vector<GridPlace>& places) {
    return contender_of(loaded, question, places);
  };
  return made;
}

}  // namespace rtac::bench
