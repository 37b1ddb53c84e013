# What the exact geometry of received zones links. Included by the installed package as well.
if(NOT TARGET rtac_exact)
  add_library(rtac_exact INTERFACE IMPORTED GLOBAL)
  foreach(library GeographicLib pugixml mpfr gmpxx gmp)
    find_library(RTAC_EXACT_${library} NAMES ${library} REQUIRED)
    mark_as_advanced(RTAC_EXACT_${library})
    target_link_libraries(rtac_exact INTERFACE ${RTAC_EXACT_${library}})
  endforeach()
endif()
