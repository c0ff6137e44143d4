#include "texplorer/scene/emboss_profile.h"

#include "texplorer/scene/emboss.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace texplorer {
namespace {

template<class T>
T linearAt(const std::vector<T>& row, float s) {
    assert(!row.empty());
    const auto last = static_cast<float>(row.size() - 1);
    const float place = std::clamp(s * static_cast<float>(row.size()) - 0.5F, 0.0F, last);
    const float low = std::floor(place);
    const auto first = static_cast<std::size_t>(low);
    const std::size_t second = std::min(first + 1, row.size() - 1);
    return glm::mix(row[first], row[second], place - low);
}

float sketchedHeight(float s) {
    constexpr float ground = 0.2F;
    constexpr float top = 0.8F;
    constexpr float bump = 0.27F;  // its middle
    constexpr float reach = 0.13F; // from there to its foot
    if (std::abs(s - bump) < reach)
        return ground + (top - ground) * (1 + std::cos(std::numbers::pi_v<float> * (s - bump) / reach)) / 2;
    constexpr float from = 0.58F;
    constexpr float to = 0.86F;
    constexpr float side = 0.05F; // how wide its slopes are
    const float rise = std::min(s - from, to - s) / side;
    return ground + (top - ground) * std::clamp(rise, 0.0F, 1.0F);
}

glm::vec3 colorOf(const Image& image, int x, int y) {
    const auto pixel = image.at(x, y);
    return glm::vec3(std::to_integer<int>(pixel[0]), std::to_integer<int>(pixel[1]),
                     std::to_integer<int>(pixel[2])) /
           255.0F;
}

} // namespace

float HeightProfile::heightAt(float s) const {
    return linearAt(heights, s);
}

glm::vec3 HeightProfile::colorAt(float s) const {
    return linearAt(colors, s);
}

HeightProfile sketchedProfile() {
    constexpr int texels = 256; // as the lesson's bump map
    const glm::vec3 clay(0.80F, 0.45F, 0.30F);
    HeightProfile profile{{}, std::vector<glm::vec3>(texels, clay)};
    for (int i = 0; i < texels; ++i)
        profile.heights.push_back(sketchedHeight((static_cast<float>(i) + 0.5F) / texels));
    return profile;
}

HeightProfile profileOf(const Image& heights, const Image& colors, int row) {
    assert(heights.width == colors.width && row < heights.height && row < colors.height);
    HeightProfile profile;
    for (int x = 0; x < heights.width; ++x) {
        profile.heights.push_back(colorOf(heights, x, row).r);
        profile.colors.push_back(colorOf(colors, x, row));
    }
    return profile;
}

glm::vec3 embossedColor(float grey, glm::vec3 lit) {
    return glm::min(2 * grey * lit, glm::vec3(1));
}

EmbossedPoint embossAt(const HeightProfile& profile, float s, float light, float depth, float brightness) {
    const Tangents tangents{{1, 0, 0}, {0, 1, 0}};
    const glm::vec4 direction(std::sin(light), 0, std::cos(light), 0);
    EmbossedPoint point;
    point.offset = embossOffset(glm::vec3(0), tangents, direction, depth).x;
    point.h0 = profile.heightAt(s);
    point.h1 = profile.heightAt(s + point.offset);
    point.grey = embossGrey(point.h0, point.h1);
    point.color = embossedColor(point.grey, profile.colorAt(s) * brightness);
    return point;
}

} // namespace texplorer
