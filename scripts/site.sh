#!/usr/bin/env bash
# Makes the documents a site, in build/site/html, that needs no server: checks the plain files, stages them, calls
# MkDocs, adds MathJax, checks every link of the result.
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
"$python" scripts/documents.py search build/site/html
# This part of MathJax sets formulas as SVG, without fonts, which a browser does not load from a file.
mathjax=/usr/share/javascript/mathjax
for part in MathJax.js config/TeX-AMS_SVG-full.js extensions jax/element jax/input/TeX jax/output/SVG/{autoload,fonts/TeX} \
  jax/output/SVG/{config,jax}.js; do
  mkdir -p "build/site/html/mathjax/$(dirname "$part")"
  cp -rL "$mathjax/$part" "build/site/html/mathjax/$part"
done
"$python" scripts/documents.py links build/site/html
say "site: $root/build/site/html/index.html, after $SECONDS s"
