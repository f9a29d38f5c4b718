#!/usr/bin/env bash
# Takes the picture of a failed image test as its new baseline, after somebody has looked at it.
# Usage: update-baseline.sh <picture> <module>|<folder>
#   update-baseline.sh build/test/Testing/Temporary/TestFooPass.png Sampled
#   update-baseline.sh build/test/Testing/Temporary/Bunny.png Testing
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
if [ $# -ne 2 ] || [ ! -f "$1" ]; then
    sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    exit 2
fi
folder="$root/Modules/$2/Testing"
[ -d "$folder" ] || folder="$root/$2"
if [ ! -d "$folder" ]; then
    echo "neither a module nor a folder of the project: $2" >&2
    exit 2
fi
mkdir -p "$folder/Data/Baseline"
cp -v "$1" "$folder/Data/Baseline/"
