# SPDX-License-Identifier: LGPL-2.1-or-later
#
# awk -f header.awk HEADER
#   A header as Doxygen is to read it, line by line the same: keys of the bibliography become links, the dots of products
#   and abbreviations end no sentence, and what comments set off by two blanks or more, formulas mostly, stays as it is.

# How far the text of a comment's line is set off; -1 for other lines and empty ones.
function indentation(line) {
  if (!match(line, /^ *(\/\/\/|\*) +/) || line ~ /^ *\*\//) return -1
  return RLENGTH - index(line, line ~ /^ *\// ? "///" : "*") - (line ~ /^ *\// ? 2 : 0)
}

function with_links(line,    result, key) {
  while (match(line, /\[(Dyyak|[A-Z][A-Za-z]+(18|19|20)[0-9][0-9])[],]/)) {
    key = substr(line, RSTART + 1, RLENGTH - 2)
    result = result substr(line, 1, RSTART) "@ref doc_bibliography_md__" tolower(key) " \"" key "\""
    line = substr(line, RSTART + RLENGTH - 1)
  }
  return result line
}

function translated(line) {
  gsub(/ \. /, " · ", line)
  gsub(/ (sec|ch|art|app)\. /, "&\001", line)
  gsub(/ \001/, "\\ ", line)
  gsub(/`/, "``", line)
  return with_links(line)
}

# The line before is held back, since what begins or ends a formula stands at its end.
{
  indent = indentation($0)
  if (indent > 0 && $0 ~ /^ *(\/\/\/|\*) +- /) in_list = 1
  else if (indent == 1) in_list = 0
  was_formula = formula
  formula = indent >= 3 && !in_list && held_is_comment
  if (formula && !was_formula) held = held " @verbatim"
  if (!formula && was_formula) held = held " @endverbatim"
  if (NR > 1) print held
  held_is_comment = $0 ~ /^ *(\/\/\/|\*)/ && $0 !~ /\*\//
  held = $0
  if (formula) sub(/\*/, " ", held)
  else held = translated(held)
}

END { print held }
