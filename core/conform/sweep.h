#pragma once

// A sweep: selects scenes, draws them with two or three renderers, and counts the differences.

#include "texplorer/conform/feature.h"
#include "texplorer/conform/judge.h"
#include "texplorer/conform/pair.h"
#include "texplorer/conform/skip.h"

#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <vector>

namespace texplorer::conform {

struct Case {
    const Feature* feature;
    int number; ///< in the feature
    Scene scene;
};

/// The scenes of a sweep. The same seed gives the same scenes on every machine; a larger number keeps them
/// and adds more. Every feature gets one scene before any gets two.
struct Selection {
    unsigned seed = 1;
    int scenes = defaultScenes;           ///< in total
    std::vector<const Feature*> features; ///< empty: all
};

[[nodiscard]] std::vector<Case> casesOf(const Selection& selection);

/// One scene of a feature.
[[nodiscard]] Scene sceneOf(const Feature& feature, unsigned seed, int number);

/// Sums over scenes.
struct Tally {
    int scenes = 0;
    std::size_t pixels = 0;
    std::size_t over = 0;          ///< pixels above the rule's bound
    std::size_t unexplained = 0;   ///< of these, pixels that the rule's tolerance does not explain
    std::size_t withinRho = 0;     ///< of these, see Judgement
    std::uint64_t overSquares = 0; ///< the sum of the squares of each scene's `over`
    std::uint64_t unexplainedSquares = 0;
    int max = 0;           ///< the largest difference of a component, in units of 1/255
    std::uint64_t sum = 0; ///< of the differences of all components

    void add(const Judgement& judgement);
    [[nodiscard]] double mean() const {
        return pixels == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(pixels) / 4;
    }
    [[nodiscard]] double shareOver() const { return share(over); }
    [[nodiscard]] double shareUnexplained() const { return share(unexplained); }
    /// The largest allowed values if the renderers obey a rule: see sample_limit.h.
    [[nodiscard]] double limitOver(const Rule& rule) const;
    [[nodiscard]] double limitUnexplained(const Rule& rule) const;

private:
    [[nodiscard]] double share(std::size_t count) const {
        return pixels == 0 ? 0 : static_cast<double>(count) / static_cast<double>(pixels);
    }
    /// The standard deviation for a total of `count` pixels, given the sum of the squares of the scenes'
    /// numbers.
    [[nodiscard]] double deviation(std::size_t count, std::uint64_t squares) const;
};

/// The scene with the largest difference between two renderers.
struct Worst {
    int number = 0;
    Scene scene;
    Image subject;
    Image against;
    Judgement judgement;
};

/// The result of a feature. TooFewScenes: a share exceeds its rule, but that may be chance.
enum class Verdict : std::uint8_t { Agree, Differ, TooFewScenes, Skipped };

inline constexpr std::array verdictRows{
    row(Verdict::Agree, "agree", "agree", "The two renderers agree."),
    row(Verdict::Differ, "differ", "DIFFER", "The two renderers differ by more than allowed."),
    row(Verdict::TooFewScenes, "too-few-scenes", "too few scenes",
        "More pixels differ than allowed for thousands of scenes, but with so few scenes this may be "
        "chance."),
    row(Verdict::Skipped, "skipped", "skipped", "No scene was compared."),
};

/// How two renderers agree on a feature.
struct Outcome {
    const Feature* feature = nullptr;
    const Rule* rule = nullptr;
    Tally all;
    std::map<Shape, Tally> shapes;
    double worstScene = 0;      ///< the largest share of unexplained pixels of one scene
    bool hasWrongScene = false; ///< a scene exceeds what its rule allows in a single scene
    std::map<const Skip*, int> skipped;
    std::map<reference::RhoMethod, int> rho; ///< number of scenes by the driver's method, without Ideal
    std::optional<Worst> worst;              ///< empty if no scene was drawn
    std::string problem; ///< the error of a renderer that could not draw a scene as specified; empty: none

    [[nodiscard]] Verdict verdict() const;
};

struct PairReport {
    Pair pair;
    std::vector<Outcome> outcomes; ///< in the order of the features

    [[nodiscard]] bool agrees() const; ///< none differs
};

/// Where a report comes from.
struct Origin {
    std::string program; ///< "texshot 0.1.0"
    std::string command; ///< the command that reproduces it
    std::string made;    ///< "2026-11-22 02:30 UTC"
};

struct Report {
    Driver driver;
    Selection selection;
    int scenes = 0;
    double seconds = 0;
    std::vector<PairReport> pairs;
    Origin origin{}; ///< set by the caller of sweep()

    [[nodiscard]] bool compared() const; ///< at least one scene was not skipped
    [[nodiscard]] bool agrees() const;   ///< false if nothing was compared
};

/// The renderers to compare. OpenGL's two are used on the calling thread only, and not needed for pairs
/// without them.
struct Renderers {
    Renderer* fixed = nullptr;
    Renderer* shader = nullptr;
    std::function<std::unique_ptr<Explainer>(const Driver&)> reference =
        referenceRenderer; ///< called once per thread
};

struct SweepOptions {
    Selection selection{};
    std::vector<Pair> pairs{defaultPairs.begin(), defaultPairs.end()};
    Driver driver{};
    unsigned threads = 0;                  ///< for the reference; 0: one per processor
    std::function<void(float)> progress{}; ///< called on the calling thread, from 0 to 1
    std::stop_token stop{};
};

/// The report does not depend on the number of threads, except for its time. Errors: a renderer that cannot
/// draw at all; Cancelled.
[[nodiscard]] Result<Report> sweep(const SweepOptions& options, const Renderers& renderers);

} // namespace texplorer::conform

template<>
struct texplorer::EnumTable<texplorer::conform::Verdict> {
    static constexpr std::span<const EnumRow> rows = texplorer::conform::verdictRows;
};
static_assert(texplorer::conform::verdictRows.size() == 4);
