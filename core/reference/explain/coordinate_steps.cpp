#include "texplorer/reference/explain/coordinate_steps.h"

#include "texplorer/base/translatable.h"

#include <fmt/core.h>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::reference {
namespace {

/// Where the texture matrix comes from, unless all of it is the pass's.
void addMatrixParts(Step& step, const FragmentExplanation& fragment, const UnitExplanation& unit) {
    const auto isOwn = [&](const MatrixPart& part) { return part.pass == fragment.pass && part.model < 0; };
    if (std::ranges::all_of(unit.matrixParts, isOwn))
        return;
    step.rows.push_back({N_("The texture matrix, by the order of the calls:")});
    for (const MatrixPart& part : unit.matrixParts) {
        const Sentence steps = Sentence::plural("{0} step", "{0} steps", part.steps);
        const bool isHere = part.pass == fragment.pass;
        step.rows.push_back({indented(
            isOwn(part)      ? Sentence("{0} of the pass", steps)
            : part.model < 0 ? Sentence("{0} that pass {1} left", steps, part.pass)
            : !isHere        ? Sentence("{0} that model {1} left in pass {2}", steps, part.model, part.pass)
            : part.model == fragment.model ? Sentence("{0} of the model", steps)
                                           : Sentence("{0} that model {1} left", steps, part.model))});
    }
}

/// A row for each coordinate that it computes, of factors of those that it is given.
void addMatrix(Step& step, const glm::mat4& matrix) {
    step.rows.push_back(heading(N_("the texture matrix"), 4));
    const glm::mat4 rows = glm::transpose(matrix);
    for (int i = 0; i < 4; ++i)
        step.rows.push_back(
            coordinates(indented(ProperName{coordinateNames.at(static_cast<std::size_t>(i))}), rows[i]));
}

/// Of a vertex that has the coordinates of another one, says so.
void addLeftOut(Step& step, std::uint32_t vertex, std::optional<std::uint32_t> of) {
    if (!of)
        step.rows.push_back({Sentence("glTexCoord of vertex {0} is left out, and the model has sent none "
                                      "before it: (0, 0, 0, 1).",
                                      vertex)});
    else if (*of != vertex)
        step.rows.push_back({Sentence(
            "glTexCoord of vertex {0} is left out: the coordinates of vertex {1} stay.", vertex, *of)});
}

} // namespace

StepRow heading(const char* label, int count) {
    StepRow row{label, {}, {}, true};
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        row.cells.push_back({coordinateNames.at(i), coordinateInks.at(i)});
    return row;
}

StepRow coordinates(Sentence label, glm::vec4 values, int count, int digits) {
    StepRow row{std::move(label)};
    for (int i = 0; i < count; ++i)
        row.cells.push_back({columnText(values[i], digits), coordinateInks.at(static_cast<std::size_t>(i))});
    return row;
}

bool compares(const UnitExplanation& unit) {
    return isDepth(unit.internalFormat) && unit.sampler.compareMode == CompareMode::RToTexture;
}

Step coordinatesStep(const FragmentExplanation& fragment, const UnitExplanation& unit) {
    const int axes = compares(unit) ? 3 : coordinatesOf(unit.target);
    Step step{StepKind::Coordinates, unit.unit, N_("Texture coordinates"), {}};
    std::string coords;
    for (int i = 0; i < axes; ++i)
        coords += fmt::format("{}{} {}", i > 0 ? ", " : "", coordinateNames.at(static_cast<std::size_t>(i)),
                              numberText(unit.coords[i]));
    step.summary = ProperName{coords};
    const auto stage = [&](const char* title, glm::vec4 CoordinateSteps::*member) {
        step.rows.push_back(heading(title, 4));
        for (std::size_t i = 0; i < unit.vertices.size(); ++i)
            step.rows.push_back(coordinates(indented(Sentence("at vertex {0}", fragment.vertices[i].vertex)),
                                            unit.vertices[i].*member));
        step.rows.push_back(coordinates(indented(N_("here")), unit.pixel.*member));
    };
    stage(N_("given"), &CoordinateSteps::given);
    for (std::size_t i = 0; i < unit.vertices.size(); ++i)
        addLeftOut(step, fragment.vertices[i].vertex, unit.vertices[i].of);
    if (unit.embosses)
        stage(N_("moved towards the light"), &CoordinateSteps::embossed);
    std::string generated;
    for (std::size_t i = 0; i < 4; ++i)
        generated += unit.generates[i] ? std::string(generated.empty() ? "" : ", ") + coordinateNames[i] : "";
    if (unit.flipped)
        step.rows.push_back({N_("The image is upside down: t becomes q - t.")});
    if (!generated.empty())
        step.rows.push_back({generated.size() > 1
                                 ? Sentence("{0} are generated at each vertex.", ProperName{generated})
                                 : Sentence("{0} is generated at each vertex.", ProperName{generated})});
    if (unit.flipped || !generated.empty())
        stage(N_("generated"), &CoordinateSteps::generated);
    addMatrixParts(step, fragment, unit);
    if (unit.matrix != glm::mat4(1)) {
        addMatrix(step, unit.matrix);
        stage(N_("after the matrix"), &CoordinateSteps::transformed);
    }
    step.rows.push_back(coordinates(N_("over q"), glm::vec4(unit.coords, 0), 3));
    if (unit.sample.cube) {
        const auto& [face, place, change] = *unit.sample.cube;
        step.rows.push_back(
            coordinates(Sentence("a direction, which hits face {0} at", rowOf(cubeFaceAt(face)).label),
                        glm::vec4(place, 0), 2));
        for (const Tie& tie : unit.ties.ties)
            if (tie.between == Tie::Between::Faces)
                step.rows.push_back({Sentence("It hits the edge of face {0}: either face is correct.",
                                              rowOf(cubeFaceAt(tie.other)).label)});
    }
    if (unit.pixel.transformed.q < 0)
        step.rows.push_back({N_("q is below 0: this point is behind the projector.")});
    if (!std::isfinite(unit.coords.s) || (axes > 1 && !std::isfinite(unit.coords.t)) ||
        (axes > 2 && !std::isfinite(unit.coords.r)))
        step.rows.push_back(
            {unit.pixel.transformed.q == 0
                 ? N_("q is 0: the quotient is undefined. Values that are not numbers count as 0 here.")
                 : N_("A coordinate is infinite or not a number: undefined. It counts as 0 here."),
             {},
             {},
             false,
             Ink::Bad});
    return step;
}

} // namespace texplorer::reference
