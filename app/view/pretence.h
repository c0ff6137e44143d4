#pragma once

// A driver that is treated as if it lacked something: what --pretend takes. What old hardware could not do is
// then drawn, said and mended on new hardware as on the old. The reference, which draws as the specification
// says, asks no driver and pretends nothing.

#include "app/view/capabilities.h"
#include "core/base/result.h"
#include "core/scene/params/param_text.h"
#include "core/scene/scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::view {

/// Something that a driver can lack.
struct PretenceRow {
    std::string_view word; ///< "no-s3tc"; "units=" is followed by a number
    std::string_view help;
    int low;  ///< of the number
    int high; ///< 0: there is no number
    /// Takes it away; never gives what the driver lacks itself.
    void (*limit)(Capabilities& capabilities, int number);
};

inline constexpr std::array pretenceRows{
    PretenceRow{"no-multitexture", "one texture unit, as before OpenGL 1.3", 0, 0,
                [](Capabilities& driver, int) { driver.textureUnits = std::min(driver.textureUnits, 1); }},
    PretenceRow{"units=", "so many texture units", 1, maxUnits,
                [](Capabilities& driver, int number) {
                    driver.textureUnits = std::min(driver.textureUnits, number);
                }},
    PretenceRow{"max-texture-size=",
                "1D and 2D textures of so many texels along an axis (GL_MAX_TEXTURE_SIZE)", 1, 16384,
                [](Capabilities& driver, int number) {
                    driver.maxTextureSize = std::min(driver.maxTextureSize, number);
                }},
    PretenceRow{"max-3d-texture-size=", "3D textures likewise (GL_MAX_3D_TEXTURE_SIZE)", 1, 16384,
                [](Capabilities& driver, int number) {
                    driver.max3DTextureSize = std::min(driver.max3DTextureSize, number);
                }},
    PretenceRow{"max-cube-map-size=", "faces of cube maps likewise (GL_MAX_CUBE_MAP_TEXTURE_SIZE)", 1, 16384,
                [](Capabilities& driver, int number) {
                    driver.maxCubeMapSize = std::min(driver.maxCubeMapSize, number);
                }},
    PretenceRow{"no-npot",
                "widths and heights that are powers of two only (no GL_ARB_texture_non_power_of_two)", 0, 0,
                [](Capabilities& driver, int) { driver.nonPowerOfTwo = false; }},
    PretenceRow{"no-s3tc", "no DXT1, DXT3 and DXT5 (no GL_EXT_texture_compression_s3tc)", 0, 0,
                [](Capabilities& driver, int) { driver.s3tc = false; }},
    PretenceRow{"no-rgtc", "no BC4 and BC5 (no GL_ARB_texture_compression_rgtc)", 0, 0,
                [](Capabilities& driver, int) { driver.rgtc = false; }},
    PretenceRow{"no-anisotropy", "no anisotropic filtering (no GL_EXT_texture_filter_anisotropic)", 0, 0,
                [](Capabilities& driver, int) { driver.maxAnisotropy = 1; }},
    PretenceRow{"max-anisotropy=", "an anisotropy of so much (GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT)", 1, 16,
                [](Capabilities& driver, int number) {
                    driver.maxAnisotropy = std::min(driver.maxAnisotropy, static_cast<float>(number));
                }},
    PretenceRow{"no-seamless-cube-maps",
                "cube maps whose faces end at their edges (no GL_ARB_seamless_cube_map)", 0, 0,
                [](Capabilities& driver, int) { driver.seamlessCubeMaps = false; }},
    PretenceRow{"no-shaders", "no GLSL 3.30, and so no shader renderer", 0, 0,
                [](Capabilities& driver, int) { driver.shaders = false; }},
};

/// What is pretended, all of it together.
class Pretence {
public:
    /// Of words with commas between them. The error is about "--pretend": an unknown word, or a number that
    /// is missing, superfluous or out of range.
    [[nodiscard]] static Result<Pretence> parse(const std::vector<std::string>& texts) {
        Pretence pretence;
        for (std::string_view text : texts) {
            for (bool more = true; more;) {
                const std::size_t end = std::min(text.find(','), text.size());
                more = end < text.size(); // a comma at the end asks for one more
                if (const Result<void> added = pretence.add(text.substr(0, end)); !added)
                    return fail(added.error());
                text.remove_prefix(std::min(end + 1, text.size()));
            }
        }
        return pretence;
    }

    /// The driver as it is treated.
    [[nodiscard]] Capabilities of(Capabilities driver) const {
        for (const Lack& each : lacks_) {
            each.row->limit(driver, each.number);
            driver.pretending.append(driver.pretending.empty() ? "" : ", ").append(wordOf(each));
        }
        return driver;
    }

    /// As parse() takes it: "no-s3tc,units=2". Empty: nothing is pretended.
    [[nodiscard]] std::string text() const {
        std::string text;
        for (const Lack& each : lacks_)
            text.append(text.empty() ? "" : ",").append(wordOf(each));
        return text;
    }

private:
    struct Lack {
        const PretenceRow* row;
        int number;
    };

    static std::string wordOf(const Lack& lack) {
        return std::string(lack.row->word) + (lack.row->high > 0 ? std::to_string(lack.number) : "");
    }

    Result<void> add(std::string_view word) {
        constexpr const char* option = "--pretend";
        const std::size_t equals = std::min(word.find('='), word.size());
        const std::string_view name = word.substr(0, equals);
        const std::string_view number = word.substr(std::min(equals + 1, word.size()));
        std::vector<std::string_view> names;
        for (const PretenceRow& row : pretenceRows) {
            const bool counts = row.high > 0;
            names.push_back(row.word.substr(0, row.word.size() - (counts ? 1 : 0)));
            if (names.back() != name)
                continue;
            if (!counts && equals < word.size())
                return fail(ErrorCode::OutOfRange,
                            fmt::format("{} takes no number, found {}", name, inQuotes(word)), option);
            Lack lack{&row, 0};
            if (counts) {
                const char* const last = number.data() + number.size();
                const auto [stop, error] = std::from_chars(number.data(), last, lack.number);
                if (error != std::errc() || stop != last || lack.number < row.low || lack.number > row.high)
                    return fail(ErrorCode::OutOfRange,
                                fmt::format("expected {} and a whole number from {} to {}, found {}",
                                            row.word, row.low, row.high, inQuotes(word)),
                                option);
            }
            lacks_.push_back(lack);
            return {};
        }
        return fail(ErrorCode::OutOfRange,
                    fmt::format("no driver lacks {}; {}", inQuotes(word), suggestName(name, names)), option);
    }

    std::vector<Lack> lacks_;
};

/// For --help: what the option does, and its words.
[[nodiscard]] inline std::string pretenceHelp() {
    std::string help = "Treat the driver as if it lacked something that it has, as old ones do: ";
    for (const PretenceRow& row : pretenceRows)
        help += fmt::format("{}{}{}: {}", &row == pretenceRows.data() ? "" : "; ", row.word,
                            row.high > 0 ? "N" : "", row.help);
    return help + ". Several with commas between them.";
}

} // namespace texplorer::view
