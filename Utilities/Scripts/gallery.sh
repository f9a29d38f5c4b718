#!/usr/bin/env bash
# Renders the benchmark's scenes with every technique, small, into Documentation/Gallery.md and
# Documentation/Images/Gallery, with the error of each visibility against ray tracing.
# Usage: gallery.sh [build folder]       (default: build/quickstart; needs the tool softshadow)
# Environment: SCENES, TECHNIQUES (names with blanks between), WIDTH, HEIGHT (pixels of a picture),
# RAYS (of the reference, per pixel and light).
# Ends with an error if a technique could not render a scene; its picture is left out then.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
tool="${1:-build/quickstart}/bin/softshadow"
scenes="${SCENES:-bunny assembly fused molecule fence street foliage}"
techniques="${TECHNIQUES:-$("$tool" --list-techniques | grep -oE '^[a-z][a-z0-9_-]*')}"
width="${WIDTH:-240}"
height="${HEIGHT:-180}"
rays="${RAYS:-256}"
page=Documentation/Gallery.md
images=Documentation/Images/Gallery

# Techniques whose light is bright in its middle by default: the reference's is uniform.
gaussian=" $("$tool" --list-techniques | awk '/^[a-z]/ { name = $1 } /weights=gaussian/ { printf "%s ", name }')"

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
mkdir "$work/images"
failed=0
"$tool" benchmark --write-models "$work/models" >/dev/null # meshes that are made, not kept

# The value of a measure in the report of softshadow compare.
measure() {
    python3 -c 'import json, sys
report = json.load(open(sys.argv[1]))
lights = report["lights"]
print("%.4f" % max(light["all"]["rmse"] for light in lights))' "$1"
}

{
    echo "# Gallery"
    echo
    echo "Made by \`Utilities/Scripts/gallery.sh\`: the benchmark's scenes with every technique at its defaults and a uniform light,"
    echo "$width x $height pixels. The number is the RMSE of the visibility over all pixels against ray tracing with $rays"
    echo "rays per light (of the light with the largest). What the techniques are for: [Choosing](Choosing.md)."
    echo "The errors belong to these small pictures and to the version that drew them; the command makes them anew."
} >"$work/page.md"

for scene in $scenes; do
    file="Utilities/Benchmark/Scenes/$scene.json"
    echo "$scene" >&2
    size=(--width "$width" --height "$height" --models "$work/models")
    "$tool" reference "$file" -o "$work/truth.exr" --samples "$rays" "${size[@]}" >"$work/log" 2>&1 ||
        { cat "$work/log" >&2; exit 1; }
    {
        echo
        echo "## $scene"
        echo
    } >>"$work/page.md"
    names="|"
    rules="|"
    pictures="|"
    errors="|"
    column=0
    # Prints the row of pictures that is complete.
    flush() {
        [ "$column" -gt 0 ] || return 0
        printf '%s\n%s\n%s\n%s\n\n' "$names" "$rules" "$pictures" "$errors" >>"$work/page.md"
        names="|"
        rules="|"
        pictures="|"
        errors="|"
        column=0
    }
    for technique in $techniques; do
        picture="$work/images/$scene-$technique.jpg"
        link="![$scene, $technique](Images/Gallery/$scene-$technique.jpg)"
        options=()
        [[ "$gaussian" != *" $technique "* ]] || options=(--option weights=mean)
        if "$tool" render "$file" --technique "$technique" "${options[@]}" -o "$picture" \
            --visibility "$work/ours.exr" "${size[@]}" >/dev/null 2>"$work/error" &&
            "$tool" compare "$work/truth.exr" "$work/ours.exr" --report "$work/report.json" >/dev/null; then
            error="$(measure "$work/report.json")"
        else
            cat "$work/error" >&2
            failed=1
            rm -f "$picture"
            link=""
            error="not rendered"
        fi
        names+=" \`$technique\` |"
        rules+=" --- |"
        pictures+=" $link |"
        errors+=" $error |"
        column=$((column + 1))
        [ "$column" -lt 3 ] || flush
    done
    flush
done
mkdir -p "$images"
rm -f "$images"/*.jpg
find "$work/images" -name '*.jpg' -exec mv -t "$images" {} +
mv "$work/page.md" "$page"
echo "$page, $(du -sk "$images" | cut -f 1) KiB of pictures"
exit "$failed"
