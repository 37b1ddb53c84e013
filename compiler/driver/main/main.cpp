#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "compiler/driver/driver.h"

int main(int argc, char** argv) {
  try {
    return rtac::driver::run(std::vector<std::string>(argv + 1, argv + argc), std::cout, std::cerr);
  } catch (const std::exception& error) {
    // nothing is thrown across folders, so this is a bug of the compiler or an exhausted machine
    std::cerr << "internal error: " << error.what() << "\n";
    return rtac::driver::exit_internal;
  }
}
