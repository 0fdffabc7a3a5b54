#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Renders a scene in slices, one after the other, and merges them: what every farm does, without one.
#
#   slices.sh COUNT OUTPUT dewbow-render-arguments…
#   slices.sh 4 ring.exr ring.glb --spp 1024 --size 1920x1080
#
# A slice that is there already is not rendered again: after an interruption call it once more.
set -euo pipefail
dewbow=${DEWBOW:-dewbow}
count=$1 output=$2
shift 2

slices=()
for ((k = 1; k <= count; ++k)); do
    slice=${output%.*}.slice-$k-of-$count.dewbow
    slices+=("$slice")
    [[ -e $slice ]] && continue
    resume=()
    [[ -e $slice.dewbow ]] && resume=(--resume)
    "$dewbow" render "$@" --slice "$k/$count" -o "$slice" "${resume[@]}"
done
"$dewbow" merge "${slices[@]}" -o "$output"
