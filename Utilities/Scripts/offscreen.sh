#!/usr/bin/env bash
# Runs a command with a virtual screen of its own, which renders in software.
# Usage: offscreen.sh <command> [argument...]
# -noreset: the server would else start afresh whenever its last client leaves, and a test that
# connects in that moment dies.
exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"
