#!/usr/bin/env bash
# Makes the documents a site, in build/site/html: checks the plain files, stages them, calls MkDocs, checks every link
# of the result.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

bash "$root/scripts/setup.sh" docs
cd "$root"
"$python" scripts/documents.py check
# The list has words of the field, of Fortran and of journals.
codespell --quiet-level 3 --ignore-words-list tread,cant,statics,fro,numer,mater,stat,inout --skip '*.png,*.svg,*.pyc,.*_cache' \
  ./*.md CITATION.cff docs fortran bindings packaging scripts include
"$python" scripts/documents.py stage build/site/pages
/usr/bin/mkdocs build --quiet --strict --config-file docs/mkdocs.yml
"$python" scripts/documents.py links build/site/html
say "site: $root/build/site/html/index.html, after $SECONDS s"
