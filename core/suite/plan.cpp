#include "texplorer/suite/plan.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/lesson/lesson_scene.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/suite/case_name.h"
#include "texplorer/suite/case_scene.h"
#include "texplorer/suite/hash.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace texplorer::suite {
namespace {

constexpr std::size_t shownPlaceBytes = 200;
constexpr std::size_t shownValueBytes = 64; ///< of an axis' value in a case's name

std::size_t product(std::size_t a, std::size_t b) {
    constexpr std::size_t max = std::numeric_limits<std::size_t>::max();
    return b != 0 && a > max / b ? max : a * b;
}

std::size_t sum(std::size_t a, std::size_t b) {
    return a > std::numeric_limits<std::size_t>::max() - b ? std::numeric_limits<std::size_t>::max() : a + b;
}

/// A scene of an entry, with what it goes through.
struct Row {
    std::size_t suite;
    std::size_t entry;
    std::size_t scene;
    std::vector<SweepAxis> axes;
    std::optional<Error> problem;
};

const std::vector<RendererKind>& renderersOf(const Settings& settings, const PlanOptions& options) {
    return options.renderers.empty() ? settings.renderers : options.renderers;
}

std::size_t casesOf(const Row& row, const Settings& settings, const PlanOptions& options) {
    std::size_t count =
        product(renderersOf(settings, options).size(), product(settings.sizes.size(), settings.times.size()));
    for (const SweepAxis& axis : row.axes)
        count = product(count, axis.values.size());
    return count;
}

Location placeOfEntry(const Suite& suite, std::size_t entry) {
    return atName(printable(suite.name)) / atPointer(fmt::format("/cases/{}", entry));
}

/// What a path says that isn't one is as long as the suite has it.
Error inEntry(const Suite& suite, std::size_t entry, const Error& error) {
    Location place = placeOfEntry(suite, entry);
    for (Location::Step step : error.where.steps()) {
        step.text = printable(std::string_view(step.text).substr(0, shownPlaceBytes));
        place = place / Location(std::move(step));
    }
    return {error.code, error.message, place};
}

/// A scene's axes. A scene that can't be read is no error: its cases say so.
Result<Row> readRow(const std::vector<Suite>& suites, std::size_t s, std::size_t e, std::size_t i) {
    const Suite& suite = suites[s];
    const Entry& entry = suite.entries[e];
    Row row{s, e, i, {}, {}};
    Result<CaseScene> opened = readScene(suite, entry.scenes[i]);
    if (!opened) {
        row.problem = opened.error();
        return row;
    }
    if (const Result<void> made = makeEdits(opened->scene, entry.edits, "/set"); !made)
        return fail(inEntry(suite, e, made.error()));
    for (std::size_t a = 0; a < entry.axes.size(); ++a) {
        Result<SweepAxis> axis = parseSweepAxis(opened->scene, entry.axes[a]);
        const Location place = atPointer(fmt::format("/axis/{}", a));
        if (!axis)
            return fail(inEntry(suite, e, within(place, axis.error())));
        if (std::ranges::find(row.axes, axis->path, &SweepAxis::path) != row.axes.end())
            return fail(
                inEntry(suite, e,
                        {ErrorCode::Malformed, N_("expected each parameter in one axis, found it again"),
                         place / axis->path}));
        row.axes.push_back(*std::move(axis));
    }
    return row;
}

std::string stemOf(std::string_view file) {
    const std::string name = std::filesystem::path(file).filename().string();
    const std::size_t dot = name.rfind(".json");
    return dot != std::string::npos && dot > 0 && dot + 5 == name.size() ? name.substr(0, dot) : name;
}

struct SceneName {
    std::string operator()(const SceneFile& source) const {
        return source.file.empty() ? "default" : stemOf(source.file);
    }
    std::string operator()(const SceneExample& source) const { return source.name; }
    std::string operator()(const SceneInline&) const { return "inline"; }
    std::string operator()(const SceneLesson& source) const {
        const std::string task = source.reached      ? "-reached"
                                 : source.answer > 0 ? fmt::format("-answer-{}", source.answer)
                                                     : std::string();
        return fmt::format("{}-{}{}", source.lesson, source.step, task);
    }
};

std::string nameOf(const Entry& entry, std::size_t scene) {
    const std::string ofScene = std::visit(SceneName{}, entry.scenes[scene]);
    if (entry.name.empty())
        return ofScene;
    return entry.scenes.size() == 1 ? entry.name : fmt::format("{}/{}", entry.name, ofScene);
}

/// "minFilter", or the whole path where two axes end in the same.
std::string_view shortPath(const std::vector<SweepAxis>& axes, const SweepAxis& axis) {
    const auto sameKey = std::ranges::count_if(
        axes, [&](const SweepAxis& each) { return keyOfPath(each.path) == keyOfPath(axis.path); });
    return sameKey > 1 ? std::string_view(axis.path) : keyOfPath(axis.path);
}

std::string shownValue(const std::string& value) {
    return value.size() <= shownValueBytes ? value : hashOf(value).substr(0, 16);
}

/// Makes the cases of one row.
class CaseMaker {
public:
    CaseMaker(Plan& plan, const Row& row, const PlanOptions& options)
        : plan_(plan)
        , row_(row)
        , options_(options)
        , settings_(plan.suites[row.suite].entries[row.entry].settings) {}

    void make() {
        const Suite& suite = plan_.suites[row_.suite];
        prefix_ = plan_.suites.size() > 1 ? printable(suite.name) + "/" : std::string();
        values_.assign(row_.axes.size(), 0);
        const std::string base = printable(nameOf(suite.entries[row_.entry], row_.scene));
        do
            addAll(base);
        while (next());
    }

private:
    /// The last axis goes round first.
    bool next() {
        for (std::size_t a = row_.axes.size(); a-- > 0;) {
            if (++values_[a] < row_.axes[a].values.size())
                return true;
            values_[a] = 0;
        }
        return false;
    }

    void addAll(std::string name) {
        std::vector<Edit> edits;
        for (std::size_t a = 0; a < row_.axes.size(); ++a) {
            const SweepAxis& axis = row_.axes[a];
            const std::string& value = axis.values[values_[a]];
            edits.push_back(edit::Set{axis.path, value});
            name += fmt::format("/{}={}", shortPath(row_.axes, axis), printable(shownValue(value)));
        }
        for (const RendererKind renderer : renderersOf(settings_, options_)) {
            for (const PictureSize size : settings_.sizes) {
                for (const double time : settings_.times)
                    add(name, edits, renderer, size, time);
            }
        }
    }

    void add(const std::string& name, const std::vector<Edit>& edits, RendererKind renderer, PictureSize size,
             double time) {
        const bool isTimed = settings_.times != std::vector<double>{0};
        const std::string when = isTimed ? fmt::format("@{}s", time) : std::string();
        const std::string extent = fmt::format("{}x{}{}", size.width, size.height, when);
        const std::string own = fmt::format("{}/{}@{}", name, rowOf(renderer).name, extent);
        plan_.cases.push_back({.name = prefix_ + own,
                               .file = fileNameFor(prefix_ + own),
                               .goldenName = fileNameFor(own),
                               .pictureName = fileNameFor(fmt::format("{}/{}", name, extent)),
                               .suite = row_.suite,
                               .entry = row_.entry,
                               .scene = row_.scene,
                               .edits = edits,
                               .renderer = renderer,
                               .size = size,
                               .time = time,
                               .problem = row_.problem});
    }

    Plan& plan_;
    const Row& row_;
    const PlanOptions& options_;
    const Settings& settings_;
    std::string prefix_;
    std::vector<std::size_t> values_;
};

/// All rows, as long as their cases are few enough; what is too much is only counted.
Result<std::vector<Row>> rowsOf(const std::vector<Suite>& suites, const PlanOptions& options) {
    std::vector<Row> rows;
    std::size_t count = 0;
    for (std::size_t s = 0; s < suites.size(); ++s) {
        for (std::size_t e = 0; e < suites[s].entries.size(); ++e) {
            for (std::size_t i = 0; i < suites[s].entries[e].scenes.size(); ++i) {
                Result<Row> row = readRow(suites, s, e, i);
                if (!row)
                    return fail(row.error());
                count = sum(count, casesOf(*row, suites[s].entries[e].settings, options));
                if (count <= options.limit)
                    rows.push_back(*std::move(row));
            }
        }
    }
    if (count > options.limit)
        return fail(ErrorCode::TooLarge,
                    Sentence("expected at most {0} cases, found {1}", options.limit, count),
                    suites.size() == 1 ? atName(printable(suites.front().name)) : Location());
    return rows;
}

/// Names are keys of records and files: each may be there once.
Result<void> checkUnique(const Plan& plan) {
    std::unordered_map<std::string_view, const Case*> seen;
    seen.reserve(plan.cases.size());
    for (const Case& each : plan.cases) {
        const auto [found, isNew] = seen.emplace(each.name, &each);
        if (!isNew)
            return fail(
                ErrorCode::Malformed,
                Sentence("two cases are called {0}, this one and one of {1}; give one of them a \"name\"",
                         inQuotes(each.name),
                         placeOfEntry(plan.suiteOf(*found->second), found->second->entry).text()),
                placeOfEntry(plan.suiteOf(each), each.entry));
    }
    return {};
}

Result<void> keepWanted(Plan& plan, const std::vector<std::string>& only) {
    if (only.empty())
        return {};
    std::erase_if(plan.cases, [&](const Case& each) {
        return std::ranges::none_of(only, [&](const std::string& glob) { return isWanted(glob, each.name); });
    });
    if (!plan.cases.empty())
        return {};
    std::string globs;
    for (const std::string& glob : only)
        globs += (globs.empty() ? "" : ", ") + inQuotes(glob);
    return fail(ErrorCode::NotFound, Sentence("no case is called {0}", globs));
}

/// An entry's own were looked at when it was read: the reference against itself always passes.
Result<void> checkRenderers(const std::vector<Suite>& suites, const PlanOptions& options) {
    if (std::ranges::find(options.renderers, RendererKind::Reference) == options.renderers.end())
        return {};
    for (const Suite& suite : suites) {
        for (std::size_t i = 0; i < suite.entries.size(); ++i) {
            if (std::holds_alternative<GoldenReference>(suite.entries[i].settings.golden))
                return fail(ErrorCode::OutOfRange,
                            "the renderer \"reference\" has no effect if it is also the golden: it is "
                            "compared with itself",
                            placeOfEntry(suite, i));
        }
    }
    return {};
}

} // namespace

Result<Plan> planOf(std::vector<Suite> suites, const PlanOptions& options) {
    if (const Result<void> renderers = checkRenderers(suites, options); !renderers)
        return fail(renderers.error());
    const Result<std::vector<Row>> rows = rowsOf(suites, options);
    if (!rows)
        return fail(rows.error());
    Plan plan{std::move(suites), {}};
    for (const Row& row : *rows)
        CaseMaker(plan, row, options).make();
    if (const Result<void> unique = checkUnique(plan); !unique)
        return fail(unique.error());
    if (const Result<void> kept = keepWanted(plan, options.only); !kept)
        return fail(kept.error());
    return plan;
}

std::string fingerprintOf(const Plan& plan) {
    std::vector<std::string_view> names;
    names.reserve(plan.cases.size());
    for (const Case& each : plan.cases)
        names.push_back(each.name);
    std::ranges::sort(names);
    HashedText text;
    for (const std::string_view name : names)
        text.add(name);
    return text.hash();
}

} // namespace texplorer::suite
