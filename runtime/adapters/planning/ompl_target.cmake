# OMPL's package gives variables only, and they name /usr/include and libraries that are not always
# installed: make one clean target of what is needed. Included by the installed package as well.
if(NOT TARGET rtac_ompl)
  find_package(ompl 1.5 REQUIRED)
  find_package(Eigen3 REQUIRED NO_MODULE)
  find_library(RTAC_OMPL_LIBRARY NAMES ompl HINTS ${OMPL_LIBRARY_DIRS} REQUIRED)
  find_path(RTAC_OMPL_INCLUDE_DIR ompl/config.h HINTS ${OMPL_INCLUDE_DIRS} REQUIRED)
  mark_as_advanced(RTAC_OMPL_LIBRARY RTAC_OMPL_INCLUDE_DIR)
  # An imported target's include directories are SYSTEM for whoever links it.
  add_library(rtac_ompl INTERFACE IMPORTED GLOBAL)
  target_include_directories(rtac_ompl SYSTEM INTERFACE ${RTAC_OMPL_INCLUDE_DIR})
  target_link_libraries(rtac_ompl INTERFACE ${RTAC_OMPL_LIBRARY} Eigen3::Eigen)
endif()
