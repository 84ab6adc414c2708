#include "demo/generate/Kinds.h"
namespace limen::demo {
WorldRecords buildTown(const GeneratedSpec&) { return {}; }
WorldRecords buildTerrainWorld(const GeneratedSpec&) { return {}; }
}
