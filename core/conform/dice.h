#pragma once

// Pseudorandom numbers that are the same on every machine.

#include "texplorer/gl/enum_row.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <random>
#include <span>
#include <string_view>

namespace texplorer::conform {

class Dice {
public:
    /// Each feature, seed and scene number has its own sequence, so a scene does not depend on the others
    /// that are drawn.
    Dice(std::string_view feature, unsigned seed, int number)
        : engine_(mixed(feature, seed, number)) {}

    /// Returns 0 to count - 1.
    [[nodiscard]] int below(int count) {
        return static_cast<int>(static_cast<std::uint32_t>(engine_()) % static_cast<std::uint32_t>(count));
    }
    [[nodiscard]] bool chance(int oneIn) { return below(oneIn) == 0; }
    /// Returns one of 1024 evenly spaced numbers.
    [[nodiscard]] float number(float low, float high) {
        return low + (high - low) * static_cast<float>(below(1024)) / 1023.0F;
    }
    [[nodiscard]] glm::vec4 color() { return {number(0, 1), number(0, 1), number(0, 1), number(0, 1)}; }
    template<class Choices>
    [[nodiscard]] auto of(const Choices& choices) {
        return choices[static_cast<std::size_t>(below(static_cast<int>(choices.size())))];
    }
    template<Enumerated E>
    [[nodiscard]] E any() {
        return static_cast<E>(of(EnumTable<E>::rows).value);
    }

private:
    static std::uint32_t mixed(std::string_view feature, unsigned seed, int number) {
        std::uint32_t hash = 2166136261U; // FNV-1a
        const auto add = [&hash](std::uint32_t byte) { hash = (hash ^ byte) * 16777619U; };
        for (const char each : feature)
            add(static_cast<unsigned char>(each));
        for (const std::uint32_t word : {std::uint32_t{seed}, static_cast<std::uint32_t>(number)}) {
            for (unsigned shift = 0; shift < 32; shift += 8)
                add((word >> shift) & 255U);
        }
        return hash;
    }

    std::mt19937 engine_;
};

} // namespace texplorer::conform
