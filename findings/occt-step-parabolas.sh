#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3 takes the parameters by which a STEP file trims a parabola for lengths across its axis, which they are not: one of focal distance 5 from
# parameter 0 to 2 goes to (20, 20), and is read as ending at (0.2, 2). It writes its own as wrongly: the same arc to (20, 20) is trimmed at 20, which is (2000, 200) to
# others. Nothing is said. Parabolas trimmed by points, circles, ellipses and hyperbolas are right, and so are bodies, whose edges have corners.
# Believed: F (u2 x + 2 u y) (ISO 10303-42, parabola).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
cat >curve.cpp <<'CPP'
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Parab.hxx>
#include <cstdio>
#include <string>

// write FILE: a parabola of focal distance 5 from its vertex to (20, 20); read FILE: where its curve ends.
int main(int, char** words) {
  if (std::string(words[1]) == "write") {
    STEPControl_Writer writer;
    writer.Transfer(BRepBuilderAPI_MakeEdge(gp_Parab(gp_Ax2(), 5), 0, 20).Shape(), STEPControl_GeometricCurveSet);
    return writer.Write(words[2]) != IFSelect_RetDone;
  }
  STEPControl_Reader reader;
  if (reader.ReadFile(words[2]) != IFSelect_RetDone || !reader.TransferRoots()) return 1;
  const TopoDS_Shape shape = reader.OneShape();
  TopExp_Explorer at(shape, TopAbs_EDGE);
  double first, last;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(at.Current()), first, last);
  const gp_Pnt from = curve->Value(first), to = curve->Value(last);
  std::printf("from (%.1f, %.1f) to (%.1f, %.1f) mm\n", from.X() + 0.0, from.Y() + 0.0, to.X() + 0.0, to.Y() + 0.0);
}
CPP
occt_program curve.cpp TKSTEP TKXSBase TKPrim TKTopAlgo TKBRep TKGeomBase TKG3d TKMath TKernel
curve() {  # WHAT ENTITY TRIMS
  echo "ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','2026-11-30T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1 = APPLICATION_CONTEXT('automotive design');
#2 = APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);
#3 = PRODUCT_CONTEXT('',#1,'mechanical');
#4 = PRODUCT('curve','curve','',(#3));
#5 = PRODUCT_DEFINITION_FORMATION('','',#4);
#6 = PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#7 = PRODUCT_DEFINITION('design','',#5,#6);
#8 = PRODUCT_DEFINITION_SHAPE('','',#7);
#9 = SHAPE_DEFINITION_REPRESENTATION(#8,#10);
#10 = GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#11,#15),#20);
#11 = AXIS2_PLACEMENT_3D('',#12,#13,#14);
#12 = CARTESIAN_POINT('',(0.,0.,0.));
#13 = DIRECTION('',(0.,0.,1.));
#14 = DIRECTION('',(1.,0.,0.));
#15 = GEOMETRIC_CURVE_SET('',(#16));
#16 = TRIMMED_CURVE('',#17,$3);
#17 = $2;
#18 = CARTESIAN_POINT('',(20.,20.,0.));
#20 = ( GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#24)) GLOBAL_UNIT_ASSIGNED_CONTEXT((#21,#22,#23)) REPRESENTATION_CONTEXT('','3D') );
#21 = ( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) );
#22 = ( NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT(\$,.RADIAN.) );
#23 = ( NAMED_UNIT(*) SI_UNIT(\$,.STERADIAN.) SOLID_ANGLE_UNIT() );
#24 = UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#21,'distance_accuracy_value','');
ENDSEC;
END-ISO-10303-21;" >curve.step
  echo "$1: $(./curve read curve.step | grep -a ' mm')"
}
by() { echo "(PARAMETER_VALUE($1)),(PARAMETER_VALUE($2)),.T.,.PARAMETER."; }
{
  curve "quarter of a circle of 10, which ends at (0, 10)" "CIRCLE('',#11,10.)" "$(by 0. 1.5707963267948966)"
  curve "quarter of an ellipse of 10 and 5, which ends at (0, 5)" "ELLIPSE('',#11,10.,5.)" "$(by 0. 1.5707963267948966)"
  curve "hyperbola of 10 and 5 to parameter 1, which ends at (15.4, 5.9)" "HYPERBOLA('',#11,10.,5.)" "$(by 0. 1.)"
  curve "parabola trimmed by points, which ends at (20, 20)" "PARABOLA('',#11,5.)" "(#12),(#18),.T.,.CARTESIAN."
  curve "parabola to parameter 1, which ends at (5, 10)" "PARABOLA('',#11,5.)" "$(by 0. 1.)"
  curve "parabola to parameter 2, which ends at (20, 20)" "PARABOLA('',#11,5.)" "$(by 0. 2.)"
  ./curve write written.step >/dev/null
  echo "written parabola to (20, 20), which is to parameter 2: $(tr -d ' \n' <written.step | grep -o 'PARAMETER_VALUE([^)]*)' | tail -n 1)"
} >seen
expect_in seen <<'END'
quarter of a circle of 10, which ends at (0, 10): from (10.0, 0.0) to (0.0, 10.0) mm
quarter of an ellipse of 10 and 5, which ends at (0, 5): from (10.0, 0.0) to (0.0, 5.0) mm
hyperbola of 10 and 5 to parameter 1, which ends at (15.4, 5.9): from (10.0, 0.0) to (15.4, 5.9) mm
parabola trimmed by points, which ends at (20, 20): from (0.0, 0.0) to (20.0, 20.0) mm
parabola to parameter 1, which ends at (5, 10): from (0.0, 0.0) to (0.1, 1.0) mm
parabola to parameter 2, which ends at (20, 20): from (0.0, 0.0) to (0.2, 2.0) mm
written parabola to (20, 20), which is to parameter 2: PARAMETER_VALUE(20.)
END
