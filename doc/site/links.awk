# SPDX-License-Identifier: LGPL-2.1-or-later
#
# awk -v page=PATH -f markdown.awk -f links.awk PATH
#   The links of a page that lead to files of the checkout, a line each: the line they stand on, the file's path, the
#   anchor where there is one. Code is passed over.
{
  if (is_code($0)) next
  if (/^ *$/) in_code = 0
  text = ""
  n = split($0, spans, "`")
  for (i = 1; i <= n; ++i) {
    if (!in_code) text = text spans[i]
    if (i < n) in_code = !in_code
  }
  while (match(text, /\]\([^) ]+\)|<img src="[^"]*"/)) {
    link = substr(text, RSTART, RLENGTH)
    gsub(/^\]\(|\)$|^<img src="|"$/, "", link)
    text = substr(text, RSTART + RLENGTH)
    if (link ~ /^[a-z]+:/) continue
    anchor = ""
    if (link ~ /#/) {
      anchor = link
      sub(/^[^#]*#/, "", anchor)
      sub(/#.*/, "", link)
    }
    print FNR, link == "" ? page : path_of(page, link), anchor
  }
}
