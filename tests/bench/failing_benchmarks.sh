#!/usr/bin/env bash
# failing_benchmarks.sh PROGRAM: benchmarks that end by an exception are named, with its message, those after them
# still run, and the program fails.
set -euo pipefail
status=0
said=$("$1" 2>&1) || status=$?
expect() { grep -qF -- "$1" <<<"$said" || { printf 'not said: %s\n%s\n' "$1" "$said"; exit 1; }; }
((status == 1)) || { printf 'exit status %s\n%s\n' "$status" "$said"; exit 1; }
expect 'FAILED: thrown/iterations:1/repeats:2: no room left'
expect 'FAILED: thrown_before/starting/iterations:1: no device'
expect 'done<3>/iterations:1'
expect '(target: at least 0.50)'
