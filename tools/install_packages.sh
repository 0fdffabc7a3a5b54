#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian packages of packages.txt, and those named as arguments, that are missing.
# A stamp under build/ makes it free when nothing has changed. Says what it does on stderr.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t packages < <(sed -e 's/#.*//' packages.txt | xargs -n 1; printf '%s\n' "$@")
mapfile -t packages < <(printf '%s\n' "${packages[@]}" | sed '/^$/d')
stamp="build/.packages-$(printf '%s\n' "${packages[@]}" | sha256sum | cut -c 1-16)"
[[ -e $stamp ]] && exit 0

if ! command -v dpkg-query >/dev/null; then
    echo "dewbow: this is not Debian; these packages, by their Debian names, must be there:" \
         "${packages[*]}" >&2
    exit 0
fi

missing=()
for package in "${packages[@]}"; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $status == installed ]] || missing+=("$package")
done

if ((${#missing[@]})); then
    as_root=()
    if ((EUID != 0)); then
        if command -v sudo >/dev/null && { [[ -t 0 ]] || sudo -n true 2>/dev/null; }; then
            as_root=(sudo)
        else
            echo "dewbow: these packages are missing, and installing them needs root:" >&2
            echo "    apt-get install --no-install-recommends ${missing[*]}" >&2
            exit 1
        fi
    fi
    echo "dewbow: installing ${missing[*]}" >&2
    apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
    "${apt[@]}" update >&2
    "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >&2
fi
mkdir -p build
touch "$stamp"
