#!/usr/bin/env bash
# Installs the Debian packages of the lists named (build, run, test) that are missing; as root or through sudo.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

wanted=()
for list in "$@"; do
  while read -r package; do
    wanted+=("$package")
  done < <(grep -v -e '^#' -e '^$' "$here/packages-$list.txt")
done
# dpkg-query knows nothing of a package that never was here, says so on stderr and fails: that is an answer, no error.
installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null || true)
missing=()
for package in "${wanted[@]}"; do
  grep -qxF "installed $package" <<<"$installed" || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

echo "Installing: ${missing[*]}" >&2
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "set-up: packages are missing and neither root nor sudo is available" >&2; exit 1; }
  as_root=(sudo)
fi
apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
"${as_root[@]}" "${apt[@]}" update >&2
"${as_root[@]}" "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >&2
