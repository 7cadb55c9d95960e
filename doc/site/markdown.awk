# SPDX-License-Identifier: LGPL-2.1-or-later
#
# What awk programs that read our pages share.

# The anchor that GitHub gives a heading: lower case, blanks as hyphens, letters, digits, hyphens and underscores; a
# number behind it where the page has had that heading before. Called once for every heading of a page but the first.
function anchor_of(heading) {
  sub(/^#+ +/, "", heading)
  gsub(/\]\([^)]*\)/, "", heading)
  heading = tolower(heading)
  gsub(/[^a-z0-9 _-]/, "", heading)
  gsub(/ /, "-", heading)
  return n_anchors[heading]++ ? heading "-" (n_anchors[heading] - 1) : heading
}

# What a link that stands on `page` means, as a path from the root of the checkout.
function path_of(page, link,    parts, n, kept, i, path) {
  if (page ~ /\//) {
    sub(/\/[^\/]*$/, "", page)
    link = page "/" link
  }
  n = split(link, parts, "/")
  for (i = 1; i <= n; ++i)
    if (parts[i] == "..") --kept
    else if (parts[i] != "." && parts[i] != "") stack[++kept] = parts[i]
  for (i = 1; i <= kept; ++i)
    path = path (i > 1 ? "/" : "") stack[i]
  return path
}

# Whether the present line belongs to a block of code. Called once for every line.
function is_code(line) {
  if (line ~ /^ *```/) {
    fenced = !fenced
    was_code = 0
    return 1
  }
  if (fenced) return 1
  if (line ~ /^ *$/) {
    was_blank = 1
    return 0
  }
  was_code = line ~ /^(    |\t)/ && (was_code || was_blank) && !in_list
  if (line ~ /^ ? ? ?([-*+]|[0-9]+\.) /) in_list = 1
  else if (line ~ /^[^ ]/) in_list = 0
  was_blank = 0
  return was_code
}
