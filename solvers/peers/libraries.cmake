# Each library that has peers, where it is found, as the target ikbench_peer_LIBRARY.
find_package(orocos_kdl QUIET)
if(orocos_kdl_FOUND)
  add_library(ikbench_peer_orocos_kdl INTERFACE)
  target_include_directories(ikbench_peer_orocos_kdl SYSTEM INTERFACE ${orocos_kdl_INCLUDE_DIRS})
  target_link_libraries(ikbench_peer_orocos_kdl INTERFACE ${orocos_kdl_LIBRARIES})
endif()

# By its header: Debian has a configuration of CMake for the C++ library alone.
find_path(NLOPT_INCLUDE_DIR nlopt.h)
find_library(NLOPT_LIBRARY nlopt)
if(NLOPT_INCLUDE_DIR AND NLOPT_LIBRARY)
  add_library(ikbench_peer_nlopt INTERFACE)
  target_include_directories(ikbench_peer_nlopt SYSTEM INTERFACE ${NLOPT_INCLUDE_DIR})
  target_link_libraries(ikbench_peer_nlopt INTERFACE ${NLOPT_LIBRARY})
endif()
