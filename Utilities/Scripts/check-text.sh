#!/usr/bin/env bash
# What the compilers do not say: sources and shaders are ASCII, without tabs and trailing blanks, and
# C++ sources begin with the two-line licence.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export LC_ALL=C
mapfile -t files < <(Utilities/Scripts/sources.sh h cxx glsl)

bad=0
# Prints the lines of $file that match a pattern, which none should.
forbid() {
    if grep -nHP "$1" "$file"; then
        echo "$file: $2"
        bad=$((bad + 1))
    fi
}
for file in "${files[@]}"; do
    forbid '[^\x00-\x7F]' "not ASCII"
    forbid '\t' "tab"
    forbid '[ \r]+$' "blank at the end of a line"
    case "$file" in
        *.h | *.cxx)
            if [ "$(head -n 2 "$file" | grep -c '^// SPDX-')" != 2 ]; then
                echo "$file: no SPDX lines"
                bad=$((bad + 1))
            fi
            ;;
    esac
done
echo "text: ${#files[@]} files, $bad complaints"
[ "$bad" -eq 0 ]
