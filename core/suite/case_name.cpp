#include "texplorer/suite/case_name.h"

#include "texplorer/suite/hash.h"

#include <algorithm>
#include <vector>

namespace texplorer::suite {
namespace {

constexpr std::size_t hashDigits = 16;
constexpr std::size_t readableBytes = 100; ///< of a name that has to have a hash

bool isAlphanumeric(char each) {
    return (each >= 'a' && each <= 'z') || (each >= 'A' && each <= 'Z') || (each >= '0' && each <= '9');
}

bool isKept(char each) {
    return isAlphanumeric(each) || std::string_view("-_=.,+@").find(each) != std::string_view::npos;
}

/// "…-0123456789abcdef" is what a name with a hash looks like: no other may.
bool looksHashed(std::string_view name) {
    if (name.size() <= hashDigits || name[name.size() - hashDigits - 1] != '-')
        return false;
    return std::ranges::all_of(name.substr(name.size() - hashDigits), [](char each) {
        return (each >= '0' && each <= '9') || (each >= 'a' && each <= 'f');
    });
}

/// Whether "__" for "/" can be read back: no other "_" stands where it could be taken for a part of one.
bool isReadableBack(std::string_view name) {
    if (name.empty() || name.front() == '.' || name.front() == '-' || looksHashed(name))
        return false;
    std::size_t bytes = 0;
    char before = '/';
    for (const char each : name) {
        if (each != '/' && !isKept(each))
            return false;
        const bool isSeam = before == '/' || before == '_';
        if (isSeam && (each == '/' || each == '_'))
            return false;
        bytes += each == '/' ? 2 : 1;
        before = each;
    }
    return before != '/' && bytes <= maxFileNameBytes;
}

struct BracketFit {
    bool fits;
    std::size_t end; ///< behind the "]"; 0: it has none
};

/// `at` is behind the "[".
BracketFit fitBracket(std::string_view glob, std::size_t at, char found) {
    const bool isNegated = at < glob.size() && (glob[at] == '!' || glob[at] == '^');
    std::size_t i = at + (isNegated ? 1 : 0);
    const std::size_t first = i;
    bool isIn = false;
    for (; i < glob.size() && (glob[i] != ']' || i == first); ++i) {
        if (i + 2 < glob.size() && glob[i + 1] == '-' && glob[i + 2] != ']') {
            isIn = isIn || (glob[i] <= found && found <= glob[i + 2]);
            i += 2;
        } else {
            isIn = isIn || glob[i] == found;
        }
    }
    return i < glob.size() ? BracketFit{isIn != isNegated, i + 1} : BracketFit{false, 0};
}

/// How many bytes of the glob a single character of the text uses up; 0: it doesn't fit.
std::size_t fitOne(std::string_view glob, std::size_t at, char found) {
    if (glob[at] == '?')
        return 1;
    if (glob[at] == '[') {
        const BracketFit bracket = fitBracket(glob, at + 1, found);
        if (bracket.end > 0)
            return bracket.fits ? bracket.end - at : 0;
    }
    if (glob[at] == '\\' && at + 1 < glob.size())
        return glob[at + 1] == found ? 2 : 0;
    return glob[at] == found ? 1 : 0;
}

} // namespace

std::string fileNameFor(std::string_view name) {
    std::string file;
    if (isReadableBack(name)) {
        for (const char each : name)
            file += each == '/' ? std::string("__") : std::string(1, each);
        return file;
    }
    for (const char each : name.substr(0, readableBytes)) {
        const bool isSafe = isKept(each) && (!file.empty() || isAlphanumeric(each));
        if (isSafe && each != '_')
            file += each;
        else if (!file.empty() && file.back() != '_')
            file += '_';
    }
    return (file.empty() ? "case" : file) + "-" + hashOf(name).substr(0, hashDigits);
}

std::string driverSlug(std::string_view rendererString) {
    if (rendererString.empty())
        return "reference";
    std::string_view name = rendererString.substr(0, rendererString.find(" ("));
    name = name.substr(0, name.find('/'));
    std::string slug;
    for (const char each : name.substr(0, readableBytes)) {
        if (isAlphanumeric(each) ||
            (!slug.empty() && std::string_view("-.+").find(each) != std::string_view::npos))
            slug += each;
        else if (!slug.empty() && slug.back() != '_')
            slug += '_';
    }
    while (slug.ends_with('_'))
        slug.pop_back();
    return slug.empty() ? "driver-" + hashOf(rendererString).substr(0, hashDigits) : slug;
}

bool fitsGlob(std::string_view glob, std::string_view text) {
    // Where it goes on after the last "*", should what follows not fit: no "*" before it need be tried again.
    std::size_t star = std::string_view::npos;
    std::size_t starText = 0;
    std::size_t g = 0;
    std::size_t t = 0;
    while (t < text.size()) {
        if (g < glob.size() && glob[g] == '*') {
            star = g++;
            starText = t;
            continue;
        }
        const std::size_t used = g < glob.size() ? fitOne(glob, g, text[t]) : 0;
        if (used > 0) {
            g += used;
            ++t;
        } else if (star != std::string_view::npos) {
            g = star + 1;
            t = ++starText;
        } else {
            return false;
        }
    }
    return glob.find_first_not_of('*', g) == std::string_view::npos;
}

bool isWanted(std::string_view pattern, std::string_view name) {
    if (fitsGlob(pattern, name))
        return true;
    for (std::size_t slash = name.find('/'); slash != std::string_view::npos;
         slash = name.find('/', slash + 1)) {
        if (fitsGlob(pattern, name.substr(0, slash)))
            return true;
    }
    return false;
}

} // namespace texplorer::suite
