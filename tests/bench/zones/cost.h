// What something takes, in a process of its own: so that the memory is that of the case.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rtac::bench {

struct Cost {
  double seconds = 0;  // of the processor: the machine may be busy
  double megabytes = 0;
};

// `work` runs in a child. false: it failed.
bool measure(const std::function<bool()>& work, Cost& cost);
// What the program says goes to the file `log`. false: it failed, or could not be started.
bool measure_program(const std::vector<std::string>& words, const std::string& log, Cost& cost);

}  // namespace rtac::bench
