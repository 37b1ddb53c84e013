# Ipopt comes through pkg-config. Its definitions are mandatory (without -DHAVE_CSTDDEF the headers
# of Debian's 3.11.9 do not compile); a language standard among its flags must not reach our
# targets. Included by the installed package as well.
if(NOT TARGET rtac_ipopt)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(RTAC_IPOPT REQUIRED ipopt)
  find_library(RTAC_IPOPT_LIBRARY NAMES ipopt HINTS ${RTAC_IPOPT_LIBRARY_DIRS} REQUIRED)
  mark_as_advanced(RTAC_IPOPT_LIBRARY)
  set(definitions ${RTAC_IPOPT_CFLAGS_OTHER})
  list(FILTER definitions INCLUDE REGEX "^-D")
  list(TRANSFORM definitions REPLACE "^-D" "")
  add_library(rtac_ipopt INTERFACE IMPORTED GLOBAL)
  target_include_directories(rtac_ipopt SYSTEM INTERFACE ${RTAC_IPOPT_INCLUDE_DIRS})
  target_compile_definitions(rtac_ipopt INTERFACE ${definitions})
  # The shared library knows what it needs itself; pkg-config would add its Fortran run time.
  target_link_libraries(rtac_ipopt INTERFACE ${RTAC_IPOPT_LIBRARY})
  unset(definitions)
endif()
