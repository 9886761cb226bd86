#!/bin/sh
# Exit codes and last lines of flatdt-check always agree. Usage: cli_test.sh PATH-TO-flatdt-check
set -u
check=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# expect CODE LAST-LINE COMMAND...: exit code, and last line of standard output ("" = no verdict line at all)
expect() {
  code=$1
  line=$2
  shift 2
  "$@" >"$dir/out" 2>"$dir/err" </dev/null
  got=$?
  [ "$got" = "$code" ] || fail "exit $got, not $code: $*"
  if [ -n "$line" ]; then
    [ "$(tail -n 1 "$dir/out")" = "$line" ] || fail "last line '$(tail -n 1 "$dir/out")', not '$line': $*"
    [ "$(grep -c '^c condition ' "$dir/out")" = 19 ] || fail "not 19 conditions: $*"
  else
    ! grep -q '^s ' "$dir/out" || fail "a verdict without one due: $*"
  fi
}

expect_stderr() { grep -q -e "$1" "$dir/err" || fail "standard error lacks '$1': $(cat "$dir/err")"; }

good() {
  cat <<'END'
flatdt-instance 1
dimension 2
manifold torus
points 9
0 0  1/3 0  2/3 0
0 1/3  1/3 1/3  2/3 1/3
0 2/3  1/3 2/3  2/3 2/3
END
}
good >"$dir/good.instance"
awk 'BEGIN {
  print "flatdt-triangulation 1\nelements 4\n1 0 0 0 1 0\n1 0 1 0 1 0\n1 0 0 0 1 1\n1 0 1 0 1 1\ncells 18"
  for (y = 0; y < 3; y++) for (x = 0; x < 3; x++) {
    X = (x + 1) % 3; Y = (y + 1) % 3; a = (x == 2); b = (y == 2)
    print x + 3 * y, 0, X + 3 * y, a, X + 3 * Y, a + 2 * b
    print x + 3 * y, 0, x + 3 * Y, 2 * b, X + 3 * Y, a + 2 * b
  }
}' >"$dir/good.triangulation"
grep -v '^8 0' "$dir/good.triangulation" | sed 's/^cells 18/cells 16/' >"$dir/wrong.triangulation"
sed 's/^cells 18/cells 19/' "$dir/good.triangulation" >"$dir/short.triangulation"
sed 's/manifold torus/manifold klein-bottle generators 2 1 0 1 0 1 0 1 0 0 0 1 1/' "$dir/good.instance" >"$dir/name.instance"
sed 's/manifold torus/generators 3 1 0 1 0 1 0 1 0 0 0 1 1 -1 0 0 0 -1 0/' "$dir/good.instance" >"$dir/torsion.instance"
sed 's/manifold torus/manifold torus metric 1 2 1/' "$dir/good.instance" >"$dir/metric.instance"
awk 'BEGIN {
  print "flatdt-instance 1 dimension 2 generators 2000"
  for (i = 0; i < 2000; i++) printf "1 0 1/1%040d%04d 0 1 0\n", 7, 2 * i + 1
  print "points 9 0 0 0 1 0 2 0 3 0 4 0 5 0 6 0 7 0 8"
}' >"$dir/limit.instance"

cd "$dir" || exit 1
expect 0 "s VERIFIED" "$check" good.instance good.triangulation
expect 0 "s VERIFIED" "$check" good.instance good.triangulation --jobs 256
expect 1 "s REFUTED" "$check" good.instance wrong.triangulation
expect 2 "s MALFORMED" "$check" good.instance short.triangulation
expect_stderr '^flatdt-check: short.triangulation:26: '
expect 2 "s MALFORMED" "$check" good.triangulation good.instance
expect_stderr 'good.triangulation:1: expected .flatdt-instance.'
expect 2 "s MALFORMED" "$check" name.instance good.triangulation
expect_stderr 'name.instance:3: group.name fails: claimed=klein-bottle manifold=torus'
grep -q '^c condition group.name fails claimed=klein-bottle' out || fail "no witness for the name"
grep -q '^c condition vertices.complete skipped$' out || fail "later conditions must be skipped"
expect 2 "s MALFORMED" "$check" torsion.instance good.triangulation
expect_stderr 'group.torsion-free fails: .*fixed-point=(0,0)'
expect 2 "s MALFORMED" "$check" metric.instance good.triangulation
expect_stderr 'not positive definite'
expect 3 "s UNKNOWN" "$check" limit.instance good.triangulation
expect_stderr 'limit of the checker'

# Wrong usage: no verdict.
expect 2 "" "$check"
expect 2 "" "$check" good.instance
expect 2 "" "$check" good.instance good.triangulation more
expect 2 "" "$check" --unknown good.instance good.triangulation
expect 2 "" "$check" - -
for jobs in 0 257 -1 x; do expect 2 "" "$check" good.instance good.triangulation --jobs $jobs; done
expect 2 "" "$check" missing good.triangulation
expect_stderr 'missing'
expect 2 "" "$check" good.instance missing
expect 2 "" "$check" . good.triangulation
expect 2 "" "$check" good.instance .
expect 0 "" "$check" --help
grep -q 'INSTANCE' out || fail "no help"
expect 0 "" "$check" --version
grep -Eq '^flatdt-check [0-9]+\.[0-9]+' out || fail "no version"

# Standard input, once.
"$check" - good.triangulation <good.instance >out && [ "$(tail -n 1 out)" = "s VERIFIED" ] || fail "instance from stdin"
"$check" good.instance - <good.triangulation >out && [ "$(tail -n 1 out)" = "s VERIFIED" ] || fail "triangulation from stdin"
"$check" good.instance - <wrong.triangulation >out
[ $? = 1 ] || fail "refuted from stdin"

# JSON: one object and nothing else, strings throughout.
for pair in "0 VERIFIED good" "1 REFUTED wrong" "2 MALFORMED short"; do
  set -- $pair
  "$check" --json good.instance "$3.triangulation" >out 2>err
  [ $? = "$1" ] || fail "json exit code for $3"
  [ "$(wc -l <out)" = 1 ] || fail "json is not one line"
  grep -q "^{\"schema\":\"flatdt-check 1\",\"verdict\":\"$2\",\"conditions\":\[{\"name\":\"group.crystallographic\",\"status\":\"" out ||
    fail "json for $3: $(cat out)"
  [ "$(grep -o '"name":' out | wc -l)" = 19 ] || fail "json conditions for $3"
  ! grep -Eq '":[ ]*[-0-9]' out || fail "json numbers must be strings"
done
"$check" good.instance wrong.triangulation --json >out
grep -q '"name":"volume.exact","status":"fails","witness":{"volume-of-cells":"8/9","expected":"1"' out || fail "json witness"

# A failed write is never a verdict.
if [ -w /dev/full ]; then
  for option in "" --json; do
    "$check" good.instance good.triangulation $option >/dev/full 2>err
    [ $? = 3 ] || fail "failed write must exit 3"
    grep -q 'cannot write' err || fail "failed write must say so"
  done
  "$check" --help >/dev/full 2>err
  [ $? = 3 ] || fail "failed write of the help must exit 3"
  grep -q 'cannot write' err || fail "failed write of the help must say so"
fi
# Nor is a limit of the sizes of files.
(ulimit -f 0 && "$check" good.instance good.triangulation >limited 2>/dev/null)
[ $? = 3 ] || fail "a limit of the sizes of files must exit 3"

# Hostile files end soon, with a verdict or a refusal.
head -c 100000 /dev/urandom >random
expect 2 "s MALFORMED" "$check" random good.triangulation
expect 2 "s MALFORMED" "$check" good.instance random
: >empty
expect 2 "s MALFORMED" "$check" empty empty
expect 2 "s MALFORMED" "$check" /dev/null good.triangulation
head -c 60 good.triangulation >cut
expect 2 "s MALFORMED" "$check" good.instance cut
awk 'BEGIN { printf "flatdt-instance 1 dimension 2 manifold torus points 1 0 "; for (i = 0; i < 1000000; i++) printf "7"; print "" }' >digits
expect 2 "s MALFORMED" "$check" digits good.triangulation
for number in 1e999999999 1e-999999999 0x1p99999999999 1/0 99999999999999999999/00; do
  echo "flatdt-instance 1 dimension 2 manifold torus points 1 0 $number" >number
  expect 2 "s MALFORMED" "$check" number good.triangulation
done
for count in 1000000000000000000 100000000 -1 1e3; do
  echo "flatdt-instance 1 dimension 2 manifold torus points $count 0 0" >count
  expect 2 "s MALFORMED" "$check" count good.triangulation
done

[ "$failures" = 0 ] && echo "all passed"
exit "$failures"
