// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/curve_options.h"
#include "bspline_curve/lines.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/mesh_checksum.h"
#include "bspline_curve/parts.h"
#include "bspline_curve/pattern.h"
#include "bspline_curve/workpiece.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Files in and out. Formats are known by the ends of names, in either case. All functions may be
// called from several threads at once. docs/FILES.md tells what the formats hold.
namespace bspline_curve {

/// The type of a number in a PLY file; None: there is none.
enum class PlyScalar : std::uint8_t {
    None,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Float,
    Double
};

/// One number for each vertex or face, as a PLY file names it.
struct MeshChannel {
    std::string name;
    PlyScalar type = PlyScalar::Float;
    std::vector<double> values;
};

/// What a mesh file holds beside vertices, faces and quality: colours, normals, textures, groups.
struct MeshExtras {
    /// Of vertices: red, green, blue, nx, ny, nz, s, t, and all others that the file has.
    std::vector<MeshChannel> vertices;
    std::vector<MeshChannel> faces;  ///< per face, as the mesh has them, in triangles
    /// Texture coordinates u, v and normals of the corners of each face; empty: there are none.
    std::vector<std::array<Eigen::Vector2d, 3>> cornerTexture;
    std::vector<std::array<Vec3, 3>> cornerNormals;
    std::vector<std::string> textures;   ///< names of files
    std::vector<std::string> libraries;  ///< of materials: what follows mtllib in OBJ
    /// Lines of OBJ that stand before faces (o, g, s, usemtl), and for each face which of these,
    /// -1: none. Empty: there are none.
    std::vector<std::string> headings;
    std::vector<int> headingOf;

    [[nodiscard]] bool empty() const {
        return vertices.empty() && faces.empty() && cornerTexture.empty() &&
               cornerNormals.empty() && libraries.empty() && headings.empty();
    }

    /// What there is, in words: "colours, texture coordinates".
    [[nodiscard]] std::string words() const;
};

/// Those of a .ply or .obj file that readMeshFile() has read; none of other formats. Throws
/// InputError (UnreadableFile). O(n).
[[nodiscard]] MeshExtras readMeshExtras(const std::filesystem::path& file);

/// The extras of a mesh that was made of another, whose faces are `parents`: numbers of vertices
/// and corners are linear in the face that they are in, those of types of whole numbers but colours
/// as at the nearest corner; normals have the length 1. A vertex that fills a hole has the mean of
/// its rim, a face that does 0, and the heading of none. O(n).
[[nodiscard]] MeshExtras carriedExtras(
    const MeshExtras& extras, const MadeMesh& made, const std::vector<Triangle>& parents
);

/// A mesh of a file.
struct MeshFile {
    TriangleMesh mesh;
    std::vector<double> quality;  ///< one value per vertex, or empty where the file has none
};

/// What to do with faces that name a vertex twice.
enum class RepeatedVertices : std::uint8_t { Refuse, Keep };

/// A mesh with its per-vertex quality (PLY only): .ply, .obj, .off and .stl.
/// Coordinates keep the precision of the file; vertices and faces keep its order. Polygons are cut
/// into triangles: fans at their first corner, or, where a fan folds, triangulations of least area.
/// Strips of triangles are read where a PLY file has no faces. The vertices of an STL file that
/// have equal coordinates are made one, in order of first use. Only what the file says is checked,
/// not whether it is a surface. Throws InputError (UnreadableFile, or DegenerateFace where a face
/// of a PLY or OBJ file names a vertex twice and is not to be kept), naming file and reason.
[[nodiscard]] MeshFile readMeshFile(
    const std::filesystem::path& file, RepeatedVertices repeated = RepeatedVertices::Refuse
);

/// The same without quality.
[[nodiscard]] TriangleMesh readMesh(const std::filesystem::path& file);

/// What a mesh file holds beside vertices and faces; empty: nothing of that.
struct MeshAttributes {
    std::span<const double> vertexQuality{};  ///< `quality` of vertices
    /// `label` (int) of faces, and the same as their `quality` (double), which MeshLab shows and
    /// selects by.
    std::span<const int> faceLabels{};
    std::span<const std::array<std::uint8_t, 3>> faceColours{};
    const MeshExtras* extras = nullptr;  ///< of this mesh; what is above goes before it
};

/// The file name extensions that meshBytes() knows, for messages: ".ply, .obj, .off or .stl".
[[nodiscard]] std::string meshExtensions();

/// Throws InputError (UnwritableFile) where a mesh cannot be written under this name.
void checkMeshExtension(const std::filesystem::path& file);

/// What of extras a file of that name cannot hold, in words: "colours, normals"; empty: nothing.
[[nodiscard]] std::string lostExtras(const std::filesystem::path& file, const MeshExtras& extras);

/// How far a file of that name moves a vertex at most: .stl holds floats.
[[nodiscard]] double largestMoveIn(const std::filesystem::path& file, const TriangleMesh& mesh);

/// The bytes of a mesh file: .ply (binary, little-endian, doubles, with all attributes but headings
/// and libraries of materials), .obj (text, shortest decimals that read back as the same doubles,
/// with colours, normals, texture coordinates, groups and materials), .off (likewise, without
/// attributes) or .stl (binary, floats, without attributes). Throws InputError (UnwritableFile) for
/// other extensions.
[[nodiscard]] std::string meshBytes(
    const std::filesystem::path& file,
    const TriangleMesh& mesh,
    const MeshAttributes& attributes = {}
);

/// Writes meshBytes() to the file: wholly, or not at all. Throws InputError (UnwritableFile).
void writeMesh(
    const std::filesystem::path& file,
    const TriangleMesh& mesh,
    const MeshAttributes& attributes = {}
);

/// The unit of a mesh, which formats of CAD have to name.
enum class LengthUnit : std::uint8_t { Millimetre, Centimetre, Metre, Micrometre, Inch, Foot };

inline constexpr std::array<LengthUnit, 6> kLengthUnits{
    LengthUnit::Millimetre,
    LengthUnit::Centimetre,
    LengthUnit::Metre,
    LengthUnit::Micrometre,
    LengthUnit::Inch,
    LengthUnit::Foot
};

/// As users write it: "mm".
[[nodiscard]] std::string_view name(LengthUnit unit);

/// The unit of such a word; none: there is no such unit.
[[nodiscard]] std::optional<LengthUnit> lengthUnitOf(std::string_view word);

/// The ends of names of curve files, for help and messages: ".ply, .obj, …".
[[nodiscard]] std::string curveExtensions();

/// Throws InputError (UnwritableFile) where writeCurve knows no format for the file's name.
void checkCurveExtension(const std::filesystem::path& file);

/// The bytes of a curve file; the format by the end of the name of `file`, in either case:
///   .ply          the polyline, binary, little-endian; vertex: x y z quality t (double), face
///                 (int), barycentric_0..2 (double), is_pick (uchar, 1 where a pick is); edge:
///                 vertex1 vertex2 (int), in order along the curve
///   .obj          the polyline: v, and one l per segment (MeshLab's importer reads two indices
///                 per l)
///   .bspline.obj  the spline: v, cstype bspline, deg, curv, parm u, end; the first `degree`
///                 control points of a closed one are named again at its end
///   .dxf          the polyline: a 3D POLYLINE of R12, closed where the curve is
///   .bspline.dxf  the spline: a SPLINE of R2000; a closed one with clamped knots
///   .vtu          the polyline, VTK XML, base64: lines; points: quality t barycentric (double),
///                 face (int), is_pick (uchar)
///   .csv          the polyline: x,y,z,t,face,b0,b1,b2,quality,is_pick, one line per vertex
///   .step .stp    the spline: B_SPLINE_CURVE_WITH_KNOTS of AP214 in `unit`; a closed one with
///                 clamped knots; .polyline.step: a POLYLINE, closed by its first point once more
///   .iges .igs    likewise as IGES 5.3: entity 126, or 106 of form 12
///   .json         {"closed", "polyline": {"points", "faces", "barycentrics", "t", "picks"},
///                 "spline": {"degree", "closed", "knots", "control_points", "pick_parameters"}};
///                 "quality" in "polyline" where there is a field, and {"mesh": {"vertices",
///                 "faces", "crc32"}} where the mesh is given
/// Numbers are written without loss. `field`: one value per polyline vertex, or empty; quality is
/// the field or, without one, t. `mesh`: the one that the curve's faces are of. Throws InputError
/// (UnwritableFile).
[[nodiscard]] std::string curveBytes(
    const std::filesystem::path& file,
    const Curve& curve,
    std::span<const double> field = {},
    const std::optional<MeshChecksum>& mesh = {},
    LengthUnit unit = LengthUnit::Millimetre
);

/// The ends of names of files that hold several curves.
[[nodiscard]] std::string manyCurvesExtensions();

/// Throws InputError (UnwritableFile) where the file's name is none of a format for several curves.
void checkManyCurvesExtension(const std::filesystem::path& file);

/// Several curves of one mesh in one file: the polylines of .ply, .obj and .dxf, and those of .step
/// and .iges, one after the other; .json {"curves": [{"closed", "polyline", "spline"}, …], "mesh"}.
/// Throws InputError (UnwritableFile).
[[nodiscard]] std::string curvesBytes(
    const std::filesystem::path& file,
    std::span<const Curve* const> curves,
    const std::optional<MeshChecksum>& mesh = {},
    LengthUnit unit = LengthUnit::Millimetre
);

/// Writes curveBytes() to the file: wholly, or not at all. Throws InputError (UnwritableFile).
void writeCurve(
    const std::filesystem::path& file,
    const Curve& curve,
    std::span<const double> field = {},
    const std::optional<MeshChecksum>& mesh = {},
    LengthUnit unit = LengthUnit::Millimetre
);

/// The same of curvesBytes().
void writeCurves(
    const std::filesystem::path& file,
    std::span<const Curve* const> curves,
    const std::optional<MeshChecksum>& mesh = {},
    LengthUnit unit = LengthUnit::Millimetre
);

/// Writes any bytes to a file: wholly, or not at all. Throws InputError (UnwritableFile).
void writeBytes(const std::filesystem::path& file, std::string_view bytes);

/// Curves of a file on a mesh.
struct CurvesOfFile {
    std::vector<SurfacePolyline> lines;
    std::vector<std::optional<SplineData>> splines;  ///< of each line, where the file has it
    std::vector<std::string> notes;                  ///< what of the file was left out, jumps
};

/// How curves of files come onto a mesh.
struct CurveReading {
    /// Of those that are projected, see ProjectionOptions.
    ProjectionOptions projection{};
    std::vector<std::string> layers{};  ///< of a DXF, those to read; empty: all that are visible
    /// What the error of polylines that are too far away advises.
    const char* remedy = "allow a larger distance";
};

/// Reads curves of files onto a mesh, all with one tree of its faces. Those of .json are read
/// exactly where they were drawn, by their faces and barycentric coordinates, and so are polylines
/// of .ply, .csv and .vtu whose places are on this mesh; all others are projected, see
/// readPolylines() and projectedLines(); a note tells where they jump, and where they are beside
/// the mesh. O(n log n). Throws InputError (UnreadableFile; NoPath: a curve of another mesh;
/// PickTooFar; BadOption) naming the file.
class CurveFileReader {
public:
    /// The workpiece must outlive this.
    explicit CurveFileReader(const Workpiece& workpiece, CurveReading reading = {});
    ~CurveFileReader();
    CurveFileReader(CurveFileReader&&) noexcept;
    CurveFileReader& operator=(CurveFileReader&&) noexcept;

    [[nodiscard]] CurvesOfFile read(const std::filesystem::path& file);
    /// The same of a file with one curve; refuses another number.
    [[nodiscard]] SurfacePolyline readOne(const std::filesystem::path& file);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The curves of one file.
[[nodiscard]] CurvesOfFile readCurvesOn(
    const Workpiece& workpiece, const std::filesystem::path& file, const CurveReading& reading = {}
);

/// Picked points.
struct PicksFile {
    std::vector<Vec3> picks;     ///< finite, in the order of the file
    std::optional<bool> closed;  ///< what the file says about it, if it can
    std::vector<int> corners{};  ///< indices of picks
    PickDirections tangents{};
    PickTolerances tolerances{};
};

/// The ends of names of files of picks, for help and messages.
inline constexpr std::string_view kPicksExtensions =
    ".pp, .json, .mrk.json, .fcsv, .csv, .xyz, .txt, .asc";

/// Picked points by extension:
///   .pp        MeshLab's PickPoints (points that are not active are left out)
///   .json      {"picks": [[x, y, z], …], "closed": true or false, "corners": [0, …], "tangents":
///              [{"pick": 0, "direction": [x, y, z]}, …], "tolerances": [0.4, 0, "1 edge",
///              "weight 100", …]}: picks by index that are corners, and that have a direction, and
///              for each pick how far from it the curve may pass; other keys are left alone
///   .mrk.json  (or .json) the markups of 3D Slicer: the placed control points of the one Fiducial,
///              Curve, ClosedCurve or Line that has any, in LPS; curves and lines say whether they
///              are closed
///   .fcsv      a list of 3D Slicer, in LPS
///   .xyz       (or .txt, .asc) x y z per line with blanks, commas or semicolons between them, more
///              columns are left alone; # and // start comments
///   .csv       commas, semicolons or tabs; a first line of names chooses the columns x, y, z, also
///              as "x [mm]" and "Points:0"; without one, a text in the first column is a label;
///              with semicolons decimal commas may be used
/// Throws InputError (UnreadableFile) naming file, line (where there are lines) and reason.
[[nodiscard]] PicksFile readPicks(const std::filesystem::path& file);

/// "x y z; x y z; …", also with line ends for semicolons and with commas between coordinates. Empty
/// text: no picks. Throws InputError (UnreadableFile) naming the pick, from 0, and what is wrong
/// with it.
[[nodiscard]] std::vector<Vec3> parsePicksText(std::string_view text);

/// Polylines of a file.
struct PolylineFile {
    std::vector<SpacePolyline> lines;
    /// For each line where its points are on the mesh that the file is of, as the file says; empty:
    /// it does not say so.
    std::vector<std::vector<SurfacePoint>> places;
    std::vector<std::string> notes;  ///< what of the file was left out
};

/// The curves of a file as polylines, in its order: .ply (elements vertex and edge), .obj
/// (statements l, and curv of B-splines), .dxf (all that drawings are read from, in space), .vtu
/// (lines) or .csv (points in order). Edges that share a vertex are chained, and chains cut where
/// more than two meet. At least one. `layers`: of a DXF, those to read; empty: all that are
/// visible. Throws InputError (UnreadableFile) naming file and place: another format, a damaged
/// file, one without edges, a point that is not finite.
[[nodiscard]] PolylineFile readPolylines(
    const std::filesystem::path& file, const std::vector<std::string>& layers = {}
);

/// A planar drawing of a file.
struct DrawingFile {
    Drawing drawing;                 ///< y upwards
    std::vector<std::string> notes;  ///< what of the file was left out
};

/// Reads the paths of a planar drawing: .svg (all shapes and path commands, groups, transforms,
/// viewBox, use; text and images are left out) or .dxf (lines, polylines, arcs, ellipses, splines
/// and inserted blocks, seen along z; curves whose ends meet are one path). The unit is that of the
/// file; of an SVG whose width has a physical unit, millimetres. What cannot be drawn is left out;
/// notes count it. `layers`: of a DXF, those to read; empty: all that are visible. Throws
/// InputError (UnreadableFile) naming file, line and what is wrong where there is no path at all.
[[nodiscard]] DrawingFile readDrawing(
    const std::filesystem::path& file, const std::vector<std::string>& layers = {}
);

/// An element of an XML document, as a parser has read it.
struct XmlElement {
    std::string name;  ///< without its prefix
    std::vector<std::pair<std::string, std::string>> attributes;
    std::vector<XmlElement> children;
    std::string text;      ///< before its first child
    std::size_t line = 0;  ///< of the file, from 1

    /// The value of an attribute; empty where there is none.
    [[nodiscard]] std::string_view attribute(std::string_view key) const {
        for (const auto& [own, value] : attributes) {
            if (own == key) {
                return value;
            }
        }
        return {};
    }
};

/// The drawing of an SVG document whose root element this is, as readDrawing() has it; `file` is
/// for messages. For programs that parse XML themselves. It may have no path. Throws likewise.
[[nodiscard]] DrawingFile drawingOfSvg(const std::filesystem::path& file, const XmlElement& root);

/// The same of the bytes of a DXF.
[[nodiscard]] DrawingFile drawingOfDxf(
    const std::filesystem::path& file,
    std::string_view bytes,
    const std::vector<std::string>& layers = {}
);

/// The drawing of path data as SVG has them ("M 0 0 L 1 1 …", y downwards), y upwards. Throws
/// InputError (BadOption) saying what is wrong at which character.
[[nodiscard]] Drawing drawingOfSvgPath(std::string_view data);

/// The outlines of a line of text, in UTF-8, in the letters of a font file (TrueType, OpenType,
/// Type 1): one unit is the font's em, and the letters stand on y = 0, the baseline. Kerning is
/// that of the font's table `kern`. Throws InputError (UnreadableFile: no font with outlines, no
/// glyph for a character; BadOption: no UTF-8, nothing but blanks, or this library was built
/// without FreeType).
[[nodiscard]] Drawing textOutlines(std::string_view text, const std::filesystem::path& font);

/// One value per vertex, in the order of the mesh's vertices: from a .npy file (float32 or float64,
/// little-endian, one dimension), or from any other file as a text of numbers between blanks, with
/// # for comments. Throws InputError: UnreadableFile (missing, not numbers, other kinds of array),
/// BadField (other than `vertexCount` values, or values that are not finite, with the ids of their
/// vertices).
[[nodiscard]] std::vector<double> readField(
    const std::filesystem::path& file, std::size_t vertexCount
);

/// Throws InputError (UnwritableFile) where fieldBytes knows no format for the extension.
void checkFieldExtension(const std::filesystem::path& file);

/// The bytes of a file with one value per vertex, in the order of the mesh's vertices, all of them
/// without loss; the format by the extension of `file`:
///   .ply   the mesh, binary, little-endian; vertex: x y z quality (double); face: vertex_indices
///   .npy   float64, little-endian, one dimension
///   .txt   one number a line
/// readField reads the last two. Throws InputError (UnwritableFile).
[[nodiscard]] std::string fieldBytes(
    const std::filesystem::path& file, const TriangleMesh& mesh, std::span<const double> field
);

/// Ids of faces, in the order of the file and not checked against a mesh: from a .npy file
/// (integers of 32 or 64 bits, little-endian, one dimension), or from any other file as a text of
/// whole numbers between blanks, with # for comments. Throws InputError (UnreadableFile: missing,
/// empty, not whole numbers, other kinds of array).
[[nodiscard]] std::vector<std::int64_t> readFaceIds(const std::filesystem::path& file);

/// Points along one curve.
struct PointsOfCurve {
    bool closed = false;
    std::vector<CurvePoint> points;
};

/// The ends of names of files of points, for help and messages.
inline constexpr const char* kPointsExtensions = ".csv, .json, .mrk.json, .fcsv, .pp, .xyz";

/// Throws InputError (UnwritableFile) where points cannot be written under this name.
void checkPointsExtension(const std::filesystem::path& file);

/// The bytes of a file of points, all of which picks are read from:
///   .csv       curve, number (both from 1), x y z, distance, tangent, normal and left, curvature
///              with its normal and geodesic part, face, barycentric coordinates
///   .json      {"picks": [[x, y, z], …], "closed"} of the first curve, and {"curves": [{"closed",
///              "points": [{…}, …]}, …]} with the same as .csv
///   .mrk.json  markups of 3D Slicer in LPS: a Curve or ClosedCurve for each curve
///   .fcsv      a list of 3D Slicer in LPS
///   .pp        picks of MeshLab
///   .xyz       x y z per line
/// Numbers are written without loss. Throws InputError (UnwritableFile).
[[nodiscard]] std::string pointsBytes(
    const std::filesystem::path& file, std::span<const PointsOfCurve> curves
);

/// `file`, or where that is empty the font that findFont() finds in fontFolders(): the same again
/// until fonts are installed or removed. Throws InputError (BadOption) where there is none.
[[nodiscard]] std::filesystem::path fontOrDefault(const std::filesystem::path& file);

}  // namespace bspline_curve
