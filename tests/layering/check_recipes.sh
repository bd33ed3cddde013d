#!/usr/bin/env bash
# Fails where docs/recipes.md lists other files than those that the recipe's example is in: each section follows one name
# ("Follow `NAME`") and lists the files of core, widgets and app that hold it, headers and sources as `file.{h,cpp}`.
#   check_recipes.sh ROOT
set -u
cd "$1" || exit 2

recipes=$(awk '
  /^## / { title = substr($0, 4) }
  match($0, /^Follow `[^`]+`/) { print title "\t" substr($0, 9, RLENGTH - 9) }' docs/recipes.md)
[ -n "$recipes" ] || { echo "docs/recipes.md has no recipes" && exit 2; }
failures=0
while IFS=$'\t' read -r title name; do
  listed=$(awk -v title="## $title" '$0 == title { here = 1; next } /^## / { here = 0 } here && match($0, /^- `[^`]+`/) { print substr($0, 4, RLENGTH - 4) }' \
    docs/recipes.md | while read -r file; do eval "printf '%s\n' $file"; done | sort)
  found=$(grep -rlw --include='*.h' --include='*.cpp' -e "$name" core widgets app | sort)
  difference=$(diff <(echo "$listed") <(echo "$found")) || {
    echo "docs/recipes.md, $title (listed <, files that hold $name >):"
    echo "$difference"
    failures=1
  }
done <<<"$recipes"
exit "$failures"
