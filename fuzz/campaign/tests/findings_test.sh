#!/bin/sh
# corpora/findings: flatdt triangulates every instance, proved by flatdt-check; what another program wrote for it is
# refuted by the conditions that its first line names.
# Usage: findings_test.sh PATH-TO-flatdt PATH-TO-flatdt-check CORPORA
set -u
flatdt=$1 check=$2 findings=$3/findings
output=$(mktemp)
trap 'rm -f "$output"' EXIT
failures=0
found=0
for instance in "$findings"/*.instance; do
    found=$((found + 1))
    "$flatdt" triangulate "$instance" -o "$output" 2>/dev/null && "$check" "$instance" "$output" >/dev/null ||
        { echo "FAILED: flatdt on $instance"; failures=$((failures + 1)); }
    recorded=${instance%.instance}.triangulation
    [ -f "$recorded" ] || continue
    wanted=$(sed -n 's/^# fails: //p' "$recorded")
    got=$("$check" "$instance" "$recorded" | sed -n 's/^c condition \([a-z.0-9-]*\) fails.*/\1/p' | tr '\n' ' ' | sed 's/ $//')
    [ -n "$wanted" ] && [ "$got" = "$wanted" ] ||
        { echo "FAILED: $recorded fails '$got', not '$wanted'"; failures=$((failures + 1)); }
done
[ $found -gt 0 ] || { echo "FAILED: no findings"; failures=1; }
exit $((failures > 0))
