#pragma once

#include "texplorer/image/texture_image.h"

#include <concepts>
#include <memory>
#include <utility>
#include <variant>

namespace texplorer {

/// A surface that is either owned or shared, which saves a copy. Compares by content.
class SharedSurface {
public:
    template<class Made>
    requires std::constructible_from<Surface, Made>
    SharedSurface(Made&& made) // NOLINT: implicit, as a surface is one
        : held_(std::in_place_type<Surface>, std::forward<Made>(made)) {}

    /// Shared; must not be null.
    explicit SharedSurface(std::shared_ptr<const Surface> lent)
        : held_(std::move(lent)) {}

    [[nodiscard]] const Surface& operator*() const {
        const Surface* made = std::get_if<Surface>(&held_);
        return made ? *made : *std::get<std::shared_ptr<const Surface>>(held_);
    }
    operator const Surface&() const { return **this; } // NOLINT: implicit, for functions of surfaces

    /// Moves an owned surface, copies a shared one.
    [[nodiscard]] Surface take() && {
        Surface* made = std::get_if<Surface>(&held_);
        if (made) // a conditional expression would copy: its other side is const
            return std::move(*made);
        return **this;
    }

    [[nodiscard]] bool isLent() const { return !std::holds_alternative<Surface>(held_); }

    friend bool operator==(const SharedSurface& a, const SharedSurface& b) { return *a == *b; }

private:
    std::variant<Surface, std::shared_ptr<const Surface>> held_;
};

} // namespace texplorer
