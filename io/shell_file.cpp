// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_file.h"

#include "bspline_curve/atomic_file.h"
#include "bspline_curve/error.h"
#include "io/byte_stream.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "BSCSHELL";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kChecksumBytes = 8;
// Magic, version, length, checksums of surface and base, length of the parameters.
constexpr std::size_t kHeaderBytes = 8 + 4 + 8 + 8 + 8 + 4;
constexpr std::size_t kCountBytes = 5 * 4 + 2 * 4;
constexpr std::size_t kPillarBytes = 9 * 8;
constexpr std::size_t kPrismBytes = 6 * 4 + 7;

// How many there are of everything in a file.
struct Counts {
    std::uint32_t pillars = 0, prisms = 0, tracks = 0, blocked = 0, intersections = 0;

    /// What they take, checksum included.
    [[nodiscard]] std::uint64_t bytes() const {
        const std::uint64_t integers =
            std::uint64_t{prisms} + 1 + tracks + blocked + 2 * std::uint64_t{intersections};
        return pillars * kPillarBytes + prisms * kPrismBytes + 4 * integers + kChecksumBytes;
    }
};

std::uint32_t count32(std::size_t count) {
    return static_cast<std::uint32_t>(count);
}

std::uint64_t baseChecksum(const ExtendedSurface& extended) {
    ByteWriter writer;
    writer.add(extended.frame.centre);
    writer.add(extended.frame.scale);
    writer.add(extended.surfaceVertexCount);
    writer.add(extended.surfaceFaceCount);
    writer.addAll(extended.vertices);
    for (const std::vector<Triangle>* triangles : {&extended.faces, &extended.faceNeighbours}) {
        for (const Triangle& triangle : *triangles) {
            writer.addAll(triangle);
        }
    }
    writer.addAll(extended.directions);
    writer.addAll(extended.ghostSource);
    writer.addAll(extended.movedVertices);
    return checksumOf(writer.bytes());
}

// ---- Writing ----

std::string encode(
    const Surface& surface,
    const ExtendedSurface& extended,
    std::string_view parameters,
    const ShellBuild& build
) {
    const Shell& shell = build.shell;
    const Counts counts{
        .pillars = count32(shell.pillars().size()),
        .prisms = count32(shell.prisms().size()),
        .tracks = count32(shell.tracks().faces.size()),
        .blocked = count32(build.report.blockedFaces.size()),
        .intersections = count32(build.report.selfIntersections.size())
    };
    ByteWriter writer;
    writer.add(kMagic);
    writer.add(kVersion);
    writer.add(std::uint64_t{kHeaderBytes + parameters.size() + kCountBytes} + counts.bytes());
    writer.add(surfaceChecksum(surface));
    writer.add(baseChecksum(extended));
    writer.add(count32(parameters.size()));
    writer.add(parameters);
    writer.addAll(
        std::array{
            counts.pillars, counts.prisms, counts.tracks, counts.blocked, counts.intersections
        }
    );
    writer.add(build.report.orientationRounds);
    writer.add(build.report.intersectionRounds);
    for (const Pillar& pillar : shell.pillars()) {
        writer.addAll(std::array{pillar.bottom, pillar.middle, pillar.top});
    }
    for (const Prism& prism : shell.prisms()) {
        writer.addAll(prism.pillars);
        writer.addAll(prism.neighbours);
        writer.addAll(prism.faceCorner);
        writer.addAll(prism.neighbourWalls);
        writer.add(prism.orientation);
    }
    writer.addAll(shell.tracks().offsets);
    writer.addAll(shell.tracks().faces);
    writer.addAll(build.report.blockedFaces);
    for (const auto& [i, j] : build.report.selfIntersections) {
        writer.add(i);
        writer.add(j);
    }
    writer.add(checksumOf(writer.bytes()));
    return writer.bytes();
}

// ---- Reading ----

// Reads one file; every step throws where the file is not what it should be.
class Decoder {
public:
    Decoder(const fs::path& file, std::string_view bytes)
        : file_(file), bytes_(bytes), reader_(bytes) {}

    ShellBuild decode(
        const Surface& surface,
        const std::shared_ptr<const ExtendedSurface>& extended,
        std::string_view parameters
    ) {
        checkWhole();
        checkKey(surface, *extended, parameters);
        readCounts();
        ShellBuildReport report;
        report.orientationRounds = reader_.take<std::int32_t>();
        report.intersectionRounds = reader_.take<std::int32_t>();
        std::vector<Pillar> pillars = readPillars();
        std::vector<Prism> prisms = readPrisms();
        SurfaceTracks tracks = readTracks(static_cast<int>(extended->faces.size()));
        report.blockedFaces = reader_.takeInts(counts_.blocked);
        checkAscending(report.blockedFaces, extended->surfaceFaceCount, "blocked face");
        const std::vector<int> pairs = reader_.takeInts(2 * std::size_t{counts_.intersections});
        for (std::size_t i = 0; i < pairs.size(); i += 2) {
            checkIndex(pairs[i], extended->surfaceFaceCount, "intersecting face");
            checkIndex(pairs[i + 1], extended->surfaceFaceCount, "intersecting face");
            report.selfIntersections.emplace_back(pairs[i], pairs[i + 1]);
        }
        return {
            .shell = Shell(std::move(pillars), std::move(prisms), std::move(tracks), extended),
            .report = std::move(report)
        };
    }

private:
    [[noreturn]] void refuse(const std::string& reason) const { refuseFile(file_, reason); }

    [[noreturn]] void refuseDamage(const std::string& what) const {
        refuse("is damaged (" + what + ")");
    }

    // That it is such a file, and that all bytes are there and as they were written.
    void checkWhole() {
        if (bytes_.size() < kMagic.size() || reader_.takeText(kMagic.size()) != kMagic) {
            refuse("is not a shell file");
        }
        if (bytes_.size() < kHeaderBytes + kCountBytes + kChecksumBytes) {
            refuse("is cut off after " + std::to_string(bytes_.size()) + " bytes");
        }
        const auto version = reader_.take<std::uint32_t>();
        if (version != kVersion) {
            refuse(
                "has version " + std::to_string(version) + " of the format, this program reads " +
                std::to_string(kVersion)
            );
        }
        const auto length = reader_.take<std::uint64_t>();
        if (length != bytes_.size()) {
            refuse(
                "has " + std::to_string(bytes_.size()) + " bytes instead of " +
                std::to_string(length)
            );
        }
        const std::string_view content = bytes_.substr(0, bytes_.size() - kChecksumBytes);
        if (ByteReader(bytes_.substr(content.size())).take<std::uint64_t>() !=
            checksumOf(content)) {
            refuseDamage("its checksum does not match");
        }
    }

    void checkKey(
        const Surface& surface, const ExtendedSurface& extended, std::string_view parameters
    ) {
        if (reader_.take<std::uint64_t>() != surfaceChecksum(surface)) {
            refuse("was made for another surface");
        }
        const auto writtenBase = reader_.take<std::uint64_t>();
        const auto length = reader_.take<std::uint32_t>();
        if (length > reader_.left() - kCountBytes - kChecksumBytes) {
            refuseDamage("its parameters are longer than the file");
        }
        const std::string_view written = reader_.takeText(length);
        if (written != parameters) {
            refuse(
                "was made with other parameters: " + inQuotes(written) + ", not " +
                inQuotes(parameters)
            );
        }
        if (writtenBase != baseChecksum(extended)) {
            refuse("was made by a program that prepares this surface in another way");
        }
    }

    void readCounts() {
        for (std::uint32_t* count :
             {&counts_.pillars,
              &counts_.prisms,
              &counts_.tracks,
              &counts_.blocked,
              &counts_.intersections}) {
            *count = reader_.take<std::uint32_t>();
        }
        if (counts_.bytes() != reader_.left() - 2 * sizeof(std::int32_t)) {
            refuseDamage("its counts and its length disagree");
        }
    }

    void checkIndex(int index, int count, std::string_view what) const {
        if (index < 0 || index >= count) {
            refuseDamage(
                std::string(what) + " " + std::to_string(index) + " of " + std::to_string(count)
            );
        }
    }

    void checkAscending(std::span<const int> indices, int count, std::string_view what) const {
        for (std::size_t i = 0; i < indices.size(); ++i) {
            checkIndex(indices[i], count, what);
            if (i > 0 && indices[i] <= indices[i - 1]) {
                refuseDamage(std::string(what) + "s are not in order");
            }
        }
    }

    std::vector<Pillar> readPillars() {
        std::vector<Pillar> pillars(counts_.pillars);
        for (Pillar& pillar : pillars) {
            for (Vec3* point : {&pillar.bottom, &pillar.middle, &pillar.top}) {
                *point = reader_.takePoint();
                if (!point->allFinite()) {
                    refuseDamage("a coordinate is not finite");
                }
            }
        }
        return pillars;
    }

    std::vector<Prism> readPrisms() {
        std::vector<Prism> prisms(counts_.prisms);
        for (Prism& prism : prisms) {
            reader_.fill(prism.pillars);
            reader_.fill(prism.neighbours);
            reader_.fill(prism.faceCorner);
            reader_.fill(prism.neighbourWalls);
            prism.orientation = reader_.take<signed char>();
        }
        for (std::size_t i = 0; i < prisms.size(); ++i) {
            checkPrism(prisms, static_cast<int>(i));
        }
        return prisms;
    }

    void checkPrism(const std::vector<Prism>& prisms, int i) const {
        const Prism& prism = prisms[i];
        checkAscending(prism.pillars, static_cast<int>(counts_.pillars), "pillar");
        if (prism.orientation != 1 && prism.orientation != -1) {
            refuseDamage("a prism has no orientation");
        }
        for (std::size_t k = 0; k < 3; ++k) {
            checkIndex(prism.faceCorner[k], 3, "corner");
            const int there = prism.neighbours[k];
            if (there == -1) {
                continue;
            }
            const int wall = prism.neighbourWalls[k];
            checkIndex(there, static_cast<int>(counts_.prisms), "prism");
            checkIndex(wall, 3, "wall");
            const Prism& neighbour = prisms[there];
            if (neighbour.neighbours[wall] != i ||
                neighbour.neighbourWalls[wall] != static_cast<int>(k)) {
                refuseDamage("prisms disagree about a wall");
            }
        }
    }

    SurfaceTracks readTracks(int faceCount) {
        SurfaceTracks tracks;
        tracks.offsets = reader_.takeInts(std::size_t{counts_.prisms} + 1);
        tracks.faces = reader_.takeInts(counts_.tracks);
        if (tracks.offsets.front() != 0 || tracks.offsets.back() != std::ssize(tracks.faces) ||
            !std::is_sorted(tracks.offsets.begin(), tracks.offsets.end())) {
            refuseDamage("the tracks of its prisms overlap");
        }
        const std::span<const int> faces(tracks.faces);
        for (std::size_t i = 0; i + 1 < tracks.offsets.size(); ++i) {
            const auto first = tracks.offsets[i];
            checkAscending(
                faces.subspan(first, (tracks.offsets[i + 1]) - first), faceCount, "face"
            );
        }
        return tracks;
    }

    const fs::path& file_;
    std::string_view bytes_;
    ByteReader reader_;
    Counts counts_;
};

}  // namespace

std::uint64_t surfaceChecksum(const Surface& surface) {
    ByteWriter writer;
    writer.add(surface.vertexCount());
    writer.add(surface.faceCount());
    writer.addAll(surface.vertices());
    for (const Triangle& face : surface.faces()) {
        writer.addAll(face);
    }
    return checksumOf(writer.bytes());
}

void saveShell(
    const fs::path& file,
    const Surface& surface,
    const ExtendedSurface& extended,
    std::string_view parameters,
    const ShellBuild& build
) {
    assert(!build.shell.isFullResolution());
    AtomicFile(file, encode(surface, extended, parameters, build)).commit();
}

ShellBuild loadShell(
    const fs::path& file,
    const Surface& surface,
    const std::shared_ptr<const ExtendedSurface>& extended,
    std::string_view parameters
) {
    return decodeShell(file, readWholeFile(file), surface, extended, parameters);
}

ShellBuild decodeShell(
    const fs::path& file,
    std::string_view bytes,
    const Surface& surface,
    const std::shared_ptr<const ExtendedSurface>& extended,
    std::string_view parameters
) {
    return Decoder(file, bytes).decode(surface, extended, parameters);
}

}  // namespace bspline_curve
