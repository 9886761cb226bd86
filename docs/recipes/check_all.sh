#!/bin/sh
# Has the triangulations of all instances in a folder proved or refuted: check_all.sh FOLDER
# MY_TRIANGULATION: the command, which reads an instance and writes a triangulation. Exit 0 if all are VERIFIED.
set -u
status=0
for instance in "$1"/*.instance; do
    triangulation=${instance%.instance}.triangulation
    if ! $MY_TRIANGULATION <"$instance" >"$triangulation"; then
        echo "::error file=$instance::the program failed"
        status=1
        continue
    fi
    report=$(flatdt-check "$instance" "$triangulation")
    verdict=$(printf '%s\n' "$report" | tail -n 1)
    echo "$instance: ${verdict#s }"
    [ "$verdict" = "s VERIFIED" ] && continue
    status=1
    printf '%s\n' "$report" | sed -n "s|^c condition \([^ ]*\) fails|::error file=$instance::\1 fails:|p"
done
exit $status
