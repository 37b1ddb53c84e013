#include <cerrno>
#include <cstring>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "program.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

// A fleet takes some MB for each run: to give them back in between doubles the time.
void keep_memory() {
#ifdef __GLIBC__
  constexpr int never_give_back = 1 << 30, at_once_bytes = 64 << 20;
  ::mallopt(M_TRIM_THRESHOLD, never_give_back);
  ::mallopt(M_TOP_PAD, at_once_bytes);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory();
  try {
    const int status = rtac::simulate::run_program(std::vector<std::string>(argv + 1, argv + argc),
                                                   std::cout, std::cerr);
    errno = 0;
    if (std::cout.flush()) return status;
    std::cerr
        << "cannot write what was found to standard output"
        << (errno != 0 ? std::string(": ") + std::strerror(errno) : "")
        << "\tmake room where it leads, for `rtac sim` where temporary files are kept: TMPDIR "
           "names another folder\t"
        << rtac::simulate::cannot_write << "\n";
    return rtac::simulate::exit_usage;
  } catch (const std::exception& error) {
    constexpr int exit_internal = 70;
    std::cerr << error.what() << "\n";
    return exit_internal;
  }
}
