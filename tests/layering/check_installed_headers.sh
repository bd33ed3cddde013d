#!/usr/bin/env bash
# Fails with file:line where an installed header includes a header of the core that is not installed: core/CMakeLists.txt
# and widgets/CMakeLists.txt list those that are.
#   check_installed_headers.sh ROOT        ROOT is the folder that holds core and widgets
set -u
cd "$1" || exit 2

listed=$(grep -hoE 'holdfast/[a-z0-9_/]+\.h\b' core/CMakeLists.txt widgets/CMakeLists.txt | sort -u)
failures=0
while IFS= read -r found; do
  header=${found##*<} header=${header%%>*}
  [ -e "core/$header" ] && ! grep -qxF "$header" <<<"$listed" || continue
  echo "$found"
  failures=1
done < <({ sed s,^,core/, <<<"$listed"; find widgets -name '*.h' ! -name '*_internal.h'; } |
  xargs grep -snE '^#include <holdfast/' /dev/null)
exit "$failures"
