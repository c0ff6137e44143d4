#pragma once

#include "texplorer/emit/emission.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::emit {

/// With the arguments of glTranslatef, glRotatef and glScalef.
enum class Transformation : std::uint8_t { Translation, Rotation, Scaling };

/// Writes the factors of a matrix, in the order of OpenGL's calls: what comes last is done to a vertex first.
class Transformations {
public:
    explicit Transformations(Emission& emission)
        : emission_(emission)
        , writer_(emission.writer) {}
    virtual ~Transformations() = default;
    Transformations(const Transformations&) = delete;
    Transformations& operator=(const Transformations&) = delete;

    /// `changes`: whether it isn't the identity as the scene stands; by key frames it may become another.
    virtual void add(Transformation transformation, std::vector<Part> arguments, bool changes = true) = 0;
    /// A matrix of a parameter's 16 numbers, for which an array gets that name. `loads`: it replaces what was
    /// there.
    virtual void addMatrix(const std::string& name, const glm::mat4& matrix, const std::string& path,
                           bool loads) = 0;
    /// From eye coordinates to the light's picture, from 0 to 1.
    virtual void addProjector(const std::string& name) = 0;
    /// "0.5f + 0.1f * seconds"; of an angle without whole turns.
    [[nodiscard]] virtual std::vector<Part> atTime(const Part& start, const Part& rate, bool isAngle) = 0;

protected:
    Emission& emission_;
    CodeWriter& writer_;
};

/// Calls that multiply OpenGL's current matrix.
class MatrixCalls final : public Transformations {
public:
    using Transformations::Transformations;

    void add(Transformation transformation, std::vector<Part> arguments, bool changes = true) override;
    void addMatrix(const std::string& name, const glm::mat4& matrix, const std::string& path,
                   bool loads) override;
    void addProjector(const std::string& name) override;
    [[nodiscard]] std::vector<Part> atTime(const Part& start, const Part& rate, bool isAngle) override;
};

/// A variable that shaders are given, as a product of doubles: what turns for hours turns smoothly.
class MatrixProduct final : public Transformations {
public:
    /// "Matrix unit0Matrix = ": the first factor makes it.
    MatrixProduct(Emission& emission, std::string variable, bool declares)
        : Transformations(emission)
        , variable_(std::move(variable))
        , declares_(declares) {}

    void add(Transformation transformation, std::vector<Part> arguments, bool changes = true) override;
    void addMatrix(const std::string& name, const glm::mat4& matrix, const std::string& path,
                   bool loads) override;
    void addProjector(const std::string& name) override;
    [[nodiscard]] std::vector<Part> atTime(const Part& start, const Part& rate, bool isAngle) override;

    /// Where there was no factor, it is the identity.
    void finish();
    [[nodiscard]] bool isEmpty() const { return isEmpty_; }

private:
    void addFactor(std::vector<Part> factor);

    std::string variable_;
    bool declares_;
    bool isEmpty_ = true;
};

/// From the world to the eye.
void addView(Emission& emission, Transformations& matrix);
/// From a model to the world, and whether it may be another matrix than the identity.
void addPlacement(Emission& emission, Transformations& matrix, std::size_t model);
[[nodiscard]] bool isPlaced(const Emission& emission, std::size_t model);
/// A step of a texture matrix. `name`: of the array that it may need.
void addStep(Emission& emission, Transformations& matrix, const PlacedStep& placed, std::size_t unit,
             const std::string& name, bool loads);

} // namespace texplorer::emit
