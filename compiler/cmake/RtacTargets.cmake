# One library per folder, so that the linker enforces who may depend on whom.
#
#   rtac_folder(<target> STANDARD 17|20 [DEPENDS target...] [SYSTEM target...])
#
# Every .cpp of the folder belongs to the target; a folder without any is header-only.
set(RTAC_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND RTAC_WARNINGS -Wno-restrict)  # false alarms of GCC 12 on std::string concatenation
endif()

function(rtac_folder target)
  cmake_parse_arguments(arg "" "STANDARD" "DEPENDS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    add_library(${target} STATIC ${sources})
    target_link_libraries(${target} PUBLIC ${arg_DEPENDS})
    target_compile_features(${target} PUBLIC cxx_std_${arg_STANDARD})
    target_compile_options(${target} PRIVATE ${RTAC_WARNINGS})
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${arg_DEPENDS})
    target_compile_features(${target} INTERFACE cxx_std_${arg_STANDARD})
  endif()
endfunction()

#   rtac_test(<folder below tests> [LINK target...])
# Every *_test.cpp of the folder goes into one GoogleTest executable; each test is a ctest case.
function(rtac_test folder)
  cmake_parse_arguments(arg "" "" "LINK;DEFINE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*_test.cpp)
  if(NOT sources)
    return()
  endif()
  string(REPLACE "/" "_" name ${folder})
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE ${arg_LINK} GTest::gtest_main)
  target_compile_features(test_${name} PRIVATE cxx_std_20)
  target_compile_options(test_${name} PRIVATE ${RTAC_WARNINGS})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(test_${name} PRIVATE
    RTAC_SOURCE_DIR="${PROJECT_SOURCE_DIR}" ${arg_DEFINE})
  gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60)
endfunction()
