#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# TCPDF 6.6.2 (PDF by PHP; ImageSVG) ends arcs whose axes are turned elsewhere, those of circles, too: one to (115, 60), turned by 90 degrees, ends at
# (115, 33.5), and what follows leaves a gap. It leaves out arcs on whose flags nothing follows but digits, as SVGO writes them. Of dashes of 4 and
# gaps of 2 with a blank between it makes dashes and gaps of 4, and drops where dashes begin. Nothing is said. Arcs that are not turned,
# and dashes with a comma, are right. Believed: as SVG 1.1 has them (8.3.8, 11.4, F.6).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages php-tcpdf=6.6.2+dfsg1-1+deb12u1 php8.2-cli php8.2-xml
cat >draw.php <<'PHP'
<?php
require_once "root/usr/share/php/tcpdf/tcpdf.php";
$shapes = [
  "an upright ellipse" => 'd="M100 60A20 10 0 0 1 130 60L150 60"', "an ellipse turned by 30 degrees" => 'd="M100 60A20 10 30 0 1 130 60L150 60"',
  "an ellipse turned by 90 degrees" => 'd="M100 60A20 10 90 0 1 115 60L150 60"', "a turned circle" => 'd="M100 60A20 20 30 0 1 130 60L150 60"',
  "an arc after SVGO" => 'd="M100 60A20 20 0 0130 60L150 60"', "dashes with a comma" => 'd="M100 60H150" stroke-dasharray="4,2"',
  "dashes with a blank" => 'd="M100 60H150" stroke-dasharray="4 2"', "dashes that begin at 1" => 'd="M100 60H150" stroke-dasharray="4,2" stroke-dashoffset="1"',
];
foreach ($shapes as $name => $shape) {
  $sheet = new TCPDF("L", "pt", [200, 100], true, "UTF-8", false);
  $sheet->setPrintHeader(false);
  $sheet->setPrintFooter(false);
  $sheet->setCompression(false);
  $sheet->AddPage();
  $sheet->ImageSVG("@<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200\" height=\"100\" viewBox=\"0 0 200 100\"><path $shape stroke=\"black\" fill=\"none\"/></svg>", 0, 0, 200, 100);
  preg_match('/([-\d.]+) ([-\d.]+) m\n(.*?)S\n/s', $sheet->Output("sheet.pdf", "S"), $path);
  preg_match_all('/([-\d.]+) ([-\d.]+) ([cl])\n/', $path[3] ?? "", $ends, PREG_SET_ORDER);
  preg_match_all('/w 0 J 0 j (\[[\d. ]+\] [\d.]+) d/', $sheet->Output("sheet.pdf", "S"), $dashes);
  $pieces = array_map(fn($end) => sprintf("%s to %.1f %.1f", $end[3] == "c" ? "curve" : "line", $end[1], 100 - $end[2]), $ends);
  $curves = array_values(array_filter($pieces, fn($piece) => $piece[0] == "c"));
  $pieces = array_merge(array_slice($curves, -1), array_filter($pieces, fn($piece) => $piece[0] == "l"));
  echo "$name: ", implode(", ", $pieces) ?: "nothing", $dashes[1] ? ", dashes " . preg_replace('/\.0+/', "", end($dashes[1])) : "", "\n";
}
PHP
php8.2 -n -d extension_dir="$(echo root/usr/lib/php/2*)" -d extension=xml draw.php >seen 2>messages || { cat seen messages; exit 1; }
expect_in seen <<'END'
an upright ellipse: curve to 130.0 60.0, line to 150.0 60.0
an ellipse turned by 30 degrees: curve to 130.8 58.1, line to 150.0 60.0
an ellipse turned by 90 degrees: curve to 115.0 33.5, line to 150.0 60.0
a turned circle: curve to 141.5 53.4, line to 150.0 60.0
an arc after SVGO: line to 150.0 60.0
dashes with a comma: line to 150.0 60.0, dashes [4 2] 0
dashes with a blank: line to 150.0 60.0, dashes [4] 0
dashes that begin at 1: line to 150.0 60.0, dashes [4 2] 0
END
