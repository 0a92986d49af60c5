#!/usr/bin/env bash
# A stranger's way: the built laboratory is installed, moved, run, and used by a C program through CMake and pkg-config;
# uninstalling leaves nothing.
#
# Usage: installed.sh SOURCE BUILD CMAKE
set -euo pipefail
source=$1 build=$2 cmake=$3
folder=$(mktemp -d)
manifest=$build/install_manifest.txt
kept=$folder/manifest
[[ ! -f $manifest ]] || cp -p "$manifest" "$kept"
finish() {
  rm -f "$manifest"
  [[ ! -f $kept ]] || cp -p "$kept" "$manifest"
  rm -rf "$folder"
}
trap finish EXIT
fail() { echo "installed.sh: $*" >&2; exit 1; }

"$cmake" --install "$build" --prefix "$folder/first" >"$folder/log"
cp "$manifest" "$folder/written"
mv "$folder/first" "$folder/moved"
prefix=$folder/moved
cd "$folder"

for module in pictures particles globe drawings; do
  [[ -n $(find "$prefix" -name "libpoissonlab_$module.so") ]] || fail "no module of $module"
done

# The program finds its pictures module, and shipped configs and tile sets are what it reads.
program=$prefix/bin/poissonlab
[[ $(ldd "$program") != *libproj* ]] || fail "the program loads PROJ when it starts"
[[ $(ldd "$program") != *lib2geom* ]] || fail "the program loads lib2geom when it starts"
"$program" --version >version
grep -q '^poissonlab [0-9]' version || fail "no version"
grep -q 'OpenImageIO' version || fail "the version does not say what was built in"
"$program" run "$prefix/share/poissonlab/configs/quick.toml" --set analysis.points=256 --set analysis.realizations=2 \
  --out out --quiet
[[ -s out/index.html ]] || fail "no report"
"$program" run configs/quick.toml --out out 2>words && fail "there is no such config in this folder"
grep -q "installed config of this name is $prefix/share/poissonlab/configs/quick.toml" words || fail "the message does not name the installed config"
LD_DEBUG=files "$program" tiles points "$prefix/share/poissonlab/tile_sets/corner-c3-n64-r075.ptiles" --min-distance 90 \
  --region 'SRID=4326;POLYGON ((4.70 50.86, 4.71 50.86, 4.71 50.87, 4.70 50.86))' --out globe.csv 2>loaded
[[ $(head -n 1 globe.csv) == longitude,latitude* ]] || fail "points on the globe have no longitude and latitude"
grep -q "init: .*/moved/.*/libpoissonlab_globe.so" loaded || fail "the program does not load the installed globe module"
for file in "$prefix"/share/poissonlab/tile_sets/*-c3-*.ptiles; do "$program" tiles verify "$file" >/dev/null; done

# The manual page has every command, and is written as man likes it.
zcat "$prefix/share/man/man1/poissonlab.1.gz" >page.1
for name in run analyze 'tiles build' samplers; do
  grep -qx ".SS ${name}" page.1 || fail "the manual page lacks $name"
done
if command -v groff >/dev/null; then
  warnings=$(groff -man -Tutf8 -ww -z page.1 2>&1)
  [[ -z $warnings ]] || fail "groff warns: $warnings"
fi

# The Python package imports from where it is, and finds the pictures module there.
if grep -qx 'POISSONLAB_PYTHON:BOOL=ON' "$build/CMakeCache.txt"; then
  PYTHONPATH=$prefix/lib/python3/dist-packages /usr/bin/python3 -W error - "$prefix" <<'END'
import sys
import poissonlab
points = poissonlab.DartThrowing(relative_radius=0.7).random(200)
assert poissonlab.analyze(points).figure().count("<img") == 4
with open("/proc/self/maps") as maps:
    modules = [line.split()[-1] for line in maps if "poissonlab" in line]
assert any(name.endswith("/libpoissonlab_pictures.so") for name in modules), modules
assert all(name.startswith(sys.argv[1]) for name in modules), modules
END
fi

# Ten lines of C use the headers.
mkdir ten && cat >ten/ten.c <<'END'
#include <poisson_tiles.h>
#include <stdio.h>
int main(int count, char** names)
{
    static unsigned char bytes[1 << 20];
    FILE* file = count == 2 ? fopen(names[1], "rb") : 0;
    ptiles_tiling t = {{0}, 1, 0};
    const double low[2] = {0, 0}, high[2] = {10, 10};
    if (!file || ptiles_open(&t.set, bytes, fread(bytes, 1, sizeof bytes, file))) return 1;
    printf("%d\n", (int)ptiles_in_window(&t, low, high, 0, 0, 1));
    return 0;
}
END
cat >ten/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(ten C)
find_package(poissonlab_runtime 0.3 REQUIRED)
add_executable(ten ten.c)
target_link_libraries(ten PRIVATE poissonlab::runtime)
file(WRITE ${CMAKE_BINARY_DIR}/sets ${poissonlab_runtime_TILE_SETS})
END
points_of() { "$1" "$2/corner-c3-n64-r075.ptiles"; } # 100 tiles of 64 points, but for what lies across the border
check_points() { (($1 > 6300 && $1 < 6500)) || fail "$1 points"; }
use_by_cmake() { # PREFIX BUILD
  "$cmake" -S ten -B "$2" -DCMAKE_PREFIX_PATH="$1" >"$folder/log"
  "$cmake" --build "$2" >"$folder/log"
  check_points "$(points_of "$2/ten" "$(<"$2/sets")")"
}
use_by_cmake "$prefix" ten/all
if command -v pkg-config >/dev/null; then
  export PKG_CONFIG_PATH=$prefix/share/pkgconfig
  # shellcheck disable=SC2046 # several words
  ${CC:-cc} $(pkg-config --cflags poissonlab_runtime) ten/ten.c -o ten/by_pkg_config
  check_points "$(points_of ten/by_pkg_config "$(pkg-config --variable=tile_sets poissonlab_runtime)")"
fi

# The headers alone, without the laboratory's libraries.
"$cmake" -S "$source" -B alone -DPOISSONLAB_RUNTIME_ONLY=ON >"$folder/log"
"$cmake" --install alone --prefix "$folder/headers" >"$folder/log"
[[ ! -e headers/bin ]] || fail "the runtime alone has programs"
use_by_cmake "$folder/headers" ten/headers

# The Debian package needs what the program is linked with, and what it starts.
if command -v dpkg-shlibdeps >/dev/null && command -v file >/dev/null; then
  "${cmake%cmake}cpack" -G DEB --config "$build/CPackConfig.cmake" -B package >"$folder/log"
  depends=$(dpkg-deb --field package/*.deb Depends)
  names=('pocl-opencl-icd | opencl-icd' 'libopenimageio2.4 (' 'gnuplot-nox | gnuplot' 'ocl-icd-libopencl1')
  if [[ -e $prefix/lib/python3 ]]; then names+=(python3-numpy 'python3 (<< 3.'); fi
  for name in "${names[@]}"; do
    [[ $depends == *"$name"* ]] || fail "the package does not depend on $name: $depends"
  done
  dpkg-deb --extract package/*.deb extracted
  [[ $(cd extracted && find . -type f | grep -v copyright | sort) == $(cd "$folder/moved" && find . -type f |
    sed 's|^\./|./usr/|' | grep -v -e copyright -e __pycache__ | sort) ]] || fail "the package holds other files than an installation"
fi

# The archive of sources has what git keeps, and nothing that was built.
"${cmake%cmake}cpack" --config "$build/CPackSourceConfig.cmake" -B sources >"$folder/log"
tar -tzf sources/poissonlab-*.tar.gz | grep -v '/$' | sed 's|^[^/]*/||' | sort >packed
grep -qx CMakeLists.txt packed || fail "the archive of sources has no CMakeLists.txt"
! grep -q -e '^build/' -e '^out/' -e '__pycache__' packed || fail "the archive of sources has what was built"
if tracked=$(git -C "$source" ls-files 2>/dev/null); then
  missing=$(sort <<<"$tracked" | comm -23 - packed)
  [[ -z $missing ]] || fail "the archive of sources lacks $missing"
fi

# Uninstalling takes what was written and leaves what others wrote.
mv "$folder/moved" "$folder/first"
touch "$folder/first/share/of_another"
"$cmake" -DMANIFEST="$folder/written" -P "$source/cmake/install/uninstall.cmake"
left=$(find "$folder/first" -type f)
[[ $left == "$folder/first/share/of_another" ]] || fail "left behind: $left"
[[ $(find "$folder/first" -type d | wc -l) == 2 ]] || fail "empty folders are left"
"$cmake" --build alone --target uninstall >"$folder/log"
[[ ! -e headers ]] || fail "the headers are still there: $(find headers)"
