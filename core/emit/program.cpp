// Programs of any flavour, and what of them moves by key frames.

#include "texplorer/emit/program.h"

#include "texplorer/emit/emission.h"
#include "texplorer/emit/model_data.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/key_edits.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/scene_at.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace texplorer::emit {
namespace {

using Lines = std::vector<Line>;

class Programs {
public:
    Programs(Flavour flavour, const ImageSource& images, const ProgramOptions& options, TextureCodes& codes)
        : flavour_(flavour)
        , images_(images)
        , options_(options)
        , codes_(codes) {}

    [[nodiscard]] Result<Lines> of(const Scene& standing, KeyFrames& keys) const {
        return flavour_ == Flavour::Glsl ? glslProgram(standing, images_, options_, codes_, keys)
                                         : fixedProgram(standing, images_, options_, codes_, keys);
    }

    /// The program of a scene that moves: the same whenever it is written, but for the values that its
    /// variables have. What else changes with the time no variable stands for, and the program would stay as
    /// it is: that is refused.
    [[nodiscard]] Result<Lines> ofMoving(const Scene& scene) const {
        const auto refusing = [&](const std::string& path) {
            return fail(ErrorCode::Unsupported,
                        Sentence("a program ({0}) can't animate this by key frames; texshot animate can",
                                 rowOf(flavour_).label),
                        path);
        };
        if (const std::string path = ofTexels(scene); !path.empty())
            return refusing(path);
        const std::vector<Track> tracks = tracksOf(scene.timeline);
        const Result<Lines> program = sameAtAllTimes(scene, tracks);
        if (program || !program.error().message.empty())
            return program;
        return refusing(program.error().where.empty() ? culprit(scene, tracks) : program.error().where);
    }

private:
    /// A moving parameter of what a texture holds, if there is one: found out before all that is made.
    [[nodiscard]] static std::string ofTexels(const Scene& scene) {
        const KeyFrames keys(scene);
        Scene still;
        still.textures = sceneAt(scene, 0).textures;
        for (const auto& [path, param] : keys.params()) {
            if (!path.starts_with(keyOf<&Scene::textures>()))
                continue;
            for (const MovingParam::Key& key : param.keys) {
                Scene moved = still;
                static_cast<void>(putBetween(moved, path, key.text, key.text, 0));
                const auto settings = [](const Texture& texture) { return imageSettings(texture); };
                if (!std::ranges::equal(moved.textures, still.textures, {}, settings, settings))
                    return path;
            }
        }
        return {};
    }

    /// What these tracks say, each in all of its stances at once; the others stand at the start. An error
    /// without a message: it isn't the same; `where` is the parameter, if that is known.
    [[nodiscard]] Result<Lines> sameAtAllTimes(const Scene& scene, std::span<const Track> moving) const {
        Scene start = sceneAt(scene, 0);
        for (const Track& track : moving)
            for (const KeyFrame* key : track.keys)
                start.timeline.keys.push_back(*key);
        KeyFrames keys(start);
        start.timeline.keys.clear();
        std::vector<Moving> params;
        std::size_t most = 1;
        for (const auto& [path, param] : keys.params()) {
            params.push_back({&param, path, stancesOf(param)});
            most = std::max(most, params.back().stances.size());
            if (params.back().stances.size() > maxSwitchedValues)
                return fail(ErrorCode::Unsupported,
                            Sentence("expected at most {0} values of its key frames, found {1}",
                                     maxSwitchedValues, params.back().stances.size()),
                            path);
        }
        Lines program;
        for (std::size_t i = 0; i < most; ++i) {
            if (options_.stop.stop_requested())
                return fail(ErrorCode::Cancelled, "writing the program was stopped");
            const Scene stands = standing(start, params, i);
            keys.standAt(stands);
            Result<Lines> lines = of(stands, keys);
            if (!lines)
                return lines;
            if (!keys.refused().empty() || (i > 0 && !std::ranges::equal(*lines, program, readsAs)))
                return fail(ErrorCode::Unsupported, {}, keys.refused());
            program = std::move(*lines);
        }
        return program;
    }

    /// Some share of the way from a key to the next one.
    struct Stance {
        std::size_t key;
        double share;

        auto operator<=>(const Stance&) const = default;
    };

    struct Moving {
        const MovingParam* param;
        std::string path;
        std::vector<Stance> stances;
    };

    /// Where a program would differ if it did anywhere: at each name that there is, at the least and the
    /// greatest that each number is, and somewhere between, where hardly anything is 0 by chance.
    [[nodiscard]] static std::vector<Stance> stancesOf(const MovingParam& param) {
        constexpr double between = 0.382;
        const std::vector<MovingParam::Key>& keys = param.keys;
        std::vector<Stance> stances{{0, 0}, {keys.size() - 1, 0}};
        const auto at = [&](auto key) {
            stances.push_back({static_cast<std::size_t>(key - keys.begin()), 0});
        };
        for (auto key = keys.begin(); param.components() == 0 && key != keys.end(); ++key) {
            const auto isSame = [&](const MovingParam::Key& other) { return other.value == key->value; };
            if (std::find_if(keys.begin(), key, isSame) == key)
                at(key);
        }
        for (std::size_t i = 0; i < param.components(); ++i) {
            const auto number = [&](const MovingParam::Key& key) { return numberIn(key.value, i); };
            const auto [least, greatest] = std::ranges::minmax_element(keys, {}, number);
            at(least);
            at(greatest);
        }
        if (const auto differs = std::ranges::adjacent_find(
                keys, [](const auto& a, const auto& b) { return a.value != b.value; });
            differs != keys.end())
            stances.push_back({static_cast<std::size_t>(differs - keys.begin()), between});
        std::ranges::sort(stances);
        const auto repeats = std::ranges::unique(stances);
        stances.erase(repeats.begin(), repeats.end());
        return stances;
    }

    /// Everything that moves in one of its stances. What is on at times is on, where the program can switch
    /// it.
    [[nodiscard]] Scene standing(const Scene& start, std::span<const Moving> params,
                                 std::size_t number) const {
        static constexpr std::array switchesOfAll{memberId<&Pass::depthTest>, memberId<&Pass::blend>};
        static constexpr std::array switchesOfFixed{memberId<&Pass::lighting>, memberId<&Pass::alphaTest>,
                                                    memberId<&Fog::enabled>, memberId<&Unit::enabled>};
        const auto isIn = [](std::span<const MemberId> members, MemberId member) {
            return std::ranges::find(members, member) != members.end();
        };
        Scene stands = start;
        for (const auto& [param, path, stances] : params) {
            const auto [key, share] = stances[number % stances.size()];
            const std::string& from = param->keys[key].text;
            const std::string& to = param->keys[std::min(key + 1, param->keys.size() - 1)].text;
            const MemberId member = param->row->member;
            const bool isOn =
                isIn(switchesOfAll, member) || (flavour_ == Flavour::Fixed && isIn(switchesOfFixed, member));
            static_cast<void>(isOn ? putBetween(stands, path, "true", "true", 0)
                                   : putBetween(stands, path, from, to, share));
        }
        return stands;
    }

    /// The first parameter with whose keys, beside those before it, the program isn't the same.
    [[nodiscard]] std::string culprit(const Scene& scene, std::span<const Track> tracks) const {
        std::size_t same = 0; // so many tracks are no problem
        std::size_t another = tracks.size();
        while (same + 1 < another) {
            const std::size_t middle = (same + another) / 2;
            (sameAtAllTimes(scene, tracks.first(middle)) ? same : another) = middle;
        }
        return std::string(tracks[another - 1].path);
    }

    Flavour flavour_;
    const ImageSource& images_;
    const ProgramOptions& options_;
    TextureCodes& codes_;
};

/// With the models of too few vertices for a triangle, a line or a point invisible; nothing: there are none.
std::optional<Scene> withoutEmptyModels(const Scene& scene) {
    std::optional<Scene> drawn;
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        const Model& model = scene.models[i];
        const std::string path = fmt::format("{}.{}", elementOf<&Scene::models>(i), keyOf<&Model::visible>());
        const bool isShown = model.visible || std::ranges::find(scene.timeline.keys, path, &KeyFrame::path) !=
                                                  scene.timeline.keys.end();
        if (!isShown || model.shape != Shape::Mesh || !drawnIndices(meshOf(model)).empty())
            continue;
        if (!drawn)
            drawn = scene;
        drawn->models[i].visible = false;
        dropKeys(drawn->timeline, path);
    }
    return drawn;
}

} // namespace

Result<std::vector<Line>> program(Flavour flavour, const Scene& scene, const ImageSource& images,
                                  const ProgramOptions& options, TextureCodes& codes) {
    if (const std::optional<Scene> drawn = withoutEmptyModels(scene))
        return program(flavour, *drawn, images, options, codes);
    const Programs programs(flavour, images, options, codes);
    if (!scene.timeline.keys.empty())
        return programs.ofMoving(scene);
    KeyFrames none;
    return programs.of(scene, none);
}

} // namespace texplorer::emit
