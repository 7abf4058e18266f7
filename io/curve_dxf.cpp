// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as DXF: the polyline for R12, which every CAD reads; the spline for R2000, the first
// version that has splines and is read widely.
#include "bspline_curve/spline.h"
#include "io/curve_formats.h"
#include "io/dxf_text.h"

#include <Eigen/Geometry>

namespace bspline_curve {

namespace {

Eigen::AlignedBox3d boxOf(std::span<const CurveContent> contents) {
    Eigen::AlignedBox3d box;
    for (const CurveContent& content : contents) {
        for (const Vec3& p : content.curve.polyline.points) {
            box.extend(p);
        }
    }
    return box;
}

/// The variables of the header that say where the drawing is.
void addExtent(DxfText& dxf, const Eigen::AlignedBox3d& box) {
    if (box.isEmpty()) {
        return;
    }
    dxf.add(9, "$EXTMIN");
    dxf.add(10, Vec3(box.min()));
    dxf.add(9, "$EXTMAX");
    dxf.add(10, Vec3(box.max()));
}

// The handles are fixed: only the entities are ours.
constexpr const char* kTablesOfR2000 = R"(0 SECTION
2 CLASSES
0 ENDSEC
0 SECTION
2 TABLES
0 TABLE
2 VPORT
5 1
330 0
100 AcDbSymbolTable
70 0
0 ENDTAB
0 TABLE
2 LTYPE
5 2
330 0
100 AcDbSymbolTable
70 3
0 LTYPE
5 10
330 2
100 AcDbSymbolTableRecord
100 AcDbLinetypeTableRecord
2 ByBlock
70 0
3
72 65
73 0
40 0.0
0 LTYPE
5 11
330 2
100 AcDbSymbolTableRecord
100 AcDbLinetypeTableRecord
2 ByLayer
70 0
3
72 65
73 0
40 0.0
0 LTYPE
5 12
330 2
100 AcDbSymbolTableRecord
100 AcDbLinetypeTableRecord
2 Continuous
70 0
3 Solid line
72 65
73 0
40 0.0
0 ENDTAB
0 TABLE
2 LAYER
5 3
330 0
100 AcDbSymbolTable
70 2
0 LAYER
5 13
330 3
100 AcDbSymbolTableRecord
100 AcDbLayerTableRecord
2 0
70 0
62 7
6 Continuous
370 -3
390 1F
0 LAYER
5 14
330 3
100 AcDbSymbolTableRecord
100 AcDbLayerTableRecord
2 SPLINE
70 0
62 1
6 Continuous
370 -3
390 1F
0 ENDTAB
0 TABLE
2 STYLE
5 4
330 0
100 AcDbSymbolTable
70 1
0 STYLE
5 15
330 4
100 AcDbSymbolTableRecord
100 AcDbTextStyleTableRecord
2 Standard
70 0
40 0.0
41 1.0
50 0.0
71 0
42 2.5
3 txt
4
0 ENDTAB
0 TABLE
2 VIEW
5 5
330 0
100 AcDbSymbolTable
70 0
0 ENDTAB
0 TABLE
2 UCS
5 6
330 0
100 AcDbSymbolTable
70 0
0 ENDTAB
0 TABLE
2 APPID
5 7
330 0
100 AcDbSymbolTable
70 1
0 APPID
5 16
330 7
100 AcDbSymbolTableRecord
100 AcDbRegAppTableRecord
2 ACAD
70 0
0 ENDTAB
0 TABLE
2 DIMSTYLE
5 8
330 0
100 AcDbSymbolTable
70 1
100 AcDbDimStyleTable
71 1
0 DIMSTYLE
105 17
330 8
100 AcDbSymbolTableRecord
100 AcDbDimStyleTableRecord
2 Standard
70 0
340 15
0 ENDTAB
0 TABLE
2 BLOCK_RECORD
5 9
330 0
100 AcDbSymbolTable
70 2
0 BLOCK_RECORD
5 18
330 9
100 AcDbSymbolTableRecord
100 AcDbBlockTableRecord
2 *Model_Space
340 0
0 BLOCK_RECORD
5 19
330 9
100 AcDbSymbolTableRecord
100 AcDbBlockTableRecord
2 *Paper_Space
340 0
0 ENDTAB
0 ENDSEC
0 SECTION
2 BLOCKS
0 BLOCK
5 1A
330 18
100 AcDbEntity
8 0
100 AcDbBlockBegin
2 *Model_Space
70 0
10 0.0
20 0.0
30 0.0
3 *Model_Space
1
0 ENDBLK
5 1B
330 18
100 AcDbEntity
8 0
100 AcDbBlockEnd
0 BLOCK
5 1C
330 19
100 AcDbEntity
67 1
8 0
100 AcDbBlockBegin
2 *Paper_Space
70 0
10 0.0
20 0.0
30 0.0
3 *Paper_Space
1
0 ENDBLK
5 1D
330 19
100 AcDbEntity
67 1
8 0
100 AcDbBlockEnd
0 ENDSEC
)";

constexpr const char* kObjectsOfR2000 = R"(0 SECTION
2 OBJECTS
0 DICTIONARY
5 A
330 0
100 AcDbDictionary
281 1
3 ACAD_GROUP
350 B
3 ACAD_PLOTSTYLENAME
350 1E
0 DICTIONARY
5 B
330 A
100 AcDbDictionary
281 1
0 ACDBDICTIONARYWDFLT
5 1E
330 A
100 AcDbDictionary
281 1
3 Normal
350 1F
100 AcDbDictionaryWithDefault
340 1F
0 ACDBPLACEHOLDER
5 1F
330 1E
0 ENDSEC
0 EOF
)";

}  // namespace

namespace {

void addPolyline(DxfText& dxf, const SurfacePolyline& polyline) {
    constexpr int kClosed = 1;
    constexpr int kPolyline3d = 8;
    constexpr int kVertex3d = 32;
    dxf.addPairs("0 POLYLINE\n8 POLYLINE\n66 1\n10 0.0\n20 0.0\n30 0.0\n");
    dxf.add(70, kPolyline3d + (polyline.closed ? kClosed : 0));
    for (const Vec3& p : polyline.points) {
        dxf.addPairs("0 VERTEX\n8 POLYLINE\n");
        dxf.add(10, p);
        dxf.add(70, kVertex3d);
    }
    dxf.addPairs("0 SEQEND\n8 POLYLINE\n");
}

}  // namespace

std::string curveDxf(std::span<const CurveContent> contents) {
    DxfText dxf;
    dxf.addPairs("0 SECTION\n2 HEADER\n9 $ACADVER\n1 AC1009\n");
    addExtent(dxf, boxOf(contents));
    dxf.addPairs(
        "0 ENDSEC\n0 SECTION\n2 TABLES\n0 TABLE\n2 LTYPE\n70 1\n0 LTYPE\n2 CONTINUOUS\n70 0\n"
        "3 Solid line\n72 65\n73 0\n40 0.0\n0 ENDTAB\n0 TABLE\n2 LAYER\n70 1\n0 LAYER\n"
        "2 POLYLINE\n70 0\n62 7\n6 CONTINUOUS\n0 ENDTAB\n0 ENDSEC\n0 SECTION\n2 ENTITIES\n"
    );
    for (const CurveContent& content : contents) {
        addPolyline(dxf, content.curve.polyline);
    }
    dxf.addPairs("0 ENDSEC\n0 EOF\n");
    return dxf.text();
}

std::string splineDxf(const CurveContent& content) {
    constexpr int kClosed = 1;
    constexpr double kSameKnot = 1e-9;
    const SplineData spline = clamped(content.curve.spline);
    DxfText dxf;
    dxf.addPairs("0 SECTION\n2 HEADER\n9 $ACADVER\n1 AC1015\n9 $HANDSEED\n5 100\n");
    addExtent(dxf, boxOf({&content, 1}));
    dxf.addPairs("0 ENDSEC\n");
    dxf.addPairs(kTablesOfR2000);
    dxf.addPairs(
        "0 SECTION\n2 ENTITIES\n0 SPLINE\n5 20\n330 18\n100 AcDbEntity\n8 SPLINE\n100 AcDbSpline\n"
    );
    dxf.add(70, spline.closed ? kClosed : 0);
    dxf.add(71, spline.degree);
    dxf.add(72, static_cast<int>(spline.knots.size()));
    dxf.add(73, static_cast<int>(spline.controlPoints.size()));
    dxf.add(74, 0);
    dxf.add(42, kSameKnot);
    for (const double knot : spline.knots) {
        dxf.add(40, knot);
    }
    for (const Vec3& p : spline.controlPoints) {
        dxf.add(10, p);
    }
    dxf.addPairs("0 ENDSEC\n");
    dxf.addPairs(kObjectsOfR2000);
    return dxf.text();
}

}  // namespace bspline_curve
