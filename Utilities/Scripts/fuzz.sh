#!/usr/bin/env bash
# Builds the fuzz target of the scene reader with Clang (libFuzzer, address and undefined-behaviour
# sanitizers) and runs it on the corpus.
# Usage: fuzz.sh [seconds]      (default: 60)
# Environment: BUILD_DIR (default build/fuzz); FUZZ_SEED (default 1).
# What it finds new is kept in $BUILD_DIR/corpus; a crash writes $BUILD_DIR/crash-... and ends with 1.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
seconds="${1:-60}"
build="${BUILD_DIR:-build/fuzz}"
scene=Utilities/Scene
mkdir -p "$build/corpus"

clang++ -std=c++17 -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined \
    -I "$scene" -o "$build/FuzzSceneReader" \
    "$scene/Testing/Fuzz/FuzzSceneReader.cxx" \
    "$scene"/{LocatedJson,SceneError,SceneKeyReader,SceneReader,SceneRules,SceneWriter,Suggestion}.cxx

# The first folder gets what is new.
"$build/FuzzSceneReader" "$build/corpus" "$scene/Testing/Fuzz/Corpus" \
    -dict="$scene/Testing/Fuzz/scene.dict" -max_total_time="$seconds" -max_len=8192 -timeout=10 \
    -rss_limit_mb=1024 -seed="${FUZZ_SEED:-1}" -print_final_stats=1 -verbosity=0 \
    -artifact_prefix="$build/"
