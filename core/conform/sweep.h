#pragma once

// A sweep: which scenes there are, drawing them with two renderers or three, and what came out.

#include "core/conform/feature.h"
#include "core/conform/judge.h"
#include "core/conform/pair.h"
#include "core/conform/skip.h"

#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <vector>

namespace texplorer::conform {

struct Case {
    const Feature* feature;
    int number; ///< within the feature
    Scene scene;
};

/// Which scenes a sweep has. The same seed gives the same scenes on every machine; more scenes are the same
/// ones and others. Every feature has one before any has two.
struct Selection {
    unsigned seed = 1;
    int scenes = defaultScenes;           ///< in all
    std::vector<const Feature*> features; ///< empty: all
};

[[nodiscard]] std::vector<Case> casesOf(const Selection& selection);

/// One scene of a feature.
[[nodiscard]] Scene sceneOf(const Feature& feature, unsigned seed, int number);

/// Sums over scenes.
struct Tally {
    int scenes = 0;
    std::size_t pixels = 0;
    std::size_t over = 0;          ///< pixels over the rule's bound
    std::size_t unexplained = 0;   ///< of these, what the rule's tolerance doesn't allow
    std::size_t withinRho = 0;     ///< of these, what Judgement says
    std::uint64_t overSquares = 0; ///< the squares of each scene's `over`
    std::uint64_t unexplainedSquares = 0;
    int max = 0;           ///< the worst component, in 255ths
    std::uint64_t sum = 0; ///< of all components' differences

    void add(const Judgement& judgement);
    [[nodiscard]] double mean() const {
        return pixels == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(pixels) / 4;
    }
    [[nodiscard]] double shareOver() const { return share(over); }
    [[nodiscard]] double shareUnexplained() const { return share(unexplained); }
    /// What these may be where all scenes that there could be keep to a rule: see sample_limit.h.
    [[nodiscard]] double limitOver(const Rule& rule) const;
    [[nodiscard]] double limitUnexplained(const Rule& rule) const;

private:
    [[nodiscard]] double share(std::size_t count) const {
        return pixels == 0 ? 0 : static_cast<double>(count) / static_cast<double>(pixels);
    }
    /// Of `count` pixels, the squares of whose numbers in each scene have this sum.
    [[nodiscard]] double deviation(std::size_t count, std::uint64_t squares) const;
};

/// The scene in which two renderers are furthest apart.
struct Worst {
    int number = 0;
    Scene scene;
    Image subject;
    Image against;
    Judgement judgement;
};

/// What comes of a feature. Too few scenes: a share is larger than its rule allows, and chance may be why.
enum class Verdict : std::uint8_t { Agree, Differ, TooFewScenes, Skipped };

inline constexpr std::array verdictRows{
    row(Verdict::Agree, "agree", "agree", "The two renderers agree."),
    row(Verdict::Differ, "differ", "DIFFER", "The two renderers differ by more than they may."),
    row(Verdict::TooFewScenes, "too-few-scenes", "too few scenes",
        "More pixels differ than thousands of scenes may have; so few may have them by chance."),
    row(Verdict::Skipped, "skipped", "skipped", "No scene was compared."),
};

/// A feature, as far as two renderers agree on it.
struct Outcome {
    const Feature* feature = nullptr;
    const Rule* rule = nullptr;
    Tally all;
    std::map<Shape, Tally> shapes;
    double worstScene = 0;      ///< the largest share of unexplained pixels of one scene
    bool hasWrongScene = false; ///< one with more than its rule allows a single scene
    std::map<const Skip*, int> skipped;
    std::map<reference::RhoMethod, int> rho; ///< how many scenes the driver drew with which, but for Ideal
    std::optional<Worst> worst;              ///< none where no scene was drawn
    std::string problem; ///< a sentence of a renderer that could not draw a scene as it is; empty: none

    [[nodiscard]] Verdict verdict() const;
};

struct PairReport {
    Pair pair;
    std::vector<Outcome> outcomes; ///< in the order of the features

    [[nodiscard]] bool agrees() const; ///< none differs
};

/// What made a report, for a reader elsewhere.
struct Origin {
    std::string program; ///< "texshot 0.1.0"
    std::string command; ///< that makes it again
    std::string made;    ///< "2026-11-22 02:30 UTC"
};

struct Report {
    Driver driver;
    Selection selection;
    int scenes = 0;
    double seconds = 0;
    std::vector<PairReport> pairs;
    Origin origin{}; ///< for the caller of sweep() to say

    [[nodiscard]] bool compared() const; ///< any scene at all: not all were skipped
    [[nodiscard]] bool agrees() const;   ///< false where nothing was compared
};

/// The renderers to compare. OpenGL's two are used on the calling thread alone; a pair without them needs
/// none.
struct Renderers {
    Renderer* fixed = nullptr;
    Renderer* shader = nullptr;
    std::function<std::unique_ptr<Explainer>()> reference = referenceRenderer; ///< one for each thread
};

struct SweepOptions {
    Selection selection{};
    std::vector<Pair> pairs{defaultPairs.begin(), defaultPairs.end()};
    Driver driver{};
    unsigned threads = 0;                  ///< for the reference; 0: as many as the processor has
    std::function<void(float)> progress{}; ///< on the calling thread, from 0 to 1
    std::stop_token stop{};
};

/// The same report whatever the number of threads, but for its time. Errors: a renderer that can't draw at
/// all; Cancelled.
[[nodiscard]] Result<Report> sweep(const SweepOptions& options, const Renderers& renderers);

} // namespace texplorer::conform

template<>
struct texplorer::EnumTable<texplorer::conform::Verdict> {
    static constexpr std::span<const EnumRow> rows = texplorer::conform::verdictRows;
};
static_assert(texplorer::conform::verdictRows.size() == 4);
