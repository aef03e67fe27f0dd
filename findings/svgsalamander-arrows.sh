#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svgSalamander 1.1.4 (SVG in Java programs, such as NetBeans and JOSM) draws arrowheads made as markers too large by the factor of their own markerWidth:
# one of 6 mm becomes 36 mm long. Symbols with a viewBox become points, an inner svg without one stands at the origin, and 100 mm are 283.39
# of its units where 4 in are 288. Nothing is said. Markers with a viewBox, clips, dashes and transforms are right. Believed: as SVG 1.1 has them
# (5.1.2, 5.6, 7.10, 11.6.2): without a viewBox the units of a marker are line widths.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libsvgsalamander-java=1.1.4-1 openjdk-17-jdk-headless
cat >Sheet.java <<'JAVA'
import com.kitfox.svg.*;
import java.awt.image.BufferedImage;
import java.io.StringReader;
import java.util.*;

public class Sheet {
  static SVGDiagram read(String attributes, String content) {
    var universe = new SVGUniverse();
    return universe.getDiagram(universe.loadSVG(new StringReader("<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' " + attributes + ">" + content + "</svg>"), "sheet"));
  }

  static String drawn(String content) throws SVGException {
    var image = new BufferedImage(100, 100, BufferedImage.TYPE_INT_ARGB);
    read("width='100' height='100'", content).render(image.createGraphics());
    int left = 100, top = 100, right = 0, bottom = 0;
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 100; ++x)
        if (image.getRGB(x, y) >>> 24 > 127) {
          left = Math.min(left, x);
          right = Math.max(right, x + 1);
          top = Math.min(top, y);
          bottom = Math.max(bottom, y + 1);
        }
    return left + " " + top + " to " + right + " " + bottom;
  }

  static String arrow(int size, String more) {
    return "<defs><marker id='arrow' orient='auto' markerWidth='" + size + "' markerHeight='" + size + "' refX='0' refY='" + size / 2.0 + "'" + more + "><path d='M0 0L" + size + " " + size / 2.0 + "L0 " + size
      + "z'/></marker></defs><path d='M10 50H50' stroke='black' marker-end='url(#arrow)'/>";
  }

  public static void main(String[] words) throws SVGException {
    System.out.println("an arrowhead of 4 at 50 50: " + drawn(arrow(4, "")) + ", right would be to 54");
    System.out.println("an arrowhead of 6 at 50 50: " + drawn(arrow(6, "")) + ", right would be to 56");
    System.out.println("an arrowhead of 6 with a viewBox: " + drawn(arrow(6, " viewBox='0 0 6 6'")) + ", right would be to 56");
    System.out.println("a symbol of 20 at 50 50: " + drawn("<symbol id='hole' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol><use xlink:href='#hole' x='50' y='50' width='20' height='20'/>") + ", right would be 50 50 to 70 70");
    System.out.println("an inner svg at 50 50: " + drawn("<svg x='50' y='50' width='20' height='20'><rect width='20' height='20'/></svg>") + ", right would be 50 50 to 70 70");
    System.out.println("an inner svg with a viewBox: " + drawn("<svg x='50' y='50' width='20' height='20' viewBox='0 0 10 10'><rect width='10' height='10'/></svg>") + ", right would be 50 50 to 70 70");
    for (var width : List.of("100mm", "10cm", "4in")) System.out.println("a sheet of " + width + ": " + read("width='" + width + "' height='1in'", "").getWidth() + " pt");
  }
}
JAVA
java_program Sheet.java 2>messages >seen || { cat messages; exit 1; }
expect_in seen <<'END'
an arrowhead of 4 at 50 50: 10 42 to 66 58, right would be to 54
an arrowhead of 6 at 50 50: 10 32 to 86 68, right would be to 56
an arrowhead of 6 with a viewBox: 10 48 to 56 53, right would be to 56
a symbol of 20 at 50 50: 0 0 to 51 51, right would be 50 50 to 70 70
an inner svg at 50 50: 0 0 to 20 20, right would be 50 50 to 70 70
an inner svg with a viewBox: 50 50 to 70 70, right would be 50 50 to 70 70
a sheet of 100mm: 283.392 pt
a sheet of 10cm: 283.392 pt
a sheet of 4in: 288.0 pt
END
