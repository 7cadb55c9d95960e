# SPDX-License-Identifier: LGPL-2.1-or-later
#
# cmake -DLIBRARY=libabut.so -DRESULT=leaf_first.inc -P leaf_first.cmake
#   Writes the names of all libraries that LIBRARY needs, those first that need no other one, as C strings.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ldd ${LIBRARY} OUTPUT_VARIABLE found COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^ \t\n]+ => /[^ \t\n]+" found "${found}")
set(paths)
foreach(line ${found})
  string(REGEX MATCH "^([^ ]+) => (.+)$" line "${line}")
  set(path_of_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  list(APPEND paths ${CMAKE_MATCH_2})
endforeach()

# needs_of_<path>: one call for all files.
execute_process(COMMAND readelf --dynamic --wide ${LIBRARY} ${paths} OUTPUT_VARIABLE entries COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "[" "<" entries "${entries}") # brackets would hold a list together
string(REPLACE "]" ">" entries "${entries}")
string(REGEX MATCHALL "File: [^\n]+|\\(NEEDED\\)[^\n]+" entries "${entries}")
foreach(entry ${entries})
  if(entry MATCHES "^File: (.+)$")
    set(file ${CMAKE_MATCH_1})
  elseif(entry MATCHES "<(.+)>")
    list(APPEND needs_of_${file} ${CMAKE_MATCH_1})
  endif()
endforeach()

# Global: a function has variables of its own.
function(visit path)
  foreach(name ${needs_of_${path}})
    get_property(is_seen GLOBAL PROPERTY seen_${name})
    if(DEFINED path_of_${name} AND NOT is_seen)
      set_property(GLOBAL PROPERTY seen_${name} TRUE)
      visit(${path_of_${name}})
      set_property(GLOBAL APPEND_STRING PROPERTY order "\"${name}\",\n")
    endif()
  endforeach()
endfunction()
visit(${LIBRARY})
get_property(order GLOBAL PROPERTY order)
file(WRITE ${RESULT} "${order}")
