# cmake -DROOT=... -DSHARED="file;..." -DSOLVERS="name;..." -DOUTPUT=... -P source_digests.cmake
# Writes digests of the sources that decide numbers, for environment.cpp to include: one of the SHARED files together,
# one of each solver's own. A digest is made of the tokens only: neither comments nor white space change it. If no digest
# changed, the output is not touched, so that nothing is compiled again.
string(ASCII 1 backslash)
string(ASCII 2 semicolon)
string(ASCII 3 opening)
string(ASCII 4 closing)
set(literal "\"([^\"${backslash}\n]|${backslash}.)*\"|'(${backslash}.[^'\n]*|[^'${backslash}\n])'")
set(comment "//[^\n]*|/\\*[^*]*\\*+([^/*][^*]*\\*+)*/")
set(token "[A-Za-z0-9_]+|[+]+|[-]+|[&]+|[^ \t\r\n]")  # a++ + b is not a + ++b

function(digest_of file result)
  file(READ ${file} text)
  if(NOT text MATCHES "R\"")  # a raw string may hold anything: its file is taken as it stands
    string(REPLACE "\\" ${backslash} text "${text}")  # four characters that have a meaning in CMake's lists
    string(REPLACE ";" ${semicolon} text "${text}")
    string(REPLACE "[" ${opening} text "${text}")
    string(REPLACE "]" ${closing} text "${text}")
    string(REGEX MATCHALL "${literal}|${comment}|${token}" text "${text}")
    list(FILTER text EXCLUDE REGEX "^/[/*]")
  endif()
  string(SHA256 digest "${text}")
  string(SUBSTRING ${digest} 0 16 digest)
  set(${result} ${digest} PARENT_SCOPE)
endfunction()

set(digests "")
foreach(file IN LISTS SHARED)
  digest_of(${ROOT}/${file} digest)
  list(APPEND digests ${digest})
endforeach()
list(SORT digests)
string(SHA256 shared "${digests}")
string(SUBSTRING ${shared} 0 16 shared)

set(solvers "")
# A peer, "peers/NAME", is its own file and the headers that peers share.
file(GLOB peer_headers ${ROOT}/solvers/peers/*.hpp)
foreach(solver IN LISTS SOLVERS)
  digest_of(${ROOT}/solvers/${solver}.cpp digest)
  if(solver MATCHES "^peers/")
    foreach(header IN LISTS peer_headers)
      digest_of(${header} of_header)
      string(APPEND digest ${of_header})
    endforeach()
    string(SHA256 digest ${digest})
    string(SUBSTRING ${digest} 0 16 digest)
  endif()
  get_filename_component(name ${solver} NAME)
  string(APPEND solvers "    {\"${name}\", \"${digest}\"},\n")
endforeach()
string(SHA256 all "${shared}${solvers}")
string(SUBSTRING ${all} 0 16 all)
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT "constexpr std::string_view of_all = \"${all}\";  // of both
constexpr std::string_view shared = \"${shared}\";
constexpr std::pair<std::string_view, std::string_view> of_solvers[]{
${solvers}};
")
