// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/drawing_builder.h"
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "text/text_parsing.h"

#ifdef BSPLINE_CURVE_FREETYPE

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

struct EndLibrary {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};

struct EndFace {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};

using Library = std::unique_ptr<std::remove_pointer_t<FT_Library>, EndLibrary>;
using Face = std::unique_ptr<std::remove_pointer_t<FT_Face>, EndFace>;

/// "U+00E4"
std::string codeName(char32_t code) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    constexpr std::size_t kLeast = 4;
    std::string digits;
    for (; code > 0 || digits.size() < kLeast; code /= 16) {
        digits.insert(digits.begin(), kDigits[code % 16]);
    }
    return "U+" + digits;
}

[[noreturn]] void refuseText(const std::string& message) {
    throw InputError(InputErrorCode::BadOption, message);
}

/// The characters of a text in UTF-8.
class Utf8 {
public:
    explicit Utf8(std::string_view text) : text_(text) {}

    std::vector<char32_t> characters() {
        std::vector<char32_t> codes;
        while (at_ < text_.size()) {
            codes.push_back(next());
        }
        return codes;
    }

private:
    struct Form {
        unsigned mask, lead;  // of the first byte
        int more;             // bytes that follow
        char32_t least;       // codes below have a shorter form
    };

    static constexpr std::array kForms{
        Form{.mask = 0x80, .lead = 0x00, .more = 0, .least = 0},
        Form{.mask = 0xE0, .lead = 0xC0, .more = 1, .least = 0x80},
        Form{.mask = 0xF0, .lead = 0xE0, .more = 2, .least = 0x800},
        Form{.mask = 0xF8, .lead = 0xF0, .more = 3, .least = 0x10000},
    };

    char32_t next() {
        const unsigned first = byte();
        for (const Form& form : kForms) {
            if ((first & form.mask) == form.lead) {
                char32_t code = first & ~form.mask;
                for (int i = 0; i < form.more; ++i) {
                    code = code * 64 + following();
                }
                if (code < form.least || code > 0x10FFFF) {
                    break;
                }
                return code;
            }
        }
        refuseText("the text is not UTF-8");
    }

    unsigned byte() {
        return at_ < text_.size() ? static_cast<unsigned char>(text_[at_++]) : 0xFFU;
    }

    unsigned following() {
        const unsigned value = byte();
        if ((value & 0xC0U) != 0x80U) {
            refuseText("the text is not UTF-8");
        }
        return value & 0x3FU;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

/// Draws glyphs side by side.
class Typesetter {
public:
    Typesetter(FT_Face face, const std::filesystem::path& file)
        : face_(face), file_(file), unit_(1.0 / face->units_per_EM) {}

    Drawing set(const std::vector<char32_t>& text) {
        for (const char32_t character : text) {
            add(character);
        }
        Drawing drawing = pen_.take();
        drawing.baseline = 0.0;
        return drawing;
    }

private:
    void add(char32_t character) {
        const FT_UInt glyph = FT_Get_Char_Index(face_, character);
        if (glyph == 0) {
            refuseFile(file_, "the font has no glyph for the character " + codeName(character));
        }
        FT_Vector kerning{};
        if (last_ != 0 && FT_Get_Kerning(face_, last_, glyph, FT_KERNING_UNSCALED, &kerning) == 0) {
            x_ += static_cast<double>(kerning.x) * unit_;
        }
        last_ = glyph;
        if (FT_Load_Glyph(face_, glyph, FT_LOAD_NO_SCALE) != 0 ||
            face_->glyph->format != FT_GLYPH_FORMAT_OUTLINE) {
            refuseFile(file_, "the font has no outline of the character " + codeName(character));
        }
        static constexpr FT_Outline_Funcs kPen{
            .move_to = moveTo,
            .line_to = lineTo,
            .conic_to = conicTo,
            .cubic_to = cubicTo,
            .shift = 0,
            .delta = 0
        };
        isOpen_ = false;
        if (FT_Outline_Decompose(&face_->glyph->outline, &kPen, this) != 0) {
            refuseFile(
                file_, "the outline of the character " + codeName(character) + " is damaged"
            );
        }
        closeContour();
        x_ += static_cast<double>(face_->glyph->metrics.horiAdvance) * unit_;
    }

    [[nodiscard]] Vec2 place(const FT_Vector& point) const {
        return {x_ + static_cast<double>(point.x) * unit_, static_cast<double>(point.y) * unit_};
    }

    void closeContour() {
        if (isOpen_) {
            pen_.close();
        }
    }

    // What FreeType calls; `setter` is the typesetter.
    static int moveTo(const FT_Vector* to, void* setter) {
        auto& self = *static_cast<Typesetter*>(setter);
        self.closeContour();
        self.isOpen_ = true;
        self.pen_.moveTo(self.place(*to));
        return 0;
    }

    static int lineTo(const FT_Vector* to, void* setter) {
        auto& self = *static_cast<Typesetter*>(setter);
        self.pen_.lineTo(self.place(*to));
        return 0;
    }

    static int conicTo(const FT_Vector* control, const FT_Vector* to, void* setter) {
        auto& self = *static_cast<Typesetter*>(setter);
        self.pen_.curveTo({self.place(*control), self.place(*to)});
        return 0;
    }

    static int cubicTo(
        const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* setter
    ) {
        auto& self = *static_cast<Typesetter*>(setter);
        self.pen_.curveTo({self.place(*first), self.place(*second), self.place(*to)});
        return 0;
    }

    FT_Face face_;
    const std::filesystem::path& file_;
    double unit_;
    double x_ = 0.0;  // where the next glyph begins
    FT_UInt last_ = 0;
    bool isOpen_ = false;
    DrawingBuilder pen_;
};

}  // namespace

Drawing textOutlines(std::string_view text, const std::filesystem::path& font) {
    const std::vector<char32_t> characters = Utf8(text).characters();
    const std::string bytes = readWholeFile(font);
    FT_Library started = nullptr;
    if (FT_Init_FreeType(&started) != 0) {
        throw std::bad_alloc();  // it needs memory alone
    }
    const Library library(started);
    FT_Face opened = nullptr;
    // FreeType's bytes are unsigned.
    const std::vector<FT_Byte> data(bytes.begin(), bytes.end());
    if (FT_New_Memory_Face(
            library.get(), data.data(), static_cast<FT_Long>(data.size()), 0, &opened
        ) != 0) {
        refuseFile(font, "is no font file; give a .ttf, .otf or .pfb");
    }
    const Face face(opened);
    if (!FT_IS_SCALABLE(face.get())) {
        refuseFile(font, "is a font of bitmaps; give one with outlines");
    }
    Drawing drawing = Typesetter(face.get(), font).set(characters);
    if (drawing.paths.empty()) {
        refuseText("the text has nothing but blanks");
    }
    return drawing;
}

}  // namespace bspline_curve

#else

namespace bspline_curve {

Drawing textOutlines(std::string_view /*text*/, const std::filesystem::path& /*font*/) {
    throw InputError(
        InputErrorCode::BadOption,
        "this was built without FreeType, so it cannot make outlines of text; turn the text into "
        "paths in a drawing program and give that drawing"
    );
}

}  // namespace bspline_curve

#endif
