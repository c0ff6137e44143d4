#include "texplorer/reference/shading/environment_table.h"

#include "texplorer/reference/sampling/sampled_texture.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace texplorer::reference {

namespace {

glm::vec4 colorAt(ByteView pixel) {
    const auto part = [&](std::size_t i) { return static_cast<float>(std::to_integer<int>(pixel[i])) / 255; };
    return {part(0), part(1), part(2), part(3)};
}

void writeColor(std::span<std::byte> pixel, glm::vec4 color) {
    for (std::size_t i = 0; i < 4; ++i) {
        const float value = std::clamp(color[static_cast<int>(i)], 0.0F, 1.0F);
        pixel[i] = static_cast<std::byte>(static_cast<int>(value * 255 + 0.5F));
    }
}

/// Into a part of a picture, whose lower left corner is given.
void drawCell(Image& picture, int left, int bottom, EnvMode mode, BaseFormat format, const Image& texels,
              TableColors colors) {
    for (int y = 0; y < texels.height; ++y) {
        for (int x = 0; x < texels.width; ++x) {
            colors.texel = colorAt(texels.at(x, y));
            writeColor(picture.at(left + x, bottom + y),
                       evaluate(mode, format, inputsOf(format, colors)).color);
        }
    }
}

bool isUndefined(EnvMode mode, BaseFormat format) {
    return environmentCell(mode, format).color == EnvFunction::Undefined;
}

Image emptyPicture(int width, int height) {
    Image picture = Image::uninitialised(PixelFormat::Rgba8, width, height);
    std::ranges::fill(picture.pixels, std::byte{0});
    return picture;
}

} // namespace

EnvironmentInputs inputsOf(BaseFormat format, const TableColors& colors) {
    return {.previous = colors.fragment,
            .source = sourceColor(format, colors.texel),
            .constant = colors.constant,
            .primary = colors.fragment};
}

SourceSymbols sourceSymbols(BaseFormat format) {
    switch (format) {
    case BaseFormat::Alpha:
        return {"0", N_("At")};
    case BaseFormat::Luminance:
        return {N_("Lt"), "1"};
    case BaseFormat::LuminanceAlpha:
        return {N_("Lt"), N_("At")};
    case BaseFormat::Intensity:
        return {N_("It"), N_("It")};
    case BaseFormat::Rgb:
        return {N_("Ct"), "1"};
    case BaseFormat::Rgba:
        return {N_("Ct"), N_("At")};
    }
    return {};
}

std::string printedEquation(std::string_view symbols) {
    if (const std::size_t sign = symbols.find(" = "); sign != std::string_view::npos)
        symbols.remove_prefix(sign + 3);
    std::string printed;
    for (std::size_t at = 0; at < symbols.size(); ++at) {
        if (symbols[at] == '*')
            ++at; // adjacent symbols are multiplied
        else if (symbols[at] == '-')
            printed += "−";
        else
            printed += symbols[at];
    }
    return printed;
}

Image environmentPictures(const Image& texels, const TableColors& colors) {
    constexpr auto columns = static_cast<int>(tableModes.size());
    constexpr auto rows = static_cast<int>(tableFormats.size());
    Image all = emptyPicture(texels.width * columns, texels.height * rows);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const EnvMode mode = tableModes.at(static_cast<std::size_t>(column));
            const BaseFormat format = tableFormats.at(static_cast<std::size_t>(row));
            if (!isUndefined(mode, format))
                drawCell(all, column * texels.width, (rows - 1 - row) * texels.height, mode, format, texels,
                         colors);
        }
    }
    return all;
}

Image hueAndAlpha(int extent) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, extent, extent);
    const auto share = [extent](int i) {
        return extent > 1 ? static_cast<float>(i) / static_cast<float>(extent - 1) : 1.0F;
    };
    for (int y = 0; y < extent; ++y) {
        for (int x = 0; x < extent; ++x) {
            // Red, green and blue rise and fall a third of the way apart.
            const auto part = [&](float peak) {
                const float way = std::abs(std::remainder(share(x) - peak, 1.0F));
                return std::clamp(2 - 6 * way, 0.0F, 1.0F);
            };
            writeColor(image.at(x, y), {part(0), part(1.0F / 3), part(2.0F / 3), share(y)});
        }
    }
    return image;
}

} // namespace texplorer::reference
