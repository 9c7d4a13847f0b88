#!/usr/bin/env bash
# Installs what is missing, builds Arris and starts it with the arguments given: packaging/run.sh plan pane.dxf …
# Without arguments and without a display it plans and plots a sample pane into out/.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/packaging/set-up.sh" build run
"$root/packaging/build.sh" arris
arris=$root/build/release/bin/arris

if [ $# -gt 0 ] || [ -n "${DISPLAY-}${WAYLAND_DISPLAY-}" ]; then
  exec "$arris" "$@"
fi

sample=$root/resources/samples/balustrade
out=$root/out
mkdir -p "$out"
echo "No display was found: planning the sample pane $sample.dxf instead of opening the window."
"$arris" plan "$sample.dxf" --recipe "$sample.json" --report "$out/balustrade.json" --profile "$out/balustrade.csv" \
  --gcode "$out/balustrade.ngc" --preview "$out/balustrade.svg" --plot "$out/balustrade-profile.svg"
cat <<END

The results are in $out:
  balustrade.svg          the pane, the wheel path and its corners
  balustrade-profile.svg  velocity and acceleration over time
  balustrade.json         report: corners, times, problems
  balustrade.csv          the profile, one row per servo period
  balustrade.ngc          G-code
Other panes: packaging/run.sh plan PATTERN.dxf --preview FILE.svg; everything else: packaging/run.sh help
END
