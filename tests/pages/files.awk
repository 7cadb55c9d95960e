# SPDX-License-Identifier: LGPL-2.1-or-later
#
# awk -f markdown.awk -f files.awk PAGE
#   Writes the files of a page into the working folder: blocks of code behind a text that ends with "save this as `NAME`:".
{
  if (is_code($0)) {
    if (name != "") {
      sub(/^    /, "")
      print > name
      began = 1
    }
    next
  }
  if (/^ *$/) {
    if (began) print > name # may stand within the block
    next
  }
  text = name != "" || text == "" ? $0 : text " " $0
  name = ""
  began = 0
  if (match(text, /[sS]ave this as `[^`]*`:$/)) {
    name = substr(text, RSTART, RLENGTH)
    gsub(/^[^`]*`|`.*/, "", name)
  }
}
