# Writes the library as two files to drop into a program: OUT/tetloft.hpp, all of the C++ interface,
# and OUT/tetloft.cpp, all sources but the command line; OUT/tetloft.h beside them once a source
# implements it.
#
# cmake -DROOT=… -DBINARY=… -DOUT=… -DMODULES=… -P amalgamate.cmake
#
# ROOT is the project, BINARY its build folder, where src/MODULE/X.cpp.in became src/MODULE/X.cpp;
# MODULES are the folders of src/, parted by commas, in the order of their sources. Every file stands
# once, after all that it includes. The same tree gives the same bytes.
#
# Texts are passed in quotes, never as lists: they hold semicolons and brackets.

cmake_minimum_required(VERSION 3.25)
foreach(needed ROOT BINARY OUT MODULES)
  if("${${needed}}" STREQUAL "")
    message(FATAL_ERROR "amalgamation: -D${needed}=… is missing")
  endif()
endforeach()
string(REPLACE "," ";" MODULES "${MODULES}")

# Beside those of the C++ standard library, which have neither point nor slash in their names.
set(known_system fcntl.h pthread.h signal.h stddef.h stdint.h sys/mman.h sys/stat.h sys/types.h unistd.h)

# Of the file being written, all but the umbrella's: it holds nothing but includes.
set_property(GLOBAL PROPERTY placed "include/tetloft/tetloft.hpp")

function(refuse shown reason)
  message(FATAL_ERROR "amalgamation: ${shown}: ${reason}")
endfunction()

# The file that an #include of `shown` names, as a path below ROOT; empty for a system header,
# which is noted to be included before all else.
function(resolve shown written result)
  set(${result} "" PARENT_SCOPE)
  if(written MATCHES "^<(tetloft/.*)>$")
    set(path "include/${CMAKE_MATCH_1}")
  elseif(written MATCHES "^\"(.*)\"$")
    set(path "src/${CMAKE_MATCH_1}")
  else()
    string(REGEX REPLACE "[<>]" "" name "${written}")
    if(NOT name MATCHES "^[a-z_]+$" AND NOT name IN_LIST known_system)
      refuse("${shown}" "includes ${written}, which is neither its own nor a known system header")
    endif()
    set_property(GLOBAL APPEND PROPERTY system "${name}")
    return()
  endif()
  if(NOT EXISTS "${ROOT}/${path}")
    refuse("${shown}" "includes ${written}, but there is no ${path}")
  endif()
  set(${result} "${path}" PARENT_SCOPE)
endfunction()

# Parts a text after its last #include, where nothing up to there is conditional, an include guard
# left out: what is moved in front of all would else be moved out of its condition.
function(split_text shown text head_result tail_result)
  string(REGEX REPLACE "\n#ifndef [A-Z_]+_H\n#define [A-Z_]+_H\n" "\n\n\n" probe "${text}")
  string(REGEX MATCHALL "\n[ \t]*#[ \t]*include" all "${probe}")
  string(REGEX MATCHALL "\n#include [<\"][^<>\";\n]+[>\"]" plain "${probe}")
  list(LENGTH all all_count)
  list(LENGTH plain plain_count)
  if(NOT all_count EQUAL plain_count)
    refuse("${shown}" "an #include names no file in plain words")
  endif()
  if(all_count EQUAL 0)
    set(${head_result} "" PARENT_SCOPE)
    set(${tail_result} "${text}" PARENT_SCOPE)
    return()
  endif()
  string(REGEX MATCH ".*\n#include [^\n]*" head "${probe}")
  if(head MATCHES "\n[ \t]*#[ \t]*if")
    refuse("${shown}" "an #include depends on a condition")
  endif()
  string(REGEX MATCH ".*\n#include [^\n]*" head "${text}")
  string(LENGTH "${head}" length)
  string(SUBSTRING "${text}" ${length} -1 tail)
  set(${head_result} "${head}" PARENT_SCOPE)
  set(${tail_result} "${tail}" PARENT_SCOPE)
endfunction()

# Appends a file to what is being written, unless it is there, after all that it includes.
function(place shown file)
  get_property(placed GLOBAL PROPERTY placed)
  if(shown IN_LIST placed)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY placed "${shown}")
  file(READ "${file}" text)
  split_text("${shown}" "\n${text}" head tail)
  string(REGEX MATCHALL "\n#include [<\"][^>\"\n]+[>\"]" lines "${head}")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^\n#include " "" written "${line}")
    resolve("${shown}" "${written}" path)
    if(path)
      place("${path}" "${ROOT}/${path}")
    endif()
  endforeach()
  # The tail may hold texts of the program, in which blank lines count.
  string(REGEX REPLACE "\n#(include |pragma once)[^\n]*" "\n" head "${head}")
  string(REGEX REPLACE "\n\n\n+" "\n\n" head "${head}")
  string(REGEX REPLACE "\n+$" "" head "${head}")
  if(head STREQUAL "")
    string(REPLACE "\n#pragma once\n" "\n" tail "${tail}")
  else()
    string(REGEX REPLACE "^\n+" "\n\n" tail "${tail}")
  endif()
  string(REGEX REPLACE "^\n+" "" text "${head}${tail}")
  set_property(GLOBAL APPEND_STRING PROPERTY text "\n// --- ${shown}\n\n${text}")
endfunction()

# What was placed since the last call, its system headers before it.
function(take result)
  get_property(system GLOBAL PROPERTY system)
  get_property(told GLOBAL PROPERTY told)
  get_property(text GLOBAL PROPERTY text)
  list(REMOVE_DUPLICATES system)
  list(REMOVE_ITEM system ${told})
  list(SORT system)
  set_property(GLOBAL PROPERTY told ${system})
  set_property(GLOBAL PROPERTY text "")
  list(TRANSFORM system REPLACE ".+" "#include <\\0>\n")
  list(JOIN system "" includes)
  set(${result} "${includes}${text}" PARENT_SCOPE)
endfunction()

# All files below ROOT of these patterns, as the compiler gets them.
function(place_all)
  list(TRANSFORM ARGV PREPEND "${ROOT}/")
  file(GLOB files RELATIVE "${ROOT}" ${ARGV})
  list(SORT files)
  foreach(shown IN LISTS files)
    set(file "${ROOT}/${shown}")
    if(shown MATCHES "^(.*)[.]in$")
      set(file "${BINARY}/${CMAKE_MATCH_1}")
      if(NOT EXISTS "${file}")
        refuse("${shown}" "is not configured yet")
      endif()
    endif()
    place("${shown}" "${file}")
  endforeach()
endfunction()

file(GLOB folders RELATIVE "${ROOT}/src" "${ROOT}/src/*/*.cpp")
list(TRANSFORM folders REPLACE "/.*" "")
list(REMOVE_DUPLICATES folders)
list(REMOVE_ITEM folders ${MODULES} cli)
if(folders)
  list(GET folders 0 folder)
  refuse("src/${folder}" "is no module of the list")
endif()

file(STRINGS "${ROOT}/include/tetloft/version.hpp" numbers REGEX "define TETLOFT_VERSION_")
string(REGEX MATCHALL "[0-9]+" numbers "${numbers}")
list(JOIN numbers "." version)

place_all("include/tetloft/*.hpp")
take(text)
file(WRITE "${OUT}/tetloft.hpp" "\
// tetloft ${version}: solids from planar cross sections. All of the C++ interface; the library is
// tetloft.cpp. Written from the headers named below: change those.
//
//   c++ -std=c++20 -O2 -c tetloft.cpp
//   c++ -std=c++20 program.cpp tetloft.o
#ifndef TETLOFT_TETLOFT_HPP
#define TETLOFT_TETLOFT_HPP

${text}
#endif  // TETLOFT_TETLOFT_HPP
")

foreach(module IN LISTS MODULES)
  place_all("src/${module}/*.hpp" "src/${module}/*/*.hpp")
endforeach()
foreach(module IN LISTS MODULES)
  place_all("src/${module}/*.cpp" "src/${module}/*/*.cpp" "src/${module}/*.cpp.in")
endforeach()
take(text)
file(WRITE "${OUT}/tetloft.cpp" "\
// tetloft ${version}: solids from planar cross sections. All of the library; its interface is
// tetloft.hpp. Written from the sources named below: change those.
//
//   c++ -std=c++20 -O2 -c tetloft.cpp
//
// Exact predicates need arithmetic as written: never -ffast-math, nor -ffp-contract=fast. Where a
// processor multiplies and adds in one step, the next lines keep compilers from making use of it;
// fp_self_check() asks whether they did.
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__) && defined(__FP_FAST_FMA)
#pragma GCC optimize(\"fp-contract=off\")
#endif

#include \"tetloft.hpp\"

${text}")

get_property(placed GLOBAL PROPERTY placed)
if("include/tetloft/tetloft.h" IN_LIST placed)
  file(COPY_FILE "${ROOT}/include/tetloft/tetloft.h" "${OUT}/tetloft.h" ONLY_IF_DIFFERENT)
endif()
