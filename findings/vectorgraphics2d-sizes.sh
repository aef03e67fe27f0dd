#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# VectorGraphics2D 0.13 (SVG, PDF and EPS by Java's Graphics2D) takes the size of a page for millimetres in PDF and EPS, and for pixels in SVG: a
# sheet of 200 x 100 is 566.9 pt wide as PDF and EPS, and 200 px, 52.9 mm, as SVG, and all lengths on it with it. Its own page size A4 comes
# out as an SVG of 56 x 79 mm. Nothing is said. Believed: one document has one size.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libvectorgraphics2d-java=0.13-3 openjdk-17-jdk-headless librsvg2-bin=2.54.7+dfsg-1~deb12u1 poppler-utils=22.12.0-2+deb12u3
cat >Sheet.java <<'JAVA'
import de.erichseifert.vectorgraphics2d.*;
import de.erichseifert.vectorgraphics2d.util.PageSize;
import java.awt.geom.Line2D;
import java.io.FileOutputStream;

public class Sheet {
  public static void main(String[] words) throws java.io.IOException {
    var drawing = new VectorGraphics2D();
    drawing.draw(new Line2D.Double(10, 10, 160, 10));
    for (String format : new String[] {"svg", "pdf", "eps"}) {
      Processors.get(format).getDocument(drawing.getCommands(), new PageSize(200, 100)).writeTo(new FileOutputStream("200 x 100." + format));
      Processors.get(format).getDocument(drawing.getCommands(), PageSize.A4).writeTo(new FileOutputStream("A4." + format));
    }
  }
}
JAVA
java_program Sheet.java
for name in A4 "200 x 100"; do
  echo "$name as PDF: $(pdfinfo "$name.pdf" | sed -n 's/^Page size: *//p')"
  echo "$name as EPS: $(sed -n 's/^%%HiResBoundingBox: //p' "$name.eps")"
  rsvg-convert --format pdf "$name.svg" >"$name of svg.pdf"
  echo "$name as SVG: $(grep -oE '(width|height)="[0-9.]+[a-z]*"' "$name.svg" | head -n 2 | paste -sd ' '), a PDF of it: $(pdfinfo "$name of svg.pdf" | sed -n 's/^Page size: *//p')"
done >seen
expect_in seen <<'END'
A4 as PDF: 595.276 x 841.89 pts (A4)
A4 as EPS: 0.0 0.0 595.2755905511812 841.8897637795277
A4 as SVG: height="297px" width="210px", a PDF of it: 157.5 x 222.75 pts
200 x 100 as PDF: 566.929 x 283.465 pts
200 x 100 as EPS: 0.0 0.0 566.9291338582677 283.46456692913387
200 x 100 as SVG: height="100px" width="200px", a PDF of it: 150 x 75 pts
END
