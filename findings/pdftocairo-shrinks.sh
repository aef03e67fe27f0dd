#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# poppler 22.12.0: pdftocairo makes drawings smaller when it converts a PDF into SVG or PDF, if its page is no whole number of
# points wide and high, such as A4: a line of 150 mm becomes 149.82 mm long, on a page as large as before. -origpagesizes changes nothing,
# -noshrink helps. Believed: 150 mm, as on a page of 595 x 420 points.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages poppler-utils=22.12.0-2+deb12u3
page() {  # FILE WIDTH HEIGHT, in points: a line of 150 mm
  local content='1 w 50 50 m 475.19685 50 l S' text=$'%PDF-1.4\n' places=() thing number=0
  for thing in '<< /Type /Catalog /Pages 2 0 R >>' '<< /Type /Pages /Kids [3 0 R] /Count 1 >>' \
    "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 $2 $3] /Contents 4 0 R /Resources << >> >>" \
    "<< /Length ${#content} >>"$'\nstream\n'"$content"$'\nendstream'; do
    places+=("${#text}")
    text+="$((++number)) 0 obj"$'\n'"$thing"$'\nendobj\n'
  done
  { printf '%sxref\n0 5\n0000000000 65535 f \n' "$text"
    printf '%010d 00000 n \n' "${places[@]}"
    printf 'trailer\n<< /Size 5 /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF\n' "${#text}"; } >"$1"
}
length() {  # SVG FILE: mm, of the line and as its transform has it
  python3 - "$1" <<'PY'
import re, sys
text = open(sys.argv[1]).read()
(x0, x1), scale = re.search(r' d="M (\S+) \S+ L (\S+) ', text).groups(), re.search(r"matrix\(([^,]+)", text)
width = re.search(r'width="([\d.]+)pt', text)[1]
print(f"line of {(float(x1) - float(x0)) * float(scale[1] if scale else 1) / 72 * 25.4:.2f} mm, page {float(width) / 72 * 25.4:.1f} mm wide")
PY
}
page a4.pdf 595.276 841.89
page whole.pdf 595 420
for name in a4 whole; do
  for option in '' -origpagesizes -noshrink; do
    pdftocairo -svg $option $name.pdf out.svg
    echo "$name as SVG${option:+, }$option: $(length out.svg)"
    pdftocairo -pdf $option $name.pdf out.pdf
    pdftocairo -svg -noshrink out.pdf out.svg
    echo "$name as PDF${option:+, }$option: $(length out.svg)"
  done
done >seen
expect_in seen <<'END'
a4 as SVG: line of 149.82 mm, page 210.0 mm wide
a4 as PDF: line of 149.82 mm, page 210.0 mm wide
a4 as SVG, -origpagesizes: line of 149.82 mm, page 210.0 mm wide
a4 as PDF, -origpagesizes: line of 149.82 mm, page 210.0 mm wide
a4 as SVG, -noshrink: line of 150.00 mm, page 210.0 mm wide
a4 as PDF, -noshrink: line of 150.00 mm, page 210.0 mm wide
whole as SVG: line of 150.00 mm, page 209.9 mm wide
whole as PDF: line of 150.00 mm, page 209.9 mm wide
whole as SVG, -origpagesizes: line of 150.00 mm, page 209.9 mm wide
whole as PDF, -origpagesizes: line of 150.00 mm, page 209.9 mm wide
whole as SVG, -noshrink: line of 150.00 mm, page 209.9 mm wide
whole as PDF, -noshrink: line of 150.00 mm, page 209.9 mm wide
END
