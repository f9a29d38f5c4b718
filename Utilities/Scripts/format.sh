#!/usr/bin/env bash
# Formats all C++ sources in place; with --check prints the diff that would, and fails if there is one.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
mapfile -t files < <(Utilities/Scripts/sources.sh h cxx)

if [ "${1:-}" != "--check" ]; then
    clang-format -i "${files[@]}"
    exit 0
fi
bad=0
for file in "${files[@]}"; do
    clang-format "$file" | diff -u --label "$file" --label "$file, formatted" "$file" - ||
        bad=$((bad + 1))
done
echo "format: ${#files[@]} files, $bad badly formatted"
[ "$bad" -eq 0 ]
