#include "texplorer/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::param;

constexpr std::array keyFrameRows{
    param<&KeyFrame::time>("time", N_("Key"), N_("Time"), "",
                           N_("The time at which the parameter has this value."),
                           {0, maxKeyTime, 0.02F, "s"}),
    param<&KeyFrame::path>("path", N_("Key"), N_("Parameter"), "",
                           N_("The path of the parameter, as --set takes it.")),
    param<&KeyFrame::value>(
        "value", N_("Key"), N_("Value"), "",
        N_("The value of the parameter at that time, as --set takes it. Numbers are interpolated between two "
           "keys; names and switches keep their value until the next key. In a file, numbers and arrays of "
           "numbers may be written without quotes.")),
    param<&KeyFrame::easing>("easing", N_("Key"), N_("Easing"), "",
                             N_("How the value changes from this key to the "
                                "next one.")),
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
    static const StructTable table{N_("KeyFrame"), keyFrameRows, {}};
    return table;
}

ChildRow timelineRow() {
    return {memberId<&Scene::timeline>,
            "timeline",
            N_("Timeline"),
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
