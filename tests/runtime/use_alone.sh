#!/usr/bin/env bash
# An engine's way: the headers, the example and a tile set that ships, copied out of the tree and compiled by themselves, as
# C++ and, but for what reads files, as C99.
#
# Usage: use_alone.sh RUNTIME C_COMPILER CXX_COMPILER
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$1/poisson_tiles.h" "$1/poisson_tiles.hpp" "$1/point_distribution.hpp" "$1/example.cpp" "$1/tile_sets/corner-c4-n64-r075.ptiles" "$folder"
cd "$folder"
"$3" -std=c++11 -Wall -Wextra -Werror -pedantic example.cpp -o example
lines() { ./example corner-c4-n64-r075.ptiles -3 2 40 25 "$@" | grep -vc '^#'; }

# A thousand tiles of 64 points, and a quarter of them, up to what lies across the window's border.
all=$(lines)
quarter=$(lines 0.25)
echo "$all points, a quarter of them is $quarter"
((all > 63400 && all < 64600 && quarter > 15700 && quarter < 16300))

cat >ten_lines.c <<'END'
#include "poisson_tiles.h"
#include <stdio.h>
int main(void)
{
    static unsigned char bytes[1 << 20];
    FILE* file = fopen("corner-c4-n64-r075.ptiles", "rb");
    ptiles_tiling t = {{0}, 1, 0};
    const double place[2] = {1e6 + 0.5, -1e6};
    ptiles_point p;
    if (!file || ptiles_open(&t.set, bytes, fread(bytes, 1, sizeof bytes, file))) return 1;
    printf("%.9g %.9g %u %d\n", ptiles_nearest(&t, place, &p), ptiles_min_distance(&t.set), ptiles_exponent(&t.set),
           ptiles_is_ranked(&t.set));
    return 0;
}
END
"$2" -std=c99 -Wall -Wextra -Werror -pedantic ten_lines.c -o ten_lines
read -r squared least exponent ranked <<<"$(./ten_lines)"
echo "squared distance $squared, minimum distance $least, exponent $exponent, ranked $ranked"
# The file has the squared distance at byte 40, and its order of equal moments at byte 112: docs/tile-set-file.md.
awk -v d="$least" -v s="$(od -An -tu8 -j40 -N8 *.ptiles)" 'BEGIN { e = d * 65536 - sqrt(s); exit !(s > 0 && e * e < 1e-6) }'
((exponent == 2 * ($(od -An -tu4 -j112 -N4 *.ptiles) + 1) && ranked == 1))
awk -v d="$squared" 'BEGIN { exit !(d >= 0 && d < 0.015) }' # of the largest empty circle: 0.11 tiles

cat >monotile.c <<'END'
#include "monotile_points.h"
#include <stdio.h>
int main(int count, char** words)
{
    static unsigned char bytes[1 << 16];
    static pmono_point points[9000];
    static pmono_set set;
    FILE* file = fopen(words[count - 1], "rb");
    const int64_t origin[2] = {123456789012, -987654321098};
    const double low[2] = {-40, -30}, high[2] = {70, 50};
    if (!file || pmono_open(&set, bytes, fread(bytes, 1, sizeof bytes, file))) return 1;
    const uint64_t n = pmono_in_window(&set, 1, origin, low, high, points, 9000, 0.75);
    for (uint64_t i = 0; i < n; ++i)
        printf("%a %a %a %lu\n", points[i].position[0], points[i].position[1], points[i].level, (unsigned long)points[i].id);
    printf("%.9g %u %d\n", pmono_min_distance(&set), pmono_exponent(&set), pmono_is_ranked(&set));
    return 0;
}
END
# All compilers find the same bits, also where they may fuse products and sums.
cp "$1"/monotile_*.h "$1"/tile_sets/*-n4.ptiles .
"$2" -std=c99 -Wall -Wextra -Werror -pedantic monotile.c -o monotile
"$2" -std=c99 -O3 -march=native -ffp-contract=fast monotile.c -o monotile_fused
"$3" -std=c++11 -x c++ -Wall -Wextra -Werror -pedantic monotile.c -o monotile_cxx
monotiles="monotile_fused monotile_cxx"
if command -v clang >/dev/null; then
  clang -std=c99 -O3 -march=native -ffp-contract=fast -Wall -Wextra -Werror -pedantic monotile.c -o monotile_clang
  monotiles="$monotiles monotile_clang"
fi
for set in hat-n4 spectre-n4; do
  ./monotile $set.ptiles >expected
  for program in $monotiles; do ./$program $set.ptiles | cmp - expected; done
  echo "$set: $(($(wc -l <expected) - 1)) points, the same bits from monotile $monotiles"
  # Three quarters of four points in each tile of area 8 sqrt(3) or 3 + 3 sqrt(3), up to what lies across the border.
  awk -v s=$set 'END { area = s == "hat-n4" ? 8 * sqrt(3) : 3 + 3 * sqrt(3); e = (NR - 1) / (3 * 8800 / area); exit !(e > 0.98 && e < 1.02) }' expected
done

cat >scatter.cpp <<'END'
#include "point_distribution.hpp"
#include <cstdio>
struct Position { float x, y; };
struct Box { Position min, max; };
int main()
{
    int all = 0, few = 0;
    const ptiles::PointDistribution distribution("corner-c4-n64-r075.ptiles");
    distribution(Box{{-3, 2}, {37, 27}}, 50, [&](const Position&, float threshold) { ++all, few += threshold <= 0.25f; });
    std::printf("%d %d\n", all, few);
    return 0;
}
END
"$3" -std=c++11 -Wall -Wextra -Werror -pedantic scatter.cpp -o scatter
read -r all few <<<"$(./scatter)"
echo "$all points of 50,000, $few at a quarter of the density"
((all > 49700 && all < 50300 && few > 12300 && few < 12700))

cat >ranges.cpp <<'END'
#include "poisson_tiles.hpp"
#include <cstdio>
int main()
{
    const ptiles::TileSet set("corner-c4-n64-r075.ptiles");
    const ptiles::Tiling tiling(set);
    int few = 0;
    for (const ptiles_point& point : tiling.window({{-3, 2}}, {{37, 27}}, 0.25)) few += point.level < 0.25;
    std::printf("%d %.9g %.9g\n", few, set.min_distance(), tiling.nearest({{1e6 + 0.5, -1e6}}).second);
    return 0;
}
END
"$3" -std=c++11 -Wall -Wextra -Werror -pedantic ranges.cpp -o ranges
[ "$(./ranges)" = "$quarter $least $squared" ]

# With a compiler for Windows the programs are compiled; with Wine they must also print the same as here.
windows=${WINDOWS_COMPILER_PREFIX:-x86_64-w64-mingw32}
if command -v "$windows-gcc" "$windows-g++" >/dev/null; then
  "$windows-gcc" -std=c99 -Wall -Wextra -Werror -pedantic ten_lines.c -o ten_lines.exe
  for file in example scatter ranges; do
    "$windows-g++" -std=c++11 -Wall -Wextra -Werror -pedantic -static "$file.cpp" -o "$file.exe"
  done
  echo "compiled for Windows"
  if wine=$(PATH=$PATH:/usr/lib/wine command -v wine64); then
    export WINEPREFIX=$folder/wine WINEDEBUG=-all
    compare() { diff <("./$1" "${@:2}") <("$wine" "$1.exe" "${@:2}" | tr -d '\r'); }
    compare ten_lines
    compare scatter
    compare ranges
    compare example corner-c4-n64-r075.ptiles -3 2 40 25
    "$(dirname "$wine")/wineserver64" -k 2>/dev/null || true
    echo "run by Wine"
  fi
fi
