# cmake -DFILES="report.html;..." -DFOLDER=... -DOUTPUT=... -P embed.cmake
# Writes one constant a file, report_html for report.html, for report_html.cpp to include.
set(text "")
foreach(file IN LISTS FILES)
  file(READ ${FOLDER}/${file} content)
  string(REPLACE . _ name ${file})
  string(APPEND text "constexpr std::string_view ${name} = R\"file(${content})file\";\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
