# ikbench_embed(OUTPUT FOLDER PATTERN): carries the files of FOLDER that match PATTERN in the program. The build writes
# OUTPUT into the caller's binary folder, to be included by a C++ source: a line {"NAME", R"embedded(TEXT)embedded"}, a
# file, by name, which is its path within FOLDER. A file that is added is found by the next build.
if(CMAKE_SCRIPT_MODE_FILE)  # cmake -DFILES="name;..." -DFOLDER=... -DOUTPUT=... -P embed.cmake
  set(lines "")
  foreach(file IN LISTS FILES)
    file(READ ${FOLDER}/${file} text)
    string(APPEND lines "{\"${file}\", R\"embedded(${text})embedded\"},\n")
  endforeach()
  file(WRITE ${OUTPUT} "${lines}")
  return()
endif()

function(ikbench_embed output folder pattern)
  set(folder ${CMAKE_CURRENT_SOURCE_DIR}/${folder})
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${output})
  file(GLOB_RECURSE files RELATIVE ${folder} CONFIGURE_DEPENDS ${folder}/${pattern})
  list(SORT files)
  list(TRANSFORM files PREPEND ${folder}/ OUTPUT_VARIABLE sources)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} "-DFILES=${files}" -DFOLDER=${folder} -DOUTPUT=${output}
      -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    DEPENDS ${sources} ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    VERBATIM)
endfunction()
