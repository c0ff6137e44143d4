#include "app/ui/texture_space/plane_look.h"

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

using ByteTable = std::array<std::byte, 256>;

/// What each value is shown as.
ByteTable tableOf(const PlaneLook& look) {
    ByteTable table{};
    const float factor = std::exp2(look.exposure);
    const float extent = std::max(look.high - look.low, 1e-4F);
    for (std::size_t value = 0; value < table.size(); ++value) {
        const float shown = (static_cast<float>(value) / 255 * factor - look.low) / extent;
        table[value] = static_cast<std::byte>(std::lround(std::clamp(shown, 0.0F, 1.0F) * 255));
    }
    return table;
}

bool isSameLook(const PlaneLook& a, const PlaneLook& b) {
    return a.channel == b.channel && a.exposure == b.exposure && a.low == b.low && a.high == b.high;
}

std::optional<LevelsRequest> requestOf(const Session& session) {
    const Texture* texture = boundTexture(session);
    if (!texture)
        return std::nullopt;
    const Selection& selection = session.window.selection;
    const Pass& pass = session.document.scene.passes[static_cast<std::size_t>(selection.pass)];
    LevelsRequest request{session.document.images.picturesOf(*texture), imageSettings(*texture),
                          pass.units[static_cast<std::size_t>(selection.unit)].target};
    return request.pictures.base ? std::optional(std::move(request)) : std::nullopt;
}

} // namespace

Image lookedAt(const Image& texels, const PlaneLook& look) {
    const ByteTable table = tableOf(look);
    Image shown = texels;
    const auto of = [](std::byte value) { return std::to_integer<std::size_t>(value); };
    for (std::size_t at = 0; at + 3 < shown.pixels.size(); at += 4) {
        std::byte* texel = shown.pixels.data() + at;
        if (look.channel == Channel::All) {
            for (int i = 0; i < 3; ++i)
                texel[i] = table[of(texel[i])];
            continue;
        }
        const std::size_t value = look.channel == Channel::Luminance
                                      ? static_cast<std::size_t>(reference::luminanceOf(
                                            std::to_integer<int>(texel[0]), std::to_integer<int>(texel[1]),
                                            std::to_integer<int>(texel[2])))
                                      : of(texel[static_cast<std::size_t>(look.channel) - 1]);
        texel[0] = texel[1] = texel[2] = table[value];
        texel[3] = std::byte{255};
    }
    return shown;
}

void LevelPicture::follow(Session& session, const PlaneLook& look, bool needed) {
    std::optional<LevelsRequest> request = needed ? requestOf(session) : std::nullopt;
    if (!request) {
        *this = {};
        return;
    }
    if (request_ != request || level_ != look.level) {
        *this = {};
        request_ = std::move(request);
        level_ = look.level;
    }
    if (!texels_ && problem_.empty()) {
        const std::shared_ptr<const PreparedLevels> levels = session.services.levels.prepare(*request_);
        if (!levels)
            return;
        Result<Image> made = *levels ? reference::levelPicture(**levels, level_, request_->target)
                                     : Result<Image>(fail(levels->error()));
        if (!made) {
            problem_ = made.error().message;
            return;
        }
        texels_ = std::make_shared<const Image>(std::move(*made));
        statistics_ = reference::statisticsOf(*texels_);
    }
    if (!texels_ || (lookedAt_ == texels_ && isSameLook(look_, look)))
        return;
    picture_ = look.isPlain() ? texels_ : std::make_shared<const Image>(lookedAt(*texels_, look));
    lookedAt_ = texels_;
    look_ = look;
}

std::vector<int> levelsOfBound(Session& session) {
    const std::optional<LevelsRequest> request = requestOf(session);
    const auto summary = request ? session.services.levels.summary(*request) : nullptr;
    std::vector<int> numbers;
    for (const LevelReport& level : summary ? summary->report.levels : std::vector<LevelReport>{})
        numbers.push_back(level.number);
    return numbers;
}

} // namespace texplorer::ui
