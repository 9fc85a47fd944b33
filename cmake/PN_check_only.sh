#!/bin/sh
# PN_check_only.sh COMPILER ... -o OBJECT ...: runs a compiler that only checks (-fsyntax-only) and, if it
# finds nothing, leaves an empty object file by which the build tool sees that this is done.
set -e
"$@"
while [ "$1" != -o ]; do shift; done
: > "$2"
