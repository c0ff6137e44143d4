#include "app/view/pretence.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/scene.h"
#include "texplorer/text/nearest_name.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace texplorer::view {

namespace {

constexpr std::array rows{
    PretenceRow{"no-multitexture", N_("one texture unit, as before OpenGL 1.3"), 0, 0,
                [](Capabilities& driver, int) { driver.textureUnits = std::min(driver.textureUnits, 1); }},
    PretenceRow{"units=", N_("this number of texture units"), 1, maxUnits,
                [](Capabilities& driver, int number) {
                    driver.textureUnits = std::min(driver.textureUnits, number);
                }},
    PretenceRow{"max-texture-size=", N_("1D and 2D textures of at most this size (GL_MAX_TEXTURE_SIZE)"), 1,
                16384,
                [](Capabilities& driver, int number) {
                    driver.maxTextureSize = std::min(driver.maxTextureSize, number);
                }},
    PretenceRow{"max-3d-texture-size=", N_("3D textures of at most this size (GL_MAX_3D_TEXTURE_SIZE)"), 1,
                16384,
                [](Capabilities& driver, int number) {
                    driver.max3DTextureSize = std::min(driver.max3DTextureSize, number);
                }},
    PretenceRow{"max-cube-map-size=",
                N_("faces of cube maps of at most this size "
                   "(GL_MAX_CUBE_MAP_TEXTURE_SIZE)"),
                1, 16384,
                [](Capabilities& driver, int number) {
                    driver.maxCubeMapSize = std::min(driver.maxCubeMapSize, number);
                }},
    PretenceRow{"no-npot", N_("sizes that are powers of two only (no GL_ARB_texture_non_power_of_two)"), 0, 0,
                [](Capabilities& driver, int) { driver.nonPowerOfTwo = false; }},
    PretenceRow{"no-s3tc", N_("no DXT1, DXT3 and DXT5 (no GL_EXT_texture_compression_s3tc)"), 0, 0,
                [](Capabilities& driver, int) { driver.s3tc = false; }},
    PretenceRow{"no-rgtc", N_("no BC4 and BC5 (no GL_ARB_texture_compression_rgtc)"), 0, 0,
                [](Capabilities& driver, int) { driver.rgtc = false; }},
    PretenceRow{"no-float-textures", N_("no formats of floats (no GL_ARB_texture_float)"), 0, 0,
                [](Capabilities& driver, int) { driver.floatTextures = false; }},
    PretenceRow{"no-anisotropy", N_("no anisotropic filtering (no GL_EXT_texture_filter_anisotropic)"), 0, 0,
                [](Capabilities& driver, int) { driver.maxAnisotropy = 1; }},
    PretenceRow{"max-anisotropy=", N_("an anisotropy of at most this (GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT)"), 1,
                16,
                [](Capabilities& driver, int number) {
                    driver.maxAnisotropy = std::min(driver.maxAnisotropy, static_cast<float>(number));
                }},
    PretenceRow{"no-seamless-cube-maps",
                N_("cube maps whose faces end at their edges (no GL_ARB_seamless_cube_map)"), 0, 0,
                [](Capabilities& driver, int) { driver.seamlessCubeMaps = false; }},
    PretenceRow{"no-shaders", N_("no GLSL 3.30, so no shader renderer"), 0, 0,
                [](Capabilities& driver, int) { driver.shaders = false; }},
};

} // namespace

std::span<const PretenceRow> pretenceRows() {
    return rows;
}

Result<Pretence> Pretence::parse(const std::vector<std::string>& texts) {
    Pretence pretence;
    for (std::string_view text : texts) {
        for (bool more = true; more;) {
            const std::size_t end = std::min(text.find(','), text.size());
            more = end < text.size(); // a comma at the end requires one more word
            if (const Result<void> added = pretence.add(text.substr(0, end)); !added)
                return fail(added.error());
            text.remove_prefix(std::min(end + 1, text.size()));
        }
    }
    return pretence;
}

Capabilities Pretence::of(Capabilities driver) const {
    for (const Lack& each : lacks_) {
        each.row->limit(driver, each.number);
        driver.pretending.append(driver.pretending.empty() ? "" : ", ").append(wordOf(each));
    }
    return driver;
}

DriverFacts Pretence::facts() const {
    constexpr int anySize = DriverFacts{}.maxTextureSize;
    return driverFacts(of({.maxTextureSize = anySize,
                           .max3DTextureSize = anySize,
                           .maxCubeMapSize = anySize,
                           .textureUnits = maxUnits,
                           .maxAnisotropy = DriverFacts{}.maxAnisotropy,
                           .s3tc = true,
                           .rgtc = true,
                           .floatTextures = true,
                           .seamlessCubeMaps = true,
                           .textureBorders = true}));
}

std::string Pretence::text() const {
    std::string text;
    for (const Lack& each : lacks_)
        text.append(text.empty() ? "" : ",").append(wordOf(each));
    return text;
}

std::string Pretence::wordOf(const Lack& lack) {
    return std::string(lack.row->word) + (lack.row->high > 0 ? std::to_string(lack.number) : "");
}

Result<void> Pretence::add(std::string_view word) {
    constexpr const char* option = "--pretend";
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string_view name = word.substr(0, equals);
    const std::string_view number = word.substr(std::min(equals + 1, word.size()));
    std::vector<std::string_view> names;
    for (const PretenceRow& row : rows) {
        const bool counts = row.high > 0;
        names.push_back(row.word.substr(0, row.word.size() - (counts ? 1 : 0)));
        if (names.back() != name)
            continue;
        if (!counts && equals < word.size())
            return fail(ErrorCode::OutOfRange,
                        Sentence("{0} takes no number, found {1}", name, inQuotes(word)), atOption(option));
        Lack lack{&row, 0};
        if (counts) {
            const char* const last = number.data() + number.size();
            const auto [stop, error] = std::from_chars(number.data(), last, lack.number);
            if (error != std::errc() || stop != last || lack.number < row.low || lack.number > row.high)
                return fail(ErrorCode::OutOfRange,
                            Sentence("expected {0} and a whole number from {1} to {2}, found {3}", row.word,
                                     row.low, row.high, inQuotes(word)),
                            atOption(option));
        }
        lacks_.push_back(lack);
        return {};
    }
    if (nearestName(name, names).empty())
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected one of {0}, found {1}",
                             ProperName{fmt::format("{}", fmt::join(names, ", "))}, inQuotes(word)),
                    atOption(option));
    return fail(ErrorCode::OutOfRange,
                Sentence("{0} cannot be taken away; {1}", inQuotes(word), suggestName(name, names)),
                atOption(option));
}

std::vector<std::string> pretenceWords() {
    std::vector<std::string> words;
    for (const PretenceRow& row : rows)
        words.emplace_back(row.word);
    return words;
}

std::string pretenceHelp() {
    std::string words;
    for (const PretenceRow& row : rows)
        words +=
            fmt::format("{}{}{}: {}", words.empty() ? "" : "; ", row.word, row.high > 0 ? "N" : "", row.help);
    return fmt::format(
        "Treat the driver like an older one that lacks a feature: {}. Separate several with commas.", words);
}

} // namespace texplorer::view
