#!/usr/bin/env bash
# Builds SoftShadows in Release and renders the bundled bunny scene with every technique there is. On
# Debian 12 it first installs the packages that are missing (with sudo, unless run by root).
# Usage: Utilities/quickstart.sh [folder for the pictures]     (default: quickstart)
# Environment: BUILD_DIR (default build/quickstart), JOBS (default: number of cores).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build="${BUILD_DIR:-build/quickstart}"
jobs="${JOBS:-$(nproc)}"
pictures="${1:-quickstart}"
scene=Testing/Data/Scenes/bunny.json

Utilities/Scripts/install-packages.sh build run
echo "Configuring and building in $build"
Utilities/Scripts/configure.sh "$build" -DBUILD_TESTING=OFF
cmake --build "$build" -j "$jobs"
tool="$build/bin/softshadow"

# One technique per line that is not indented: its name is the first word.
techniques="$("$tool" --list-techniques | grep -oE '^[a-z][a-z0-9_-]*')"
mkdir -p "$pictures"
failed=0
for technique in $techniques; do
    picture="$pictures/bunny-$technique.png"
    if "$tool" render "$scene" --technique "$technique" -o "$picture"; then
        echo "  $picture"
    else
        echo "  $technique failed" >&2
        failed=$((failed + 1))
    fi
done
echo "The pictures are in $(cd "$pictures" && pwd)"
[ "$failed" -eq 0 ]
