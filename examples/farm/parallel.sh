#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Slices on many machines by GNU parallel, merged here.
#
#   parallel.sh COUNT OUTPUT dewbow-render-arguments…
#
# HOSTS names the machines, as parallel's --sshlogin wants them ("4/node1,4/node2"); without it this
# machine does all. They must see the same files under the same names, and have the same processor
# features: dewbow merge refuses slices of another kind. A slice that fails is tried again twice, and
# goes on where it was.
set -euo pipefail
dewbow=${DEWBOW:-dewbow}
count=$1 output=$2
shift 2
stem=$(realpath -m "${output%.*}")

# One line for the shell of the machine that takes the slice.
render_slice() {
    local slice=$stem.slice-{}-of-$count.dewbow
    printf '[ -e %q ] || { resume=; [ ! -e %q ] || resume=--resume; ' "$slice" "$slice.dewbow"
    printf '%q ' "$dewbow" render "$@" --slice "{}/$count" -o "$slice"
    printf '$resume; }'
}
job=$(render_slice "$@")
job=${job//\\\{\\\}/\{\}}

seq "$count" | parallel --retries 3 --halt now,fail=1 ${HOSTS:+--sshlogin "$HOSTS"} \
    --workdir "$PWD" --jobs "${JOBS:-1}" "$job"
"$dewbow" merge "$stem".slice-*-of-"$count".dewbow -o "$output"
