#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Two attachments of a PDF, the first with a folder in its name, as ISO 32000-1, 7.11.2 allows: pdfdetach 22.12 -saveall stops there and
# saves neither; qpdf 11.3.0 gives both.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages qpdf=11.3.0-1+deb12u1 poppler-utils=22.12.0-2+deb12u3
printf one >one.txt
printf two >two.txt
qpdf --empty empty.pdf
qpdf empty.pdf --add-attachment one.txt --filename=parts/one.txt --key=1 -- --add-attachment two.txt --filename=two.txt --key=2 -- both.pdf
mkdir saved
{
  pdfdetach -list both.pdf
  pdfdetach -saveall -o saved both.pdf 2>/dev/null || echo "exit code $?"
  echo "saved: $(find saved -type f | wc -l)"
  echo "qpdf: $(qpdf --show-attachment=1 both.pdf), $(qpdf --show-attachment=2 both.pdf)"
} >seen
expect_in seen <<'END'
2 embedded files
1: parts/one.txt
2: two.txt
exit code 2
saved: 0
qpdf: one, two
END
