# cmake -DTABLES="paper/table.csv;..." -DFOLDER=... -DOUTPUT=... -P embed.cmake
# Writes one line {"paper", "table", R"csv(text)csv"}, a table, for published.cpp to include.
set(text "")
foreach(table IN LISTS TABLES)
  file(READ ${FOLDER}/${table} csv)
  get_filename_component(paper ${table} DIRECTORY)
  get_filename_component(name ${table} NAME_WE)
  string(APPEND text "{\"${paper}\", \"${name}\", R\"csv(${csv})csv\"},\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
