#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Holds every source to .clang-format (clang-format 14). With --fix, rewrites them instead.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=(--dry-run -Werror)
[[ ${1:-} == --fix ]] && mode=(-i)

folders=()
for folder in src apps tests examples bench; do
    [[ -d $folder ]] && folders+=("$folder")
done
find "${folders[@]}" -name '*.h' -print0 -o -name '*.cpp' -print0 |
    xargs -0 -r clang-format "${mode[@]}"
echo "format: done"
