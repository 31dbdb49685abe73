# After CPack: makes the wheel of each archive.
foreach(file IN LISTS CPACK_PACKAGE_FILES)
  if(file MATCHES "\\.tar\\.gz$")
    get_filename_component(folder ${file} DIRECTORY)
    get_filename_component(name ${file} NAME)
    file(COPY ${file} DESTINATION ${CPACK_PACKAGE_DIRECTORY})  # where CPack will put it itself
    execute_process(COMMAND python3 ${CMAKE_CURRENT_LIST_DIR}/wheel.py ${CPACK_PACKAGE_DIRECTORY}/${name} COMMAND_ERROR_IS_FATAL ANY)
  endif()
endforeach()
