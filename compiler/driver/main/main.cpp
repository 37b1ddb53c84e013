#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "compiler/driver/driver.h"

int main(int argc, char** argv) {
  try {
    return rtac::driver::run(std::vector<std::string>(argv + 1, argv + argc), std::cout, std::cerr);
  } catch (const std::bad_alloc&) {
    std::cerr << "error: there is not enough memory for this specification\n";
    return rtac::driver::exit_usage;
  } catch (const std::exception& error) {
    // nothing is thrown across folders, so this is a bug of the compiler
    std::cerr << "internal error: " << error.what() << "\n";
    return rtac::driver::exit_internal;
  }
}
