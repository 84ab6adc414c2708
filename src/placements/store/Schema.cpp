#include "placements/store/Schema.h"

namespace limen::placements {

const char* const kSchema = R"(
CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE landblock(id INTEGER PRIMARY KEY, hash INTEGER NOT NULL);
CREATE TABLE placement(
    landblock INTEGER NOT NULL, guid INTEGER NOT NULL, template INTEGER NOT NULL, cell INTEGER NOT NULL,
    x REAL NOT NULL, y REAL NOT NULL, z REAL NOT NULL,
    qw REAL NOT NULL, qx REAL NOT NULL, qy REAL NOT NULL, qz REAL NOT NULL,
    is_link_child INTEGER NOT NULL, PRIMARY KEY(landblock, guid)) WITHOUT ROWID;
CREATE INDEX placement_guid ON placement(guid);
CREATE INDEX placement_template ON placement(template);
CREATE TABLE link(
    landblock INTEGER NOT NULL, parent INTEGER NOT NULL, child INTEGER NOT NULL,
    PRIMARY KEY(landblock, parent, child)) WITHOUT ROWID;
CREATE TABLE template(
    id INTEGER PRIMARY KEY, hash INTEGER NOT NULL,
    class_name TEXT NOT NULL, type INTEGER NOT NULL, name TEXT NOT NULL,
    setup INTEGER NOT NULL, motion_table INTEGER NOT NULL, palette_base INTEGER NOT NULL,
    clothing_base INTEGER NOT NULL, physics_effects INTEGER NOT NULL,
    eyes_texture INTEGER NOT NULL, nose_texture INTEGER NOT NULL, mouth_texture INTEGER NOT NULL,
    plain_eyes_texture INTEGER NOT NULL, plain_nose_texture INTEGER NOT NULL,
    plain_mouth_texture INTEGER NOT NULL, hair_palette INTEGER NOT NULL, eyes_palette INTEGER NOT NULL,
    skin_palette INTEGER NOT NULL, head_object INTEGER NOT NULL, physics_script INTEGER NOT NULL,
    palette_template INTEGER, physics_state INTEGER, max_generated INTEGER, init_generated INTEGER,
    item_type INTEGER, clothing_priority INTEGER, valid_locations INTEGER, combat_style INTEGER,
    parent_location INTEGER, placement_position INTEGER,
    shade REAL, scale REAL, translucency REAL, generator_radius REAL, script_intensity REAL,
    open INTEGER, locked INTEGER, ethereal INTEGER, visibility INTEGER, default_open INTEGER,
    default_locked INTEGER, no_draw INTEGER);
CREATE TABLE template_palette(
    template INTEGER NOT NULL, number INTEGER NOT NULL, palette INTEGER NOT NULL, first INTEGER NOT NULL,
    length INTEGER NOT NULL, PRIMARY KEY(template, number)) WITHOUT ROWID;
CREATE TABLE template_texture(
    template INTEGER NOT NULL, number INTEGER NOT NULL, part INTEGER NOT NULL, old INTEGER NOT NULL,
    new INTEGER NOT NULL, PRIMARY KEY(template, number)) WITHOUT ROWID;
CREATE TABLE template_part(
    template INTEGER NOT NULL, number INTEGER NOT NULL, part INTEGER NOT NULL, model INTEGER NOT NULL,
    PRIMARY KEY(template, number)) WITHOUT ROWID;
CREATE TABLE template_item(
    template INTEGER NOT NULL, number INTEGER NOT NULL, destination INTEGER NOT NULL, item INTEGER NOT NULL,
    palette INTEGER NOT NULL, shade REAL NOT NULL, PRIMARY KEY(template, number)) WITHOUT ROWID;
CREATE TABLE template_generator(
    template INTEGER NOT NULL, number INTEGER NOT NULL, probability REAL NOT NULL, made INTEGER NOT NULL,
    init_create INTEGER NOT NULL, max_create INTEGER NOT NULL, when_create INTEGER NOT NULL,
    where_create INTEGER NOT NULL, palette INTEGER, shade REAL,
    cell INTEGER, x REAL, y REAL, z REAL, qw REAL, qx REAL, qy REAL, qz REAL,
    PRIMARY KEY(template, number)) WITHOUT ROWID;
CREATE TABLE template_destination(
    template INTEGER PRIMARY KEY, cell INTEGER NOT NULL, x REAL NOT NULL, y REAL NOT NULL, z REAL NOT NULL,
    qw REAL NOT NULL, qx REAL NOT NULL, qy REAL NOT NULL, qz REAL NOT NULL);
)";

} // namespace limen::placements
