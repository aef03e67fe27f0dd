#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Debian's wkhtmltopdf 0.12.6, run as on a server without a display, prints a drawing that stands in a page, and all else of it, at 77 %: an SVG of
# 100 mm is 76.8 mm wide on the sheet, whatever paper, resolution (--dpi) and zoom (--zoom) are asked for; sheets that are measured or cut by are
# too small. Of the switch that would prevent it (--disable-smart-shrinking) it says that it is not supported with Debian's Qt; of the size
# it says nothing. Believed: 100 mm, which is a length of CSS.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages wkhtmltopdf=0.12.6-2+b1 poppler-utils=22.12.0-2+deb12u3
export HOME=$work XDG_RUNTIME_DIR=$work QT_QPA_PLATFORM=offscreen QT_PLUGIN_PATH=$work/root/usr/lib/x86_64-linux-gnu/qt5/plugins
chmod 700 "$work"
cat >page.html <<'END'
<!DOCTYPE html>
<html><body style="margin: 0"><svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 100 50" style="display: block"><rect width="100" height="50" fill="#f00"/></svg></body></html>
END
while read -r what options; do
  # shellcheck disable=SC2086
  wkhtmltopdf -q -T 0 -B 0 -L 0 -R 0 $options page.html page.pdf 2>messages
  pdftocairo -svg page.pdf page.svg
  sed -nE 's/.*fill:rgb\(100%,0%,0%\).* d="M 0 0 L ([0-9.]+) 0 L [0-9.]+ ([0-9.]+) .*/\1 \2/p' page.svg |
    awk -v what="$what" '{ printf "%s: %.1f x %.1f mm\n", what, $1 / 72 * 25.4, $2 / 72 * 25.4 }'
  grep -o 'The switch.*' messages || true
done >seen <<'END'
A4 -s A4
A3 -s A3
300-dpi --dpi 300
zoom-1.3 --zoom 1.3
no-shrinking --disable-smart-shrinking
END
expect_in seen <<'END'
A4: 76.8 x 38.4 mm
A3: 76.8 x 38.4 mm
300-dpi: 76.8 x 38.4 mm
zoom-1.3: 76.8 x 38.4 mm
no-shrinking: 76.8 x 38.4 mm
The switch --disable-smart-shrinking, is not support using unpatched qt, and will be ignored.
END
