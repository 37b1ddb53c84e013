#include <cerrno>
#include <cstring>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "program.h"

int main(int argc, char** argv) {
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
