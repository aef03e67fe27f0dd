#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3 reads of a STEP file that places a body by an operator with a scale (MAPPED_ITEM, CARTESIAN_TRANSFORMATION_OPERATOR_3D) the move and the
# turn and not the scale: twice the size of a box of 10 x 20 x 30 mm is the box. One whose third axis is reversed, a mirror, it turns by half a turn about
# the first, so that a left part comes as a right one. It says nothing, and the transfer is done. FreeCAD and gmsh read STEP by it. Moves and turns are right.
# Believed: corners moved as the operator has it (cartesian_transformation_operator_3d of ISO 10303-42), or the item refused.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
cat >part.cpp <<'CPP'
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <cstdio>
#include <string>

// write FILE: a box without the corner at its greatest x, y and z; read FILE WHAT: where it is.
int main(int, char** words) {
  if (std::string(words[1]) == "write") {
    STEPControl_Writer writer;
    writer.Transfer(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(6, 16, 26), 9, 9, 9).Shape()).Shape(), STEPControl_AsIs);
    return writer.Write(words[2]) != IFSelect_RetDone;
  }
  STEPControl_Reader reader;
  if (reader.ReadFile(words[2]) != IFSelect_RetDone || !reader.TransferRoots()) return 1;
  const TopoDS_Shape shape = reader.OneShape();
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  double b[6];
  box.Get(b[0], b[1], b[2], b[3], b[4], b[5]);
  GProp_GProps mass;
  BRepGProp::VolumeProperties(shape, mass);
  const gp_Pnt centre = mass.CentreOfMass();
  std::printf("%s: from %.0f %.0f %.0f to %.0f %.0f %.0f, %.0f mm3, centre of gravity %.2f %.2f %.2f\n", words[3], b[0] + 0.0, b[1] + 0.0, b[2] + 0.0, b[3] + 0.0, b[4] + 0.0,
              b[5] + 0.0, mass.Mass(), centre.X(), centre.Y(), centre.Z());
}
CPP
occt_program part.cpp TKSTEP TKXSBase TKBO TKPrim TKTopAlgo TKBRep TKGeomBase TKG3d TKMath TKernel
./part write part.step >/dev/null
place() {  # WHAT TARGET: the operator or placement #9003; #9011 to #9013 are the axes, #9014 and #9015 the reversed third and first one, #9010 the place
  local shape context frame
  shape=$(sed -n "s/.*SHAPE_DEFINITION_REPRESENTATION(#[0-9]*,#\([0-9]*\)).*/\1/p" part.step)
  context=$(tr -d '\n' <part.step | sed -n "s/.*#$shape = ADVANCED_BREP_SHAPE_REPRESENTATION('',([^)]*),#\([0-9]*\)).*/\1/p")
  frame=$(tr -d '\n' <part.step | sed -n "s/.*#$shape = ADVANCED_BREP_SHAPE_REPRESENTATION('',(#\([0-9]*\),.*/\1/p")
  { sed "s/\(SHAPE_DEFINITION_REPRESENTATION(#[0-9]*,\)#$shape/\1#9000/; \$d" part.step | sed '$d'
    echo "#9000 = SHAPE_REPRESENTATION('',(#9001),#$context);
#9001 = MAPPED_ITEM('',#9002,#9003);
#9002 = REPRESENTATION_MAP(#$frame,#$shape);
#9003 = $2;
#9010 = CARTESIAN_POINT('',(100.,0.,0.));
#9011 = DIRECTION('',(1.,0.,0.));
#9012 = DIRECTION('',(0.,1.,0.));
#9013 = DIRECTION('',(0.,0.,1.));
#9014 = DIRECTION('',(0.,0.,-1.));
#9015 = DIRECTION('',(-1.,0.,0.));
ENDSEC;
END-ISO-10303-21;"; } >placed.step
  ./part read placed.step "$1" | grep -a ' mm3'
}
operator() { echo "CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',$1,$2,#9010,$4,$3)"; }  # FIRST SECOND THIRD SCALE
{
  ./part read part.step "as it is" | grep -a ' mm3'
  place "placed by axes at x = 100" "AXIS2_PLACEMENT_3D('',#9010,#9013,#9011)"
  place "moved by an operator" "$(operator '#9011' '#9012' '#9013' 1.)"
  place "turned by an operator" "$(operator '#9012' '#9015' '#9013' 1.)"
  place "twice as large, which has 47488 mm3" "$(operator '#9011' '#9012' '#9013' 2.)"
  place "mirrored in z, which lies from 100 0 -30 to 110 20 0" "$(operator '#9011' '#9012' '#9014' 1.)"
} >seen
expect_in seen <<'END'
as it is: from 0 0 0 to 10 20 30, 5936 mm3, centre of gravity 4.97 9.91 14.86
placed by axes at x = 100: from 100 0 0 to 110 20 30, 5936 mm3, centre of gravity 104.97 9.91 14.86
moved by an operator: from 100 0 0 to 110 20 30, 5936 mm3, centre of gravity 104.97 9.91 14.86
turned by an operator: from 80 0 0 to 100 10 30, 5936 mm3, centre of gravity 90.09 4.97 14.86
twice as large, which has 47488 mm3: from 100 0 0 to 110 20 30, 5936 mm3, centre of gravity 104.97 9.91 14.86
mirrored in z, which lies from 100 0 -30 to 110 20 0: from 100 -20 -30 to 110 0 0, 5936 mm3, centre of gravity 104.97 -9.91 -14.86
END
