#!/usr/bin/env bash
# Starts, ends or looks at the HAL session that drives the axes, as root or as a user:
# packaging/hal/start.sh start [simulated|real|FILE.hal] | stop | status
# One session a machine. What HAL said is in $TMPDIR/arris-hal-UID/log (/tmp where TMPDIR is not set).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=${TMPDIR:-/tmp}/arris-hal-$(id -u)

usage() {
  sed -n 's/^# \(packaging.*\)/usage: \1/p' "${BASH_SOURCE[0]}" >&2
  exit 2
}

command -v halcmd >/dev/null || { echo "start: LinuxCNC is not installed (package linuxcnc-uspace)" >&2; exit 1; }

# LinuxCNC's programs do not work for root: they are told to be nobody, and where nobody may put its socket.
if [ "$(id -u)" -eq 0 ]; then
  export RTAPI_UID=65534 RTAPI_FIFO_PATH=$folder/fifo
  install -d -m 0700 -o 65534 "$folder"
else
  install -d -m 0700 "$folder"
fi

runs() {
  halcmd -s show thread 2>/dev/null </dev/null | grep -q .
}

case ${1-} in
start)
  case ${2-simulated} in
  simulated | real) file=$here/arris-${2-simulated}.hal ;;
  *) file=$2 ;;
  esac
  [ -r "$file" ] || { echo "start: $file cannot be read" >&2; exit 1; }
  runs && { echo "start: a HAL session runs already; end it with: $0 stop" >&2; exit 1; }
  # The daemon keeps whatever it inherits open: never a pipe.
  if ! halcmd -f "$file" >"$folder/log" 2>&1 </dev/null; then
    cat "$folder/log" >&2
    halrun -U >/dev/null 2>&1 </dev/null || true
    exit 1
  fi
  ;;
stop) halrun -U >>"$folder/log" 2>&1 </dev/null ;;
status)
  runs || { echo "no HAL session runs"; exit 3; }
  halcmd -s show comp </dev/null
  ;;
*) usage ;;
esac
