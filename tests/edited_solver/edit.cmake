# cmake -DSOURCE=... -DROOT=... ... -P edit.cmake: copies the sources that decide numbers to ROOT, changes a constant of
# ik_bat there, and writes the digests of the copy.
file(COPY ${SOURCE}/numerics ${SOURCE}/robots ${SOURCE}/solvers ${SOURCE}/experiments DESTINATION ${ROOT})
file(READ ${SOURCE}/solvers/ik_bat.cpp text)
string(REPLACE "options_.step_factor * loudness_" "0.9 * options_.step_factor * loudness_" edited "${text}")
if(edited STREQUAL text)
  message(FATAL_ERROR "solvers/ik_bat.cpp has no longer what is to be edited")
endif()
file(WRITE ${ROOT}/solvers/ik_bat.cpp "${edited}")
include(${SOURCE}/experiments/source_digests.cmake)
file(TOUCH ${OUTPUT})
