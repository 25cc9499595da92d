#!/usr/bin/env bash
# Packs the sources, which build without git: what git tracks here, and the references and the package for Octave, which
# are written for it; or all of an unpacked tarball. tarball.sh [FOLDER]; it writes out/rollcon-VERSION.tar.xz by default.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
folder=${1:-$root/out}
version=$(sed -n 's/^#define ROLLCON_VERSION_STRING "\(.*\)"/\1/p' "$root/include/rollcon.h")
mkdir -p "$folder"
packed=$(realpath "$folder")/rollcon-$version.tar.xz
cd "$root"
"$python" bindings/generate.py --texts . >/dev/null
{
  if [ -e .git ]; then
    git ls-files -z
    git ls-files -z --others --ignored --exclude-standard -- docs/'*.md' bindings/octave/'*.[cm]'
  else
    find . -type f -not -path './build*' -not -path './out/*' -not -name '*.pyc' -printf '%P\0'
  fi
} | while IFS= read -r -d '' file; do if [ -e "$file" ]; then printf '%s\0' "$file"; fi; done |
  tar --null --files-from=- --sort=name --owner=0 --group=0 --numeric-owner --mtime='2026-01-01 00:00:00Z' \
    --transform "s,^,rollcon-$version/," --create | xz -T0 -6 >"$packed"
say "$packed: $(stat -c %s "$packed") bytes"
