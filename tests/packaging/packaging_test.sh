#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# packaging_test.sh BUILD-DIR: installs into a folder and holds what is there to systemd's and man's checks.
# shellcheck disable=SC2317  # check() calls the functions by name
set -euo pipefail
export LC_ALL=C.UTF-8
build=$1
root=$build/packaging
rm -rf "$root"
failures=0
check() { # WHAT COMMAND...
  local what=$1
  shift
  if "$@" >"$build/packaging.out" 2>&1; then
    echo "ok: $what"
  else
    echo "FAILED: $what"
    cat "$build/packaging.out"
    failures=$((failures + 1))
  fi
}
silent() { # COMMAND...: succeeds and has nothing to complain of
  local complaints
  if ! complaints=$("$@" 2>&1 >/dev/null) || [ -n "$complaints" ]; then
    echo "$complaints"
    return 1
  fi
}
manual_names_all() { # PAGE PROGRAM: each --option that --help lists stands in the manual page
  local option options missing=0
  options=$("$2" --help | grep -oE -- '--[a-z][a-z-]+' | sort -u)
  [ -n "$options" ] || return 1
  for option in $options; do
    grep -q -- "\\\\-${option#--}" "$1" || {
      echo "$1 does not mention $option"
      missing=1
    }
  done
  return "$missing"
}

udev_grammar() { # RULES: each line is matches and assignments, which udevadm of Debian 12 does not check without devices
  local term='[A-Z][A-Z_]*(\{[^}"]+\})?(==|!=|\+=|-=|:=|=)"[^"]*"'
  local wrong
  wrong=$(grep -vE "^(#.*)?$|^$term(, *$term)*$" "$1") || return 0
  echo "$1: no rule: $wrong"
  return 1
}

DESTDIR=$root cmake --install "$build" --prefix /usr >"$build/packaging.out"
unit=$root/usr/lib/systemd/system/hindsightd.service
for file in usr/bin/hindsightd usr/bin/hindsight usr/bin/hindsight-spy etc/hindsight/lagr.toml etc/hindsight/lagr.dbc; do
  check "/$file is installed" test -f "$root/$file"
done
for page in man8/hindsightd.8 man1/hindsight.1; do
  check "${page#*/} is well-formed" silent man --warnings -E UTF-8 -l -Tutf8 -Z "$root/usr/share/man/$page"
done
check "hindsightd.8 has all options" manual_names_all "$root/usr/share/man/man8/hindsightd.8" "$build/hindsightd"
if command -v systemd-analyze >/dev/null; then
  # Without units of other packages there is nothing that `root` could order us after, hence the unit by itself.
  sed "s|/usr/bin/hindsightd|$build/hindsightd|; /^User=/d; /^Group=/d; /^SupplementaryGroups=/d" "$unit" \
    >"$build/hindsightd-check.service"
  check "the unit has no mistakes" \
    silent systemd-analyze verify --recursive-errors=yes --man=no "$build/hindsightd-check.service"
  check "the unit is shut tight: 2.0 or better" systemd-analyze security --offline=true --threshold=20 "$unit"
  check "sysusers makes user and groups" systemd-sysusers --root="$root" "$root/usr/lib/sysusers.d/hindsight.conf"
  check "the user is there" grep -q '^hindsight:' "$root/etc/passwd"
  check "tmpfiles makes its folders" systemd-tmpfiles --create --root="$root" "$root/usr/lib/tmpfiles.d/hindsight.conf"
  check "run logs have a folder of ours alone" test "$(stat -c %a "$root/var/lib/hindsight/runs")" = 750
fi
check "udev's rules are well-formed" udev_grammar "$root/usr/lib/udev/rules.d/70-hindsight.rules"
if udevadm verify --help >/dev/null 2>&1; then
  check "udev takes the rules" udevadm verify "$root/usr/lib/udev/rules.d/70-hindsight.rules"
fi
# Receive buffers for LCM. Where a container hides the keys there is nothing to hold them to.
if [ -e /proc/sys/net/core/rmem_max ]; then
  check "the kernel has what sysctl.d sets" sysctl --dry-run -p "$root/usr/lib/sysctl.d/60-hindsight.conf"
fi
check "LCM's buffers are set" grep -Eq '^net.core.rmem_max = [0-9]{7,}$' "$root/usr/lib/sysctl.d/60-hindsight.conf"
exit $((failures > 0))
