#!/usr/bin/env bash
# Grinds a pane in a real window as a person would, by mouse and keys alone: opens a pattern by the dialog, homes, starts,
# holds, resumes, ends, calls the pane good and closes. What has come of it is read from the folder of the state.
# session.sh ARRIS ARRIS_PLACES FOLDER: pictures of the steps are left in FOLDER. Exit status 77: tools are missing.
set -euo pipefail
arris=$1 places=$2 folder=$3
size=(1024 768)

for tool in Xvfb openbox xdotool xwdtopnm pnmtopng; do
  command -v "$tool" >/dev/null || { echo "Skipped: $tool is missing (packaging/set-up.sh test)"; exit 77; }
done

work=$(mktemp -d)
state=$work/state
mkdir -p "$state" "$folder"
mkdir -m 700 "$work/runtime"
export XDG_RUNTIME_DIR=$work/runtime
rm -f "$folder"/*.png
children=()
finish() {
  [ ${#children[@]} -eq 0 ] || kill "${children[@]}" 2>/dev/null || true
  wait || true
  rm -rf "$work"
}
trap finish EXIT

fail() {
  echo "session: $*" >&2
  picture failed || true
  cat "$work/arris.log" >&2
  exit 1
}

# until_so SECONDS WHAT COMMAND…: as soon as the command succeeds.
until_so() {
  local ends=$((SECONDS + $1)) what=$2
  shift 2
  until "$@"; do
    [ $SECONDS -lt $ends ] || fail "waited in vain: $what"
    sleep 0.2
  done
}

picture() {
  sleep 0.5 # what has just happened is painted
  xwdtopnm "$work/Xvfb_screen0" 2>/dev/null | pnmtopng 2>/dev/null >"$folder/$1.png"
}

# point WINDOW PART.BUTTON: the mouse onto a button.
point() {
  local at
  at=$(awk -v name="$2" '$1 == name { print $2, $3 }' "$work/places")
  [ -n "$at" ] || fail "there is no $2"
  # shellcheck disable=SC2086 # x and y
  xdotool mousemove --sync --window "$1" $at
}

tap() {
  point "$@"
  xdotool click 1
}

hold_down() {
  point "$@"
  xdotool mousedown 1
  sleep 1
  xdotool mouseup 1
}

# A triangle of 100 mm with an edge along X, as wide as it is quickly ground.
cat >"$work/small triangle.dxf" <<DXF
0
SECTION
2
HEADER
9
\$INSUNITS
70
4
0
ENDSEC
0
SECTION
2
ENTITIES
0
LWPOLYLINE
8
0
90
3
70
1
10
0
20
0
10
100
20
0
10
50
20
86.6
0
ENDSEC
0
EOF
DXF
# Set-points far ahead: a busy computer wakes the thread late.
echo '{"arris_machine": 1, "set_point_lead_s": 0.2}' >"$state/machine.json"
echo '{"arris_recipe": 1, "accel_x_mm_s2": 200, "accel_y_mm_s2": 200}' >"$state/recipe.json"
echo '{"arris_settings": 1, "language": "en"}' >"$state/settings.json"

"$places" "${size[@]}" >"$work/places" 2>/dev/null

# A display of its own, whose picture lies in a file.
Xvfb -fbdir "$work" -displayfd 3 -screen 0 1280x900x24 -dpi 96 -nolisten tcp 3>"$work/display" 2>/dev/null &
children+=($!)
SECONDS=0
until [ -s "$work/display" ]; do
  [ $SECONDS -lt 20 ] || { echo "session: no display" >&2; exit 1; }
  sleep 0.1
done
DISPLAY=:$(cat "$work/display")
export DISPLAY QT_QPA_PLATFORM=xcb LC_ALL=C.UTF-8
openbox >/dev/null 2>&1 &
children+=($!)

"$arris" --state-dir "$state" >"$work/arris.log" 2>&1 &
program=$!
children+=("$program")

find_window() {
  window=$(xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -n 1)
  [ -n "$window" ]
}
until_so 60 "the window" find_window 'Arris$'
main=$window
xdotool windowsize --sync "$main" "${size[@]}" windowmove "$main" 20 40 windowactivate --sync "$main"
picture 1-start

# The pattern, by the dialog.
xdotool key F2
tap "$main" pageJob.open
until_so 20 "the dialog" find_window '^Open pattern$'
dialog=$window
tap "$dialog" dialog.patternsFolder
sleep 1
tap "$dialog" dialog.folderPath
xdotool key ctrl+a
xdotool type --delay 20 "$work/small triangle.dxf"
picture 2-dialog
is_open() {
  xdotool key Return
  sleep 0.5
  xdotool getwindowname "$main" | grep -q '^small triangle.dxf'
}
until_so 30 "the pattern" is_open
picture 3-pattern

# Drives, home, cycle start: the record of the run tells that it has begun.
xdotool key F3
sleep 0.5
tap "$main" pageSetup.enable
sleep 3
tap "$main" pageSetup.home
picture 4-homing
xdotool key F4
has_started() {
  tap "$main" pageRun.loadJob
  hold_down "$main" pageRun.cycleStart
  compgen -G "$state/records/*" >/dev/null
}
until_so 120 "the start" has_started
picture 5-started

# What the state folder says of the job that is not yet ended.
point_says() {
  grep -q "$1" "$state/resume.json" 2>/dev/null
}
until_so 60 "the wheel on the glass" point_says '"segment": *[4-9]'
picture 6-running
tap "$main" pageRun.feedHold
until_so 20 "the hold" point_says '"ended": *"held"'
picture 7-held
tap "$main" pageRun.resume
until_so 20 "the resuming" point_says '"ended": *"running"'
picture 8-resumed
has_ended() {
  [ ! -e "$state/resume.json" ]
}
until_so 120 "the end" has_ended
tap "$main" pageRun.paneGood
until_so 20 "the verdict" grep -q good "$state/panes.jsonl"
picture 9-ended

xdotool key alt+F4
is_gone() {
  ! kill -0 "$program" 2>/dev/null
}
until_so 20 "the end of the program" is_gone
wait "$program" || fail "the program ended with $?"
[ ! -s "$work/arris.log" ] || fail "the program complained"
echo "A pane was ground in a real window; the pictures are in $folder"
