#pragma once

#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/shots/shot_list.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::screenshot {

/// What there is to say of a picture that was drawn.
[[nodiscard]] std::vector<Error> warningsAbout(const ShotRequest& request, const Shot& shot);

/// What one sees: a viewer would let its own background through the framebuffer's alpha. False colours are no
/// framebuffer: where there is none, there is nothing.
[[nodiscard]] bool isOpaque(const ShotRequest& request);

/// A picture that was drawn, or why it couldn't be.
struct DrawnShot {
    std::size_t index; ///< in the list
    const ShotRequest& request;
    Result<Shot>& shot;
    const std::vector<Error>& warnings;
};

/// Draws the pictures of a list, on several contexts side by side where that is worth it, and goes on where
/// one can't be drawn.
struct Drawing {
    const ShotList& list;
    const std::vector<std::string>& names;      ///< of all its pictures, in sentences about them
    const ShotRequest& common;                  ///< all but scene, images, file, renderer, time and size
    LongWork& work;                             ///< whose stop ends it
    std::function<void(const DrawnShot&)> take; ///< each as it comes, on the thread that has drawn it
    std::function<bool()> goesOn{};             ///< false: no more is wanted; empty: all are
};

struct DrawingEnd {
    bool complete = true;            ///< none was impossible; why has been said
    std::optional<Error> unopened{}; ///< why nothing, or not all, was drawn: there is no context
    std::vector<Error> warnings{};   ///< each sentence once, however many pictures it is about; not said yet
};

[[nodiscard]] DrawingEnd drawList(const Drawing& drawing);

} // namespace texplorer::screenshot
