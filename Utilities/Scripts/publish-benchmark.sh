#!/usr/bin/env bash
# Makes the published benchmark run: all scenes, then every paper's tables, and writes
# Documentation/SpeedAgainstError.md with its pictures, and the README's plot. Words outside the generated
# blocks stay.
#
# Usage: publish-benchmark.sh [--references-only | --document-only | --card FILE]
#   --references-only  traces the references that the run reads, and ends; may be done long before
#   --document-only    fills the document from the last run
#   --card FILE        adds what a graphics card gave: results.json of gpu-bundle.sh's archive
# Settings, from the environment:
#   TOOL           the program (build/bin/softshadow)
#   OUTPUT         where reports go (build/benchmark)
#   REFERENCES     where references are kept, by content of their scenes (~/.cache/softshadows)
#   BUDGET         seconds for the scenes (600); a little more is used
#   PAPER_BUDGET   seconds for all papers together (520)
# A part that fails is reported at the end; the rest goes on.
set -u
self=$(realpath "${BASH_SOURCE[0]}")
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
tool=${TOOL:-build/bin/softshadow}
output=${OUTPUT:-build/benchmark}
references=${REFERENCES:-${XDG_CACHE_HOME:-$HOME/.cache}/softshadows}
budget=${BUDGET:-600}
paper_budget=${PAPER_BUDGET:-520}
document=Documentation/SpeedAgainstError.md
failures=()

# Shares of the papers' time, in percent.
papers=(sssm:32 pvssm:17 sbfs:18 cascaded:12 estimators:18 pcss:3)

try() {
    local name=$1
    shift
    echo "== $name ($(date +%T))"
    "$@" || failures+=("$name")
}

benchmark() {
    bash Utilities/Scripts/offscreen.sh "$tool" benchmark --output "$output" --references "$references" "$@"
}

# What decides which references are read stands here once.
scenes() { benchmark --width 400 --height 300 --reference-samples 1024 --sweep foliage "$@"; }
paper() { benchmark --paper "$1" --reference-samples 256 "${@:2}"; }

trace_references() {
    try "references of the scenes" scenes --references-only
    for entry in "${papers[@]}"; do
        try "references of ${entry%:*}" paper "${entry%:*}" --references-only
    done
}

measure() {
    try "scenes" timeout -k 10 $((budget * 3 / 2 + 120)) bash "$self" --scenes
    for entry in "${papers[@]}"; do
        local seconds=$((paper_budget * ${entry#*:} / 100))
        # Five rounds at most; a paper that hangs must not keep the others waiting.
        try "${entry%:*}" timeout -k 10 $((seconds * 2 + 60)) bash "$self" --paper "${entry%:*}" "$seconds"
    done
}

fill_document() {
    local blocks=(--block "benchmark=$output/benchmark.md")
    for entry in "${papers[@]}"; do
        blocks+=(--block "paper-${entry%:*}=$output/paper-${entry%:*}.md")
    done
    python3 Utilities/Scripts/fill-document.py "$document" "${blocks[@]}" --images "$output/Images"
    local result=$? plot=Documentation/Images/speed-bunny.png
    if [ -e "$plot" ]; then
        cat > "$output/readme.md" <<END
![RMSE of the visibility over milliseconds of a frame, all techniques](Documentation/Images/speed-bunny.png)

*A bunny under a square lamp: time of a frame with a moving lamp against the error of the visibility, every technique with several
settings. The grey line is the front that no other setting beats in both.*
END
        python3 Utilities/Scripts/fill-document.py README.md --block "speed-against-error=$output/readme.md" || result=1
    fi
    return $result
}

fill_card() {
    mkdir -p "$output"
    python3 Utilities/Scripts/card-section.py "$1" > "$output/card.md" &&
        python3 Utilities/Scripts/fill-document.py "$document" --block "card=$output/card.md"
}

main() {
    case "${1:-}" in
        --references-only) trace_references ;;
        --document-only) try "document" fill_document ;;
        --card) try "document" fill_card "$2" ;;
        # The parts of a run, each a process that can be ended by itself.
        --scenes) scenes --budget "$budget" --rounds 7 --seconds 8; return $? ;;
        --paper) paper "$2" --budget "$3" --rounds 5 --seconds 30 > /dev/null; return $? ;;
        "")
            mkdir -p "$output"
            trace_references
            measure
            try "document" fill_document
            ;;
        *)
            sed -n '2,/^set/s/^# \{0,1\}//p' "$self"
            exit 1
            ;;
    esac
    echo "== done ($(date +%T))"
    if [ ${#failures[@]} -gt 0 ]; then
        printf 'FAILED: %s\n' "${failures[@]}"
        return 1
    fi
}

# In one line: the script may change while it runs.
main "$@"; exit $?
