#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeHEP's VectorGraphics 2.4 (SVG, PDF and EPS by Java's Graphics2D) draws what is given in whole numbers (drawLine, drawOval, drawRect) half a unit to the
# right and down, and what is given as shapes where it is: of two concentric circles one stands 0.7 off, on a sheet in millimetres 0.7 mm. Its SVG
# drops clips: of a detail the whole part is drawn. Its PDF has five digits: 1234.56 becomes 1234.6. Nothing is said. Believed: as Batik 1.16 draws
# them, and the same by both ways.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreehep-graphicsio-svg-java=2.4+dfsg-3 libfreehep-graphicsio-pdf-java=2.4+dfsg-3 libfreehep-graphics2d-java=2.4+dfsg-3 \
  libfreehep-graphicsbase-java=2.4+dfsg-3 libfreehep-graphicsio-java=2.4+dfsg-3 libfreehep-io-java=2.0.2-6 libfreehep-util-java=2.0.2-7 \
  libfreehep-xml-java=2.1.2+dfsg1-5 libbatik-java=1.16+dfsg-1+deb12u1 openjdk-17-jdk-headless
cat >Halves.java <<'JAVA'
import java.awt.*;
import java.awt.geom.*;
import java.nio.file.*;
import java.util.*;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.*;

public class Halves {
  static final Dimension SHEET = new Dimension(2000, 100);

  static String freehep(boolean pdf, Consumer<Graphics2D> draw) throws Exception {
    var file = new java.io.File(pdf ? "sheet.pdf" : "sheet.svg");
    var sheet = pdf ? new org.freehep.graphicsio.pdf.PDFGraphics2D(file, SHEET) : new org.freehep.graphicsio.svg.SVGGraphics2D(file, SHEET);
    if (pdf) {
      var settings = new Properties();
      settings.setProperty(org.freehep.graphicsio.pdf.PDFGraphics2D.COMPRESS, "false");
      sheet.setProperties(settings);
    }
    sheet.startExport();
    draw.accept(sheet);
    sheet.endExport();
    return new String(Files.readAllBytes(file.toPath()), "ISO-8859-1");
  }

  static String batik(Consumer<Graphics2D> draw) throws Exception {
    var document = org.apache.batik.dom.GenericDOMImplementation.getDOMImplementation().createDocument("http://www.w3.org/2000/svg", "svg", null);
    var sheet = new org.apache.batik.svggen.SVGGraphics2D(document);
    draw.accept(sheet);
    var text = new java.io.StringWriter();
    sheet.stream(text, true);
    return text.toString();
  }

  static String ends(String svg) {
    double[] box = {1e9, 1e9, -1e9, -1e9};
    var path = Pattern.compile(" d=\"([^\"]*)\"").matcher(svg);
    while (path.find()) {
      var point = Pattern.compile("(-?[\\d.]+)[ ,](-?[\\d.]+)").matcher(path.group(1));
      while (point.find())
        for (int axis = 0; axis < 2; ++axis) {
          double value = Double.parseDouble(point.group(axis + 1));
          box[axis] = Math.min(box[axis], value);
          box[axis + 2] = Math.max(box[axis + 2], value);
        }
    }
    return String.format(Locale.ROOT, "%.1f %.1f to %.1f %.1f", box[0], box[1], box[2], box[3]);
  }

  public static void main(String[] words) throws Exception {
    Map<String, Consumer<Graphics2D>> shapes = new LinkedHashMap<>();
    shapes.put("circle as a shape", g -> g.draw(new Ellipse2D.Double(40, 60, 20, 20)));
    shapes.put("circle by drawOval", g -> g.drawOval(40, 60, 20, 20));
    shapes.put("line as a shape", g -> g.draw(new Line2D.Double(10, 5, 100, 5)));
    shapes.put("line by drawLine", g -> g.drawLine(10, 5, 100, 5));
    shapes.put("rectangle by drawRect", g -> g.drawRect(10, 5, 90, 20));
    for (var shape : shapes.entrySet())
      System.out.println("FreeHEP, " + shape.getKey() + ": " + ends(freehep(false, shape.getValue())));
    Consumer<Graphics2D> detail = g -> {
      g.clip(new Rectangle2D.Double(0, 0, 20, 20));
      g.fill(new Rectangle2D.Double(0, 0, 100, 100));
    };
    System.out.println("clips in SVG: FreeHEP " + (freehep(false, detail).contains("clip-path") ? 1 : 0) + ", Batik " + (batik(detail).contains("clip-path") ? 1 : 0));
    var point = Pattern.compile("(1234[\\d.]*|1235[\\d.]*) [\\d.]+ l\\b").matcher(freehep(true, g -> g.draw(new Line2D.Double(10, 5, 1234.56, 5))));
    System.out.println("line to 1234.56 in PDF: to " + (point.find() ? point.group(1) : "elsewhere"));
  }
}
JAVA
java_program Halves.java >seen 2>messages || { tail -n 5 messages; exit 1; }
expect_in seen <<'END'
FreeHEP, circle as a shape: 40.0 60.0 to 60.0 80.0
FreeHEP, circle by drawOval: 40.5 60.5 to 60.5 80.5
FreeHEP, line as a shape: 10.0 5.0 to 100.0 5.0
FreeHEP, line by drawLine: 10.5 5.5 to 100.5 5.5
FreeHEP, rectangle by drawRect: 10.5 5.5 to 100.5 25.5
clips in SVG: FreeHEP 0, Batik 1
line to 1234.56 in PDF: to 1234.6
END
