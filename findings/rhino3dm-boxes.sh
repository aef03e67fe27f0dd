#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# rhino3dm 8.35.0 (openNURBS, by which scripts read Rhino's files) gives the box of the control points of what is round once it was turned: a circle
# of 20 mm, turned about its own axis by 30 degrees, which changes nothing, is 27.3 mm wide, a sphere or cylinder of 20 mm, turned about x by 45,
# 40 mm along x. Unturned ones are right, and so are lines. Nothing is said. Believed: "the world axis aligned bounding box
# for the geometry", from which views are arranged and stock is cut.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages rhino3dm@8.35.0
cat >boxes.js <<'JS'
require("rhino3dm")().then((rhino) => {
  const shapes = {
    "a circle of 20": () => new rhino.Circle(10).toNurbsCurve(),
    "a cylinder of 20 x 20 x 20": () => new rhino.Cylinder(new rhino.Circle(10), 20).toBrep(true, true),
    "an extruded cylinder": () => rhino.Extrusion.createCylinderExtrusion(new rhino.Cylinder(new rhino.Circle(10), 20), true, true),
    "a sphere of 20": () => rhino.Brep.createFromSphere(new rhino.Sphere([0, 0, 0], 10)),
    "a line of 20": () => new rhino.LineCurve([-10, 0, 0], [10, 0, 0]),
  };
  const turns = { "as made": null, "about z by 30": [30, [0, 0, 1]], "about x by 45": [45, [1, 0, 0]] };
  for (const [name, make] of Object.entries(shapes))
    for (const [how, turn] of Object.entries(turns)) {
      const shape = make();
      if (turn) shape.transform(rhino.Transform.rotation((turn[0] * Math.PI) / 180, turn[1], [0, 0, 0]));
      const { min, max } = shape.getBoundingBox();
      console.log(`${name}, ${how}: ${max.map((x, i) => (x - min[i]).toFixed(1)).join(" x ")}`);
    }
});
JS
node boxes.js >seen
expect_in seen <<'END'
a circle of 20, as made: 20.0 x 20.0 x 0.0
a circle of 20, about z by 30: 27.3 x 27.3 x 0.0
a circle of 20, about x by 45: 20.0 x 14.1 x 14.1
a cylinder of 20 x 20 x 20, as made: 20.0 x 20.0 x 20.0
a cylinder of 20 x 20 x 20, about z by 30: 27.3 x 27.3 x 20.0
a cylinder of 20 x 20 x 20, about x by 45: 40.0 x 28.3 x 28.3
an extruded cylinder, as made: 20.0 x 20.0 x 20.0
an extruded cylinder, about z by 30: 27.3 x 27.3 x 20.0
an extruded cylinder, about x by 45: 20.0 x 28.3 x 28.3
a sphere of 20, as made: 20.0 x 20.0 x 20.0
a sphere of 20, about z by 30: 27.3 x 27.3 x 20.0
a sphere of 20, about x by 45: 40.0 x 28.3 x 28.3
a line of 20, as made: 20.0 x 0.0 x 0.0
a line of 20, about z by 30: 17.3 x 10.0 x 0.0
a line of 20, about x by 45: 20.0 x 0.0 x 0.0
END
