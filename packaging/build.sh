#!/usr/bin/env bash
# Builds targets of the preset `release` and configures it before where that was not done:
# packaging/build.sh [--with-tests] TARGET...
# Speaks on stderr, and not at all when there is nothing to do.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release

tests=OFF
if [ "${1-}" = --with-tests ]; then
  tests=ON
  shift
fi
# A build folder that has the tests serves both; one without them must learn of them first.
if [ ! -f "$build/build.ninja" ] || { [ $tests = ON ] && ! grep -q '^ARRIS_BUILD_TESTS:BOOL=ON' "$build/CMakeCache.txt"; }; then
  cmake -S "$root" --preset release "-DARRIS_BUILD_TESTS=$tests" >&2
fi
if ! ninja -C "$build" -n "$@" 2>/dev/null | grep -q 'no work to do'; then
  cmake --build "$build" --target "$@" >&2
fi
