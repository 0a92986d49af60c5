#!/usr/bin/env bash
# Builds the site of the documentation: lays pages, configs and runtime out as they are in the checkout, so that links
# between them lead somewhere in both, lets the program write the pages that follow from its descriptions, and runs
# mkdocs, which refuses links that lead nowhere.
#
#   docs/site/build.sh PROGRAM WORK OUT     WORK: a folder for what is laid out, OUT: the site
set -euo pipefail

source=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../..
program=$(readlink -f "$1")
mkdir -p "$2" "$3"
work=$(readlink -f "$2")
out=$(readlink -f "$3")

rm -rf "$work/pages" "$work/overrides"
mkdir -p "$work/pages/python"
cd "$source"
cp -r docs/site/mkdocs.yml docs/site/hooks.py docs/site/overrides "$work"
cp -r README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md Dockerfile LICENSE docs configs runtime "$work/pages"
cp -r python/examples "$work/pages/python"
mv "$work/pages/docs/site/site.css" "$work/pages"
rm -r "$work/pages/docs/site"
"$program" manual --out "$work/pages/docs"
python3 docs/site/configs_page.py configs >"$work/pages/docs/configs.md"
python3 docs/site/python_page.py python/poissonlab >"$work/pages/docs/python-names.md"
cd "$work"
mkdocs build --strict --clean --site-dir "$out" >"$work/mkdocs.log" 2>&1 || {
  grep -E '^(WARNING|ERROR|Aborted)' "$work/mkdocs.log" >&2 || cat "$work/mkdocs.log" >&2
  exit 1
}
