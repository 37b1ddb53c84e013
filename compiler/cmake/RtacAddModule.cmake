# rtac_add_module(<target> SPEC <file.rta> [NAMESPACE <ns>] [TYPE STATIC|SHARED|OBJECT]
#                 [MAX_BYTES <n>])
#
# Compiles a specification and makes a library of the result:
#
#   find_package(rtac REQUIRED)
#   rtac_add_module(delivery_rta SPEC delivery.rta)
#   target_link_libraries(app PRIVATE delivery_rta)    # then: #include "delivery_system.h"
#
# Two modules of one specification in a program need a NAMESPACE each. It names the C++ namespace and
# prefixes the C names of the kernel; the headers, which then have the same names, are found behind
# the name of their target: #include "delivery_rta/delivery_system.h".
#
# The library has the decision modules (delivery.h), their integer kernels (delivery_kernel.h, C99)
# and the runtime of the system (delivery_system.h). The specification and everything that it
# imports are dependencies: editing one rebuilds exactly what it must. The manifest lies at the
# path in the target property RTAC_MANIFEST.
#
# MAX_BYTES is what its monitors may remember; `rtac help build` says what they may without it.
#
# The compiler is the target rtac::rtac, of this build or of the installed package; the variable
# RTAC_EXECUTABLE names another one, which a cross build needs: its package holds a compiler for
# the wrong machine.
include_guard(GLOBAL)

function(_rtac_compiler out_command out_dependency)
  if(RTAC_EXECUTABLE)
    set(${out_command} "${RTAC_EXECUTABLE}" PARENT_SCOPE)
    set(${out_dependency} "${RTAC_EXECUTABLE}" PARENT_SCOPE)
    return()
  endif()
  if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    message(FATAL_ERROR
      "rtac_add_module: a cross build needs a compiler that runs here: -DRTAC_EXECUTABLE=<path of rtac>")
  endif()
  set(${out_command} rtac::rtac PARENT_SCOPE)
  set(${out_dependency} "$<TARGET_FILE:rtac::rtac>" PARENT_SCOPE)
endfunction()

function(rtac_add_module target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SPEC;NAMESPACE;TYPE;MAX_BYTES" "")
  if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "rtac_add_module(${target}): cannot make sense of "
      "`${arg_UNPARSED_ARGUMENTS}${arg_KEYWORDS_MISSING_VALUES}`; the form is "
      "rtac_add_module(<target> SPEC <file.rta> [NAMESPACE <ns>] [TYPE STATIC|SHARED|OBJECT] "
      "[MAX_BYTES <n>])")
  endif()
  if(NOT arg_SPEC)
    message(FATAL_ERROR "rtac_add_module(${target}): SPEC <file.rta> is missing")
  endif()
  if(NOT arg_TYPE)
    set(arg_TYPE STATIC)
  elseif(NOT arg_TYPE MATCHES "^(STATIC|SHARED|OBJECT)$")
    message(FATAL_ERROR
      "rtac_add_module(${target}): TYPE is `${arg_TYPE}`; STATIC, SHARED and OBJECT exist")
  endif()
  get_filename_component(spec "${arg_SPEC}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  if(NOT EXISTS "${spec}")
    message(FATAL_ERROR "rtac_add_module(${target}): there is no file ${spec}")
  elseif(IS_DIRECTORY "${spec}")
    message(FATAL_ERROR "rtac_add_module(${target}): SPEC is the directory ${spec}; "
      "the path of a .rta file works")
  endif()
  if(DEFINED arg_NAMESPACE AND NOT arg_NAMESPACE MATCHES "^[A-Za-z_][A-Za-z0-9_]*$")
    message(FATAL_ERROR "rtac_add_module(${target}): NAMESPACE is `${arg_NAMESPACE}`; "
      "letters, digits and `_` make one")
  endif()

  get_filename_component(stem "${spec}" NAME_WLE)
  set(directory "${CMAKE_CURRENT_BINARY_DIR}/rtac/${target}")
  set(headers "${directory}/${stem}_kernel.h" "${directory}/${stem}.h"
    "${directory}/${stem}_system.h")
  set(kernel "${directory}/${stem}_kernel.c")
  set(manifest "${directory}/${stem}_manifest.json")
  set(sources "${kernel}" "${directory}/${stem}.cpp")
  set(flags "")
  if(arg_NAMESPACE)
    list(APPEND flags --namespace "${arg_NAMESPACE}")
  endif()
  if(arg_MAX_BYTES)
    list(APPEND flags --max-bytes "${arg_MAX_BYTES}")
  endif()

  _rtac_compiler(command dependency)
  file(MAKE_DIRECTORY "${directory}")
  # Ninja takes a dependency file only when its first target is the first output: both are the
  # header of the kernel.
  add_custom_command(
    OUTPUT ${headers} ${sources} "${manifest}"
    COMMAND "${command}" build "${spec}" -o "${directory}"
      --depfile "${directory}/${stem}.d" ${flags}
    DEPENDS "${spec}" "${dependency}"
    DEPFILE "${directory}/${stem}.d"
    COMMENT "Compiling specification ${stem}.rta"
    VERBATIM)

  add_library(${target} ${arg_TYPE} ${sources} "${manifest}")
  target_sources(${target} PUBLIC
    FILE_SET HEADERS BASE_DIRS "${directory}" FILES ${headers})
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}/rtac>")  # "<target>/<name>.h"
  target_link_libraries(${target} PUBLIC rtac::core rtac::stack)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES RTAC_MANIFEST "${manifest}")

  # The kernel is C99 and C++17 alike; a project without C compiles it as C++.
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if("C" IN_LIST languages)
    target_compile_features(${target} PRIVATE c_std_99)
  else()
    set_source_files_properties("${kernel}" PROPERTIES LANGUAGE CXX)
  endif()
endfunction()
