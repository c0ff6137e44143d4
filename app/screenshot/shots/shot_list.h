#pragma once

#include "app/screenshot/arguments/scene_argument.h"
#include "app/view/size.h"
#include "texplorer/scene/params/sweep_axis.h"
#include "texplorer/scene/renderer.h"
#include "texplorer/text/name_pattern.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::screenshot {

/// How many pictures one call draws at most.
inline constexpr std::size_t maxShots = 100'000;

/// By whom pictures of a scene are drawn, how large and when: each with each.
struct PictureKinds {
    std::vector<RendererKind> renderers;
    std::vector<view::Size> sizes;
    std::vector<double> times;

    /// At most a little more than maxShots, however many there would be.
    [[nodiscard]] std::size_t count() const;
};

/// What is to be drawn: every scene by every renderer, in every size, at every time, with every combination
/// of the axes' values.
class ShotList {
public:
    /// A scene, and the axes as they are for it: the same paths for all scenes; the values that "*" stands
    /// for may differ.
    struct Entry {
        std::string name; ///< "{scene}": the file's, without folder and extension
        std::string file; ///< empty: none
        OpenedScene opened;
        std::vector<SweepAxis> axes{};
    };

    ShotList(std::vector<Entry> entries, PictureKinds kinds);

    /// One of the pictures.
    struct Case {
        std::size_t entry = 0;
        RendererKind renderer = RendererKind::Fixed;
        view::Size size;
        double time = 0;
        std::vector<std::size_t> values{}; ///< of each axis, which
    };

    /// At most a little more than maxShots, however many there would be.
    [[nodiscard]] std::size_t count() const { return count_; }
    /// Scenes in their order, of each the renderers, the sizes, the times and then the axes, the last of
    /// which goes fastest.
    [[nodiscard]] Case at(std::size_t index) const;
    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
    [[nodiscard]] const std::vector<RendererKind>& renderers() const { return kinds_.renderers; }
    [[nodiscard]] const Entry& entryOf(const Case& shot) const { return entries_[shot.entry]; }
    /// With the values of the axes.
    [[nodiscard]] Result<Scene> sceneOf(const Case& shot) const;

    /// A name for each picture. Refused: more than maxShots of them, places that nothing is known of or that
    /// could mean several axes, the same name for two. Places: scene, number (of the picture, from 1, with
    /// zeros in front), renderer, time, size and the axes' paths or keys.
    [[nodiscard]] Result<std::vector<std::string>> names(const NamePattern& pattern) const;

private:
    [[nodiscard]] Result<void> checkPlaces(const NamePattern& pattern) const;

    std::vector<Entry> entries_;
    PictureKinds kinds_;
    std::vector<std::size_t> ends_; ///< of each entry, the number of the case behind its last
    std::size_t count_ = 0;
};

} // namespace texplorer::screenshot
