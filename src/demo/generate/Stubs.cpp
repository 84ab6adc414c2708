#include "demo/generate/Kinds.h"
namespace limen::demo {
WorldRecords buildTerrainWorld(const GeneratedSpec&) { return {}; }
}
