# ikbench_embed(OUTPUT FOLDER PATTERN...): carries the files of FOLDER that match in the program. Writes OUTPUT into the
# caller's binary folder, to be included by a C++ source: a line {"NAME", R"embedded(TEXT)embedded"}, a file, by
# name, which is its path within FOLDER. A file that is added or edited is found by the next build. Hidden files, which
# editors leave, are not carried.
function(ikbench_embed output folder)
  cmake_path(ABSOLUTE_PATH folder BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE patterns)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${patterns})
  list(FILTER files EXCLUDE REGEX "/\\.[^/]*$")
  list(SORT files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(lines "")
  foreach(file IN LISTS files)
    file(RELATIVE_PATH name ${folder} ${file})
    file(READ ${file} text)
    file(SIZE ${file} size)
    string(LENGTH "${text}" length)  # without carriage returns, which CMake reads away
    if(NOT name MATCHES "^[A-Za-z0-9_./-]+$" OR text MATCHES "\\)embedded\"" OR NOT length EQUAL size)
      message(FATAL_ERROR "${file} cannot be embedded; expected a name of A-Z a-z 0-9 _ . / - and neither )embedded\" "
                          "nor carriage returns in it")
    endif()
    string(APPEND lines "{\"${name}\", R\"embedded(${text})embedded\"},\n")
  endforeach()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${output})
  file(WRITE ${output}.new "${lines}")
  file(COPY_FILE ${output}.new ${output} ONLY_IF_DIFFERENT)
endfunction()
