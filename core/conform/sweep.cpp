#include "texplorer/conform/sweep.h"

#include "texplorer/base/parallel.h"
#include "texplorer/base/thrown.h"
#include "texplorer/conform/sample_limit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <tuple>
#include <utility>

namespace texplorer::conform {

namespace {

const Rule& ruleOf(const Feature& feature, const Pair& pair) {
    return pair.has(RendererKind::Reference) ? feature.reference : feature.shader;
}

/// A scene with OpenGL's pictures of it, for the threads that compare.
struct DrawnCase {
    const Case* item = nullptr;
    std::map<RendererKind, Frame> frames;
};

/// Scenes between the thread that has the context and those that compare. Short, because waiting
/// pictures only take memory.
class Queue {
public:
    void push(DrawnCase drawn) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return items_.size() < limit || closed_; });
        items_.push_back(std::move(drawn));
        changed_.notify_all();
    }
    std::optional<DrawnCase> pop() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !items_.empty() || closed_; });
        if (items_.empty())
            return std::nullopt;
        DrawnCase drawn = std::move(items_.front());
        items_.pop_front();
        changed_.notify_all();
        return drawn;
    }
    void close() {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
        changed_.notify_all();
    }

private:
    static constexpr std::size_t limit = 64;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<DrawnCase> items_;
    bool closed_ = false;
};

/// By how much `a` is worse; of two that are alike the first is kept, so that the order of threads decides
/// nothing.
auto badness(const Worst& worst) {
    const Judgement& j = worst.judgement;
    return std::tuple(j.unexplained, j.difference.over, j.difference.max, -worst.number);
}

/// The first problem that only one of two has; nullptr: they have the same.
const Sentence* problemOfOne(const std::vector<Sentence>& a, const std::vector<Sentence>& b) {
    for (const auto& [own, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        const auto lacks = [&other = *other](const Sentence& each) {
            return std::ranges::find(other, each) == other.end();
        };
        if (const auto found = std::ranges::find_if(*own, lacks); found != own->end())
            return &*found;
    }
    return nullptr;
}

/// What the threads have found so far.
class Outcomes {
public:
    explicit Outcomes(const SweepOptions& options, const std::vector<Case>& cases) {
        for (const Pair& pair : options.pairs) {
            PairReport report{pair, {}};
            for (const Case& item : cases) {
                if (report.outcomes.empty() || report.outcomes.back().feature != item.feature) {
                    Outcome& outcome = report.outcomes.emplace_back();
                    outcome.feature = item.feature;
                    outcome.rule = &ruleOf(*item.feature, pair);
                }
            }
            pairs_.push_back(std::move(report));
        }
    }

    void skip(std::size_t pair, const Case& item, const Skip& skip) {
        const std::scoped_lock lock(mutex_);
        ++of(pair, item).skipped[&skip];
    }

    void add(std::size_t pair, const Case& item, Judgement judgement, const Frame& subject,
             const Frame& against) {
        const std::scoped_lock lock(mutex_);
        Outcome& outcome = of(pair, item);
        outcome.all.add(judgement);
        if (judgement.rho != reference::RhoMethod::Ideal)
            ++outcome.rho[judgement.rho];
        if (!item.scene.models.empty())
            outcome.shapes[item.scene.models.front().shape].add(judgement);
        outcome.worstScene = std::max(outcome.worstScene, judgement.shareUnexplained());
        outcome.hasWrongScene = outcome.hasWrongScene || !judgement.isAllowed(*outcome.rule);
        // What neither can do, as a compression without a cache, is no disagreement.
        const Sentence* only = problemOfOne(subject.problems, against.problems);
        if (only && (outcome.problem.empty() || only->english() < outcome.problem))
            outcome.problem = only->english();
        Worst candidate{item.number, item.scene, subject.image, against.image, std::move(judgement)};
        if (auto& redrawn = candidate.judgement.redrawn)
            (pairs_[pair].pair.subject == RendererKind::Reference ? candidate.subject : candidate.against) =
                *std::exchange(redrawn, std::nullopt);
        if (!outcome.worst || badness(*outcome.worst) < badness(candidate))
            outcome.worst = std::move(candidate);
    }

    void fail(Error error) {
        const std::scoped_lock lock(mutex_);
        if (!error_)
            error_ = std::move(error);
    }
    [[nodiscard]] std::optional<Error> error() const {
        const std::scoped_lock lock(mutex_);
        return error_;
    }
    [[nodiscard]] std::vector<PairReport> take() { return std::move(pairs_); }

private:
    Outcome& of(std::size_t pair, const Case& item) {
        return *std::ranges::find(pairs_[pair].outcomes, item.feature, &Outcome::feature);
    }

    mutable std::mutex mutex_;
    std::vector<PairReport> pairs_;
    std::optional<Error> error_;
};

/// Compares one drawn scene after the other, on one thread.
class Comparer {
public:
    Comparer(const SweepOptions& options, const Renderers& renderers, Outcomes& outcomes)
        : options_(options)
        , outcomes_(outcomes)
        , reference_(renderers.reference(options.driver)) {}

    void compare(DrawnCase drawn) {
        if (options_.stop.stop_requested() || outcomes_.error())
            return;
        const Case& item = *drawn.item;
        for (std::size_t i = 0; i < options_.pairs.size(); ++i) {
            const Pair& pair = options_.pairs[i];
            if (const Skip* skip = skipOf(item.scene, pair, options_.driver)) {
                outcomes_.skip(i, item, *skip);
                continue;
            }
            if (pair.has(RendererKind::Reference) && !drawn.frames.contains(RendererKind::Reference)) {
                Result<Frame> frame = reference_->draw(item.scene);
                if (!frame)
                    return outcomes_.fail(frame.error());
                drawn.frames.emplace(RendererKind::Reference, std::move(*frame));
            }
            const Frame& subject = drawn.frames.at(pair.subject);
            const Frame& against = drawn.frames.at(pair.against);
            const bool turned = pair.against == RendererKind::Reference;
            Result<Judgement> judgement =
                judge(ruleOf(*item.feature, pair), item.scene, turned ? against.image : subject.image,
                      turned ? subject.image : against.image, *reference_, rhoRangeOf(options_.driver));
            if (!judgement)
                return outcomes_.fail(judgement.error());
            outcomes_.add(i, item, *std::move(judgement), subject, against);
        }
    }

private:
    const SweepOptions& options_;
    Outcomes& outcomes_;
    std::unique_ptr<Explainer> reference_;
};

/// Compares what comes out of the queue, until there is no more.
void compareAll(const SweepOptions& options, const Renderers& renderers, Queue& queue, Outcomes& outcomes) {
    Comparer comparer(options, renderers, outcomes);
    while (std::optional<DrawnCase> drawn = queue.pop())
        comparer.compare(std::move(*drawn));
}

/// What OpenGL makes of a scene, as far as a pair wants it.
Result<DrawnCase> drawByOpenGl(const SweepOptions& options, const Renderers& renderers, const Case& item) {
    DrawnCase drawn{&item, {}};
    for (const auto& [kind, renderer] : {std::pair{RendererKind::Fixed, renderers.fixed},
                                         std::pair{RendererKind::Shader, renderers.shader}}) {
        const bool wanted = std::ranges::any_of(options.pairs, [&, kind = kind](const Pair& pair) {
            return pair.has(kind) && !skipOf(item.scene, pair, options.driver);
        });
        if (!wanted)
            continue;
        Result<Frame> frame = renderer->draw(item.scene);
        if (!frame)
            return fail(frame.error());
        drawn.frames.emplace(kind, std::move(*frame));
    }
    return drawn;
}

/// Draws the scenes and gives each to those who compare.
void drawAll(const SweepOptions& options, const Renderers& renderers, const std::vector<Case>& cases,
             Outcomes& outcomes, const std::function<void(DrawnCase)>& give) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (options.progress)
            options.progress(static_cast<float>(i) / static_cast<float>(cases.size()));
        if (options.stop.stop_requested() || outcomes.error())
            return;
        Result<DrawnCase> drawn = drawByOpenGl(options, renderers, cases[i]);
        if (!drawn)
            return outcomes.fail(drawn.error());
        give(std::move(*drawn));
    }
}

/// How many of so many scenes each feature has. One by one they go to the feature that has the fewest for its
/// weight, one without any first (Adams' apportionment): so the sum is exact, and more scenes take none away.
std::vector<int> sharesOf(const std::vector<const Feature*>& features, int scenes) {
    std::vector<int> shares(features.size());
    const auto isBehind = [&](std::size_t a, std::size_t b) {
        return static_cast<long long>(shares[a]) * features[b]->scenes <
               static_cast<long long>(shares[b]) * features[a]->scenes;
    };
    for (int i = 0; i < scenes; ++i) {
        std::size_t next = 0;
        for (std::size_t f = 1; f < features.size(); ++f) {
            if (isBehind(f, next))
                next = f;
        }
        ++shares[next];
    }
    return shares;
}

/// As many as are asked for and the system gives, which may be none.
void startComparers(std::vector<std::jthread>& comparers, unsigned asked, const std::function<void()>& work) {
    const unsigned count = asked == 0 ? processorThreads() : asked;
    while (comparers.size() < count) {
        try {
            comparers.emplace_back(work);
        } catch (const std::system_error&) {
            return;
        }
    }
}

} // namespace

void Tally::add(const Judgement& judgement) {
    ++scenes;
    pixels += judgement.difference.pixels;
    over += judgement.difference.over;
    unexplained += judgement.unexplained;
    withinRho += judgement.withinRho;
    overSquares += std::uint64_t{judgement.difference.over} * judgement.difference.over;
    unexplainedSquares += std::uint64_t{judgement.unexplained} * judgement.unexplained;
    max = std::max(max, judgement.difference.max);
    // A whole number: the order in which threads add does not matter.
    sum += static_cast<std::uint64_t>(
        std::llround(judgement.difference.mean * static_cast<double>(judgement.difference.pixels) * 4));
}

double Tally::deviation(std::size_t count, std::uint64_t squares) const {
    const double n = std::max(scenes, 1);
    const double mean = static_cast<double>(count) / n;
    const double variance = static_cast<double>(squares) / n - mean * mean;
    return scenes == 0 ? 0 : std::sqrt(std::max(variance, 0.0)) * n / static_cast<double>(pixels);
}

double Tally::limitOver(const Rule& rule) const {
    const double most = rule.tolerance == Tolerance::None ? 1 - rule.explainedScene : 1;
    return sampleLimit(1 - rule.share, {scenes, deviation(over, overSquares), most});
}

double Tally::limitUnexplained(const Rule& rule) const {
    return sampleLimit(1 - rule.explained,
                       {scenes, deviation(unexplained, unexplainedSquares), 1 - rule.explainedScene});
}

Verdict Outcome::verdict() const {
    if (!problem.empty() || hasWrongScene || all.shareOver() > all.limitOver(*rule) ||
        all.shareUnexplained() > all.limitUnexplained(*rule))
        return Verdict::Differ;
    if (all.scenes == 0)
        return Verdict::Skipped;
    const bool isMore = all.shareOver() > 1 - rule->share || all.shareUnexplained() > 1 - rule->explained;
    return isMore && areFewScenes(all.scenes) ? Verdict::TooFewScenes : Verdict::Agree;
}

bool PairReport::agrees() const {
    return std::ranges::none_of(outcomes,
                                [](const Outcome& each) { return each.verdict() == Verdict::Differ; });
}

bool Report::compared() const {
    return std::ranges::any_of(pairs, [](const PairReport& pair) {
        return std::ranges::any_of(pair.outcomes, [](const Outcome& each) { return each.all.scenes > 0; });
    });
}

bool Report::agrees() const {
    return compared() && std::ranges::all_of(pairs, &PairReport::agrees);
}

Scene sceneOf(const Feature& feature, unsigned seed, int number) {
    const int state = number / scenesPerState;
    Dice ofState(feature.name, ~seed, state);
    Dice ofValues(feature.name, seed, number);
    return feature.scene(state, ofState, ofValues);
}

std::vector<Case> casesOf(const Selection& selection) {
    std::vector<const Feature*> chosen = selection.features;
    if (chosen.empty()) {
        for (const Feature& feature : features())
            chosen.push_back(&feature);
    }
    const std::vector<int> shares = sharesOf(chosen, selection.scenes);
    std::vector<Case> cases;
    for (std::size_t f = 0; f < chosen.size(); ++f) {
        for (int i = 0; i < shares[f]; ++i)
            cases.push_back({chosen[f], i, sceneOf(*chosen[f], selection.seed, i)});
    }
    return cases;
}

Result<Report> sweep(const SweepOptions& options, const Renderers& renderers) {
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<Case> cases = casesOf(options.selection);
    Outcomes outcomes(options, cases);
    Queue queue;
    // One side of the queue. At its end, in any case, the other side stops waiting for it.
    const auto side = [&](const auto& work) {
        try {
            work();
        } catch (const std::bad_alloc&) {
            outcomes.fail({ErrorCode::TooLarge, N_("not enough memory for the pictures"), {}});
        } catch (const std::exception& error) {
            outcomes.fail({ErrorCode::Driver, Sentence("a renderer failed: {0}", reasonOf(error)), {}});
        }
        queue.close();
    };
    {
        std::vector<std::jthread> comparers;
        side([&] {
            startComparers(comparers, options.threads,
                           [&] { side([&] { compareAll(options, renderers, queue, outcomes); }); });
            std::optional<Comparer> alone; // without a thread: slower, but it works
            if (comparers.empty())
                alone.emplace(options, renderers, outcomes);
            drawAll(options, renderers, cases, outcomes, [&](DrawnCase drawn) {
                if (alone)
                    alone->compare(std::move(drawn));
                else
                    queue.push(std::move(drawn));
            });
        });
    }
    if (options.stop.stop_requested())
        return fail(ErrorCode::Cancelled, "the comparison was stopped");
    if (auto error = outcomes.error())
        return fail(std::move(*error));
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    return Report{options.driver,  options.selection, static_cast<int>(cases.size()),
                  elapsed.count(), outcomes.take(),   {}};
}

} // namespace texplorer::conform
