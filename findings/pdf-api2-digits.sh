#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# PDF::API2 2.044 and PDF::Builder 3.025 (Perl) write numbers below 100000 with five digits, larger ones with all: on a sheet drawn in millimetres
# (scale 72/25.4) a plate from 1188.45 to 1188.85, 0.4 mm thick, is drawn from 1188.5 to 1188.8, 0.3 mm; one on a site in metres
# at 123.456 stands 4 mm off. Nothing is said. Believed: a thousandth of a millimetre on any sheet, and no fewer digits below 100000
# than above.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libpdf-api2-perl=2.044-1 libpdf-builder-perl=3.025-1
export PERL5LIB=$work/root/usr/share/perl5
cat >draw.pl <<'PL'
use strict;
use PDF::API2;
use PDF::Builder;
for my $library ("PDF::API2", "PDF::Builder") {
  for my $x (0.123456, 12.3456, 1188.45, 1188.85, 12345.6, 123.456, 99999.4, 123456.78) {
    my $content = $library->new()->page()->gfx();
    $content->line($x, 0);
    my ($written) = $content->{" stream"} =~ /(\S+) 0 l/;
    print "$library: $x is $written\n";
  }
}
PL
perl draw.pl >seen
expect_in seen <<'END'
PDF::API2: 0.123456 is 0.12346
PDF::API2: 12.3456 is 12.346
PDF::API2: 1188.45 is 1188.5
PDF::API2: 1188.85 is 1188.8
PDF::API2: 12345.6 is 12346
PDF::API2: 123.456 is 123.46
PDF::API2: 99999.4 is 99999
PDF::API2: 123456.78 is 123456.78
PDF::Builder: 0.123456 is 0.12346
PDF::Builder: 12.3456 is 12.346
PDF::Builder: 1188.45 is 1188.5
PDF::Builder: 1188.85 is 1188.8
PDF::Builder: 12345.6 is 12346
PDF::Builder: 123.456 is 123.46
PDF::Builder: 99999.4 is 99999
PDF::Builder: 123456.78 is 123456.78
END
