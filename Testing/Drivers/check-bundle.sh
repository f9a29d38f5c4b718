#!/usr/bin/env bash
# Packs the archive for graphics cards with small pictures, unpacks it elsewhere, runs it there with an empty
# environment, and turns its results into a part of a page.
# Usage: check-bundle.sh <build folder> <python>
set -euo pipefail
build="$(realpath "$1")"
python="$2"
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

fail() { echo "$1" >&2; exit 1; }

SIZE="96 64" SAMPLES=64 SCENES=bunny "$root/Utilities/Scripts/gpu-bundle.sh" "$build" "$work/bundle.tar.gz"
size="$(du -m "$work/bundle.tar.gz" | cut -f 1)"
[ "$size" -lt 60 ] || fail "the archive has $size MiB, not under 60"

# A folder with a blank in its name, and the archive's own file gone.
mkdir "$work/else where"
tar -C "$work/else where" -xzf "$work/bundle.tar.gz"
rm "$work/bundle.tar.gz"
cd "$work"
env -i PATH=/usr/bin:/bin HOME="$work" ${DISPLAY:+DISPLAY="$DISPLAY"} \
    ${XAUTHORITY:+XAUTHORITY="$XAUTHORITY"} LIBGL_ALWAYS_SOFTWARE=1 TESTS=Core \
    "$work/else where/softshadows-gpu/run.sh" --rounds 1 || fail "run.sh failed"
grep -qE '[0-9]+ tests? from .* ran' tests.log || fail "no unit test ran"
"$python" "$root/Utilities/Scripts/card-section.py" results.json >section.md
for row in plain pcss cascaded marched; do
    grep -qE "^\| $row[^|]*\| [0-9.]+ \|" section.md || fail "no row of $row in: $(cat section.md)"
done
# The bunny's visibility is as near to the truth as at any size.
awk -F '|' '/^\| cascaded/ { found = 1; exit !($7 < 0.05) } END { exit !found }' section.md ||
    fail "cascaded is not near its reference: $(grep cascaded section.md)"
# A visibility that is wrong altogether is a failure: here the reference says that all is dark.
cp -r "$work/else where/softshadows-gpu" "$work/dark"
"$python" - "$work/dark/References/bunny-soft.raw" <<'END'
import sys
with open(sys.argv[1], "r+b") as file:
    file.readline()
    file.write(bytes(4 * 96 * 64))
END
if TESTS="" "$work/dark/run.sh" --rounds 1 >dark.log 2>&1; then
    fail "a wrong visibility was taken for right"
fi
grep -q 'has an error of' dark.log || fail "the wrong visibility is not named: $(cat dark.log)"
# References of another size are refused.
if TESTS="" "$work/else where/softshadows-gpu/run.sh" --size 64 64 >wrong.log 2>&1; then
    fail "references of another size were taken"
fi
grep -q 'not those of --size' wrong.log || fail "the wrong size is not named: $(cat wrong.log)"
