# SPDX-License-Identifier: LGPL-2.1-or-later
#
# awk -v page=PATH -v pages=LIST -f markdown.awk -f page.awk PATH
#   A page as Doxygen wants it: headings have identifiers, links lead to pages of the site (LIST has their paths, one a
#   line) or to the copies of files beside them, formulas between dollars stand between \f$, \f[ and \f].

# The identifier of a page, and of a heading on it.
function id_of(path, anchor) {
  gsub(/[^A-Za-z0-9_]/, "_", path)
  return path (anchor == "" ? "" : "__" anchor)
}

# Where a link leads: to a page or heading of the site, a tutorial's program, or the copy of a file.
function target_of(link,    path, anchor) {
  if (link ~ /^[a-z]+:/) return link
  if (link ~ /#/) {
    anchor = link
    sub(/^[^#]*#/, "", anchor)
    sub(/#.*/, "", link)
  }
  path = link == "" ? page : path_of(page, link)
  if (path in is_page) return anchor == "" && path == "README.md" ? "index.html" : "@ref " id_of(path, anchor)
  if (path == "doc/changes" || path == "CHANGELOG.md") return "@ref " id_of("doc/changes/CHANGELOG.md")
  if (path ~ /\/step-[0-9]+\.cc$/) {
    sub(/.*\//, "", path)
    sub(/\.cc$/, "_8cc-example.html", path)
    return path
  }
  return "files/" path
}

# Text without code: links, pictures and formulas.
function translated_text(text,    before, result, link, alt) {
  while (match(text, /!\[[^\]]*\]\([^)]*\)|\]\([^) ]+\)|\$\$|<img src="[^"]*"/)) {
    link = substr(text, RSTART, RLENGTH)
    before = substr(text, 1, RSTART - 1)
    text = substr(text, RSTART + RLENGTH)
    result = result with_formulas(before)
    if (link == "$$") {
      displayed = !displayed
      result = result (displayed ? "\\f[" : "\\f]")
    } else if (link ~ /^</) {
      gsub(/^[^"]*"|"$/, "", link)
      result = result "<img src=\"files/" path_of(page, link) "\""
    } else if (link ~ /^!/) {
      alt = link
      sub(/^!\[/, "", alt)
      sub(/\].*/, "", alt)
      sub(/.*\(/, "", link)
      sub(/\)$/, "", link)
      result = result "<img src=\"files/" path_of(page, link) "\" alt=\"" alt "\"/>"
    } else
      result = result "](" target_of(substr(link, 3, length(link) - 3)) ")"
  }
  return result with_formulas(text)
}

function with_formulas(text) {
  if (!displayed) gsub(/\$/, "\\f$", text)
  return text
}

# A line: what stands between backticks stays as it is; such code may go on in the next line. Two backticks, for to
# Doxygen a ' ends what begins with one; and tags where the code has a \| in a table, of which Doxygen would show both.
function translated(line,    result, place, span) {
  line = with_plain_links(line)
  while (place = index(line, "`")) {
    result = result translated_span(substr(line, 1, place - 1))
    line = substr(line, place + 1)
    place = index(line, "`")
    span = substr(line, 1, place - 1)
    if (!in_code && index(span, "\\|")) {
      result = result "<code>" escaped(span) "</code>"
      line = substr(line, place + 1)
    } else {
      result = result "``"
      in_code = !in_code
    }
  }
  return result translated_span(line)
}

# Code as the text of a link, which Doxygen would show with its backticks.
function with_plain_links(line,    result, text) {
  while (!in_code && match(line, /\[`[^`]*`\]\(/)) {
    text = substr(line, RSTART + 2, RLENGTH - 5)
    result = result substr(line, 1, RSTART) escaped(text) "]("
    line = substr(line, RSTART + RLENGTH)
  }
  return result line
}

function escaped(code) {
  gsub(/&/, "\\&amp;", code)
  gsub(/</, "\\&lt;", code)
  gsub(/>/, "\\&gt;", code)
  return code
}

function translated_span(text) { return in_code ? text : translated_text(text) }

# A heading with its identifier, without backticks. The main page's are no entries of the tree, which shows the pages in
# their place.
function translated_heading(line,    id) {
  gsub(/`/, "", line)
  if (!headings++) return line " {#" (page == "README.md" ? "mainpage" : id_of(page)) "}\n\n@tableofcontents{html:2}"
  id = id_of(page, anchor_of(line))
  return page == "README.md" ? "@anchor " id "\n" line : line " {#" id "}"
}

BEGIN {
  while ((getline line < pages) > 0) is_page[line] = 1
}

{
  code = is_code($0)
  if (code) {
    print
    next
  }
  if (/^ *$/) in_code = 0
  print /^#+ / ? translated_heading($0) : translated($0)
}
