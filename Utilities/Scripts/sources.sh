#!/usr/bin/env bash
# Prints the project's own files with the given endings, one per line, relative to the root.
# Usage: sources.sh h cxx glsl
# Not git's list: the scripts also serve an unpacked archive.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folders=()
for folder in Modules Testing Utilities Examples; do
    [ ! -d "$folder" ] || folders+=("$folder")
done
for ending in "$@"; do
    find "${folders[@]}" -name "*.$ending" -not -path '*/build*/*'
done | sort
