#!/bin/sh
# flatdt-check --from: exit codes and last lines. Usage: from_test.sh PATH-TO-flatdt-check CORPORA
set -u
check=$1
streams=$2/imports
failures=0

# expect CODE LAST-LINE ARGUMENT...
expect() {
  code=$1 line=$2
  shift 2
  last=$("$check" "$@" 2>/dev/null </dev/null | tail -n 1)
  "$check" "$@" >/dev/null 2>&1 </dev/null
  got=$?
  [ "$got" = "$code" ] || { echo "FAILED: exit $got, not $code: $*"; failures=$((failures + 1)); }
  [ "$last" = "$line" ] || { echo "FAILED: last line '$last', not '$line': $*"; failures=$((failures + 1)); }
}

expect 0 "s VERIFIED" --from cgal-p2t2 "$streams/square-nine-sheets.p2t2"
expect 0 "s VERIFIED" --from cgal-p3t3 "$streams/cube-27-sheets.p3t3"
expect 2 "s MALFORMED" --from cgal-p3t3 "$streams/square-nine-sheets.p2t2"
expect 2 "s MALFORMED" --from cgal-p2t2 "$check"
expect 2 "" --from cgal-p2t2 "$streams/no-such-file"
expect 2 "" --from cgal-p2t2 "$streams/square-nine-sheets.p2t2" "$streams/square-nine-sheets.p2t2"
expect 2 "" --from geogram "$streams/square-nine-sheets.p2t2"
expect 2 "" "$streams/square-nine-sheets.p2t2"
"$check" --from cgal-p2t2 --json - <"$streams/square-one-sheet.p2t2" 2>/dev/null | grep -q '"verdict":"VERIFIED"' ||
  { echo "FAILED: standard input, --json"; failures=$((failures + 1)); }
"$check" --from cgal-p2t2 /dev/null 2>&1 >/dev/null | grep -q '^flatdt-check: [^ ]*:1: ' ||
  { echo "FAILED: an empty file ends in line 1"; failures=$((failures + 1)); }
printf '1 2 3\n4\n' | "$check" --from cgal-p2t2 - 2>&1 >/dev/null | grep -q ':3: ' ||
  { echo "FAILED: two lines end where the third would begin"; failures=$((failures + 1)); }
exit $((failures > 0))
