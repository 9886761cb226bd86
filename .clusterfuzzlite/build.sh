#!/bin/bash -eu
exec "$SRC/flatdt/fuzz/oss-fuzz/build.sh"
