#!/usr/bin/env bash
# Installs what is missing, builds Arris with its tests and runs every test; arguments are passed on to ctest.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/packaging/set-up.sh" build run test
"$root/packaging/build.sh" --with-tests all
cd "$root"
ctest --preset release "$@"
