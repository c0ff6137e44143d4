#include "app/ui/files/asking.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/sheet_choice.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/list_buttons.h"
#include "app/ui/widgets/param_parts.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/popups.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/texture/level_plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

using SharedPicture = std::shared_ptr<const Image>;

constexpr float pictureHeight = 2.6F; ///< of a small picture, in letters' heights

/// Lines with a small picture on their left, together at least as high as the picture.
class PictureLines {
public:
    /// The place of the picture stays empty until it is ready.
    PictureLines(const Pictures& pictures, const SharedPicture& image, const std::string& name)
        : low_(ImGui::GetCursorScreenPos())
        , extent_(ImGui::GetFontSize() * pictureHeight)
        , indent_(extent_ + ImGui::GetStyle().ItemSpacing.x) {
        const ImVec2 high(low_.x + extent_, low_.y + extent_);
        ImGui::GetWindowDrawList()->AddRectFilled(low_, high, color::ground);
        if (image && !image->empty()) {
            noteDrawn(name, low_, high);
            drawImageIn(pictures, image, low_, {extent_, extent_},
                        extent_ / static_cast<float>(std::max(image->width, image->height)));
        }
        ImGui::Indent(indent_);
    }
    PictureLines(const PictureLines&) = delete;
    PictureLines& operator=(const PictureLines&) = delete;
    ~PictureLines() {
        const float left = low_.y + extent_ - ImGui::GetCursorScreenPos().y;
        if (left > 0)
            ImGui::Dummy({0, left});
        ImGui::Unindent(indent_);
    }

private:
    ImVec2 low_;
    float extent_;
    float indent_;
};

constexpr ListWords stepWords{
    N_("image step"),       "", N_("Move this step up"),   N_("Move this step down"),
    N_("Remove this step"), "", N_("Reorder image steps"), N_("Remove image step")};
constexpr ListWords levelWords{"level",
                               "",
                               N_("Make this picture a larger level"),
                               N_("Make this picture a smaller level"),
                               N_("Remove this level"),
                               "",
                               N_("Reorder levels"),
                               N_("Remove level")};

constexpr ListWords subimageWords{"subimage",
                                  "",
                                  N_("Replace this subimage earlier"),
                                  N_("Replace this subimage later"),
                                  N_("Remove this subimage"),
                                  "",
                                  N_("Reorder subimages"),
                                  N_("Remove subimage")};

/// The buttons of one element.
void editElement(const Session& session, std::size_t index, std::size_t count, const std::string& path,
                 const ListWords& words) {
    if (const std::optional<ListEdit> pressed = elementButtons(words, path, index, count))
        submit(session, {.name = words.nameOf(*pressed),
                         .edits = {editOf(*pressed, path.substr(0, path.rfind('[')), index)}});
}

/// The parameters of one element, next to its picture.
template<class Element>
void elementRows(const Session& session, const Element& element, const std::string& path,
                 const StructTable& table) {
    static const Element initial;
    const Owner owner{&element, &initial, path, [&](const ParamRow& row, const Value& value) {
                          return acceptsFile(session, path, element.file, row, value);
                      }};
    paramRows(session, owner, table, {.captions = false});
}

/// "128 × 64", with as many axes as the target has.
Sentence extentsText(const PlannedLevel& level, Target target) {
    std::string text = std::to_string(level.width);
    if (axesOf(target) > 1)
        text += fmt::format(" × {}", level.height);
    if (axesOf(target) > 2)
        text += fmt::format(" × {}", level.depth);
    return ProperName{text};
}

/// The size of a level, and the expected size if that differs.
void levelExtents(const LevelPlan& plan, int number, Target target) {
    const auto found = std::ranges::find(plan.levels, number, &PlannedLevel::number);
    if (found == plan.levels.end()) {
        dimText("Not loaded");
        return;
    }
    const PlannedLevel fit = levelAbove(plan.levels.front(), number);
    const bool fits = *found == fit;
    const Sentence extents = extentsText(*found, target);
    text(fits ? extents : Sentence("{0} instead of {1}", extents, extentsText(fit, target)),
         fits ? color::dim : color::problem);
    noteItem(fmt::format("level extents:{}", number));
    if (!fits)
        helpTip("Each level has half the width and height of the level before, rounded down and at least "
                "1. With another size the texture is incomplete.");
}

/// The picture of one level, once it is made.
SharedPicture pictureOf(const LevelsSummary* summary, int level) {
    if (!summary)
        return nullptr;
    const auto found =
        std::ranges::find(summary->pictures, level, [](const auto& each) { return each.first; });
    return found == summary->pictures.end() ? nullptr : found->second;
}

/// The number of levels that a complete texture has above its base.
std::size_t levelsWanted(const LevelPlan& plan) {
    if (plan.levels.empty())
        return 0;
    const PlannedLevel& base = plan.levels.front();
    const int count = mipLevelCount(base.width, base.height, base.depth) - 1;
    return std::min(maxGivenLevels, static_cast<std::size_t>(std::max(0, count)));
}

/// Adds levels with the pattern of the smallest one until there are `count`.
void addLevels(const Session& session, std::size_t index, std::size_t count) {
    const Texture& texture = presentScene(session).textures[index];
    const Pattern pattern = texture.levels.empty() ? texture.pattern : texture.levels.back().pattern;
    const std::string list =
        fmt::format("{}.{}", elementOf<&Scene::textures>(index), keyOf<&Texture::levels>());
    std::vector<Edit> edits;
    for (std::size_t level = texture.levels.size(); level < count; ++level) {
        edits.emplace_back(edit::Insert{list, level});
        edits.emplace_back(edit::Set{fmt::format("{}[{}].{}", list, level, keyOf<&GivenLevel::pattern>()),
                                     std::string(rowOf(pattern).name)});
    }
    submit(session, {.name = N_("Add levels"), .edits = std::move(edits)});
}

/// A dim line above a list without effect, with the reason.
void idleNote(const Session& session, const std::string& path) {
    if (const Finding* idle = idleReasonOf(session.document.findings, path))
        dimWrappedText(shownSentence(idle->sentence));
}

/// What a list as a whole lacks, with its fixes; what its elements lack is said at theirs.
void problemNote(const Session& session, const std::string& path) {
    const Finding* problem = problemOf(session.document.findings, path);
    if (!problem || problem->path != path)
        return;
    problemSign(session, path, *problem);
    ImGui::SameLine();
    dimWrappedText(shownSentence(problem->sentence));
}

} // namespace

void preparationList(const Session& session, std::size_t texture, const LevelsSummary* summary,
                     const Pictures& pictures) {
    const std::vector<ImageStep>& steps = presentScene(session).textures[texture].preparation;
    const std::string owner = elementOf<&Scene::textures>(texture) + ".";
    caption("Preparation");
    idleNote(session, owner + keyOf<&Texture::preparation>());
    problemNote(session, owner + keyOf<&Texture::preparation>());
    const auto pictureAfter = [&](std::size_t step) {
        return summary && step < summary->steps.size() ? summary->steps[step] : nullptr;
    };
    if (!steps.empty()) {
        const PictureLines lines(pictures, pictureAfter(0), "picture:" + owner + "source");
        dimText("The unchanged image");
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::string path = owner + elementOf<&Texture::preparation>(i);
        ImGui::PushID(path.c_str());
        const PictureLines lines(pictures, pictureAfter(i + 1), "picture:" + path);
        labelText(Sentence("Step {0}", i + 1), color::dim);
        editElement(session, i, steps.size(), path, stepWords);
        elementRows(session, steps[i], path, imageStepTable());
        ImGui::PopID();
    }
    ImGui::BeginDisabled(steps.size() >= maxImageSteps);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (beginCombo("##add step", tr("+ Step"), ImGuiComboFlags_NoArrowButton)) {
        for (const EnumRow& op : imageOpRows) {
            if (ImGui::Selectable(label(op.label).c_str())) {
                const std::string list = owner + keyOf<&Texture::preparation>();
                const std::string added =
                    fmt::format("{}[{}].{}", list, steps.size(), keyOf<&ImageStep::op>());
                submit(session,
                       {.name = N_("Add image step"),
                        .edits = {edit::Insert{list, steps.size()}, edit::Set{added, std::string(op.name)}}});
            }
            noteItem(fmt::format("add step:{}", op.name));
            choiceTip(op);
        }
        endCombo();
    }
    noteItem("add step");
    ImGui::EndDisabled();
    helpTip("An operation on the image and all its levels before they are uploaded");
}

void levelList(const Session& session, std::size_t index, const LevelsSummary* summary,
               const Pictures& pictures) {
    const Texture& texture = presentScene(session).textures[index];
    const bool given = texture.mipmaps == MipPolicy::Given;
    if (!given && texture.levels.empty())
        return;
    const std::string owner = elementOf<&Scene::textures>(index) + ".";
    const Target target = selectedUnit(session).target;
    const LevelPlan plan = planLevels(texture, session.document.images.picturesOf(texture), target);
    caption("Levels");
    idleNote(session, owner + keyOf<&Texture::levels>());
    for (std::size_t i = 0; i < texture.levels.size(); ++i) {
        const std::string path = owner + elementOf<&Texture::levels>(i);
        const int number = static_cast<int>(i) + 1;
        ImGui::PushID(path.c_str());
        const PictureLines lines(pictures, pictureOf(summary, number), "picture:" + path);
        labelText(Sentence("Level {0}", number), color::dim);
        ImGui::SameLine();
        if (const Finding* problem = problemOf(session.document.findings, path)) {
            problemSign(session, path, *problem);
            ImGui::SameLine();
        }
        if (given)
            levelExtents(plan, number, target);
        editElement(session, i, texture.levels.size(), path, levelWords);
        elementRows(session, texture.levels[i], path, givenLevelTable());
        ImGui::PopID();
    }
    const std::size_t wanted = levelsWanted(plan);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
    if (button("+ Level", "levels:add", "Adds a smaller level from a built-in pattern or a file",
               texture.levels.size() < maxGivenLevels, width))
        addLevels(session, index, texture.levels.size() + 1);
    ImGui::SameLine(0, gap);
    if (button("+ Down to 1 × 1", "levels:add all", "Adds all levels that a complete texture needs",
               texture.levels.size() < wanted, width))
        addLevels(session, index, wanted);
}

void subimageList(const Session& session, std::size_t texture) {
    const std::vector<Subimage>& subimages = presentScene(session).textures[texture].subimages;
    const std::string owner = elementOf<&Scene::textures>(texture) + ".";
    const std::string list = owner + keyOf<&Texture::subimages>();
    if (!subimages.empty())
        caption("Subimages");
    for (std::size_t i = 0; i < subimages.size(); ++i) {
        const std::string path = owner + elementOf<&Texture::subimages>(i);
        ImGui::PushID(path.c_str());
        labelText(Sentence("Subimage {0}", i + 1), color::dim);
        if (const Finding* problem = problemOf(session.document.findings, path)) {
            ImGui::SameLine();
            problemSign(session, path, *problem);
        }
        editElement(session, i, subimages.size(), path, subimageWords);
        elementRows(session, subimages[i], path, subimageTable());
        ImGui::PopID();
    }
    if (button("+ Subimage", "subimages:add",
               "Replaces a part of a level after the upload, as glTexSubImage2D does",
               subimages.size() < maxSubimages, ImGui::GetContentRegionAvail().x))
        submit(session, {.name = N_("Add subimage"), .edits = {edit::Insert{list, subimages.size()}}});
}

bool acceptsFile(const Session& session, const std::string& owner, const std::string& file,
                 const ParamRow& row, const Value& value) {
    const std::string param =
        fmt::format("{}.{}", owner, keyOf<&Texture::file>()); // all elements have these keys
    const bool choosesFile =
        row.key == keyOf<&Texture::source>() &&
        std::get<EnumValue>(value).number == static_cast<std::uint32_t>(SourceKind::File);
    if (choosesFile && file.empty()) {
        act(session, [param](Session& s) { askOpenImage(s, param); }); // it has no file yet
        return false;
    }
    if (row.key != keyOf<&Texture::file>() && !choosesFile)
        return true;
    const std::string& wanted = choosesFile ? file : std::get<std::string>(value);
    if (wanted.empty() || session.document.images.holds(wanted))
        return !wanted.empty();
    // The path is set when the file turns out to be an image, which may take a while.
    act(session, [param, wanted](Session& s) { setFile(s, param, wanted); });
    return false;
}

} // namespace texplorer::ui
