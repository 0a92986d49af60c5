#!/usr/bin/env bash
# Runs small kernel tests under oclgrind, which interprets kernels and sees accesses out of bounds, data races and reads
# of uninitialised memory. Fails when a test fails or oclgrind finds anything.
#
# Usage: under_oclgrind.sh TEST_BINARY GTEST_FILTER
set -euo pipefail

log=$(mktemp)
trap 'rm -f "$log"' EXIT

# Optimised code has instructions that oclgrind 21.10 cannot follow with --uninitialized.
oclgrind --data-races --uninitialized --build-options "-cl-opt-disable" --log "$log" \
    "$1" --gtest_filter="$2" --gtest_brief=1

if [[ -s $log ]]; then
    echo "oclgrind found:"
    head -n 60 "$log"
    exit 1
fi
