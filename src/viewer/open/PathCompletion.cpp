#include "viewer/open/PathCompletion.h"

#include "core/AbsolutePath.h"
#include "core/platform/Files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace limen::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMatches = 200;

/// The longest text with which all matches begin.
std::string commonStart(const std::vector<std::string>& texts) {
    std::string common = texts.front();
    for (const std::string& text : texts) {
        const auto [end, ignored] = std::mismatch(common.begin(), common.end(), text.begin(), text.end());
        common.erase(end, common.end());
    }
    return common;
}

} // namespace

std::string expandHome(const std::string& typed, const std::string& home) {
    const auto first = typed.find_first_not_of(" \t"), last = typed.find_last_not_of(" \t\r\n");
    if (first == std::string::npos)
        return {};
    std::string text = typed.substr(first, last - first + 1);
    if (text[0] == '~' && (text.size() == 1 || text[1] == '/') && !home.empty())
        return home + text.substr(1);
    return fs::path(text).generic_string(); // '/' also where the system writes another separator
}

std::string parentOf(const std::string& typed, const std::string& home) {
    std::string text = expandHome(typed, home);
    while (text.size() > 1 && text.back() == '/')
        text.pop_back();
    const std::size_t slash = text.rfind('/');
    return slash == std::string::npos ? "/" : text.substr(0, slash + 1);
}

PathCompletion completeDirectory(const std::string& typed, const std::string& home) {
    const std::string text = expandHome(typed, home);
    PathCompletion completion{text, {}};
    const std::size_t slash = text.rfind('/');
    if (slash == std::string::npos)
        return completion;
    const std::string directory = text.substr(0, slash + 1), begun = text.substr(slash + 1);
    std::error_code error;
    for (fs::directory_iterator it(directory, error), end; !error && it != end; it.increment(error)) {
        if (!platform::isText(it->path()))
            continue; // it cannot be typed
        const std::string name = it->path().filename().string();
        std::error_code ignored;
        if (name.starts_with(begun) && (name[0] != '.' || begun.starts_with('.')) &&
            it->is_directory(ignored))
            completion.matches.push_back(directory + name);
    }
    std::sort(completion.matches.begin(), completion.matches.end());
    if (!completion.matches.empty()) {
        completion.text = commonStart(completion.matches);
        if (completion.matches.size() == 1)
            completion.text += '/';
    }
    if (completion.matches.size() > kMostMatches)
        completion.matches.resize(kMostMatches);
    return completion;
}

bool looksLikeWorld(const std::string& directory) {
    std::error_code error;
    for (fs::directory_iterator it(directory, error), end; !error && it != end; it.increment(error)) {
        if (!platform::isText(it->path()))
            continue;
        std::string name = it->path().filename().string();
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        if (name == "client_portal.dat")
            return true;
    }
    return false;
}

std::string directoryOfDrop(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) ? path.parent_path().string() : path.string();
}

std::string absoluteDirectory(const std::string& directory) {
    if (directory.empty())
        return {};
    const fs::path whole = absolutePath(directory).lexically_normal();
    const bool endsWithSeparator = !whole.has_filename() && whole.has_relative_path();
    return (endsWithSeparator ? whole.parent_path() : whole).string();
}

std::string nameOfWorld(const std::string& directory) {
    return directory.empty() ? "the built-in world" : directory;
}

} // namespace limen::viewer
