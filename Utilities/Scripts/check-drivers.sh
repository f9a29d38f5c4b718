#!/usr/bin/env bash
# Compares the visibility of every technique under other OpenGL drivers with that under llvmpipe.
# Usage: check-drivers.sh [option...] [driver...]
#   Drivers: llvmpipe-128, softpipe, gl32 (llvmpipe with nothing beyond OpenGL 3.2), softpipe-gl32; all of
#   them if none is named. And zink, over a Vulkan driver that draws in software (Debian:
#   mesa-vulkan-drivers), without a screen: with VTK 9.4 or later and Mesa 23.1 or later (Debian testing).
#   --build DIR       the folder with bin/softshadow (default: build/test)
#   --tool FILE       that program, wherever it is
#   --small           one scene and small pictures, and no closed forms: less than a minute
#   --output DIR      keep pictures of differences and reports there
# Environment: SCENES (names of the benchmark's, or files), TECHNIQUES (with blanks between), WIDTH, HEIGHT.
# Prints a table and fails if any RMSE is above 0.003, or any pixel is off by more than 0.25. Left out are
# silhouettes, and pixels whose centres lie on an edge, of two triangles or of a hard shadow: there drivers
# may see either side. They place corners on a grid of 1/256 pixel, so an edge lies between two drivers' for
# one in 128 of the pixels beside edges: more than that is a failure too.
# With a test program beside the tool, the closed forms are tried under every driver too.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
. Utilities/Scripts/driver-settings.sh
largest_rmse=0.003
largest_error=0.25
largest_share=0.0078

build=build/test
tool=
small=0
output=
drivers=()
while [ $# -gt 0 ]; do
    case "$1" in
        --build) build="$2"; shift ;;
        --tool) tool="$2"; shift ;;
        --small) small=1 ;;
        --output) output="$2"; shift ;;
        -*)
            sed -n '2,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
            exit 2
            ;;
        *) drivers+=("$1") ;;
    esac
    shift
done
tool="${tool:-$build/bin/softshadow}"
[ -x "$tool" ] || { echo "no such program: $tool" >&2; exit 2; }
[ "${#drivers[@]}" -gt 0 ] || drivers=(llvmpipe-128 softpipe gl32 softpipe-gl32)
# All windows share one screen.
[ -n "${DISPLAY:-}" ] || exec Utilities/Scripts/offscreen.sh "${BASH_SOURCE[0]}" --tool "$tool" \
    $([ $small = 0 ] || echo --small) ${output:+--output "$output"} "${drivers[@]}"

if [ $small = 1 ]; then
    scenes="${SCENES:-$PWD/Testing/Data/Scenes/drivers.json}"
    width="${WIDTH:-64}"
    height="${HEIGHT:-48}"
    map=128
else
    scenes="${SCENES:-bunny lights fence assembly}"
    width="${WIDTH:-200}"
    height="${HEIGHT:-150}"
    map=512
fi
techniques="${TECHNIQUES:-hard $("$tool" --list-techniques | grep -oE '^[a-z][a-z0-9_-]*')}"

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
[ -z "$output" ] || mkdir -p "$output"

# render <driver> <scene> <technique> <file>
render() {
    local driver="$1" scene="$2" technique="$3" file="$4"
    local -a options=(--option "map_size=$map")
    [ -f "$scene" ] || scene="Utilities/Benchmark/Scenes/$scene.json"
    case "$technique" in
        hard) technique=sampled; options+=(--option samples=1) ;;
        pcss | sssm) options+=(--option search_width=9 --option filter_width=13) ;;
        traced) options=() ;;
    esac
    with_driver "$driver" "$tool" render "$scene" --technique "$technique" \
        "${options[@]}" --width "$width" --height "$height" -o "$work/picture.png" --visibility "$file" \
        --report "$work/frame.json" >"$work/log" 2>&1 || return 1
    # Or the driver would be compared with itself.
    grep -qE "\"driver\": \"$(driver_pattern "$driver")" "$work/frame.json" ||
        { grep '"driver"' "$work/frame.json" >"$work/log"; return 1; }
}

# Of all lights in a report: the largest RMSE and the largest error, the share of the pixels beside edges
# that lie on their other side, and how many pixels have a value under one driver alone.
measure() {
    awk '{ value = $2; sub(/,/, "", value); if (value == "null") { value = 9 } value += 0 }
        /"all"/ { inside = 1 } /}/ { inside = 0 }
        inside && /"(rmse|maximum)"/ && value > most[$1] { most[$1] = value }
        /"shifted_edges"/ { shifted += value }
        /"edges"/ { edges += value }
        /"only_in_/ { alone += value }
        END { print most["\"rmse\":"] + 0, most["\"maximum\":"] + 0, shifted / (edges + 1e-9), alone + 0 }' "$1"
}

failed=0
compared=0
printf '%-14s %-10s %-10s %8s %8s %8s\n' driver scene technique rmse largest edges
for file in $scenes; do
    scene="$(basename "$file" .json)"
    for technique in $techniques; do
        truth="$work/$scene-$technique.exr"
        if ! render llvmpipe-256 "$file" "$technique" "$truth"; then
            printf '%-14s %-10s %-10s   FAILED\n' llvmpipe-256 "$scene" "$technique"
            cat "$work/log"
            failed=$((failed + 1))
            continue
        fi
        for driver in "${drivers[@]}"; do
            compared=$((compared + 1))
            name="$driver-$scene-$technique"
            if ! render "$driver" "$file" "$technique" "$work/other.exr" ||
                ! "$tool" compare "$truth" "$work/other.exr" --without-edges \
                    --report "$work/$name.json" --diff "$work/$name.png" >"$work/log" 2>&1; then
                printf '%-14s %-10s %-10s   FAILED\n' "$driver" "$scene" "$technique"
                cat "$work/log"
                failed=$((failed + 1))
                continue
            fi
            read -r rmse largest share alone < <(measure "$work/$name.json")
            verdict="$(awk -v r="$rmse" -v e="$largest" -v s="$share" -v a="$alone" \
                -v lr=$largest_rmse -v le=$largest_error -v ls=$largest_share \
                'BEGIN { print (r <= lr && e <= le && s <= ls && a == 0) ? "" : "  FAILED" }')"
            printf '%-14s %-10s %-10s %8.5f %8.4f %8.5f%s\n' \
                "$driver" "$scene" "$technique" "$rmse" "$largest" "$share" "$verdict"
            [ -z "$verdict" ] || failed=$((failed + 1))
            [ -z "$output" ] || cp "$work/$name.json" "$work/$name"*.png "$output"
        done
    done
done

# The closed forms, where the tests are built.
tests="$(dirname "$tool")/SoftShadowsTechniqueTests"
if [ $small = 0 ] && [ -x "$tests" ]; then
    for driver in "${drivers[@]}"; do
        compared=$((compared + 1))
        if with_driver "$driver" "$tests" --gtest_filter='*ClosedForm*' --gtest_brief=1 >"$work/log" 2>&1; then
            printf '%-14s closed forms: %s\n' "$driver" "$(grep -oE '[0-9]+ tests? from .* ran' "$work/log" | tail -n 1)"
        else
            printf '%-14s closed forms FAILED\n' "$driver"
            grep -E 'FAILED|Failure|expected|worst' "$work/log" | head -n 40
            failed=$((failed + 1))
        fi
    done
fi
echo "$compared compared, $failed failed"
[ $failed = 0 ]
