# SPDX-License-Identifier: LGPL-2.1-or-later
#
# awk -f same-figure.awk MADE SHOWN
#   Ends with 1 where two SVG files differ by more than round-off: in their texts, in a number by more than .1 (a tenth of
#   a pixel) and a hundredth of it, or in a colour by more than 3 of 255.
function numbers(line,    rest) { # what stands between numbers; these in `value`
  n = 0
  while (match(line, /-?[0-9]+(\.[0-9]+)?(e-?[0-9]+)?/)) {
    value[++n] = substr(line, RSTART, RLENGTH)
    rest = rest substr(line, 1, RSTART - 1) "#"
    line = substr(line, RSTART + RLENGTH)
  }
  return rest line
}

# Colours as three numbers.
function with_colours(line,    result) {
  while (match(line, /#[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]/)) {
    result = result substr(line, 1, RSTART - 1) " rgb " part(line, 1) " " part(line, 3) " " part(line, 5)
    line = substr(line, RSTART + 7)
  }
  return result line
}

function part(line, place) {
  return 16 * digit(substr(line, RSTART + place, 1)) + digit(substr(line, RSTART + place + 1, 1)) " rgb"
}

function digit(character) { return index("0123456789abcdef", character) - 1 }

function different(a, b) {
  difference = a > b ? a - b : b - a
  return difference > tolerance && difference > .01 * (a > 0 ? a : -a)
}

NR == FNR {
  made[FNR] = $0
  n_made = FNR
  next
}

{
  if (made[FNR] == $0) next
  tolerance = .1
  text = numbers(with_colours(made[FNR]))
  n_first = n
  for (i = 1; i <= n; ++i) first[i] = value[i]
  if (numbers(with_colours($0)) != text || n != n_first) bad = 1
  for (i = 1; i <= n && !bad; ++i) bad = different(first[i] + 0, value[i] + 0)
  if (bad) {
    print FILENAME ":" FNR ": " substr($0, 1, 200) > "/dev/stderr"
    exit 1
  }
}

END { exit bad || n_made != FNR }
