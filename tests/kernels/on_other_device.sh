#!/usr/bin/env bash
# Runs kernel tests on another device than the default one: "basic", PoCL's without threads; "no_doubles", PoCL's that
# says it has no double precision; or "rusticl", Mesa's on the processor, which has none. Ends with status 77, which CTest
# shows as skipped, where that is not installed.
#
# Usage: on_other_device.sh DEVICE TEST_BINARY GTEST_FILTER
set -euo pipefail

case $1 in
  basic) export POCL_DEVICES=basic ;;
  no_doubles)
    # Sanitizers refuse to run behind another library unless they are told so.
    export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=0}:verify_asan_link_order=0
    export LD_PRELOAD=$(dirname "$2")/libsmall_device.so SMALL_DEVICE_DOUBLES=0
    ;;
  rusticl)
    library=$(ldconfig -p | sed -n 's/.*=> \(.*libRusticlOpenCL\.so\.1\)$/\1/p' | head -n 1)
    if [[ -z $library ]]; then
      echo "skipped: Mesa's OpenCL is not installed (Debian: mesa-opencl-icd, libclc-15)"
      exit 77
    fi
    drivers=$(mktemp -d)
    trap 'rm -rf "$drivers"' EXIT
    echo "$library" >"$drivers/rusticl.icd"
    export OCL_ICD_VENDORS=$drivers RUSTICL_ENABLE=llvmpipe POISSONLAB_SHORT_LOOPS=1
    ;;
esac
"$2" --gtest_filter="$3" --gtest_brief=1
