#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3: STEPCAFControl_Reader drops where the viewer of a saved view (CAMERA_MODEL_D3) stands. The projection point is in
# the axes of the camera, whose origin nothing gives, so that two cameras of central rays at 100 and at 500 are one; the distance of the
# view plane, which is all that is left of it, is the zoom factor. Lengths stay in inches where the shape is in millimetres. Believed:
# a place in the model, a zoom, one unit.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
camera() {  # NUMBER NAME X
  cat <<STEP
#$1=CAMERA_MODEL_D3('$2',#$(($1 + 1)),#$(($1 + 2)));
#$(($1 + 1))=AXIS2_PLACEMENT_3D('',#$(($1 + 3)),#$(($1 + 4)),#$(($1 + 5)));
#$(($1 + 2))=VIEW_VOLUME(.CENTRAL.,#$(($1 + 6)),90.,0.,.F.,0.,.F.,.F.,#$(($1 + 7)));
#$(($1 + 3))=CARTESIAN_POINT('',($3,15.,10.));
#$(($1 + 4))=DIRECTION('',(-1.,0.,0.));
#$(($1 + 5))=DIRECTION('',(0.,-1.,0.));
#$(($1 + 6))=CARTESIAN_POINT('',(0.,0.,0.));
#$(($1 + 7))=PLANAR_BOX('',4.,3.,#$(($1 + 1)));
STEP
}
{
  camera 1000 near 100.
  camera 1010 far 500.
  echo "#1020=(CHARACTERIZED_OBJECT(*,*)CHARACTERIZED_REPRESENTATION()DRAUGHTING_MODEL()REPRESENTATION('',(#1000,#1010),#345));"
} | step_with_pmi views.step INCH
cat >views.cpp <<'CPP'
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_View.hxx>
#include <XCAFDoc_ViewTool.hxx>
#include <XCAFView_Object.hxx>
#include <cstdio>

int main(int, char** words) {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  STEPCAFControl_Reader reader;
  reader.SetViewMode(true);
  if (reader.ReadFile(words[1]) != IFSelect_RetDone || !reader.Transfer(document)) return 1;
  TDF_LabelSequence views;
  XCAFDoc_DocumentTool::ViewTool(document->Main())->GetViewLabels(views);
  for (const TDF_Label& label : views) {
    Handle(XCAFDoc_View) found;
    label.FindAttribute(XCAFDoc_View::GetID(), found);
    const Handle(XCAFView_Object) view = found->GetObject();
    const gp_Pnt point = view->ProjectionPoint();
    std::printf("%s: point %g %g %g, zoom %g, window %g x %g\n", view->Name()->ToCString(), point.X(), point.Y(),
                point.Z(), view->ZoomFactor(), view->WindowHorizontalSize(), view->WindowVerticalSize());
  }
}
CPP
occt_program views.cpp TKXDESTEP TKXCAF TKSTEP TKXSBase TKLCAF TKCAF TKCDF TKBRep TKMath TKernel
./views views.step | grep -a ': point' >seen
expect_in seen <<'END'
near: point 0 0 0, zoom 90, window 4 x 3
far: point 0 0 0, zoom 90, window 4 x 3
END
