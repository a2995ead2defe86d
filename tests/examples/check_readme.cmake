# A block of README must be EXAMPLE, character by character, and be told by its extension.
# cmake -DREADME=… -DEXAMPLE=… -P check_readme.cmake
cmake_minimum_required(VERSION 3.25)
file(READ "${README}" readme)
file(READ "${EXAMPLE}" example)
get_filename_component(language "${EXAMPLE}" EXT)
string(SUBSTRING "${language}" 1 -1 language)
string(FIND "${readme}" "```${language}\n${example}```\n" at)
if(at EQUAL -1)
  message(FATAL_ERROR "${README} does not show ${EXAMPLE}")
endif()
