#include "core/Error.h"

#include <utility>

namespace limen {

std::string Error::message() const {
    return where.empty() ? what : where + ": " + what;
}

Failure fail(ErrorCode code, std::string where, std::string what) {
    return Failure(Error{code, std::move(where), std::move(what)});
}

} // namespace limen
