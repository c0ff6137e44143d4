#pragma once

// What is done to a random scene, and what must come of it.

#include "tests/random/batches.h"
#include "tests/random/random_scene.h"
#include "texplorer/base/result.h"

#include <filesystem>
#include <memory>

namespace texplorer::random {

/// How OpenGL is asked to draw. Mesa's shortcuts are what users have, and what crashes; without them its
/// pictures can be held against the reference's.
enum class Precision : std::uint8_t { Usual, Exact };

/// A context without a display with both of OpenGL's renderers, and the reference. One a process.
class Trial {
public:
    /// `files`: the folder that the scenes' textures are in; `shaders`: of the shader renderer, empty: the
    /// built-in ones. Errors: those of the context and the renderers.
    [[nodiscard]] static Result<Trial> open(Precision precision, const std::filesystem::path& files,
                                            const std::filesystem::path& shaders);
    Trial(Trial&&) noexcept;
    Trial& operator=(Trial&&) noexcept;
    ~Trial();

    /// Writes and reads the scene, loads its files, diagnoses it, draws it with all three, probes it, looks
    /// for a texel's pixels, and holds the pictures against each other. Into the journal go each of these as
    /// a step, what must not be as notes of kind "broken", and for each pair of renderers one of kind
    /// "agree", "differ" or "skip" (with the name of the skip), and "blank" where the picture is of one
    /// colour.
    void run(const RandomScene& random, Journal& journal);

private:
    struct State;
    explicit Trial(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace texplorer::random
