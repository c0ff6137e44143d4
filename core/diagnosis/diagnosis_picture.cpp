// Pictures of passes, and parts of levels that are replaced.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/pass_pictures.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::diagnosis {
namespace {

std::string picturePath(std::size_t pass) {
    return fmt::format("{}.{}", elementOf<&Scene::passes>(pass), keyOf<&Pass::picture>());
}

void pictureNotShown(const Case& about, Report& report) {
    for (std::size_t p = 0; p < about.scene.passes.size(); ++p) {
        const Pass& pass = about.scene.passes[p];
        if (pass.enabled && !isSeen(about.scene, pass))
            report.add(picturePath(p), Sentence("no unit shows picture {0}", pass.picture),
                       Fix{N_("Draw in the window"), {{picturePath(p), "0"}}});
    }
}

/// Of textures that a unit shows.
template<class Visit> ///< visit(texture, path)
void forEachPicture(const Case& about, Visit visit) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const Texture& texture = about.scene.textures[i];
        if (about.textures[i].shown && texture.source == SourceKind::Picture)
            visit(texture, elementOf<&Scene::textures>(i) + ".");
    }
}

void pictureNotDrawn(const Case& about, Report& report) {
    forEachPicture(about, [&](const Texture& texture, const std::string& path) {
        const auto draws = [&](const Pass& pass) {
            return pass.picture == texture.picture && drawsAnything(about.scene, pass);
        };
        if (std::ranges::any_of(about.scene.passes, draws))
            return;
        const std::string& key = keyOf<&Texture::picture>();
        std::vector<Fix> fixes;
        const auto other = std::ranges::find_if(about.scene.passes, [&](const Pass& pass) {
            return pass.picture != 0 && drawsAnything(about.scene, pass);
        });
        if (other != about.scene.passes.end())
            fixes.push_back({Sentence("Show picture {0}", other->picture),
                             {{path + key, std::to_string(other->picture)}}});
        report.add(path + key,
                   Sentence("no pass draws in picture {0}: it shows the background", texture.picture),
                   std::move(fixes));
    });
}

void emptyWindow(const Case& about, Report& report) {
    const auto& passes = about.scene.passes;
    const auto isElsewhere = [](const Pass& pass) { return !pass.enabled || pass.picture != 0; };
    if (!std::ranges::all_of(passes, isElsewhere) || std::ranges::none_of(passes, &Pass::enabled))
        return;
    const auto last = std::ranges::find_if(passes.rbegin(), passes.rend(), &Pass::enabled);
    const std::string path = picturePath(static_cast<std::size_t>(passes.rend() - last) - 1);
    report.add(path, N_("no pass draws in the window"), Fix{N_("Draw in the window"), {{path, "0"}}});
}

/// OpenGL leaves open what a pass reads of the texture that it draws into (EXT_framebuffer_object, 4.4.3).
void feedback(const Case& about, Report& report) {
    for (const auto& [pass, texture] : unfinishedReads(about.scene)) {
        const Texture& read = about.scene.textures[texture];
        const std::string path =
            fmt::format("{}.{}", elementOf<&Scene::textures>(texture), keyOf<&Texture::frames>());
        if (read.frames == 1)
            report.add(path,
                       Sentence("{0} reads picture {1} before it is finished, and there is no frame before: "
                                "it is black, with alpha 0",
                                ProperName{elementOf<&Scene::passes>(pass)}, read.picture),
                       Fix{Sentence("Draw {0} frames", 8), {{path, "8"}}});
    }
}

void subimageRefused(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        for (const TargetFacts& facts : about.textures[i].targets) {
            for (const RefusedSubimage& each : facts.plan.refusedSubimages) {
                if (!about.textures[i].pictures.subimage(each.index)) // is another mistake
                    continue;
                report.add(fmt::format("{}.{}", elementOf<&Scene::textures>(i),
                                       elementOf<&Texture::subimages>(each.index)),
                           Sentence("{0}; not changed", each.why));
            }
        }
    }
}

constexpr std::array pictureRuleRows{
    Rule{"subimage-refused", Severity::Warning, subimageRefused, true},
    Rule{"empty-window", Severity::Warning, emptyWindow},
    Rule{"picture-not-drawn", Severity::Warning, pictureNotDrawn},
    Rule{"unfinished-picture", Severity::Warning, feedback},
    Rule{"picture-not-shown", Severity::Hint, pictureNotShown},
};

} // namespace

std::span<const Rule> pictureRules() {
    return pictureRuleRows;
}

} // namespace texplorer::diagnosis
