#!/bin/sh
# The wall (docs/soundness.md): nothing in ref is included by checker or the other way round.
# Usage: wall_test.sh SOURCE_DIR. First it proves that it can fail, on a tree made for that.
set -eu
source_dir=$1

crossings() {
    # Any include of the other side, by public header, by relative path, or by a bare file name that exists only there.
    grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"][^">]*(flatdt/checker|checker/)' "$1/ref" || true
    grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"][^">]*(flatdt/ref|ref/)' "$1/checker" || true
    grep -nE '(flatdt[_:]+checker|\.\./checker|/checker/)' "$1/ref/CMakeLists.txt" || true
    grep -nE '(flatdt[_:]+ref|\.\./ref|/ref/)' "$1/checker/CMakeLists.txt" || true
}

broken=$(mktemp -d)
trap 'rm -rf "$broken"' EXIT
mkdir -p "$broken/ref" "$broken/checker"
echo '#include "../checker/include/flatdt/checker/check.hpp"' > "$broken/ref/a.cpp"
echo '  #  include <flatdt/ref/instance.hpp>' > "$broken/checker/b.cpp"
echo 'target_link_libraries(x flatdt::checker)' > "$broken/ref/CMakeLists.txt"
echo 'target_link_libraries(x flatdt_ref)' > "$broken/checker/CMakeLists.txt"
count=$(crossings "$broken" | wc -l)
if [ "$count" -ne 4 ]; then
    echo "wall_test: the search finds $count of 4 planted crossings" >&2
    exit 1
fi

found=$(crossings "$source_dir")
if [ -n "$found" ]; then
    echo "the wall between ref and checker is broken:" >&2
    echo "$found" >&2
    exit 1
fi
echo "no include and no link crosses the wall"
