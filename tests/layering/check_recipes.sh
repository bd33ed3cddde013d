#!/usr/bin/env bash
# Fails where docs/recipes.md lists other files than those that hold the names that a recipe follows. Each section says
# "Follow `NAME`", or several, up to the first full stop, and lists files of core, widgets and app: - `FILE`.
#   check_recipes.sh ROOT
set -u
cd "$1" || exit 2

# recipes: one line a recipe, its title and its names.
recipes() {
  awk '/^## / { title = substr($0, 4) } /^Follow / { sub(/\. .*/, ""); sub(/^Follow /, ""); print title "\t" $0 }' docs/recipes.md
}

failures=0
while IFS=$'\t' read -r title names; do
  mapfile -t names < <(grep -o '`[^`]*`' <<<"$names" | tr -d '`')
  listed=$(awk -v title="## $title" '/^## / { here = $0 == title } here && /^- `/ { split($0, parts, "`"); print parts[2] }' docs/recipes.md |
    sed -E 's/(.*)\.\{h,cpp\}/\1.h\n\1.cpp/' | sort)
  found=$(grep -rlwF --include='*.h' --include='*.cpp' "${names[@]/#/-e}" core widgets app | sort)
  if ! difference=$(diff <(echo "$listed") <(echo "$found")); then
    printf 'docs/recipes.md, %s: < is listed, > is found\n%s\n' "$title" "$difference"
    failures=1
  fi
done < <(recipes)
[ -n "$(recipes)" ] || { echo "docs/recipes.md has no recipes" && failures=1; }
exit "$failures"
