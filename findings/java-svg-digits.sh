#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Batik 1.16 (SVGGraphics2D) and JFreeSVG 4.1, by which Java programs write SVG, round to four and two decimals of the units that they are given, not of
# the sheet: of a part drawn in metres, scaled by 1000 to a sheet in millimetres, a bore of 30.1 mm is 30 mm wide by Batik and 40 mm by JFreeSVG,
# which also moves the ends of a line by 2.3 and 3.5 mm. Nothing is said. Believed: sizes to a thousandth of what is seen, as
# VectorGraphics2D 0.13 writes them.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libbatik-java=1.16+dfsg-1+deb12u1 libjfreesvg-java=4.1-2 libvectorgraphics2d-java=0.13-3 openjdk-17-jdk-headless
cat >Metres.java <<'JAVA'
import de.erichseifert.vectorgraphics2d.*;
import de.erichseifert.vectorgraphics2d.util.PageSize;
import java.awt.*;
import java.awt.geom.*;
import java.util.*;
import java.util.regex.*;

public class Metres {
  static void draw(Graphics2D sheet) {
    sheet.scale(1000, 1000);
    sheet.setStroke(new BasicStroke(0.001f));
    sheet.draw(new Line2D.Double(0.0123, 0.05, 0.0765, 0.05));
    sheet.draw(new Ellipse2D.Double(0.01, 0.02, 0.0301, 0.0301));
  }

  static Map<String, Double> attributes(String svg, String element) {
    var tag = Pattern.compile("<" + element + "\\b[^>]*>").matcher(svg);
    var found = new HashMap<String, Double>();
    if (!tag.find()) return found;
    var each = Pattern.compile("\\b(x1|x2|rx?)=\"(-?[0-9.]+)").matcher(tag.group());
    while (each.find()) found.put(each.group(1), Double.valueOf(each.group(2)) * 1000);
    return found;
  }

  static void tell(String library, String svg) {
    var line = attributes(svg, "line");
    var circle = attributes(svg, svg.contains("<circle") ? "circle" : "ellipse");
    double radius = circle.getOrDefault("r", circle.getOrDefault("rx", 0.0));
    System.out.println(library + String.format(Locale.ROOT, ": line from %.2f to %.2f, bore of %.2f mm", line.get("x1"), line.get("x2"), 2 * radius));
  }

  public static void main(String[] words) throws Exception {
    var document = org.apache.batik.dom.GenericDOMImplementation.getDOMImplementation().createDocument("http://www.w3.org/2000/svg", "svg", null);
    var batik = new org.apache.batik.svggen.SVGGraphics2D(document);
    draw(batik);
    var text = new java.io.StringWriter();
    batik.stream(text, true);
    tell("Batik", text.toString());
    var jfree = new org.jfree.svg.SVGGraphics2D(100, 100);
    draw(jfree);
    tell("JFreeSVG", jfree.getSVGElement());
    var other = new VectorGraphics2D();
    draw(other);
    var bytes = new java.io.ByteArrayOutputStream();
    Processors.get("svg").getDocument(other.getCommands(), new PageSize(100, 100)).writeTo(bytes);
    tell("VectorGraphics2D", bytes.toString());
  }
}
JAVA
java_program Metres.java >seen
expect_in seen <<'END'
Batik: line from 12.30 to 76.50, bore of 30.00 mm
JFreeSVG: line from 10.00 to 80.00, bore of 40.00 mm
VectorGraphics2D: line from 12.30 to 76.50, bore of 30.10 mm
END
