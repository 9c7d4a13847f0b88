#!/usr/bin/env bash
# Pictures of every page in every language, light and dark, at 1024x768 and 1920x1080, in the states empty, loaded,
# running, held and fault, and of the parts of the pages and the dialogs with a job loaded:
# build/screenshots/LANGUAGE-APPEARANCE-WIDTH/PAGE-STATE.png, PAGE-PART.png
# packaging/screenshots.sh [LANGUAGE...]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/packaging/set-up.sh" build run test
"$root/packaging/build.sh" --with-tests arris_screenshots
rm -rf "$root/build/screenshots"
"$root/build/release/bin/arris_screenshots" "$root/build/screenshots" "$@"
find "$root/build/screenshots" -name '*.png' | wc -l
