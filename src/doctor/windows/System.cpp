#include "doctor/Machine.h"

#include <fmt/format.h>
#include <windows.h>

namespace limen::doctor {

DisplayFacts queryDisplay() {
    DisplayFacts facts;
    facts.desktop = fmt::format("the desktop of Windows, {}x{} pixels", GetSystemMetrics(SM_CXSCREEN),
                                GetSystemMetrics(SM_CYSCREEN));
    return facts;
}

SystemWords systemWords() {
    return {"unpack the whole archive again: fonts\\DejaVuSans.ttf belongs beside limen.exe",
            "put ffmpeg.exe into a directory of PATH (optional)"};
}

} // namespace limen::doctor
