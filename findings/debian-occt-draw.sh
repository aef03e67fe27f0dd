#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Debian 12's occt-draw 7.6.3 loads its commands by names that only the -dev package has (libTKTopTest.so): without libocct-draw-dev
# "pload MODELING" fails and no shape can be made. Believed: the package of a program holds or requires what the program loads.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages occt-draw=7.6.3+dfsg1-7
echo 'pload MODELING' >load.tcl
CSF_OCCTResourcePath=root/usr/share/opencascade CASROOT=root/usr/share/opencascade DRAWHOME=root/usr/share/opencascade/resources/DrawResources \
  timeout 120 occt-draw-7.6 -b -f load.tcl 2>&1 | grep -oE 'Could not open: [A-Za-z0-9.]+' >seen || true
expect_in seen <<'END'
Could not open: libTKTopTest.so
END
