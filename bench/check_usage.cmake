# A name that nothing has is a usage error that lists what there is.
# cmake -DPROGRAM=… -DWORDS=a;b;c -DLISTED=… -P check_usage.cmake
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND "${PROGRAM}" ${WORDS} RESULT_VARIABLE code OUTPUT_VARIABLE out
  ERROR_VARIABLE err TIMEOUT 20)
if(NOT code EQUAL 2)
  message(FATAL_ERROR "${WORDS}: exit code ${code} instead of 2\n${out}${err}")
endif()
string(FIND "${err}" "${LISTED}" at)
if(at EQUAL -1 OR NOT out STREQUAL "")
  message(FATAL_ERROR "${WORDS}: '${LISTED}' is not listed, or there is a result\n${out}${err}")
endif()
