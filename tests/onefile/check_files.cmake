# cmake -DSCRIPT=… -DROOT=… -DBINARY=… -DMODULES=… -DOUT=… -DCXX=… -P check_files.cmake: the two
# files come out the same twice, hold all that they include but system headers, once, and the header
# is enough for a program without exceptions and run-time types.
function(write_into folder)
  execute_process(COMMAND "${CMAKE_COMMAND}" "-DROOT=${ROOT}" "-DBINARY=${BINARY}"
      "-DMODULES=${MODULES}" "-DOUT=${folder}" -P "${SCRIPT}"
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${OUT}")
write_into("${OUT}/first")
write_into("${OUT}/second")
foreach(name tetloft.hpp tetloft.cpp)
  file(SHA256 "${OUT}/first/${name}" first)
  file(SHA256 "${OUT}/second/${name}" second)
  if(NOT first STREQUAL second)
    message(FATAL_ERROR "${name} differs from run to run")
  endif()
endforeach()

# Each file of ours stands in one of the two, once; umbrella and command line do not.
file(GLOB expected RELATIVE "${ROOT}" "${ROOT}/include/tetloft/*.hpp" "${ROOT}/src/*/*.hpp"
  "${ROOT}/src/*/*.cpp" "${ROOT}/src/*/*.cpp.in" "${ROOT}/src/io/*/*.hpp" "${ROOT}/src/io/*/*.cpp")
list(FILTER expected EXCLUDE REGEX "^src/cli/|/tetloft[.]hpp$")
set(parts)
set(system)
foreach(name tetloft.hpp tetloft.cpp)
  file(STRINGS "${OUT}/first/${name}" lines REGEX "^(// --- |[ \t]*#[ \t]*(include|pragma once))")
  foreach(line IN LISTS lines)
    if(line MATCHES "^// --- (.*)$")
      list(APPEND parts "${CMAKE_MATCH_1}")
    elseif(line MATCHES "^#include (<[a-z_/]+([.]h)?>)$")
      list(APPEND system "${CMAKE_MATCH_1}")
    elseif(NOT "${name} ${line}" STREQUAL "tetloft.cpp #include \"tetloft.hpp\"")
      message(FATAL_ERROR "${name} still says ${line}")
    endif()
  endforeach()
endforeach()
list(REMOVE_ITEM parts include/tetloft/tetloft.h)
list(SORT parts)
list(SORT expected)
if(NOT parts STREQUAL expected)
  set(missing ${expected})
  list(REMOVE_ITEM missing ${parts})
  message(FATAL_ERROR "not each file once; missing: ${missing}")
endif()
list(LENGTH system all)
list(REMOVE_DUPLICATES system)
list(LENGTH system distinct)
if(NOT all EQUAL distinct OR all EQUAL 0)
  message(FATAL_ERROR "${all} system headers, ${distinct} of them distinct")
endif()

file(WRITE "${OUT}/first/alone.cpp" "#include \"tetloft.hpp\"\n")
execute_process(COMMAND "${CXX}" -std=c++20 -fsyntax-only -fno-exceptions -fno-rtti -Wall -Wextra
    -Wshadow -Wconversion -pedantic-errors -Werror "${OUT}/first/alone.cpp"
  COMMAND_ERROR_IS_FATAL ANY)
