#!/bin/bash -eu
# Builds the fuzz targets for OSS-Fuzz and ClusterFuzzLite: from $SRC/flatdt to $OUT, with the compiler, flags and engine
# of the environment. Rehearsed by fuzz/oss-fuzz/rehearse.
#
# The machines that run the targets have no packages: GMP and zlib are linked statically. libgmpxx.a is not needed: flatdt
# uses none of its stream operators, the rest of gmpxx.h is in the header, and with libc++ the operators of a libgmpxx that
# was built with libstdc++ could not be linked.
library() {
    local found
    found=$("$CXX" -print-file-name="$1")
    [ -f "$found" ] || { echo "build.sh: no static $1" >&2; exit 1; }
    echo "$found"
}

# Boost before 1.82 names a class that libc++ no longer has.
export CXXFLAGS="$CXXFLAGS -DBOOST_NO_CXX98_FUNCTION_BASE"

cmake -S "$SRC/flatdt" -B "$WORK/build" \
    -DCMAKE_BUILD_TYPE=None \
    -DFLATDT_BUILD_TESTS=OFF \
    -DFLATDT_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" \
    -DFLATDT_GMP_LIBRARY="$(library libgmp.a)" \
    -DFLATDT_GMPXX_LIBRARY="$(library libgmp.a)" \
    -DZLIB_LIBRARY="$(library libz.a)"
cmake --build "$WORK/build" --parallel "$(nproc)" --target fuzz_targets

for program in "$WORK"/build/fuzz/fuzz_*; do
    [ -f "$program" ] && [ -x "$program" ] || continue
    name=$(basename "$program")
    target=${name#fuzz_}
    cp "$program" "$OUT/$name"
    seeds=$SRC/flatdt/corpora/seeds/$target
    [ ! -d "$seeds" ] || (cd "$seeds" && zip -q -r "$OUT/${name}_seed_corpus.zip" .)
    for kind in dict options; do
        folder=$([ $kind = dict ] && echo dictionaries || echo options)
        file=$SRC/flatdt/fuzz/$folder/$target.$kind
        [ ! -f "$file" ] || cp "$file" "$OUT/$name.$kind"
    done
done
