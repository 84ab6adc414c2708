#include "placements/server/ServerUrl.h"

#include <charconv>
#include <optional>

namespace limen::placements {
namespace {

/// The text after the scheme; none for other schemes.
std::optional<std::string> afterScheme(const std::string& text) {
    for (const std::string_view scheme : {"mariadb://", "mysql://"})
        if (text.starts_with(scheme))
            return text.substr(scheme.size());
    return std::nullopt;
}

/// Cuts a text at the first occurrence of a character; returns the second part.
std::optional<std::string> cutAt(std::string& text, char at) {
    const std::size_t found = text.find(at);
    if (found == std::string::npos)
        return std::nullopt;
    std::string rest = text.substr(found + 1);
    text.resize(found);
    return rest;
}

std::string decoded(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned byte = 0;
        const char* const digits = text.data() + i + 1;
        const bool isEscape = text[i] == '%' && i + 2 < text.size();
        if (isEscape && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            plain += static_cast<char>(byte);
            i += 2;
        } else {
            plain += text[i];
        }
    }
    return plain;
}

} // namespace

bool isServerUrl(const std::string& text) {
    return afterScheme(text).has_value();
}

Result<ServerUrl> parseServerUrl(const std::string& text) {
    constexpr const char* kForm = "give mariadb://USER@HOST/DATABASE or mariadb://USER@/DATABASE?socket=PATH";
    const auto refuse = [&](const std::string& what) {
        return fail(ErrorCode::BadArgument, "URL of a database", what);
    };
    const std::optional<std::string> rest = afterScheme(text);
    if (!rest)
        return refuse(kForm);
    std::string place = *rest;
    const std::optional<std::string> query = cutAt(place, '?');
    const std::optional<std::string> database = cutAt(place, '/');
    ServerUrl url;
    std::string host = place;
    if (const std::size_t at = place.rfind('@'); at != std::string::npos) {
        std::string user = place.substr(0, at);
        host = place.substr(at + 1);
        if (cutAt(user, ':'))
            return refuse("other users could read a password here; set MYSQL_PWD or give --option-file FILE");
        url.user = decoded(user);
    }
    if (const std::optional<std::string> port = cutAt(host, ':')) {
        const char* const end = port->data() + port->size();
        const auto read = std::from_chars(port->data(), end, url.port);
        if (read.ec != std::errc() || read.ptr != end || url.port == 0 || url.port > 65535)
            return refuse("the port is not a number from 1 to 65535");
    }
    url.host = decoded(host);
    if (!database || database->empty())
        return refuse(std::string("the name of the database is missing; ") + kForm);
    url.database = decoded(*database);
    if (query) {
        std::string key = *query;
        const std::optional<std::string> value = cutAt(key, '=');
        if (key != "socket" || !value || value->empty())
            return refuse("the only option of the URL is socket=PATH");
        url.socket = decoded(*value);
    }
    return url;
}

} // namespace limen::placements
