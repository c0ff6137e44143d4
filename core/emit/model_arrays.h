#pragma once

#include "texplorer/emit/emission.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace texplorer::emit {

/// How many of s, t, r and q have to be given: two at least.
[[nodiscard]] int coordCount(const TexCoords& coords);
[[nodiscard]] std::span<const float> firstOf(const glm::vec4& coord, int count);

/// Arrays of a program with a row for each vertex that a model sends. Their names begin with variable(). They
/// are written where they are declared, or at the end of the program if they have many numbers.
class ModelArrays {
public:
    ModelArrays(Emission& emission, std::size_t model);

    [[nodiscard]] const Model& model() const { return *sent_; }
    [[nodiscard]] const Mesh& mesh() const { return mesh_; }
    [[nodiscard]] const std::string& variable() const { return variable_; }
    [[nodiscard]] bool isColored() const { return mesh_.colored; }
    /// A unit's; `flips`: t becomes 1 - t.
    [[nodiscard]] TexCoords coords(std::size_t unit, bool flips = false) const;
    /// How many numbers of each an array has.
    [[nodiscard]] int columns(const TexCoords& coords) const { return isWritten_ ? coordCount(coords) : 4; }

    void writeHeading();
    void writePositions();
    void writeNormals();
    void writeColors();
    void writeCoords(const std::string& name, std::size_t unit, bool flips);
    /// Position, normal and coordinates of each in one struct: "Vertices".
    void writeVertices();
    void writeIndices(const std::vector<std::uint32_t>& indices);
    /// What coordinates that move towards the light are computed from, and the array that they are put into.
    void writeEmbossing(std::size_t unit);
    /// Fills that array, in braces of the caller: `modelView` is the matrix as an array of doubles.
    void writeEmboss(std::size_t pass, std::size_t unit, const std::string& modelView);

private:
    [[nodiscard]] const Model& original() const { return emission_.scene.models[index_]; }
    void write(const std::string& name, int columns, std::span<const glm::vec4> rows,
               const std::string& path = {});
    template<class Get>
    void writeEach(const std::string& name, int columns, Get get);

    Emission& emission_;
    std::size_t index_;
    SentModel sent_;
    Mesh mesh_;
    std::string variable_;
    bool isWritten_;
};

} // namespace texplorer::emit
