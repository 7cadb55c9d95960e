# SPDX-License-Identifier: LGPL-2.1-or-later
#
# awk -f markdown.awk -f commands.awk PAGE
#   The commands of a page, one a line: those of blocks of code, joined where a line ends with \, and between backticks
#   those that run a script of contrib/, or a built program with arguments; a test program may stand there without its
#   folder. Remarks behind # are cut off.
function is_command(text) { return text ~ /^(build\/|contrib\/|doc\/site\/|tests\/browser\/|\.ci\/|cmake |ctest |cp |mkdir |awk |sh |mpirun |\/usr\/bin\/)/ }

function is_inline_command(text) {
  return text ~ /^build\/release\/[^ ]+ / || text ~ /^\.ci\/run/ || text ~ /^contrib\/[a-z-]+( |$)/ && is_file(text)
}

function is_file(text) {
  sub(/ .*/, "", text)
  return system("test -f " text) == 0
}

function print_command(text) {
  sub(/ +#.*/, "", text)
  gsub(/ +/, " ", text)
  sub(/ $/, "", text)
  print text
}

{
  if (is_code($0)) {
    line = $0
    sub(/^ +/, "", line)
    if (continued || is_command(line)) {
      command = command line
      continued = sub(/\\$/, "", command)
      if (!continued) {
        print_command(command)
        command = ""
      }
    }
    next
  }
  text = /^ *$/ ? "" : text " " $0
  while (match(text, /`[^`]*`/)) {
    span = substr(text, RSTART + 1, RLENGTH - 2)
    text = substr(text, RSTART + RLENGTH)
    gsub(/ +/, " ", span)
    if (span ~ /^(unit|convergence|regression|extreme)[a-z_]* --gtest/) {
      folder = span
      sub(/[_ ].*/, "", folder)
      span = "build/release/tests/" folder "/" span
    }
    if (is_inline_command(span)) print_command(span)
  }
}
