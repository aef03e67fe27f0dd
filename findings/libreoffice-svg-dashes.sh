#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# LibreOffice Draw 7.4.7 writes dashed lines into SVG as continuous ones, so that hidden lines become visible: a line of 80 mm with dashes of
# 6 mm and gaps of 4 has 80 mm of ink instead of 48. Its PDF and EPS of the same document have 48. Believed: the dashes, by SVG's
# stroke-dasharray (SVG 1.1, 11.4), or as lines of their own.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libreoffice-draw=4:7.4.7-1+deb12u14 librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3 ghostscript=10.0.0~dfsg-11+deb12u9
export HOME=$work LD_LIBRARY_PATH=$work/root/usr/lib/libreoffice/program:$LD_LIBRARY_PATH
# Debian's settings name the folders of an installation.
library=$work/root/usr/lib/libreoffice
sed -i -e "s,file:///etc/libreoffice/registry,file://$library/share/.registry,g" -e "s,file:///usr/lib/libreoffice,file://$library,g" "$library"/program/*rc
cat >drawn.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 100 50">
  <path d="M10 25H90" fill="none" stroke="#000" stroke-width="2" stroke-dasharray="6 4"/>
</svg>
SVG
mkdir written
for format in pdf eps svg; do
  timeout 120 "$library"/program/soffice --headless --convert-to $format --outdir written drawn.svg >messages 2>&1 || { cat messages >&2; exit 1; }
done
rsvg-convert -f pdf -o drawn.pdf drawn.svg
rsvg-convert -f pdf -o svg.pdf written/drawn.svg
gs -q -dBATCH -dNOPAUSE -dEPSCrop -sDEVICE=pdfwrite -o eps.pdf written/drawn.eps
cp written/drawn.pdf pdf.pdf
for name in drawn pdf eps svg; do
  pdftoppm -r 254 -gray -singlefile $name.pdf picture
  python3 - $name <<'PY'
import sys
data = open("picture.pgm", "rb").read()
width, height = map(int, data.split(None, 3)[1:3])
print(f"{sys.argv[1]}: {sum(pixel < 128 for pixel in data[-width * height:]) / 200:.0f} mm of ink")
PY
done >seen
expect_in seen <<'END'
drawn: 48 mm of ink
pdf: 48 mm of ink
eps: 48 mm of ink
svg: 80 mm of ink
END
