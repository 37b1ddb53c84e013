#include "compiler/driver/help.h"

#include <algorithm>

namespace rtac::driver {
namespace {

struct FlagText {
  const char *flag, *value, *text;
  const char* command = nullptr;  // the only one that it is about; none: all that have the flag
};
// In the order in which they are listed. A text may have several lines.
constexpr FlagText flag_texts[] = {
    {"-o", "DIR", "directory of the generated files; made when it is not there", "build"},
    {"-o", "DIR",
     "where the certificates go, with the run that shows a refutation; made when it is not there.\n"
     "Without it such a run goes to the specification's name with .trace",
     "verify"},
    {"-o", "FILE", "the picture; - is standard output", "zones"},
    {"-o", "DIR", "directory of the models; made when it is not there", "protocol"},
    {"--recheck", "DIR",
     "check what was written with `-o DIR` instead, by other means; needs z3, spin"},
    {"--attack", "SECONDS",
     "of processor time in which runs are sought that show what is refuted; default: 12"},
    {"--conservatism", "",
     "measure how much of what each monitor keeps free the worst admissible control, error and\n"
     "latency that is found reaches; more than all of it is a refutation. Takes seconds"},
    {"--namespace", "NAME",
     "C++ namespace of the generated code; default: the specification's name"},
    {"--depfile", "FILE", "write the dependencies for make or ninja"},
    {"--engine", "kernel|interp",
     "run the generated code (default; needs a C compiler, $CC or cc),\n"
     "or the reference interpreter on exact numbers"},
    {"--monitor", "NAME", "the findings of one monitor only"},
    {"--contracts", "",
     "write STEM_proof.c, too: the kernel with contracts for Frama-C, see `./dev prove`"},
    {"--check", "", "change nothing; name the files that are not in the layout, exit 1 then"},
    {"--max-bytes", "N",
     "refuse monitors that remember more, those without a robot or of one robot;\n"
     "default: 268435456"},
    {"--scenario", "FILE", "duration, starts, adversaries, noise, ages of samples, faults: JSON"},
    {"--seed", "N", "of the first run; the next runs have the numbers after it; default: 1"},
    {"--runs", "N", "how many; default: 100"},
    {"--jobs", "N", "how many of them are played at once; default: 1"},
    {"--adversary", "NAME", "only this one; default: all in turn"},
    {"--trace", "FILE",
     "where the first run with a violation is written; default: the specification's name with\n"
     ".trace"},
    {"--replay", "FILE", "play a recorded run again instead"},
    {"--in", "SPEC",
     "FILE is imported by this specification, or by what it imports: the line is explained as a\n"
     "part of it; - is standard input"},
    {"--simulate", "N",
     "simulate each decision N times, too, as `rtac sim` does, and tell how much of the time its\n"
     "advanced controller had, and how far that is from what is predicted; needs a C compiler"},
    {"--mutate", "NAME",
     "a deliberately unsound variant, for tests of tests: its code says so in every file; an\n"
     "unknown NAME lists them"},
    {"-Werror", "", "warnings count as errors"},
    {"--format", "text|json|sarif", "form of the diagnostics on standard error"},
    {"--dump-ast", "", "print the tree instead of the summary"},
    {"--dump-spec", "", "print the checked specification"},
    {"--dump-ir", "", "print the decision IR after all passes"},
    {"--print-after", "PASS", "print the IR after that pass"},
};

struct CommandText {
  const char *name, *usage, *about, *examples, *exit_codes;
};
constexpr const char* spec_codes =
    "  0  no errors\n"
    "  1  the specification has errors, or warnings with -Werror\n"
    "  2  usage, or a file that cannot be read or written\n"
    "  70 a bug of rtac\n";
constexpr CommandText command_texts[] = {
    {"check", "rtac check SPEC [FLAG...]",
     "Checks a specification and prints what was derived: monitors with their memory and\n"
     "operations; of robots, look-ahead, horizons and clearances. Writes no files.\n"
     "SPEC is the path of a .rta file, or - for standard input.\n",
     "  rtac check door.rta\n"
     "  rtac check door.rta -Werror --max-bytes 4096\n"
     "  rtac check door.rta --format json 2>reports.json\n",
     spec_codes},
    {"build", "rtac build SPEC -o DIR [FLAG...]",
     "Checks a specification and writes its code into DIR. Of door.rta:\n"
     "  door_kernel.h, door_kernel.c  the monitors on integers, C99, without dependencies\n"
     "  door.h, door.cpp              the same in C++17, with doubles in SI units\n"
     "  door_system.h                 the runtime of robots: modules, periods, controllers\n"
     "  door_manifest.json            what was derived\n"
     "All files are written, or none. SPEC is the path of a .rta file, or - for standard input.\n",
     "  rtac build door.rta -o generated\n"
     "  rtac build door.rta -o generated --namespace front_door --depfile door.d\n",
     spec_codes},
    {"replay", "rtac replay SPEC TRACE [FLAG...]",
     "Judges a recorded trace and prints a row a tick as CSV: `tick,time`, and verdict (`true`,\n"
     "`false`, `unknown`), margin and unit of every monitor. SPEC is the path of a .rta file, "
     "TRACE\n"
     "of a .csv file; one of them may be - for standard input.\n"
     "\n"
     "A trace has a line of names, `time,<input>,...` (components `p.x`, `temps.2`), and a row a "
     "tick:\n"
     "seconds; numbers in SI units, a ratio of 1 is 100 %; `true`, `false`, 1, 0; values of\n"
     "enumerations; `nan` and `inf` are unknown; an empty cell is no new sample. A row is the "
     "step\n"
     "of the tick that is nearest to its time, the earlier of two; what further rows of that tick\n"
     "bring counts at the next one, and a tick without a row is missed. Of robots that no "
     "decision\n"
     "is about only the columns that monitors use are needed, `one.battery`; others of them may "
     "be\n"
     "there and are ignored.\n"
     "\n"
     "Decisions with a period are replayed as well. Of each robot the trace has all that its kind\n"
     "senses, `r1.position.x`, `r1.velocity.y`, `r1.heading`, `r1.battery`, and its plan, "
     "`r1.plan`:\n"
     "way-points `1 2; 3.5 2`, or `none`, with the next of them, from 0, in `r1.plan.index`. A "
     "sample\n"
     "is as old as its row. The findings have of every monitor verdict, margin and unit of its "
     "property\n"
     "now, and the verdict of its `return when`, if it has one, as `walls.return`. The kernel adds "
     "the\n"
     "look-ahead, `ahead`, with its margin and unit; then who drives, `mode`, and `monitor` and "
     "`reason`\n"
     "of that: `--engine interp` has none of these. With several robots all of it follows their "
     "names:\n"
     "`r1.mode`. Robots hear what the others sense, and nobody promises to stay.\n"
     "\n"
     "Of decisions `on plan` each row with a new plan, `r1.plan`, is a proposal, judged whenever "
     "it "
     "comes:\n"
     "verdict, margin and unit, then who plans, and why; there is no `ahead`. The column of the "
     "plan "
     "may\n"
     "stand alone. Where the robot has a decision with a period as well, `plan.mode`, "
     "`plan.monitor` and\n"
     "`plan.reason` say so; without any period `tick` counts proposals, and before the first one "
     "cells are\n"
     "empty.\n"
     "\n"
     "With several periods a row is printed at a tick of any of them; `tick` counts the shortest, "
     "and of\n"
     "what is not due in a row stands what it found last. Both engines print the same rows, and "
     "find the\n"
     "same but where the look-ahead, or a bound of the generated code, leaves open what exact "
     "numbers\n"
     "decide, and for `energy_to`, of which the interpreter knows no upper bound.\n",
     "  rtac replay door.rta monday.csv >findings.csv\n"
     "  rtac replay door.rta monday.csv --engine interp --monitor shut\n"
     "  zcat monday.csv.gz | rtac replay door.rta -\n",
     "  0  no monitor was false\n"
     "  1  the specification has errors\n"
     "  2  usage, or a file or trace that cannot be used\n"
     "  3  a monitor was false in the trace; what is ahead does not count\n"
     "  70 a bug of rtac\n"},
    {"sim", "rtac sim SPEC [FLAG...]",
     "Simulates the robots of a specification under attack and prints a table: violations of the\n"
     "properties by the true state, the least margins with their seeds, who drives, how much of "
     "the\n"
     "time the advanced controller has beside what is predicted, and how often control changes. "
     "The\n"
     "decisions run as compiled code; advanced controllers are replaced by adversaries that know\n"
     "everything, measurements are as false, old and lossy as is declared.\n"
     "Runs are the same on every machine. Adversaries: `bang-bang`, `chase-fence`, `chase-robot`,\n"
     "`drain`, `follow-plans`, `aimed-noise`, `fresh-samples`, `unequal-samples`,\n"
     "`wandering-samples`, `drop-outs`, `lasting-errors`, `gusts`, and only when it is named\n"
     "`push-at-fence`.\n"
     "\n"
     "The first run with a violation is written to a file, which `--replay` plays again to the "
     "last\n"
     "bit. Needs a C compiler, $CC or cc. SPEC is the path of a .rta file, or - for standard "
     "input.\n",
     "  rtac sim delivery.rta\n"
     "  rtac sim delivery.rta --runs 2000 --adversary chase-robot\n"
     "  rtac sim delivery.rta --scenario corner.json --seed 7 --runs 1 --trace corner.trace\n"
     "  rtac sim delivery.rta --replay corner.trace\n",
     "  0  no property was violated\n"
     "  1  the specification has errors, or warnings with -Werror\n"
     "  2  usage, or a file that cannot be used\n"
     "  3  a property was violated\n"
     "  4  it cannot be simulated, or a run that is played again is another one\n"
     "  70 a bug of rtac\n"},
    {"verify", "rtac verify SPEC [FLAG...]\n       rtac verify --recheck DIR",
     "Says what the decisions of a specification need so that they keep what their monitors say, "
     "and\n"
     "how far each of it is shown: P1a to P3 of RTA modules for every monitor, whether its "
     "recovery\n"
     "keeps what the others say, whether there is a place where control can be given back, and "
     "whether\n"
     "recoveries take over from each other for ever, which the model checker spin is asked. Each "
     "is\n"
     "proved, acknowledged by the specification, unknown, or refuted, with how and why. With -o "
     "the\n"
     "proofs are written as certificates, which --recheck checks by other means, with z3 and spin. "
     "SPEC\n"
     "is the path of a .rta file, or - for standard input. --format json is the form of the "
     "report, too.\n",
     "  rtac verify delivery.rta\n"
     "  rtac verify delivery.rta --format json -o certificates\n"
     "  rtac verify delivery.rta --conservatism\n"
     "  rtac verify --recheck certificates\n",
     "  0  everything is proved or acknowledged, and with --recheck every certificate is one\n"
     "  1  the specification has errors that no obligation is about\n"
     "  2  usage, or a file that cannot be read or written\n"
     "  3  an obligation is refuted; with --recheck also: a certificate is none\n"
     "  4  an obligation is unknown; with --recheck also: z3 or spin is missing, or does not end "
     "in\n"
     "     time\n"
     "  70 a bug of rtac\n"},
    {"zones", "rtac zones SPEC -o FILE [FLAG...]",
     "Draws the zones of a specification as SVG, with a scale: every zone that has a name, where "
     "it\n"
     "is declared and how; the places that the checks leave of it, at the distance of a robot's\n"
     "body, of its ways and of the return of control; and the sites. Circles are drawn as the\n"
     "polygons that stand for them. SPEC is the path of a .rta file, or - for standard input.\n",
     "  rtac zones yard.rta -o zones.svg\n"
     "  rtac zones yard.rta -o - >zones.svg\n",
     spec_codes},
    {"protocol", "rtac protocol SPEC -o DIR [FLAG...]",
     "Writes how controllers are switched, of each decision as a model for the checker `spin`:\n"
     "DIR/DECISION.pml. A model has what decision and runtime do in a tick, everything that may\n"
     "happen to them, and what is claimed of all runs: one controller always drives, an engaged\n"
     "recovery does so in time, recoveries do not take over from each other for ever, and control\n"
     "comes back. What is proved of the recoveries stands in tables in front. `rtac verify` asks "
     "spin\n"
     "by itself. SPEC is the path of a .rta file, or - for standard input.\n",
     "  rtac protocol delivery.rta -o models\n"
     "  cd models && spin -search -a -ltl no_livelock plan_executor.pml\n"
     "  cd models && spin -t -T -B plan_executor.pml\n",
     spec_codes},
    {"fmt", "rtac fmt FILE... [FLAG...]",
     "Writes specifications in the canonical layout. Comments, blank lines between items and the\n"
     "lines that an author began at operators are kept; what a file says does not change. A file\n"
     "with syntax errors stays as it is, and so do all others then. A FILE of - formats standard\n"
     "input to standard output.\n",
     "  rtac fmt door.rta\n"
     "  rtac fmt --check *.rta\n"
     "  rtac fmt - <door.rta\n",
     "  0  all files are in the layout\n"
     "  1  a file has errors, or with --check is not in the layout\n"
     "  2  usage, or a file that cannot be read or written\n"
     "  70 a bug of rtac\n"},
    {"explain", "rtac explain CODE\n       rtac explain FILE:LINE [--in SPEC] [--simulate N]",
     "CODE is the number or name of a diagnostic: what it means, with a faulty and a mended\n"
     "specification. FILE:LINE is a line of a specification: what was derived for each expression\n"
     "on it, range, grid, rounding, error, bytes and operations; of robots look-ahead and\n"
     "clearances. A line of a file that is imported is one of the specification that imports it.\n",
     "  rtac explain 3001\n"
     "  rtac explain unit_missing\n"
     "  rtac explain door.rta:7\n"
     "  rtac explain common/limits.rta:3 --in door.rta\n"
     "  rtac explain delivery.rta:57 --simulate 20\n",
     "  0  it was printed\n"
     "  1  the specification has errors\n"
     "  2  usage: no such diagnostic or line, or a file that cannot be read\n"
     "  3  a property was violated in what was simulated\n"
     "  4  it cannot be simulated\n"
     "  70 a bug of rtac\n"},
};

bool is_about(const FlagText& flag, const std::string& command) {
  return flag.command == nullptr || command == flag.command;
}

std::string flag_lines(const std::vector<std::string>& flags, const std::string& command) {
  constexpr std::size_t column = 26;
  std::string lines;
  for (const FlagText& each : flag_texts) {
    if (std::find(flags.begin(), flags.end(), each.flag) == flags.end()) continue;
    if (!is_about(each, command)) continue;
    std::string line = std::string("  ") + each.flag + (*each.value ? " " : "") + each.value;
    if (line.size() + 2 > column) {
      lines += line + "\n";
      line.clear();
    }
    line.resize(column, ' ');
    for (const char* c = each.text; *c != '\0'; ++c) {
      line += *c;
      if (*c == '\n') line += std::string(column, ' ');
    }
    lines += line + "\n";
  }
  return lines;
}

std::string overview() {
  return "rtac: compiles a page of specification into monitors and decision modules for robots\n"
         "\n"
         "  rtac check SPEC              check, and print what was derived\n"
         "  rtac build SPEC -o DIR       write the modules and the runtime of the system\n"
         "  rtac replay SPEC TRACE       judge a recorded trace; the findings are CSV\n"
         "  rtac verify SPEC             what the decisions need, and how far it is proved\n"
         "  rtac sim SPEC                attack the simulated robots; what is violated, who "
         "drives\n"
         "  rtac zones SPEC -o FILE      draw the zones as SVG: from where, and what checks leave\n"
         "  rtac protocol SPEC -o DIR    write how controllers are switched, for the checker spin\n"
         "  rtac fmt FILE...             write specifications in the canonical layout\n"
         "  rtac explain CODE            what a diagnostic means, and what to do\n"
         "  rtac explain FILE:LINE       what was derived for a line: ranges, grids, errors, "
         "bytes,\n"
         "                               operations; look-ahead and clearances\n"
         "  rtac help [COMMAND]          this page, or that of a command with its flags and "
         "examples\n"
         "  rtac version\n"
         "\n"
         "SPEC and FILE are paths of .rta files, TRACE of a .csv file, or - for standard input.\n"
         "Data goes to standard output, diagnostics to standard error.\n"
         "\n"
         "Exit codes:\n"
         "  0  clean; of `verify`: every obligation is proved or acknowledged\n"
         "  1  the specification has errors, or `fmt --check` a finding\n"
         "  2  usage, or a file or trace that cannot be used\n"
         "  3  refuted: `verify` refutes an obligation or a certificate, a property was violated "
         "in "
         "a\n"
         "     simulation, or a monitor was false in a trace\n"
         "  4  unknown: `verify` neither proves nor refutes an obligation, or it cannot be "
         "simulated;\n"
         "     unknown is to be taken for unsafe\n"
         "  70 a bug of rtac\n";
}

}  // namespace

std::string help_text(const std::string& command, const std::vector<std::string>& flags) {
  for (const CommandText& each : command_texts) {
    if (command != each.name) continue;
    const std::string lines = flag_lines(flags, command);
    return std::string("usage: ") + each.usage + "\n\n" + each.about +
           (lines.empty() ? "" : "\nFlags:\n" + lines) + "\nExamples:\n" + each.examples +
           "\nExit codes:\n" + each.exit_codes;
  }
  return overview();
}

}  // namespace rtac::driver
