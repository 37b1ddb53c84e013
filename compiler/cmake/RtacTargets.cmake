# One library per folder, so that the linker enforces who may depend on whom.
#
#   rtac_folder(<target> STANDARD 17|20 [DEPENDS target...] [BATCH number] [KEEP source...])
#
# Every .cpp of the folder belongs to the target; a folder without any is header-only.
set(RTAC_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND RTAC_WARNINGS -Wno-restrict)  # false alarms of GCC 12 on std::string concatenation
endif()

# Most of the work on a source is what it includes. With RTAC_UNITY so many sources share it; those
# after KEEP stand alone, since they give a name to something else than another one does.
#   rtac_unite(<target> [BATCH number] [KEEP source...])
function(rtac_unite target)
  cmake_parse_arguments(arg "" "BATCH" "KEEP" ${ARGN})
  if(NOT RTAC_UNITY OR arg_BATCH EQUAL 1)
    return()
  endif()
  if(NOT arg_BATCH)
    set(arg_BATCH 8)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${arg_BATCH})
  foreach(source IN LISTS arg_KEEP)
    set_property(SOURCE ${source} APPEND PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
  endforeach()
endfunction()

function(rtac_folder target)
  cmake_parse_arguments(arg "" "STANDARD;BATCH" "DEPENDS;KEEP" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    add_library(${target} STATIC ${sources})
    target_link_libraries(${target} PUBLIC ${arg_DEPENDS})
    target_compile_features(${target} PUBLIC cxx_std_${arg_STANDARD})
    target_compile_options(${target} PRIVATE ${RTAC_WARNINGS})
    rtac_unite(${target} BATCH ${arg_BATCH} KEEP ${arg_KEEP})
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${arg_DEPENDS})
    target_compile_features(${target} INTERFACE cxx_std_${arg_STANDARD})
  endif()
endfunction()

# With RTAC_UNITY, what nearly every test includes is compiled once; what all tests of a target
# include besides, once for that.
#   rtac_precompiled_tests(<target> [header...])
function(rtac_precompiled_tests target)
  if(NOT RTAC_UNITY)
    return()
  endif()
  if(ARGN)
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests/precompiled.h ${ARGN})
    return()
  endif()
  if(NOT TARGET rtac_tests_precompiled)
    # An executable, as those that use it: another kind of code would not fit.
    set(source ${PROJECT_BINARY_DIR}/tests_precompiled.cpp)
    file(WRITE ${source} "")
    add_executable(rtac_tests_precompiled EXCLUDE_FROM_ALL ${source})
    target_link_libraries(rtac_tests_precompiled PRIVATE GTest::gtest_main)
    target_compile_features(rtac_tests_precompiled PRIVATE cxx_std_20)
    target_compile_options(rtac_tests_precompiled PRIVATE ${RTAC_WARNINGS})
    target_precompile_headers(rtac_tests_precompiled PRIVATE
      ${PROJECT_SOURCE_DIR}/tests/precompiled.h)
  endif()
  target_precompile_headers(${target} REUSE_FROM rtac_tests_precompiled)
endfunction()

#   rtac_test(<folder below tests> [LINK target...] [DEFINE definition...] [BATCH number] [KEEP source...]
#             [PRECOMPILE header...] [ENVIRONMENT NAME=VALUE] [WITH_C])
# Every *_test.cpp of the folder goes into one GoogleTest executable; each test is a ctest case.
# WITH_C: it gets sources in C as well, which cannot share what is precompiled.
function(rtac_test folder)
  cmake_parse_arguments(arg "WITH_C" "BATCH;ENVIRONMENT" "LINK;DEFINE;KEEP;PRECOMPILE" ${ARGN})
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
  list(TRANSFORM arg_KEEP PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/)
  rtac_unite(test_${name} BATCH ${arg_BATCH} KEEP ${arg_KEEP})
  if(NOT arg_WITH_C)
    rtac_precompiled_tests(test_${name} ${arg_PRECOMPILE})
  endif()
  gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${name} ENVIRONMENT "${arg_ENVIRONMENT}") # ctest sums up times of labels
endfunction()
