# cmake --build BUILD --target amalgamation: BUILD/amalgamation/tetloft.hpp and tetloft.cpp, made of
# the folders in `modules`.
list(JOIN modules "," amalgamated)
set_property(GLOBAL PROPERTY TETLOFT_AMALGAMATE "${CMAKE_COMMAND}" "-DROOT=${PROJECT_SOURCE_DIR}"
  "-DBINARY=${PROJECT_BINARY_DIR}" "-DMODULES=${amalgamated}")
if(NOT PROJECT_IS_TOP_LEVEL)  # the name may be the caller's own
  return()
endif()
get_property(amalgamate GLOBAL PROPERTY TETLOFT_AMALGAMATE)
add_custom_target(amalgamation
  COMMAND ${amalgamate} "-DOUT=${PROJECT_BINARY_DIR}/amalgamation" -P
    "${CMAKE_CURRENT_LIST_DIR}/amalgamate.cmake"
  COMMENT "All of the library as tetloft.hpp and tetloft.cpp" VERBATIM)
