#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# php-svg-lib 0.5.0 (below dompdf, PDF by PHP) leaves out arcs of SVG paths that go as far left as down, or right as up, between whole numbers: two of the
# four round corners of a plate are cut off by slanted lines. Quadratic curves are a quarter too low. Clip paths are not clipped by, but painted
# black over the drawing, and nested sheets and symbols stand at the origin in their own units. Nothing is said. The same corners at 0.5, cubic curves,
# circles and dashes are right. Believed: as SVG 1.1 has them (5.1.2, 8.3.7, 8.3.8, 14.3.5).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages php-dompdf-svg-lib=0.5.0-3+deb12u1 php8.2-cli php8.2-xml php8.2-mbstring
cat >draw.php <<'PHP'
<?php
set_include_path("root/usr/share/php");
require_once "Dompdf/Svg/autoload.php";

function content($shapes) {
  file_put_contents("sheet.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100' viewBox='0 0 200 100'>$shapes</svg>");
  $document = new Svg\Document();
  $document->loadFile("sheet.svg");
  $surface = new Svg\Surface\SurfaceCpdf($document);
  $document->render($surface);
  preg_match_all('/stream\r?\n(.*?)endstream/s', $surface->out(), $streams);
  return implode(" ", array_map(fn($stream) => @gzuncompress($stream) ?: $stream, $streams[1]));
}

function operators($text) {  // of paths, each with its numbers
  preg_match_all('/((?:-?[\d.]+\s+)+)(m|l|c|v|re)\b/', $text, $found, PREG_SET_ORDER);
  return array_map(fn($match) => [$match[2], array_map('floatval', preg_split('/\s+/', trim($match[1])))], $found);
}

function count_of($operator, $text) {
  return count(array_filter(operators($text), fn($each) => $each[0] == $operator));
}

function tell($what, $seen, $right) {
  echo "$what: $seen", $seen == $right ? "" : ", right would be $right", "\n";
}

$pen = "fill='none' stroke='black'";
foreach (["10" => 0, "10.5" => 0.5] as $at => $shift) {
  [$left, $top, $right, $bottom] = [10 + $shift, 10 + $shift, 90 + $shift, 60 + $shift];
  $path = sprintf("M%s %sH%sA5 5 0 0 1 %s %sV%sA5 5 0 0 1 %s %sH%sA5 5 0 0 1 %s %sV%sA5 5 0 0 1 %s %sz", $left + 5, $top, $right - 5, $right, $top + 5,
    $bottom - 5, $right - 5, $bottom, $left + 5, $left, $bottom - 5, $top + 5, $left + 5, $top);
  tell("plate with four round corners, from $at on", count_of("c", content("<path d='$path' $pen/>")) . " arcs", "4 arcs");
}
tell("half circle", count_of("c", content("<path d='M110 50A10 10 0 0 1 90 50' $pen/>")) . " curves", "2 curves");
foreach (["cubic" => "M0 0C0 13.333333 20 13.333333 20 0", "quadratic" => "M0 0Q10 20 20 0"] as $kind => $path)
  foreach (operators(content("<path d='$path' $pen/>")) as [$operator, $numbers])
    if ($operator == "c" || $operator == "v") {
      [$first, $second] = $operator == "c" ? [$numbers[1], $numbers[3]] : [0, $numbers[1]];
      tell("height of a $kind curve", round(3 / 8 * ($first + $second), 1), 10);
    }
$clipped = content("<clipPath id='c'><rect width='10' height='10'/></clipPath><line x2='100' y2='50' clip-path='url(#c)' $pen/>");
tell("line clipped by a square", preg_match('/\bW\*? n\b/', $clipped) ? "clipped" : (preg_match('/\bre\s+f\b/', $clipped) ? "whole, and a black square" : "whole"), "clipped");
[, $numbers] = array_values(array_filter(operators(content("<svg x='100' y='50' width='100' height='50' viewBox='0 0 10 5'><line x2='10' y2='5' $pen/></svg>")), fn($each) => $each[0] == "l"))[0];
tell("line of a nested sheet", "ends at " . implode(" ", $numbers), "ends at 200 100");
PHP
php8.2 -n -d extension_dir="$(echo root/usr/lib/php/2*)" -d extension=ctype -d extension=mbstring -d extension=xml -d error_reporting=8191 draw.php >seen 2>messages ||
  { cat seen messages; exit 1; }
expect_in seen <<'END'
plate with four round corners, from 10 on: 2 arcs, right would be 4 arcs
plate with four round corners, from 10.5 on: 4 arcs
half circle: 2 curves
height of a cubic curve: 10
height of a quadratic curve: 7.5, right would be 10
line clipped by a square: whole, and a black square, right would be clipped
line of a nested sheet: ends at 10 5, right would be ends at 200 100
END
