# A ```cpp block of README must be EXAMPLE, character by character.
# cmake -DREADME=… -DEXAMPLE=… -P check_readme.cmake
cmake_minimum_required(VERSION 3.25)
file(READ "${README}" readme)
file(READ "${EXAMPLE}" example)
string(FIND "${readme}" "```cpp\n${example}```\n" at)
if(at EQUAL -1)
  message(FATAL_ERROR "${README} does not show ${EXAMPLE}")
endif()
