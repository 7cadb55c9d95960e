# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Read by the scripts beside it, which stand in the root of the checkout then.

# The pages, without the records of changes, whose commands are those of their day.
pages() {
  ls README.md CONTRIBUTING.md CHANGELOG.md
  find doc -name '*.md' -not -path 'doc/changes/*' | LC_ALL=C sort
}

# read_entries FILE: a list of entries, each a line and indented lines `field: value` below it. Sets `entries` and
# `field[entry,name]`.
read_entries() {
  local line entry
  entries=()
  declare -gA field=()
  while IFS= read -r line; do
    if [[ $line == '  '* ]]; then
      line=${line#  }
      field[$entry,${line%%: *}]=${line#*: }
    elif [[ $line && $line != '#'* ]]; then
      entry=$line
      entries+=("$entry")
    fi
  done <"$1"
}

# scratch_copy BUILD SCRATCH: a new folder with what commands read, laid out as the checkout is, its build folder a link.
scratch_copy() {
  rm -rf "$2"
  mkdir -p "$2/build" "$2/tests"
  cp -r ./*.md CMakePresets.json .ci contrib doc prm "$2"
  cp -r tests/data "$2/tests"
  ln -s "$1" "$2/build/release"
}

complaints=0
complain() {
  echo "$*" >&2
  complaints=$((complaints + 1))
}
