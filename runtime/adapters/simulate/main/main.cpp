#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "program.h"

int main(int argc, char** argv) {
  try {
    const int status = rtac::simulate::run_program(std::vector<std::string>(argv + 1, argv + argc),
                                                   std::cout, std::cerr);
    if (std::cout.flush()) return status;
    std::cerr << "cannot write to standard output\t\n";
    return rtac::simulate::exit_usage;
  } catch (const std::exception& error) {
    constexpr int exit_internal = 70;
    std::cerr << error.what() << "\n";
    return exit_internal;
  }
}
