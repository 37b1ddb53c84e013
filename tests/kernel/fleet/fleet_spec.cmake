# Robots that keep away from each other, in a fleet of `count`: `closed`, `open` (who is absent does not
# count) or in `space`. Writes ${kind}_of_${count}.rta to the current binary directory.
function(rtac_fleet_spec kind count)
  set(present "")
  set(axes "")
  set(recovery "yield within field speed 0.6 m/s order id")
  set(holds "")
  if(kind STREQUAL open)
    set(present ", present")
  elseif(kind STREQUAL space)
    set(axes 3)
    set(recovery brake_and_hold)
    set(holds "hold when violated \"somebody leads them apart\";")
  endif()
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fleet.rta.in
    ${CMAKE_CURRENT_BINARY_DIR}/${kind}_of_${count}.rta @ONLY)
endfunction()
