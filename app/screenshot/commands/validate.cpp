// Whether files are what they should be, strictly: what a decoder survives is a fault here.

#include "app/screenshot/arguments/input.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/json_text.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/codec/registry.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/obj_scene.h"
#include "texplorer/suite/plan.h"
#include "texplorer/suite/record_json.h"
#include "texplorer/text/json_encoding.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <utility>

namespace texplorer::screenshot {
namespace {

using PlainJson = nlohmann::json;

constexpr std::size_t maxFaults = 100; // of a scene

/// What a file is held to be, and what is wrong with it.
struct Validity {
    std::string file;
    std::string kind; ///< "PNG", "scene", "OBJ", "suite", "run", "output"; empty: it couldn't be told
    std::vector<Error> faults{};
    std::vector<Sentence> remarks{}; ///< what is right and Texplorer doesn't follow
    bool drawn = true;               ///< false: an image that isn't decoded
    bool read = true;                ///< false: standard error says why not

    [[nodiscard]] bool isValid() const { return faults.empty(); }
};

void addOnce(std::vector<Error>& faults, Sentence fault) {
    if (std::ranges::find(faults, fault, &Error::message) == faults.end())
        faults.push_back({ErrorCode::Malformed, std::move(fault), {}});
}

/// Of an image that isn't decoded: what is wrong with it, or why it isn't. What is merely larger than
/// anything that is decoded is looked at without its pixels; what is too large for that as well is a fault.
void addRefusal(ByteView file, const Error& refusal, Validity& validity) {
    if (refusal.code == ErrorCode::TooLarge) {
        DecodeLimits limits;
        limits.maxExtent = 1 << 30;
        limits.maxPixels = limits.maxBytes = std::numeric_limits<std::size_t>::max() / 4;
        limits.pixels = false;
        if (const Result<TextureImage> outline = decodeTexture(file, limits); !outline) {
            const bool isTooLarge = outline.error().code == ErrorCode::TooLarge;
            validity.faults.push_back(isTooLarge ? refusal : outline.error());
            return;
        }
    }
    if (refusal.code == ErrorCode::Malformed)
        validity.faults.push_back(refusal);
    else
        validity.remarks.push_back(refusal.message);
}

/// All that the decoder refuses or notes, and all that looks wrong in a field. What it only doesn't know or
/// hasn't room for is no fault of the file.
Validity validateImage(const std::string& in, ByteView file) {
    Validity validity{in, std::string(recogniseImage(file)->name)};
    DecodeLimits limits;
    limits.everything = true;
    const Result<TextureImage> texture = decodeTexture(file, limits);
    validity.drawn = texture.has_value();
    if (texture)
        validity.remarks = texture->remarks;
    else
        addRefusal(file, texture.error(), validity);
    const Anatomy anatomy = dissect(file);
    const auto isOfField = [&anatomy](const std::string& note) {
        return std::ranges::any_of(anatomy.fields, [&note](const Field& field) {
            return field.wrong.english().find(note) != std::string::npos;
        });
    };
    for (const Sentence& note : texture ? texture->notes : std::vector<Sentence>())
        if (!isOfField(note))
            addOnce(validity.faults, note);
    for (const Field& field : anatomy.fields)
        if (!field.wrong.empty())
            addOnce(validity.faults, Sentence("{0} at {1}: {2}", field.name, field.offset, field.wrong));
    if (!anatomy.damage.empty() && texture) // else the decoder has said it
        addOnce(validity.faults, anatomy.damage);
    return validity;
}

std::string_view wholeText(ByteView file) {
    return {reinterpret_cast<const char*>(file.data()), file.size()};
}

/// Takes away the member that a JSON pointer names, or that has the number it names in its list; false: it
/// can't be done without changing what the others mean.
bool takeAway(PlainJson& document, const std::string& pointer) {
    std::vector<std::string> path;
    for (std::size_t at = 0; at < pointer.size();) {
        const std::size_t end = std::min(pointer.find('/', at + 1), pointer.size());
        std::string part = pointer.substr(at + 1, end - at - 1);
        for (const auto& [escaped, plain] : {std::pair("~1", "/"), std::pair("~0", "~")})
            for (std::size_t i = part.find(escaped); i != std::string::npos; i = part.find(escaped, i + 1))
                part.replace(i, 2, plain);
        path.push_back(std::move(part));
        at = end;
    }
    PlainJson* owner = nullptr;
    PlainJson* at = &document;
    std::string key;
    for (const std::string& part : path) {
        if (at->is_object() && at->contains(part)) {
            owner = at;
            key = part;
            at = &(*at)[part];
            continue;
        }
        std::size_t index = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
        const bool isIndex = error == std::errc() && end == part.data() + part.size();
        if (!at->is_array() || !isIndex || index >= at->size())
            return false;
        if (at->front().is_structured())
            owner = nullptr; // an element less would rename the others
        at = &(*at)[index];
    }
    if (!owner || pointer == "/version")
        return false;
    owner->erase(key);
    return true;
}

/// Whether brackets go deeper than a scene's: nlohmann-json writes by recursion.
bool isTooDeep(std::string_view text) {
    constexpr int maxDepth = 32;
    int depth = 0;
    bool isInText = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"')
            isInText = !isInText;
        else if (isInText && text[i] == '\\')
            ++i;
        else if (!isInText && (text[i] == '{' || text[i] == '['))
            ++depth;
        else if (!isInText && (text[i] == '}' || text[i] == ']'))
            --depth;
        if (depth > maxDepth)
            return true;
    }
    return false;
}

/// Reading a scene ends with its first fault: it is read again without what was at fault, as long as that is
/// a member, and the text is neither long nor deep.
std::vector<Error> sceneFaults(std::string_view text) {
    constexpr std::size_t maxReadBytes = std::size_t{1} << 20;
    std::vector<Error> faults;
    PlainJson document;
    std::string left;
    for (Result<Scene> scene = parseScene(text); !scene; scene = parseScene(left)) {
        faults.push_back(scene.error());
        if (faults.size() == 1 && text.size() <= maxReadBytes && !isTooDeep(text))
            document = PlainJson::parse(text, nullptr, false);
        if (!document.is_object() || faults.size() == maxFaults ||
            !takeAway(document, scene.error().where.text()))
            break;
        left = document.dump(-1, ' ', false, PlainJson::error_handler_t::replace);
    }
    return faults;
}

Validity validateScene(const std::string& in, ByteView file) {
    Validity validity{in, "scene"};
    if (file.size() > maxSceneBytes) {
        validity.faults.push_back(
            {ErrorCode::TooLarge,
             Sentence("at most {0} bytes of a scene are read, it has {1}", maxSceneBytes, file.size()),
             {}});
        return validity;
    }
    validity.faults = sceneFaults(wholeText(file));
    return validity;
}

/// What `texshot test --list` would say of it. Standard input lies in the current folder.
Validity validateSuite(const std::string& in, ByteView file) {
    Validity validity{in, "suite"};
    Result<suite::Suite> read = suite::parseSuite(wholeText(file));
    if (read && !isStandardInput(in))
        read->folder = std::filesystem::path(in).parent_path();
    const Result<suite::Plan> plan =
        read ? suite::planOf({*std::move(read)}) : Result<suite::Plan>(fail(read.error()));
    if (!plan)
        validity.faults.push_back(plan.error());
    return validity;
}

Validity validateRun(const std::string& in, ByteView file) {
    Validity validity{in, "run"};
    if (const Result<suite::RunRecord> run = suite::parseRun(wholeText(file)); !run)
        validity.faults.push_back(run.error());
    return validity;
}

/// What --json prints is valid here where it has a run of tests.
Validity validateOutput(const std::string& in, ByteView file) {
    Validity validity = validateRun(in, file);
    if (!validity.isValid())
        validity.kind = "output";
    return validity;
}

/// Standard input lies in the current folder.
Validity validateObj(const std::string& in, ByteView file) {
    Validity validity{in, "OBJ"};
    if (const Result<MeshFile> read = meshFileIn(file, isStandardInput(in) ? "" : in))
        validity.remarks = read->obj.notes;
    else
        validity.faults.push_back(read.error());
    return validity;
}

/// The keys of an object that is the whole text; what they have is passed over. Of
/// what is longer than a scene may be, the first key: runs are.
std::vector<std::string> topKeys(std::string_view text) {
    if (text.size() > maxSceneBytes) {
        const std::size_t begin = std::min(text.find('"'), text.size() - 1) + 1;
        return {std::string(text.substr(begin, std::min(text.find('"', begin), text.size()) - begin))};
    }
    std::vector<std::string> keys;
    const auto keep = [&keys](int depth, PlainJson::parse_event_t event, PlainJson& parsed) {
        if (depth == 1 && event == PlainJson::parse_event_t::key)
            keys.push_back(parsed.get<std::string>());
        return depth == 0;
    };
    [[maybe_unused]] const PlainJson document =
        PlainJson::parse(text, keep, false); // up to the damage, if any
    return keys;
}

bool beginsAsJson(ByteView file) {
    constexpr std::string_view space = " \t\r\n";
    std::string_view text(reinterpret_cast<const char*>(file.data()),
                          std::min<std::size_t>(file.size(), 4096));
    if (text.starts_with(byteOrderMark))
        text.remove_prefix(byteOrderMark.size());
    text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
    return text.starts_with("{");
}

/// By its content: an image, a scene, a suite, what a run wrote, or nothing that is known. A name that ends
/// in .json promises a scene, one in .obj meshes.
Validity validate(const std::string& in, ByteView file) {
    if (recogniseImage(file) != nullptr)
        return validateImage(in, file);
    if (beginsAsJson(file) || in.ends_with(".json")) {
        const std::vector<std::string> keys = topKeys(wholeText(file));
        const auto has = [&keys](const char* key) { return std::ranges::find(keys, key) != keys.end(); };
        if (has("suite") || in.ends_with(suite::suiteExtension))
            return validateSuite(in, file);
        if (has("texshot"))
            return validateOutput(in, file);
        return has("run") || in.ends_with(".jsonl") ? validateRun(in, file) : validateScene(in, file);
    }
    if (isObjInput(in, file))
        return validateObj(in, file);
    const Error why = decodeTexture(file).error(); // its message has the known formats and what was found
    const std::vector<Sentence>& said = why.message.arguments();
    const Sentence message =
        file.empty() ? Sentence("expected a scene or an image ({0}), the file is empty", said.at(0))
                     : Sentence("expected a scene or an image ({0}), the file begins with {1}", said.at(0),
                                said.at(1));
    return {.file = in, .kind = {}, .faults = {{why.code, message, {}}}, .drawn = false};
}

Validity validateFile(const std::string& in) {
    const Result<Bytes> file =
        readInput(in, defaultMaxFileBytes, [&in, head = ImageHead()](ByteView start) mutable {
            return head(start) || beginsAsJson(start) || isObjInput(in, start);
        });
    if (!file) {
        static_cast<void>(complain(file.error()));
        return {.file = in, .kind = {}, .faults = {file.error()}, .drawn = false, .read = false};
    }
    return validate(in, *file);
}

std::string validityText(const std::vector<Validity>& all) {
    std::string text;
    for (const Validity& each : all) {
        if (!each.read)
            continue;
        std::string faults;
        for (const Error& fault : each.faults)
            faults += (faults.empty() ? "" : "; ") + printable(describe(fault));
        std::string remarks;
        for (const std::string& remark : each.remarks)
            remarks += (remarks.empty() ? ": " : "; ") + printable(remark);
        text += fmt::format("{}: {}{}\n", printable(inputName(each.file)),
                            each.kind.empty() ? std::string() : each.kind + ", ",
                            !each.isValid() ? "not valid: " + faults
                            : each.drawn    ? "valid" + remarks
                                            : "valid, but not drawn" + remarks);
    }
    return text;
}

std::string validityJson(const std::vector<Validity>& all) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const Validity& each : all) {
        nlohmann::ordered_json faults = nlohmann::ordered_json::array();
        for (const Error& fault : each.faults)
            faults.push_back(problemJson(fault));
        files.push_back({{"file", each.file},
                         {"valid", each.isValid()},
                         {"kind", each.kind},
                         {"drawn", each.drawn},
                         {"faults", std::move(faults)},
                         {"remarks", messagesJson(each.remarks)}});
    }
    return documentText(std::move(files));
}

ExitCode validateAll(const std::vector<std::string>& files, bool json) {
    if (const Result<void> once = checkStandardInputOnce(files); !once)
        return complain(once.error(), wrongCall);
    std::vector<Validity> all;
    for (const std::string& file : files)
        all.push_back(validateFile(file));
    const bool valid = std::ranges::all_of(all, &Validity::isValid);
    const Result<void> printed = print(json ? validityJson(all) : validityText(all));
    if (!printed)
        return complain(printed.error());
    return valid ? success : failure;
}

} // namespace

void addValidate(CommandLine& line) {
    struct Options {
        std::vector<std::string> files;
        bool json = false;
    };
    Command& command =
        line.command("validate", "Check image files, scenes and suites strictly against their formats.");
    auto options = std::make_shared<Options>();
    command.option(
        "FILE", options->files,
        "Images, scenes, OBJ files, suites and the run.json of reports, recognized by their content; - for "
        "standard input.",
        {.required = true});
    command.flag("--json", options->json,
                 "As JSON, for programs: file, valid, kind, drawn, faults and remarks of each file.");
    command.footer(
        "A line for each file on standard output, or on standard error if it can't be read. For an image, "
        "defects that readers recover from are also faults; valid data that Texplorer ignores is mentioned. "
        "For a scene, unknown keys and values out of range are faults, as many as can be found; for a suite, "
        "the first that \"texshot test --list\" finds. Use \"texshot check\" for the meaning of a scene.\n"
        "Exit status: 0 all are valid, 1 one is invalid or can't be read, 2 invalid arguments.");
    command.onCall([options] { return validateAll(options->files, options->json); });
}

} // namespace texplorer::screenshot
