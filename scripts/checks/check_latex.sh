#!/bin/sh
# Say what to install if something that `make pdf` needs is missing; --debian: all its packages.
set -eu

packages="latexmk texlive-xetex texlive-latex-recommended texlive-latex-extra"
packages="$packages texlive-fonts-recommended texlive-pictures tex-gyre fonts-freefont-otf librsvg2-bin poppler-utils"
if [ "${1-}" = --debian ]; then
    echo "$packages"
    exit
fi
missing=
for program in latexmk xelatex rsvg-convert pdftoppm; do
    command -v "$program" >/dev/null 2>&1 || missing="$missing $program"
done
if [ -z "$missing" ]; then
    for file in fncychap.sty tabulary.sty capt-of.sty needspace.sty qrcode.sty; do
        kpsewhich "$file" >/dev/null 2>&1 || missing="$missing $file"
    done
    fc-list 2>/dev/null | grep -q FreeSerif.otf || missing="$missing FreeSerif.otf"
fi
if [ -n "$missing" ]; then
    echo "discostorm: make pdf needs LaTeX; missing here:$missing" >&2
    echo "On Debian: apt-get install $packages" >&2
    exit 1
fi
