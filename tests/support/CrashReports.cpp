// Each test program reports a crash of itself (core/platform/CrashReport.h).
#include "core/platform/CrashReport.h"

namespace {

[[maybe_unused]] const bool isReporting = [] {
    limen::platform::reportCrashes("test");
    return true;
}();

} // namespace
