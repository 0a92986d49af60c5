#!/usr/bin/env bash
# check_format.sh CLANG_FORMAT: every C++ file is laid out as .clang-format says. Kernels and runtime/ are laid out by
# hand: the formatter takes the loops that kernels write as macros for functions, and breaks the tables in comments.
set -euo pipefail
cd "$(dirname "$0")/../.."
find analysis app base experiment host python reports results tests tiles \( -name '*.cpp' -o -name '*.hpp' \) -print0 |
  xargs -0 -n 64 -P "$(nproc)" "$1" --dry-run -Werror
