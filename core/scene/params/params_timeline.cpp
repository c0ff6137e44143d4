#include "core/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::param;

constexpr std::array keyFrameRows{
    param<&KeyFrame::time>("time", "Key", "Time", "", "When the parameter has this value.",
                           {0, maxKeyTime, 0.02F, "s"}),
    param<&KeyFrame::path>("path", "Key", "Parameter", "",
                           "Which parameter it is, by its path, as --set has it."),
    param<&KeyFrame::value>(
        "value", "Key", "Value", "",
        "What the parameter is then, as --set takes it. Between two keys there is what lies between them; "
        "names, and what is on or off, stay until the next key comes. In a file, numbers and arrays of "
        "numbers may stand without quotes."),
    param<&KeyFrame::easing>("easing", "Key", "Easing", "", "How it goes from here to its next key."),
};
static_assert(keyFrameRows.size() == 4 && keyFrameRows.size() == build::memberCount<KeyFrame>());
static_assert(build::memberCount<Timeline>() == 1);

std::vector<KeyFrame>& keysOf(void* owner) {
    return static_cast<Scene*>(owner)->timeline.keys;
}
const std::vector<KeyFrame>& keysOf(const void* owner) {
    return static_cast<const Scene*>(owner)->timeline.keys;
}

} // namespace

const StructTable& keyFrameTable() {
    static const StructTable table{"KeyFrame", keyFrameRows, {}};
    return table;
}

ChildRow timelineRow() {
    return {memberId<&Scene::timeline>,
            "timeline",
            "Timeline",
            &keyFrameTable(),
            true,
            0,
            maxKeyFrames,
            [](const void* owner) -> std::size_t { return keysOf(owner).size(); },
            [](void* owner, std::size_t index) -> void* { return &keysOf(owner)[index]; },
            [](void* owner, std::size_t count) { keysOf(owner).resize(count); },
            [](const void* owner, std::size_t index) { return keysOf(owner)[index] == KeyFrame{}; }};
}

} // namespace texplorer
