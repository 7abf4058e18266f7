// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vcglib_import.h"

#include "utility/large_array.h"

#include <vcg/complex/complex.h>
#include <wrap/io_trimesh/import_obj.h>
#include <wrap/io_trimesh/import_off.h>
#include <wrap/io_trimesh/import_ply.h>
#include <wrap/io_trimesh/import_stl.h>

namespace bspline_curve {

namespace {

// Without normals, colours and texture coordinates the importers skip them, and cannot fail over
// them.
class Vertex;
class Edge;
class Face;

struct Types : vcg::UsedTypes<
                   vcg::Use<Vertex>::AsVertexType,
                   vcg::Use<Edge>::AsEdgeType,
                   vcg::Use<Face>::AsFaceType> {};

class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3d, vcg::vertex::BitFlags> {};

class Edge : public vcg::Edge<Types, vcg::edge::VertexRef> {};

class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::BitFlags> {};

class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Edge>, std::vector<Face>> {
public:
    Mesh() = default;
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;

    ~Mesh() override { ClearAttributes(); }  // which vcglib leaves to us
};

using Allocator = vcg::tri::Allocator<Mesh>;

/// Takes vertices and faces as they are, also those that a file's flags mark as deleted.
ImportedMesh toArrays(const Mesh& source) {
    ImportedMesh result;
    reserveLarge(result.mesh.vertices, source.vert.size());
    for (const Vertex& vertex : source.vert) {
        const auto& p = vertex.cP();
        result.mesh.vertices.emplace_back(p[0], p[1], p[2]);
    }
    reserveLarge(result.mesh.faces, source.face.size());
    for (const Face& face : source.face) {
        Triangle triangle{};
        for (int k = 0; k < 3; ++k) {
            triangle[k] = static_cast<int>(face.cV(k) - source.vert.data());
        }
        result.mesh.faces.push_back(triangle);
    }
    return result;
}

ImportedMesh failure(const char* reason) {
    ImportedMesh result;
    result.error = reason;
    return result;
}

template <class Scalar>
std::vector<double> takeAttribute(Mesh& mesh, const std::string& name) {
    auto handle = Allocator::GetPerVertexAttribute<Scalar>(mesh, name);
    std::vector<double> values;
    values.reserve(mesh.vert.size());
    for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
        values.push_back(static_cast<double>(handle[i]));
    }
    return values;
}

}  // namespace

ImportedMesh importPly(const std::filesystem::path& file, PlyScalar quality) {
    using Importer = vcg::tri::io::ImporterPLY<Mesh>;
    // As an attribute of its own and not as vcglib's quality, which takes a "confidence" for one.
    const std::string name = "quality";
    Mesh mesh;
    vcg::tri::io::PlyInfo info;
    if (quality == PlyScalar::Float) {
        Allocator::AddPerVertexAttribute<float>(mesh, name);
        info.addPerVertexScalarAttribute(name, vcg::ply::T_FLOAT);
    } else if (quality == PlyScalar::Double) {
        Allocator::AddPerVertexAttribute<double>(mesh, name);
        info.addPerVertexScalarAttribute(name, vcg::ply::T_DOUBLE);
    }
    const int status = Importer::Open(mesh, file.c_str(), info);
    if (status != 0) {
        return failure(Importer::ErrorMsg(status));
    }
    ImportedMesh result = toArrays(mesh);
    if (quality == PlyScalar::Float) {
        result.quality = takeAttribute<float>(mesh, name);
    } else if (quality == PlyScalar::Double) {
        result.quality = takeAttribute<double>(mesh, name);
    }
    return result;
}

ImportedMesh importObj(const std::filesystem::path& file) {
    using Importer = vcg::tri::io::ImporterOBJ<Mesh>;
    Importer::Info info;
    if (!Importer::LoadMask(file.c_str(), info)) {
        return failure("cannot be read");
    }
    // A face with a wrong normal or texture index is a face all the same: read neither.
    info.mask = vcg::tri::io::Mask::IOM_VERTCOORD | vcg::tri::io::Mask::IOM_FACEINDEX;
    Mesh mesh;
    const int status = Importer::Open(mesh, file.c_str(), info);
    if (Importer::ErrorCritical(status)) {
        return failure(Importer::ErrorMsg(status));
    }
    return toArrays(mesh);
}

ImportedMesh importStl(const std::filesystem::path& file) {
    using Importer = vcg::tri::io::ImporterSTL<Mesh>;
    Mesh mesh;
    int mask = 0;
    const int status = Importer::Open(mesh, file.c_str(), mask);
    return status == 0 ? toArrays(mesh) : failure(Importer::ErrorMsg(status));
}

ImportedMesh importOffText(const std::string& text) {
    using Importer = vcg::tri::io::ImporterOFF<Mesh>;
    Mesh mesh;
    int mask = 0;
    const int status = Importer::OpenMem(mesh, text.data(), text.size(), mask);
    return status == 0 ? toArrays(mesh) : failure(Importer::ErrorMsg(status));
}

}  // namespace bspline_curve
