// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "fuzz/fuzz_target.h"
#include "io/mesh_parsers.h"

#include <algorithm>

namespace bspline_curve::fuzz {

namespace {

using Parser = ParsedMesh (*)(const std::filesystem::path& file, std::string_view bytes);

void parseAndCheck(Parser parse, std::string_view bytes) {
    ParsedMesh parsed;
    try {
        parsed = parse("file", bytes);
    } catch (const InputError&) {
        return;
    }
    const TriangleMesh& mesh = parsed.mesh;
    const auto count = static_cast<int>(mesh.vertices.size());
    for (const Triangle& face : mesh.faces) {
        require(
            std::ranges::all_of(face, [&](int id) { return id >= 0 && id < count; }),
            "faces name vertices that are there"
        );
    }
    require(
        parsed.quality.empty() || parsed.quality.size() == mesh.vertices.size(),
        "quality is one value per vertex"
    );
}

}  // namespace

void readPlyBytes(std::string_view bytes) {
    parseAndCheck(parsePly, bytes);
}

void readObjBytes(std::string_view bytes) {
    parseAndCheck(parseObj, bytes);
}

void readOffBytes(std::string_view bytes) {
    parseAndCheck(parseOff, bytes);
}

void readStlBytes(std::string_view bytes) {
    parseAndCheck(parseStl, bytes);
}

}  // namespace bspline_curve::fuzz
