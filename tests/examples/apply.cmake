# cmake -DSOURCE=... -DEXAMPLES=... -DDIGESTS=... -DCOPY=... -P apply.cmake: copies what the examples change to COPY, and
# changes it there as their diffs say.
file(MAKE_DIRECTORY ${COPY}/experiments ${COPY}/solvers)
foreach(file runner.cpp solve_runner.cpp study.hpp study_fields.hpp)
  configure_file(${SOURCE}/experiments/${file} ${COPY}/experiments/${file} COPYONLY)
endforeach()
file(READ ${EXAMPLES}/solvers/hill_climb.cpp text)
string(REPLACE "hill_climb" "hill_climb_ahead" text "${text}")
string(REPLACE "HillClimb" "HillClimbAhead" text "${text}")
file(WRITE ${COPY}/solvers/hill_climb_ahead.cpp "${text}")
file(GLOB diffs ${EXAMPLES}/*.diff)
get_filename_component(above ${COPY} DIRECTORY)  # so that git takes COPY for no part of a repository
execute_process(COMMAND ${CMAKE_COMMAND} -E env GIT_CEILING_DIRECTORIES=${above} git apply ${diffs}
  WORKING_DIRECTORY ${COPY} COMMAND_ERROR_IS_FATAL ANY)

file(READ ${DIGESTS} text)  # any digest will do for the solvers of the examples
string(REPLACE "of_solvers[]{" "of_solvers[]{\n    {\"hill_climb\", \"\"},\n    {\"hill_climb_ahead\", \"\"}," text "${text}")
file(WRITE ${COPY}/source_digests.inc "${text}")
