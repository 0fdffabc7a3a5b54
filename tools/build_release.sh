#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the given targets (default: all) into build/release. Quiet when there is nothing to do;
# everything it says goes to stderr.
set -euo pipefail
cd "$(dirname "$0")/.."
if [[ ! -e build/release/build.ninja ]]; then
    cmake --preset release >&2
fi
cmake --build build/release --target "${@:-all}" >&2
