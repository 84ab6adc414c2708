#include "viewer/DisplayLoss.h"

namespace limen::viewer {

/// The desktop of Windows does not vanish while a program of the session runs.
void noteDisplayLoss(bool&) {}

} // namespace limen::viewer
