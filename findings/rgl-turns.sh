#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# rgl 1.0.1 (3D models in R) turns clockwise as seen from the tip of the axis: rotate3d by 90 degrees about z carries a part from x to -y, where CAD, glTF
# and X3D have it on y. Its rotationMatrix is the usual one, and is applied to rows. What was mirrored (scale3d) is inside out. Nothing is
# said; the help names an angle about an axis, not a side. Moves and even scales are right. Believed: by the right-hand rule.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages r-base-core=4.2.2.20221110-2 r-cran-rgl=1.0.1-1
cat >turn.R <<'R'
options(rgl.useNULL = TRUE)
library(rgl)
corners <- rbind(c(0, 0, 0), c(10, 0, 0), c(0, 20, 0), c(0, 0, 30))
facets <- rbind(c(1, 3, 2), c(1, 2, 4), c(2, 3, 4), c(1, 4, 3))
part <- tmesh3d(t(corners), t(facets), homogeneous = FALSE)
tell <- function(name, mesh, right) {
  at <- function(i) mesh$vb[1:3, i] / mesh$vb[4, i]
  volume <- sum(apply(mesh$it, 2, function(i) det(cbind(at(i[1]), at(i[2]), at(i[3])))) / 6)
  cat(sprintf("%s: its corner of 10 0 0 at %s, right would be %s, volume %.0f\n", name, paste(round(at(2), 3) + 0, collapse = " "), right, volume))
}
tell("moved by 1 2 3", translate3d(part, 1, 2, 3), "11 2 3")
tell("turned by 90 degrees about z", rotate3d(part, pi / 2, 0, 0, 1), "0 10 0")
tell("turned by 90 degrees about y", rotate3d(part, pi / 2, 0, 1, 0), "0 0 -10")
tell("twice as large", scale3d(part, 2, 2, 2), "20 0 0")
tell("mirrored along x", scale3d(part, -1, 1, 1), "-10 0 0")
R
EDITOR=vi PAGER=cat R_HOME=$work/root/usr/lib/R R_SHARE_DIR=$work/root/usr/share/R/share R_LIBS=$work/root/usr/lib/R/site-library \
  LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$work/root/usr/lib/R/lib root/usr/lib/R/bin/exec/R --no-echo --no-restore --vanilla --file=turn.R >output 2>messages || { tail -n 3 messages; exit 1; }
grep right output >seen
expect_in seen <<'END'
moved by 1 2 3: its corner of 10 0 0 at 11 2 3, right would be 11 2 3, volume 1000
turned by 90 degrees about z: its corner of 10 0 0 at 0 -10 0, right would be 0 10 0, volume 1000
turned by 90 degrees about y: its corner of 10 0 0 at 0 0 10, right would be 0 0 -10, volume 1000
twice as large: its corner of 10 0 0 at 20 0 0, right would be 20 0 0, volume 8000
mirrored along x: its corner of 10 0 0 at -10 0 0, right would be -10 0 0, volume -1000
END
