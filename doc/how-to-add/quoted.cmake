# SPDX-License-Identifier: LGPL-2.1-or-later
#
# cmake -D PAGE=page.md -D QUOTED=file;... -D COMMAND=program;argument;... -P quoted.cmake
#   Fails where the page does not quote a file beside it, all of it but for the licence's line, in a fenced block, or does
#   not end a fenced block with what the command prints in the working folder.
cmake_minimum_required(VERSION 3.25)
file(READ ${PAGE} page)
cmake_path(GET PAGE PARENT_PATH folder)
foreach(file ${QUOTED})
  file(READ ${folder}/${file} content)
  string(REGEX REPLACE "^// SPDX[^\n]*\n" "" content "${content}")
  string(FIND "${page}" "\n${content}```\n" place)
  if(place EQUAL -1)
    message(SEND_ERROR "${PAGE} does not quote ${file} as it is")
  endif()
endforeach()

execute_process(COMMAND ${COMMAND} OUTPUT_VARIABLE output ERROR_QUIET)
string(FIND "${page}" "\n${output}```\n" place)
if(output STREQUAL "" OR place EQUAL -1)
  message(SEND_ERROR "${PAGE} does not show what ${COMMAND} prints:\n${output}")
endif()
