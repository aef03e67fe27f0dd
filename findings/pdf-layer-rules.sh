#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Layers of PDF that are not simply on or off: MuPDF 1.21.1 draws what is to be seen only if all of two layers are on, hides what is to be
# seen if any is off, and takes no expressions (/VE); poppler 22.12 takes all of these, but draws what is to be seen only in print
# (/Usage, /AS) in its pictures, too. Believed: both take all of them, as the standard has had them since PDF 1.5 and 1.6.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages mupdf-tools=1.21.1+ds2-1+deb12u1 poppler-utils=22.12.0-2+deb12u3
python3 - <<'PY'
SQUARE = b"/OC /B BDC 0 0 100 50 re f EMC"
USUAL = b"/ON[5 0 R]/OFF[6 0 R]"
AUTOMATIC = b"/ON[5 0 R 6 0 R]/AS[<</Event/View/Category[/View]/OCGs[6 0 R]>>]"

def write(name, rule, states=USUAL, usage=b""):
    objects = [
        b"<</Type/Catalog/Pages 2 0 R/OCProperties<</OCGs[5 0 R 6 0 R]/D<<" + states + b">>>>>>",
        b"<</Type/Pages/Kids[3 0 R]/Count 1>>",
        b"<</Type/Page/Parent 2 0 R/MediaBox[0 0 100 50]/Contents 4 0 R/Resources<</Properties<</B 7 0 R>>>>>>",
        b"<</Length %d>>stream\n%s\nendstream" % (len(SQUARE), SQUARE),
        b"<</Type/OCG/Name(on)>>", b"<</Type/OCG/Name(off)" + usage + b">>", b"<</Type/OCMD" + rule + b">>"]
    file, places = b"%PDF-1.7\n", []
    for number, text in enumerate(objects, 1):
        places.append(len(file))
        file += b"%d 0 obj\n%s\nendobj\n" % (number, text)
    table = b"".join(b"%010d 00000 n \n" % place for place in places)
    file += b"xref\n0 8\n0000000000 65535 f \n%strailer<</Size 8/Root 1 0 R>>\nstartxref\n%d\n%%%%EOF\n" % (table, len(file))
    open(name + ".pdf", "wb").write(file)

both = b"/OCGs[5 0 R 6 0 R]"
write("all are on, seen if any is on", both + b"/P/AnyOn", b"/ON[5 0 R 6 0 R]")
write("one is off, seen if any is on", both + b"/P/AnyOn")
write("one is off, seen if all are on", both + b"/P/AllOn")
write("one is off, seen if any is off", both + b"/P/AnyOff")
write("one is off, seen if all are off", both + b"/P/AllOff")
write("one is off, seen if it is not", b"/VE[/Not 6 0 R]")
write("one is on, seen if it is not", b"/VE[/Not 5 0 R]")
write("to be seen only in print", b"/OCGs 6 0 R", AUTOMATIC, b"/Usage<</View<</ViewState/OFF>>/Print<</PrintState/ON>>>>")
PY
for file in *.pdf; do
  pdftoppm -r 72 -gray -singlefile "$file" poppler
  mutool draw -q -r 72 -c gray -o mupdf.pgm "$file" 2>/dev/null
  python3 - "${file%.pdf}" <<'PY'
import sys
seen = [open(program + ".pgm", "rb").read()[-2550] < 128 for program in ("poppler", "mupdf")]
print(sys.argv[1] + ":", ", ".join(f"{name} {'draws' if it else 'hides'}" for name, it in zip(("poppler", "MuPDF"), seen)))
PY
done >seen
expect_in seen <<'END'
all are on, seen if any is on: poppler draws, MuPDF draws
one is off, seen if all are off: poppler hides, MuPDF hides
one is off, seen if all are on: poppler hides, MuPDF draws
one is off, seen if any is off: poppler draws, MuPDF hides
one is off, seen if any is on: poppler draws, MuPDF draws
one is off, seen if it is not: poppler draws, MuPDF draws
one is on, seen if it is not: poppler hides, MuPDF draws
to be seen only in print: poppler draws, MuPDF hides
END
