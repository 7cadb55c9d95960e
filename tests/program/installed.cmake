# SPDX-License-Identifier: LGPL-2.1-or-later
#
# cmake -DBUILD=... -DSOURCE=... -DSCENE=... -DBUILD_TYPE=... -P installed.cmake
cmake_minimum_required(VERSION 3.25)
set(prefix ${BUILD}/tests/program/installed)
file(REMOVE_RECURSE ${prefix} ${prefix}-other ${prefix}-alone)

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
# Moved: nothing points into the build folder or to where it was put at first.
file(RENAME ${prefix} ${prefix}-other)
set(prefix ${prefix}-other)
execute_process(COMMAND ${prefix}/bin/abut ${SCENE} --quiet --output ${prefix}/results COMMAND_ERROR_IS_FATAL ANY)
file(READ ${prefix}/results/summary.json summary)
string(JSON status GET ${summary} status)
if(NOT status STREQUAL "converged")
  message(FATAL_ERROR "the installed program has ended with the status ${status}")
endif()

file(COPY ${prefix}/bin/abut DESTINATION ${prefix}-alone)
execute_process(COMMAND ${prefix}-alone/abut ${SCENE} RESULT_VARIABLE status ERROR_VARIABLE message)
if(NOT status EQUAL 1 OR NOT message MATCHES "^abut: the program's library cannot be loaded: libabut.so")
  message(FATAL_ERROR "without its library the program has ended with ${status}: ${message}")
endif()

# As doc/tutorial/README.md says; building all steps would take too long.
foreach(step step-1 step-2 step-3 step-4)
  file(COPY ${SOURCE}/doc/tutorial/${step} DESTINATION ${prefix})
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${step} -B build-${step} -G Ninja -D CMAKE_PREFIX_PATH=${prefix}
                          -D CMAKE_BUILD_TYPE=${BUILD_TYPE}
                  WORKING_DIRECTORY ${prefix} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} --build build-step-1 WORKING_DIRECTORY ${prefix} OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND build-step-1/step-1 WORKING_DIRECTORY ${prefix} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
