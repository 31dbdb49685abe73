# Writes what was built, and from which commit, into a header; only where it changed, so that nothing is rebuilt. A repository
# above this source is another one.
set(commit "unknown")
if(GIT)
  execute_process(COMMAND ${GIT} --git-dir=${SOURCE}/.git --work-tree=${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed)
    set(commit "unknown")
  endif()
endif()
foreach(text BUILD_TYPE SANITIZE)
  if("${${text}}" STREQUAL "")
    set(${text} none)
  endif()
endforeach()
string(STRIP "${FLAGS}" FLAGS)
set(content "#pragma once
namespace ikbench::build_info {
constexpr const char* version = \"${VERSION}\";
constexpr const char* commit = \"${commit}\";
constexpr const char* build_type = \"${BUILD_TYPE}\";
constexpr const char* sanitize = \"${SANITIZE}\";
constexpr const char* flags = \"${FLAGS}\";
}  // namespace ikbench::build_info
")
file(CONFIGURE OUTPUT ${OUT} CONTENT "${content}" @ONLY)
