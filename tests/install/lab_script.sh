#!/usr/bin/env bash
# ./lab itself: which modules, tests and options it asks CMake for, with programs in place of dpkg-query, cmake and ctest
# that write down what they are called with.
#
#   lab_script.sh SOURCE_FOLDER
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/bin" "$folder/lab/tests/host/regions"
cp "$1/lab" "$folder/lab/lab"
touch "$folder/lab/tests/host/file_opening_test.cpp"
calls=$folder/calls

stub() {
  printf '#!/usr/bin/env bash\nprintf "%%s\\n" "%s $*" >>%q\n%s\n' "$1" "$calls" "$2" >"$folder/bin/$1"
  chmod +x "$folder/bin/$1"
}
# All packages are installed.
stub dpkg-query 'shift 3; printf "installed %s\n" "$@"'
stub apt-get 'exit 1'
stub ctest ''
# Ninja has 12 steps to make.
stub ninja 'for i in {1..12}; do echo "[$i/12] Building"; done'
stub nproc 'echo 3'
# Configuring writes the cache as CMake does, building the program: one that tells its arguments.
stub cmake '
if [[ $1 == -S ]]; then
  mkdir -p "$2/build/release"
  touch "$2/build/release/build.ninja"
  {
    printf "CMAKE_HOME_DIRECTORY:INTERNAL=%s\n" "$2"
    for word in "$@"; do
      case $word in
        -DPOISSONLAB_MODULES=* | -DPOISSONLAB_ONLY=*) word=${word#-D}; printf "%s:STRING=%s\n" "${word%%=*}" "${word#*=}" ;;
        -D*=ON) word=${word#-D}; printf "%s:BOOL=ON\n" "${word%%=*}" ;;
      esac
    done
  } >"$2/build/release/CMakeCache.txt"
else
  printf "#!/bin/sh\necho program \"\$@\"\n" >"$2/poissonlab"
  chmod +x "$2/poissonlab"
fi'

# lab STATUS ARGUMENTS...: runs ./lab, which must end with this status; what CMake and CTest were called with is in $calls,
# what it wrote in $folder/out and $folder/err.
lab() {
  local expected=$1 status=0
  shift
  : >"$calls"
  env -u CI -u OMPI_COMM_WORLD_SIZE PATH="$folder/bin:$PATH" XDG_CACHE_HOME="$folder/cache" "$folder/lab/lab" "$@" \
    >"$folder/out" 2>"$folder/err" || status=$?
  [[ $status == "$expected" ]] || { cat "$folder/err"; fail "lab $* ended with $status, not $expected"; }
}
fail() {
  echo "$*" >&2
  exit 1
}
called() { grep -qF -- "$1" "$calls" || { cat "$calls" >&2; fail "no call with: $1"; }; }
not_called() { ! grep -qF -- "$1" "$calls" || fail "a call with: $1"; }
wrote() { grep -qF -- "$2" "$folder/$1" || { cat "$folder/$1" >&2; fail "not in $1: $2"; }; }

lab 2
wrote err './lab run CONFIG'

# The core first; a program that is there is only built again.
lab 0 run a.toml
called '-DPOISSONLAB_MODULES= '
called '--target poissonlab'
wrote out 'program run a.toml'
lab 0 run a.toml
not_called 'cmake -S'
called '--target poissonlab'

# Modules only grow, and each is configured once.
lab 0 --with tiles run b.toml
called '-DPOISSONLAB_MODULES=tiles '
wrote err 'building the module tiles'
wrote out 'program run b.toml'
lab 0 --with textures run b.toml
called '-DPOISSONLAB_MODULES=tiles;textures '
lab 0 --with tiles run b.toml
not_called 'cmake -S'

# Thirty steps of 10 s, four at a time, say how long twelve will take; fewer steps, or none to make, say nothing.
not_said() { ! grep -qF 'takes about' "$folder/err" || fail "said how long: $(cat "$folder/err")"; }
not_said
for ((i = 0; i < 30; ++i)); do printf '%d\t%d\t0\tfile%d\t0\n' $((i * 1000)) $((i * 1000 + 10000)) "$i"; done \
  >"$folder/lab/build/release/.ninja_log"
lab 0 run a.toml
wrote err 'building takes about 30 s'
sed -i 1d "$folder/lab/build/release/.ninja_log"
lab 0 run a.toml
not_said
stub ninja 'echo "ninja: no work to do."'
seq 100 | sed 's/.*/0\t10000\t0\tfile&\t0/' >"$folder/lab/build/release/.ninja_log"
lab 0 run a.toml
not_said
lab 0 build
called '-DPOISSONLAB_MODULES=all '
lab 0 --with regions run b.toml
not_called 'cmake -S'

# Tests: all, or those of a folder or of a file.
lab 0 test -R Something
called '-DPOISSONLAB_TESTS=ON'
called '--target all'
called 'ctest --preset release'
called '-R Something'
not_called '-L only'
lab 0 test --only regions -V
called '-DPOISSONLAB_ONLY=regions'
called '--target only_tests'
called '-L only -V'
lab 0 test --only file_opening
called '-DPOISSONLAB_ONLY=file_opening'
lab 0 run a.toml
not_called 'cmake -S'
lab 0 test
called '-DPOISSONLAB_ONLY= '
not_called '-L only'
for name in '' nothing ../tests 'a b'; do
  lab 2 test --only "$name"
  wrote err 'must be a folder below tests/'
  not_called 'cmake -'
done
