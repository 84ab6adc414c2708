#pragma once

#include "dat/Archive.h"
#include "doctor/retail/Census.h"
#include "doctor/retail/Ledger.h"

// The judges, one for each area: each compares its table of facts with decoded records. A table stands in the file of
// its judge.
namespace limen::doctor {

/// Headers, indices and free lists (ids "container...").
void judgeContainer(const dat::Archive& archive, const Census& census, Ledger& ledger);
/// Counts over all records ("count...").
void judgeCounts(const Census& census, Ledger& ledger);
/// Surfaces and their pictures ("surface...").
void judgeSurfaces(const dat::Archive& archive, Ledger& ledger);
/// Levels of detail, never-drawn markers, lamps, the player's body, the openings of a cottage ("model...").
void judgeModels(const dat::Archive& archive, Ledger& ledger);
/// Heights, texture merging, terrain types, named landblocks ("land...").
void judgeLand(const dat::Archive& archive, Ledger& ledger);
/// Calendar and day groups ("calendar...").
void judgeCalendar(const dat::Archive& archive, Ledger& ledger);
/// Sky objects and keyframes ("sky...").
void judgeSky(const dat::Archive& archive, Ledger& ledger);
/// Named cells and shapes, the training academy, Holtburg ("cell...").
void judgeCells(const dat::Archive& archive, Ledger& ledger);
/// Known places and the ground under them ("place...").
void judgePlaces(const dat::Archive& archive, Ledger& ledger);
/// Scripts of the sky and of the weather ("effect...").
void judgeEffects(const dat::Archive& archive, Ledger& ledger);
/// Rules that need no files: random numbers, splits, roads, keys ("rule...").
void judgeRules(Ledger& ledger);

} // namespace limen::doctor
