# SPDX-License-Identifier: LGPL-2.1-or-later
#
# cmake -D PAGE=page.md -D QUOTED=file;... -P quoted.cmake
#   Fails where the page does not quote a file, all of it but for the licence's line, in a fenced block.
cmake_minimum_required(VERSION 3.25)
file(READ ${PAGE} page)
foreach(file ${QUOTED})
  file(READ ${file} content)
  string(REGEX REPLACE "^// SPDX[^\n]*\n" "" content "${content}")
  string(FIND "${page}" "\n${content}```\n" place)
  if(place EQUAL -1)
    message(SEND_ERROR "${PAGE} does not quote ${file} as it is")
  endif()
endforeach()
