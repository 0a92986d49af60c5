#!/usr/bin/env bash
# What a device does, as a section of a page, and kernel tests there, whose sets must be those of the plain twins; eight
# minutes at most. `./lab bench --device NAME --short` calls this. Where sets differ, the page stays as it was.
#
# Usage: device.sh BUILD_FOLDER DEVICE PAGE
set -euo pipefail

build=$1 page=$3
export POISSONLAB_DEVICE=$2
section=$(mktemp)
trap 'rm -f "$section"' EXIT
timeout 240 "$build/device_benchmark" "$POISSONLAB_DEVICE" | tee "$section"

tests='Small/DartThrowing.*:Small/RelaxationDartThrowing.*:Small/ClassDartSets.AreTheSame*:Small/VariedDartSets.AreTheSame*'
tests+=':Small/SurfaceDartSets.AreTheSame*'
tests+=':Small/VoronoiCells2d.*:Small/RelaxedBits.*:LloydRelaxation.*'
timeout 240 "$build/test_sampling" --gtest_filter="$tests" --gtest_brief=1
PYTHONDONTWRITEBYTECODE=1 python3 "$(dirname "$0")/device_section.py" "$page" "$section"
