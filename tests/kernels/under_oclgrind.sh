#!/usr/bin/env bash
# Runs small kernel tests under oclgrind, which interprets kernels and sees accesses out of bounds and data races. Fails
# when a test fails or oclgrind finds anything. (Its check for uninitialised memory does not follow buffers that the
# host writes in parts, in version 21.10.)
#
# Usage: under_oclgrind.sh TEST_BINARY GTEST_FILTER [BUILD_OPTIONS]
# (Version 21.10 lacks an intrinsic that inlining brings into some kernels: -cl-opt-disable keeps it out.)
set -euo pipefail

log=$(mktemp)
trap 'rm -f "$log"' EXIT

oclgrind --data-races --build-options "${3:-}" --log "$log" "$1" --gtest_filter="$2" --gtest_brief=1

if [[ -s $log ]]; then
    echo "oclgrind found:"
    head -n 60 "$log"
    exit 1
fi
