# Names that an application uses, and what `cmake --install` puts where.
#
# Inside this build, find_package(rtac) finds the targets of the build itself: an example reads
# like a project of an outside user, because it is one.
include(CMakePackageConfigHelpers)

set(RTAC_COMPONENTS core stack sim planning optimize zones)
set(rtac_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/rtac)

foreach(component ${RTAC_COMPONENTS})
  add_library(rtac::${component} ALIAS rtac_${component})
  set_target_properties(rtac_${component} PROPERTIES EXPORT_NAME ${component})
  install(TARGETS rtac_${component} EXPORT rtac-${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  # One file each, so that a user who needs no planner needs no OMPL either.
  install(EXPORT rtac-${component} NAMESPACE rtac:: DESTINATION ${rtac_package_dir})
endforeach()

if(TARGET rtac_cli)
  add_executable(rtac::rtac ALIAS rtac_cli)
  set_target_properties(rtac_cli PROPERTIES EXPORT_NAME rtac)
  install(TARGETS rtac_cli EXPORT rtac-tools RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  # `rtac sim` starts it, and looks for it beside itself.
  install(TARGETS rtac_sim_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(EXPORT rtac-tools NAMESPACE rtac:: DESTINATION ${rtac_package_dir})
endif()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/include/rtac
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/specs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/rtac/specs
  FILES_MATCHING PATTERN "*.rta")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/rtac-config.cmake.in ${PROJECT_BINARY_DIR}/package/rtac-config.cmake
  INSTALL_DESTINATION ${rtac_package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/rtac-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/package/rtac-config.cmake
  ${PROJECT_BINARY_DIR}/package/rtac-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/RtacAddModule.cmake
  ${PROJECT_SOURCE_DIR}/runtime/adapters/planning/ompl_target.cmake
  ${PROJECT_SOURCE_DIR}/runtime/adapters/optimize/ipopt_target.cmake
  ${PROJECT_SOURCE_DIR}/runtime/adapters/geometry/exact_target.cmake
  DESTINATION ${rtac_package_dir})

# For builds without CMake: the two libraries that every generated module links.
set(rtac_pc_libraries "")
foreach(component stack core)
  get_target_property(kind rtac_${component} TYPE)
  if(NOT kind STREQUAL INTERFACE_LIBRARY)
    string(APPEND rtac_pc_libraries " -lrtac_${component}")
  endif()
endforeach()
file(RELATIVE_PATH rtac_pc_to_prefix
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" rtac_pc_to_prefix "${rtac_pc_to_prefix}")
file(RELATIVE_PATH rtac_pc_libdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH rtac_pc_includedir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(${CMAKE_CURRENT_LIST_DIR}/rtac.pc.in ${PROJECT_BINARY_DIR}/package/rtac.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/rtac.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/rtac-config.cmake
  "foreach(component ${RTAC_COMPONENTS})\n  set(rtac_\${component}_FOUND TRUE)\nendforeach()\n")
file(COPY_FILE ${PROJECT_BINARY_DIR}/package/rtac-config-version.cmake
  ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/rtac-config-version.cmake)
