#include "visibility/VisibleSet.h"

namespace limen::visibility {

void VisibleSet::clear() {
    visits.clear();
    regionVertices.clear();
    seen.clear();
    counts = {};
}

} // namespace limen::visibility
