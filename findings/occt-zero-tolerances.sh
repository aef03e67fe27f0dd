#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3: STEPCAFControl_Reader makes 0 of a tolerance whose magnitude is a measure and a representation item at once, as some
# programs write all their measures. It has the entity, its kind and its faces; nothing is said. ISO 10303-47 asks for a measure with unit,
# and such an item is one. Believed: 0.05 mm in each of these forms.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
step_with_pmi tolerances.step MM <<'STEP'
#1000=SHAPE_ASPECT('top','',#4,.T.);
#1001=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1000,#10,#331);
#1002=VALUE_FORMAT_TYPE_QUALIFIER('NR2 1.2');
#1010=MEASURE_WITH_UNIT(LENGTH_MEASURE(0.05),#346);
#1011=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.05),#346);
#1012=MEASURE_REPRESENTATION_ITEM('',LENGTH_MEASURE(0.05),#346);
#1013=(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(LENGTH_MEASURE(0.05),#346)REPRESENTATION_ITEM(''));
#1014=(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(LENGTH_MEASURE(0.05),#346)
QUALIFIED_REPRESENTATION_ITEM((#1002))REPRESENTATION_ITEM(''));
#1020=FLATNESS_TOLERANCE('measure','',#1010,#1000);
#1021=FLATNESS_TOLERANCE('length','',#1011,#1000);
#1022=FLATNESS_TOLERANCE('item','',#1012,#1000);
#1023=FLATNESS_TOLERANCE('length and item','',#1013,#1000);
#1024=FLATNESS_TOLERANCE('length and item with decimals','',#1014,#1000);
STEP
read_pmi tolerances.step >seen
expect_in seen <<'END'
measure: 0.0500
length: 0.0500
item: 0.0000
length and item: 0.0000
length and item with decimals: 0.0000
END
