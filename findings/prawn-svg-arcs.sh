#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# prawn-svg 0.32.0 (SVG in PDF by Ruby) draws elliptical arcs of paths so that they end elsewhere: an arc to (80, 50) ends at (75.9, 47.0), and what
# follows leaves a gap. Corners of rectangles whose radii differ come with one for both, hidden lines (visibility="hidden") are drawn, dashes begin at
# 0 whatever their offset, and a width of "inherit" is the thinnest line. There are no warnings, of which it has a list. Round arcs, ellipses,
# dashes and transforms are right. Believed: ends where SVG 1.1 (F.6) has them, and as librsvg draws the rest.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages ruby-prawn-svg=0.32.0-1
export RUBYLIB=$work/root/usr/lib/ruby/vendor_ruby:$work/root/usr/lib/ruby/3.1.0:$work/root/usr/lib/x86_64-linux-gnu/ruby/3.1.0
export GEM_PATH=$work/root/usr/share/rubygems-integration/all:$work/root/usr/share/rubygems-integration/3.1.0:$work/root/usr/lib/ruby/gems/3.1.0
cat >draw.rb <<'RUBY'
require 'prawn'
require 'prawn-svg'
SIDE = 100 * 72 / 25.4
STROKE = 'stroke="#000" fill="none" stroke-width="1"'
def drawn(content)
  warnings = []
  Prawn::Document.generate('sheet.pdf', margin: 0, page_size: [SIDE, SIDE], compress: false) do
    warnings = svg(%(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">#{content}</svg>), at: [0, bounds.top])[:warnings]
  end
  lines = File.binread('sheet.pdf')[/stream\n(.*?)endstream/m, 1].lines.map(&:strip).drop_while { |line| line != '/DeviceRGB CS' }
  point = ->(line) { x, y = line.split[-3, 2].map(&:to_f); format('%.1f %.1f', x + 0.0, SIDE - y) }
  [lines, point, warnings]
end
[['round arc', 'A30 30 0 0 1 80 50'], ['elliptical arc', 'A40 30 0 0 1 80 50'], ['turned by 30 degrees', 'A40 30 30 0 1 80 50'],
 ['turned by 45 degrees, other side', 'A40 30 45 0 0 80 50'], ['turned by 90 degrees', 'A40 30 90 0 1 80 50']].each do |name, arc|
  lines, point, warnings = drawn(%(<path #{STROKE} d="M20 50#{arc}"/>))
  puts "#{name} to 80.0 50.0: ends at #{point.(lines.grep(/ c$/).last)}, #{warnings.size} warnings"
end
lines, point, warnings = drawn(%(<rect #{STROKE} x="20" y="20" width="60" height="40" rx="20" ry="5"/>))
puts "corners 20 wide, 5 high: the first one from #{point.(lines.grep(/ l$/).first)} to #{point.(lines.grep(/ c$/).first)}, #{warnings.size} warnings"
lines, point, warnings = drawn(%(<path #{STROKE} visibility="hidden" d="M10 40H90"/>))
puts "a hidden line: #{lines.grep(/ l$/).size} line, #{warnings.size} warnings"
lines, point, warnings = drawn(%(<path #{STROKE} stroke-dasharray="20 10" stroke-dashoffset="15" d="M10 50H90"/>))
puts "dashes 20 10 from 15 on: #{lines.grep(/ d$/).last}, #{warnings.size} warnings"
lines, point, warnings = drawn(%(<g stroke="#000" stroke-width="4"><path stroke-width="inherit" d="M10 50H90"/></g>))
puts "the width 4 inherited: #{lines.grep(/ w$/).last}, #{warnings.size} warnings"
RUBY
ruby3.1 draw.rb >seen
expect_in seen <<'END'
round arc to 80.0 50.0: ends at 80.0 50.0, 0 warnings
elliptical arc to 80.0 50.0: ends at 75.9 47.0, 0 warnings
turned by 30 degrees to 80.0 50.0: ends at 77.8 48.1, 0 warnings
turned by 45 degrees, other side to 80.0 50.0: ends at 80.6 46.1, 0 warnings
turned by 90 degrees to 80.0 50.0: ends at 80.0 50.0, 0 warnings
corners 20 wide, 5 high: the first one from 60.0 20.0 to 80.0 40.0, 0 warnings
a hidden line: 1 line, 0 warnings
dashes 20 10 from 15 on: [20.0 10.0] 0.0 d, 0 warnings
the width 4 inherited: 0.0 w, 0 warnings
END
