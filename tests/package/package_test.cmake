# An outside user's day: install into an empty prefix, copy an example to another place, build it
# against the installed package with find_package(rtac), run it.
#
#   cmake -DBUILD=... -DSOURCE=... -DWORK=... -DEXAMPLE=... -DGENERATOR=... -DCC=... -DCXX=...
#     -DFLAGS=... -DIMPORTED=... -P package_test.cmake
#
# The tools and flags are those of this build: a sanitized library needs a sanitized user.
set(prefix "${WORK}/a prefix")
set(copy "${WORK}/copy")
set(example_build "${WORK}/build")
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")

function(run what)
  execute_process(COMMAND ${ARGN}
    RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what} failed (${status}):\n${text}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

run("installing" ${CMAKE_COMMAND} --install "${BUILD}" --prefix "${prefix}")

# What was installed must not look back into the tree that it came from.
file(GLOB_RECURSE installed
  "${prefix}/*.cmake" "${prefix}/*.h" "${prefix}/*.pc" "${prefix}/*.rta")
foreach(file ${installed})
  file(READ "${file}" text)
  foreach(place "${SOURCE}" "${BUILD}")
    string(FIND "${text}" "${place}/" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${file} names ${place}")
    endif()
  endforeach()
endforeach()

# Examples find the library of specifications beside them, as in the repository.
file(COPY "${SOURCE}/examples/${EXAMPLE}" DESTINATION "${copy}/examples")
file(COPY "${SOURCE}/specs" DESTINATION "${copy}")
set(user -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
  -DCMAKE_BUILD_TYPE=Release "-DCMAKE_C_COMPILER=${CC}" "-DCMAKE_CXX_COMPILER=${CXX}"
  "-DCMAKE_C_FLAGS_RELEASE=${FLAGS}" "-DCMAKE_CXX_FLAGS_RELEASE=${FLAGS}")
run("configuring" ${CMAKE_COMMAND} -S "${copy}/examples/${EXAMPLE}" -B "${example_build}" ${user})
run("building" ${CMAKE_COMMAND} --build "${example_build}" --parallel 2)

run("building again" ${CMAKE_COMMAND} --build "${example_build}")
if(output MATCHES "Compiling specification")
  message(FATAL_ERROR "a second build compiles the specifications again:\n${output}")
endif()

# A touched import must reach the generated files: that is what the dependency file is for.
run("waiting for the clock of the file system" ${CMAKE_COMMAND} -E sleep 1)
file(TOUCH_NOCREATE "${copy}/specs/${IMPORTED}")
run("building after an edit" ${CMAKE_COMMAND} --build "${example_build}" --parallel 2)
if(NOT output MATCHES "Compiling specification")
  message(FATAL_ERROR "what imports an edited file is not compiled again:\n${output}")
endif()

run("running" "${example_build}/${EXAMPLE}" --seeds 1 --out "${WORK}/out")
file(GLOB results "${WORK}/out/*")
if(NOT results)
  message(FATAL_ERROR "the example wrote nothing to ${WORK}/out:\n${output}")
endif()
# Two modules of one specification in one program: a namespace each keeps their classes, the C names
# of their kernels and their headers apart.
file(COPY "${CMAKE_CURRENT_LIST_DIR}/two_modules" DESTINATION "${copy}")
set(configure_two ${CMAKE_COMMAND} -S "${copy}/two_modules" ${user})
run("configuring two modules" ${configure_two} -B "${WORK}/two")
run("building two modules" ${CMAKE_COMMAND} --build "${WORK}/two" --parallel 2)
run("running two modules" "${WORK}/two/two_modules")

# A zone that is imported is a file like any other: editing it reaches the program, and what cannot
# be read ends the build with its name.
file(COPY "${CMAKE_CURRENT_LIST_DIR}/imported_zone" DESTINATION "${copy}")
set(zone "${copy}/imported_zone/zones/field.geojson")
set(build_zone ${CMAKE_COMMAND} --build "${WORK}/zone" --parallel 2)
function(rewrite from to)
  file(READ "${zone}" text)
  string(REPLACE "${from}" "${to}" edited "${text}")
  if(edited STREQUAL text)
    message(FATAL_ERROR "${zone} has no ${from}")
  endif()
  run("waiting for the clock of the file system" ${CMAKE_COMMAND} -E sleep 1)
  file(WRITE "${zone}" "${edited}")
endfunction()
function(expect_mower far)
  run("running with a zone of a file" "${WORK}/zone/imported_zone")
  if(NOT output STREQUAL "30 m east: on the field\n80 m east: ${far} the field\n")
    message(FATAL_ERROR "80 m east is not ${far} the field:\n${output}")
  endif()
endfunction()
run("configuring a zone of a file" ${CMAKE_COMMAND} -S "${copy}/imported_zone" -B "${WORK}/zone"
  ${user})
run("building a zone of a file" ${build_zone})
expect_mower(on)
run("building a zone of a file again" ${build_zone})
if(output MATCHES "Compiling specification")
  message(FATAL_ERROR "a second build reads the zone again:\n${output}")
endif()
rewrite("8.5469" "8.5462")
run("building after the zone was edited" ${build_zone})
if(NOT output MATCHES "Compiling specification")
  message(FATAL_ERROR "an edited zone is not read again:\n${output}")
endif()
expect_mower(off)
rewrite("]]" "]")
execute_process(COMMAND ${build_zone} RESULT_VARIABLE status OUTPUT_VARIABLE log ERROR_VARIABLE log)
if(status EQUAL 0 OR NOT log MATCHES "field.geojson")
  message(FATAL_ERROR "a zone that cannot be read does not end the build (${status}):\n${log}")
endif()

# Mistakes in the call are found when configuring, with what is wrong.
function(refuses text spec)
  execute_process(COMMAND ${configure_two} -B "${WORK}/refused" "-DSPEC=${spec}" ${ARGN}
    RESULT_VARIABLE status OUTPUT_VARIABLE log ERROR_VARIABLE log)
  string(REGEX REPLACE "[ \n]+" " " log "${log}")
  string(FIND "${log}" "${text}" position)
  if(status EQUAL 0 OR position EQUAL -1)
    message(FATAL_ERROR "SPEC ${spec} ${ARGN}: not refused with `${text}`:\n${log}")
  endif()
endfunction()
refuses("SPEC is the directory" .)
refuses("there is no file" missing.rta)
refuses("SPEC <file.rta> is missing" "")
refuses("NAMESPACE is `a-b`" gate.rta -DSPACE=a-b)
message(STATUS "ok")
