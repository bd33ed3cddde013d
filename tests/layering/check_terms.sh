#!/usr/bin/env bash
# Fails with file:line where a source names a thing by a word that docs/glossary.md replaces: what stands in the first
# column of its last table. Strings, comments and names of tests may use them, as may members and scoped names that start
# with a capital; file names may not.
#   check_terms.sh ROOT
set -u
cd "$1" || exit 2

words=$(sed -n '/^| not used/,$ { s/^| \([^|]*\) |.*/\1/p }' docs/glossary.md | grep -o '`[^`]*`' | tr -d '`' | paste -sd'|')
[ -n "$words" ] || { echo "docs/glossary.md has no table of names that are not used" && exit 2; }
mapfile -t sources < <(find core widgets app tests bench examples \( -name '*.h' -o -name '*.cpp' \) 2>/dev/null | sort)
found=$(
  printf '%s\n' "${sources[@]}" | grep -E "/($words)(_test)?\.(h|cpp)\$"
  words=$words perl -ne '
    my $line = $_;
    s/"(\\.|[^"\\])*"//g; s{//.*}{}; s/\bTEST(_[FP])?\(.*//; s/(::|\.|->)[A-Z]\w*//g;
    print "$ARGV:$.:$line" if /(?<![\w:])(?:$ENV{words})(?!\w)/;
    close ARGV if eof' "${sources[@]}"
)
[ -z "$found" ] || { echo "$found" && exit 1; }
