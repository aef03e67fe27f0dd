#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3: STEPCAFControl_Reader gives a size that has a number of decimals (a qualified item) in the unit of the file and
# without the decimals, where it gives the shape, limits, tolerances, and sizes without decimals in millimetres; of deviations none is
# converted. Nothing says which is which. Believed: all in one unit, and three decimals of 'NR2 1.3' (ISO 6093).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
inches() { echo "(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(LENGTH_MEASURE($1),#346)${3:-}REPRESENTATION_ITEM('$2'))"; }
step_with_pmi inches.step INCH <<STEP
#1000=SHAPE_ASPECT('top','',#4,.T.);
#1001=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1000,#10,#331);
#1002=SHAPE_ASPECT('bottom','',#4,.T.);
#1003=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1002,#10,#338);
#1004=VALUE_FORMAT_TYPE_QUALIFIER('NR2 1.3');
#1010=DIMENSIONAL_LOCATION('0.787 in','',#1000,#1002);
#1011=$(inches 0.787 'nominal value');
#1012=SHAPE_DIMENSION_REPRESENTATION('',(#1011),#345);
#1013=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#1010,#1012);
#1020=DIMENSIONAL_LOCATION('0.787 in with decimals','',#1000,#1002);
#1021=$(inches 0.787 'nominal value' 'QUALIFIED_REPRESENTATION_ITEM((#1004))');
#1022=SHAPE_DIMENSION_REPRESENTATION('',(#1021),#345);
#1023=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#1020,#1022);
#1030=DIMENSIONAL_LOCATION('0.787 in -0.002/+0.004','',#1000,#1002);
#1031=$(inches 0.787 'nominal value');
#1032=SHAPE_DIMENSION_REPRESENTATION('',(#1031),#345);
#1033=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#1030,#1032);
#1034=$(inches -0.002 '');
#1035=$(inches 0.004 '');
#1036=TOLERANCE_VALUE(#1034,#1035);
#1037=PLUS_MINUS_TOLERANCE(#1036,#1030);
#1040=DIMENSIONAL_LOCATION('0.785 to 0.791 in','',#1000,#1002);
#1041=$(inches 0.785 'lower limit');
#1042=$(inches 0.791 'upper limit');
#1043=SHAPE_DIMENSION_REPRESENTATION('',(#1041,#1042),#345);
#1044=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#1040,#1043);
#1050=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.002),#346);
#1051=FLATNESS_TOLERANCE('flatness 0.002 in','',#1050,#1000);
STEP
read_pmi inches.step >seen
expect_in seen <<'END'
0.787 in: 19.9898, 0 decimals
0.787 in with decimals: 0.7870, 0 decimals
0.787 in -0.002/+0.004: 19.9898, upper 0.0040, lower 0.0020, 0 decimals
0.785 to 0.791 in: 20.0152, between 19.9390 and 20.0914, 0 decimals
flatness 0.002 in: 0.0508
END
