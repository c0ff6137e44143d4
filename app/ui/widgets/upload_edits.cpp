#include "app/ui/widgets/upload_edits.h"

#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/texture/level_plan.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace texplorer::ui {
namespace {

std::string uploadPath(const Session& session) {
    return fmt::format("{}.{}",
                       elementOf<&Scene::textures>(static_cast<std::size_t>(selectedUnit(session).texture)),
                       keyOf<&Texture::upload>());
}

} // namespace

UploadFacts uploadFacts(const Session& session) {
    Texture texture = *boundTexture(session);
    const Target target = selectedUnit(session).target;
    const TexturePictures pictures = session.document.images.picturesOf(texture);
    Upload upload = std::exchange(texture.upload, {});
    upload.custom = true; // for its layout
    const LevelPlan plan = planLevels(texture, pictures, target);
    if (plan.levels.empty())
        return {{}, upload};
    texture.upload = upload;
    const LevelPlan custom = planLevels(texture, pictures, target);
    const MemoryLayout held =
        custom.upload ? custom.upload->memory : memoryOf(upload, PixelFormat::Rgba8, pictures.base->format);
    const auto widthOf = [&](const PlannedLevel& level) { return level.width + 2 * plan.border; };
    upload = fittingUpload(upload, held, widthOf(plan.levels.front()), isDepth(texture.internalFormat));
    const UploadCall call = callOf(upload);
    const auto isSheared = [&](const PlannedLevel& level) {
        return rowStride(call, widthOf(level)) !=
               rowStride({held.pixels, {.alignment = held.alignment}}, widthOf(level));
    };
    if (std::ranges::any_of(plan.levels, isSheared)) // a smaller level
        upload.alignment = held.alignment;
    return {held, upload};
}

void turnUploadOn(const Session& session) {
    const Upload& now = boundTexture(session)->upload;
    const Upload fitting = uploadFacts(session).fitting;
    const std::string path = uploadPath(session);
    Step step{.name = findParam(uploadTable(), keyOf<&Upload::custom>())->label,
              .path = fmt::format("{}.{}", path, keyOf<&Upload::custom>())};
    for (const ParamRow& row : uploadTable().params) {
        const Value value = row.read(&fitting);
        if (value != row.read(&now))
            step.edits.emplace_back(edit::Set{fmt::format("{}.{}", path, row.key), formatValue(row, value)});
    }
    submit(session, std::move(step));
}

Owner uploadOwner(const Session& session) {
    static const Upload initial;
    return {&boundTexture(session)->upload, &initial, uploadPath(session),
            [&session](const ParamRow& row, const Value& value) {
                if (row.member != memberId<&Upload::custom> || !std::get<bool>(value))
                    return true;
                turnUploadOn(session);
                return false;
            }};
}

} // namespace texplorer::ui
