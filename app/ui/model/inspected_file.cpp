#include "app/ui/model/inspected_file.h"

#include "app/ui/model/loads.h"
#include "app/ui/model/session.h"

#include <algorithm>
#include <numeric>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

struct WantedFile {
    fs::path path;
    std::shared_ptr<const Bytes> inMemory = nullptr;
};

WantedFile wantedFile(const Session& session) {
    if (!session.window.fileView.chosen.empty())
        return {session.window.fileView.chosen};
    const Texture* texture = boundTexture(session);
    if (!texture || texture->source != SourceKind::File || texture->file.empty())
        return {};
    if (auto bytes = session.document.images.fileInMemory(texture->file))
        return {texture->file, std::move(bytes)};
    return {session.document.images.directory() / texture->file};
}

} // namespace

FieldMap::FieldMap(const Anatomy& anatomy) {
    const std::vector<Field>& fields = anatomy.fields;
    std::vector<std::size_t> order(fields.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Painted from the largest to the smallest, so that a field covers the section that it is part of.
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return fields[i].size; });
    starts_[0] = std::nullopt;
    for (const std::size_t index : order) {
        const Field& field = fields[index];
        const std::size_t begin = field.offset;
        const std::size_t end = begin + std::min(field.size, SIZE_MAX - begin);
        if (begin == end)
            continue;
        const auto after = std::prev(starts_.upper_bound(end))->second; // what goes on behind it
        starts_.erase(starts_.lower_bound(begin), starts_.upper_bound(end));
        starts_[begin] = index;
        starts_[end] = after;
    }
}

std::optional<std::size_t> FieldMap::at(std::size_t offset) const {
    const auto next = starts_.upper_bound(offset);
    return next == starts_.begin() ? std::nullopt : std::prev(next)->second;
}

void receiveInspected(Session& session, Result<ImageLoader::Content> content) {
    InspectedFile& view = session.window.fileView;
    view.ticket = 0;
    if (!content) {
        view.content.reset();
        view.problem = describe(content.error());
        return;
    }
    view.problem.clear();
    view.content = std::get<std::shared_ptr<const DissectedFile>>(std::move(*content));
    view.map = FieldMap(view.content->anatomy);
}

void refreshInspected(Session& session) {
    InspectedFile& view = session.window.fileView;
    if (view.shown.empty())
        return;
    if (view.inMemory)
        return receiveInspected(session, dissectFile(*view.inMemory)); // it is small
    Files& files = session.services.files;
    if (view.ticket != 0)
        files.cancel(view.ticket);
    view.ticket = files.load(view.shown, Files::Wanted::Anatomy);
}

void followFile(Session& session) {
    InspectedFile& view = session.window.fileView;
    WantedFile wanted = wantedFile(session);
    if (wanted.path == view.shown && wanted.inMemory == view.inMemory)
        return;
    if (view.ticket != 0)
        cancelLoad(session, view.ticket);
    InspectedFile next;
    next.chosen = std::move(view.chosen);
    next.shown = std::move(wanted.path);
    next.inMemory = std::move(wanted.inMemory);
    view = std::move(next);
    refreshInspected(session);
}

void lookInto(Session& session, fs::path file) {
    session.window.fileView.chosen = std::move(file);
    session.window.wantedTab = Tab::File;
}

} // namespace texplorer::ui
