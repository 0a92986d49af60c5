#!/usr/bin/env bash
# Kernel tests on a device, whose sets must be those of the plain twins, and then what it does, as a section of a page;
# eight minutes at most. `./lab bench --device NAME --short` calls this.
#
# Usage: device.sh BUILD_FOLDER DEVICE PAGE
set -euo pipefail

build=$1 page=$3
export POISSONLAB_DEVICE=$2
status=0
tests='Small/DartThrowing.*:Small/RelaxationDartThrowing.*:Small/ClassDartSets.AreTheSame*:Small/VariedDartSets.AreTheSame*'
tests+=':*/SurfaceDartSets.AreTheSame*:Small/VoronoiCells2d.*:LloydRelaxation.*'
timeout 240 "$build/test_sampling" --gtest_filter="$tests" --gtest_brief=1 || status=$?
if ((status == 124)); then echo "the kernel tests took more than four minutes, and were stopped" >&2; fi
section=$(mktemp)
trap 'rm -f "$section"' EXIT
timeout 240 "$build/device_benchmark" "$POISSONLAB_DEVICE" | tee "$section" || status=$?
if ((status == 0)); then python3 "$(dirname "$0")/device_section.py" "$page" "$section"; fi
exit "$status"
