# SPDX-License-Identifier: LGPL-2.1-or-later
#
# cmake -D PROGRAM=program -D PAGES=folder -P compare.cmake
#   Runs a program in the working folder. Fails where README.md in the folder of its pages does not show its output, all of
#   it in a block fenced by ```text, or where a picture there (*.svg) is not the one that the program has drawn.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE output)
file(READ ${PAGES}/README.md page)
string(FIND "${page}" "```text\n${output}```\n" place)
if(place EQUAL -1)
  message(SEND_ERROR "${PAGES}/README.md does not show what ${PROGRAM} prints:\n${output}")
endif()

file(GLOB pictures RELATIVE ${PAGES} ${PAGES}/*.svg)
foreach(picture ${pictures})
  file(SHA256 ${PAGES}/${picture} committed)
  file(SHA256 ${picture} drawn)
  if(NOT committed STREQUAL drawn)
    message(SEND_ERROR "${PAGES}/${picture} is not what ${PROGRAM} draws")
  endif()
endforeach()
