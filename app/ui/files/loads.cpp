#include "app/ui/files/loads.h"

#include "app/ui/model/session.h"
#include "texplorer/files/file_fingerprint.h"

#include <functional>
#include <set>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;
using Wanted = ImageLoader::Wanted;

/// The missing images that a load needs.
std::set<std::string> missingFiles(const Session& session, const Load& load) {
    if (load.kind == Load::Kind::Reload)
        return {load.file};
    if (load.kind == Load::Kind::Import || load.kind == Load::Kind::SetFile || load.kind == Load::Kind::Used)
        return session.document.images.holds(load.file) ? std::set<std::string>{} : std::set{load.file};
    if (!load.obj.empty())
        return {load.obj};
    std::set<std::string> files(load.added.begin(), load.added.end());
    if (load.kind == Load::Kind::Add)
        std::erase_if(files, [&](const std::string& file) { return session.document.images.holds(file); });
    files.merge(filesOf(load.scene));
    std::erase_if(files, [&](const std::string& file) { return load.images.holds(file); });
    return files;
}

/// The files that a load needs, each with all its notations.
std::vector<std::vector<std::string>> missingBySpelling(const Session& session, const Load& load) {
    std::vector<std::vector<std::string>> missing;
    std::map<FileFingerprint, std::size_t> places;
    for (const std::string& file : missingFiles(session, load)) {
        const std::optional<FileFingerprint> same = fingerprintOf(folderOf(session, load) / file);
        const auto known = same ? places.find(*same) : places.end();
        if (known != places.end()) {
            missing[known->second].push_back(file);
            continue;
        }
        if (same)
            places[*same] = missing.size();
        missing.push_back({file});
    }
    return missing;
}

void cancelThose(Session& session, const std::function<bool(const Load&)>& isMeant) {
    std::erase_if(session.document.loads, [&](const Load& load) {
        const bool cancels = isMeant(load);
        if (cancels)
            cancelWaiting(session, load);
        return cancels;
    });
}

} // namespace

fs::path folderOf(const Session& session, const Load& load) {
    return load.kind == Load::Kind::Scene ? load.images.directory() : session.document.images.directory();
}

void cancelWaiting(Session& session, const Load& load) {
    for (const auto& [ticket, spellings] : load.waits)
        session.services.files->cancel(ticket);
}

void start(Session& session, Load load) {
    const fs::path folder = folderOf(session, load);
    for (std::vector<std::string>& spellings : missingBySpelling(session, load)) {
        const ImageLoader::Ticket ticket = session.services.files->load(folder / spellings.front());
        load.waits[ticket] = std::move(spellings);
    }
    if (load.kind == Load::Kind::Scene) { // the last requested scene is the wanted one
        cancelThose(session, [](const Load& each) { return each.kind == Load::Kind::Scene; });
    }
    session.document.loads.push_back(std::move(load));
}

void cancelLoad(Session& session, Files::Ticket ticket) {
    session.services.files->cancel(ticket);
    if (ticket == session.look.fileView.ticket) {
        session.look.fileView.ticket = 0;
        session.look.fileView.problem = N_("Reading was cancelled.");
    }
    cancelThose(session, [&](const Load& load) { return load.waits.contains(ticket); });
}

void cancelLoads(Session& session) {
    cancelThose(session, [](const Load& /*all*/) { return true; });
}

} // namespace texplorer::ui
