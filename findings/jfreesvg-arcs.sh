#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# JFreeSVG 4.1 (SVG by Java's Graphics2D, as of JFreeChart) draws an arc by drawArc, such as that of an angular dimension, as a pie: with lines
# from both its ends to its centre. It drops where a dash pattern begins, so that chain lines no longer meet at their centre, and the limit of mitres,
# which is 10 in Java and 4 in SVG, so that sharp corners are cut off. Nothing is said. Arcs as shapes (Arc2D.OPEN) are right. Believed: as Java
# paints them, "the outline of a circular or elliptical arc", and as VectorGraphics2D 0.13 writes them.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libjfreesvg-java=4.1-2 libvectorgraphics2d-java=0.13-3 openjdk-17-jdk-headless
cat >Draw.java <<'JAVA'
import java.awt.*;
import java.awt.geom.*;
import java.util.function.Consumer;

public class Draw {
  static void show(String name, Consumer<Graphics2D> shape) {
    var jfree = new org.jfree.svg.SVGGraphics2D(200, 100);
    shape.accept(jfree);
    var other = new de.erichseifert.vectorgraphics2d.VectorGraphics2D();
    shape.accept(other);
    var document = de.erichseifert.vectorgraphics2d.Processors.get("svg").getDocument(other.getCommands(), new de.erichseifert.vectorgraphics2d.util.PageSize(200, 100));
    var bytes = new java.io.ByteArrayOutputStream();
    try {
      document.writeTo(bytes);
    } catch (java.io.IOException error) {
      throw new RuntimeException(error);
    }
    System.out.println(name + ": JFreeSVG" + told(jfree.getSVGElement()) + "; VectorGraphics2D" + told(bytes.toString()));
  }

  static String told(String svg) {
    var found = java.util.regex.Pattern.compile(" d=\"[^\"]*\"|stroke-(dash|miter)[a-z]*: ?[^;\"]*").matcher(svg.replaceAll("(\\.\\d\\d?)\\d+", "$1"));
    var parts = new java.util.TreeSet<String>();
    while (found.find()) parts.add(found.group().strip().replaceAll(": |, ", ":").replaceAll("(\\d)\\.0\\b", "$1"));
    return parts.isEmpty() ? " nothing" : " " + String.join(" ", parts);
  }

  public static void main(String[] words) {
    show("drawArc", g -> g.drawArc(0, 0, 20, 20, 0, 90));
    show("Arc2D.OPEN", g -> g.draw(new Arc2D.Double(0, 0, 20, 20, 0, 90, Arc2D.OPEN)));
    show("dashes of 4 and 2 from 1 on", g -> {
      g.setStroke(new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {4, 2}, 1));
      g.draw(new Line2D.Double(0, 0, 30, 0));
    });
    show("a sharp corner", g -> {
      g.setStroke(new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10));
      var corner = new Path2D.Double();
      corner.moveTo(0, 0);
      corner.lineTo(20, 4);
      corner.lineTo(0, 8);
      g.draw(corner);
    });
  }
}
JAVA
java_program Draw.java >seen
expect_in seen <<'END'
drawArc: JFreeSVG d="M 20 10 C 20 4.4 15.5 0 10 0 L 10 10 Z "; VectorGraphics2D d="M20,10 C20,4.47 15.52,0 10,0" stroke-miterlimit:10
Arc2D.OPEN: JFreeSVG d="M 20 10 C 20 4.4 15.5 0 10 0"; VectorGraphics2D d="M20,10 C20,4.47 15.52,0 10,0" stroke-miterlimit:10
dashes of 4 and 2 from 1 on: JFreeSVG stroke-dasharray:4:2; VectorGraphics2D stroke-dasharray:4,2 stroke-dashoffset:1 stroke-miterlimit:10
a sharp corner: JFreeSVG d="M 0 0 L 20 4 L 0 8"; VectorGraphics2D d="M0,0 L20,4 L0,8" stroke-miterlimit:10
END
