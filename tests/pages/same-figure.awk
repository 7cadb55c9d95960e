# SPDX-License-Identifier: LGPL-2.1-or-later
#
# awk -f same-figure.awk MADE SHOWN
#   Ends with 1 where two SVG files differ by more than round-off: in their texts, in a number by more than .1 (a tenth of
#   a pixel) and a hundredth of it, or in a colour by more than 3 of 255 in red, green or blue.

# Takes what matches out of a line and returns the rest; the matches are in `taken`, their number in `n_taken`.
function without(pattern, line,    rest) {
  n_taken = 0
  while (match(line, pattern)) {
    taken[++n_taken] = substr(line, RSTART, RLENGTH)
    rest = rest substr(line, 1, RSTART - 1) "~"
    line = substr(line, RSTART + RLENGTH)
  }
  return rest line
}

function component(colour, place) {
  return 16 * digit(substr(colour, place, 1)) + digit(substr(colour, place + 1, 1))
}

function digit(character) { return index("0123456789abcdef", character) - 1 }

function distance(a, b) { return a > b ? a - b : b - a }

function same_colours(a, b,    place) {
  for (place = 2; place <= 6; place += 2)
    if (distance(component(a, place), component(b, place)) > 3) return 0
  return 1
}

function same_numbers(a, b) { return distance(a, b) <= .1 || distance(a, b) <= .01 * distance(a, 0) }

function same(a, b,    n, i, first) {
  a = without("#[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]", a)
  n = n_taken
  for (i = 1; i <= n; ++i) first[i] = taken[i]
  b = without("#[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]", b)
  if (n_taken != n) return 0
  for (i = 1; i <= n; ++i)
    if (!same_colours(first[i], taken[i])) return 0

  a = without("-?[0-9]+(\\.[0-9]+)?(e-?[0-9]+)?", a)
  n = n_taken
  for (i = 1; i <= n; ++i) first[i] = taken[i] + 0
  if (without("-?[0-9]+(\\.[0-9]+)?(e-?[0-9]+)?", b) != a) return 0
  for (i = 1; i <= n; ++i)
    if (!same_numbers(first[i], taken[i] + 0)) return 0
  return 1
}

NR == FNR {
  made[FNR] = $0
  n_made = FNR
  next
}

made[FNR] != $0 && !same(made[FNR], $0) {
  print FILENAME ":" FNR ": " substr($0, 1, 200) > "/dev/stderr"
  bad = 1
  exit 1
}

END { exit bad || n_made != FNR }
