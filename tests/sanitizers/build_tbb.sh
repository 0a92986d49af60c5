#!/usr/bin/env bash
# Builds oneTBB with the thread sanitizer, for the preset "tsan". The sanitizer must see how oneTBB hands work from one
# thread to another: with the system's library every parallel loop looks like a race.
#
# Usage: build_tbb.sh SOURCE    the source of the oneTBB whose headers are installed, such as a checkout of v2021.8.0
set -euo pipefail

source=${1:?usage: build_tbb.sh SOURCE_OF_ONETBB}
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
build=$root/build/tsan-tbb/build

cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DTBB_SANITIZE=thread \
  -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF \
  -DTBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON -DCMAKE_INSTALL_LIBDIR=lib
cmake --build "$build" --target tbb
cmake --install "$build" --prefix "$root/build/tsan-tbb"
