#pragma once

#include "placements/Placements.h"

#include <algorithm>
#include <array>

// The properties of templates that have one value each: their numbers in the database, and their members. The order is that
// of the columns of a world.db (store/Schema.cpp).
namespace limen::placements {

template <class Value>
struct TemplateField {
    std::int64_t property = 0; ///< the column `type` of its table
    Value Template::*member = nullptr;
};

/// Of weenie_properties_d_i_d.
inline constexpr std::array kIdFields{
    TemplateField<std::uint32_t>{1, &Template::setup},
    TemplateField<std::uint32_t>{2, &Template::motionTable},
    TemplateField<std::uint32_t>{6, &Template::paletteBase},
    TemplateField<std::uint32_t>{7, &Template::clothingBase},
    TemplateField<std::uint32_t>{22, &Template::physicsEffects},
    TemplateField<std::uint32_t>{9, &Template::eyesTexture},
    TemplateField<std::uint32_t>{10, &Template::noseTexture},
    TemplateField<std::uint32_t>{11, &Template::mouthTexture},
    TemplateField<std::uint32_t>{12, &Template::plainEyesTexture},
    TemplateField<std::uint32_t>{13, &Template::plainNoseTexture},
    TemplateField<std::uint32_t>{14, &Template::plainMouthTexture},
    TemplateField<std::uint32_t>{15, &Template::hairPalette},
    TemplateField<std::uint32_t>{16, &Template::eyesPalette},
    TemplateField<std::uint32_t>{17, &Template::skinPalette},
    TemplateField<std::uint32_t>{18, &Template::headObject},
    TemplateField<std::uint32_t>{30, &Template::physicsScript},
};

/// Of weenie_properties_int.
inline constexpr std::array kIntFields{
    TemplateField<std::optional<std::int32_t>>{3, &Template::paletteTemplate},
    TemplateField<std::optional<std::int32_t>>{93, &Template::physicsState},
    TemplateField<std::optional<std::int32_t>>{81, &Template::maxGenerated},
    TemplateField<std::optional<std::int32_t>>{82, &Template::initGenerated},
    TemplateField<std::optional<std::int32_t>>{1, &Template::itemType},
    TemplateField<std::optional<std::int32_t>>{4, &Template::clothingPriority},
    TemplateField<std::optional<std::int32_t>>{9, &Template::validLocations},
    TemplateField<std::optional<std::int32_t>>{46, &Template::combatStyle},
    TemplateField<std::optional<std::int32_t>>{52, &Template::parentLocation},
    TemplateField<std::optional<std::int32_t>>{65, &Template::placementPosition},
};

/// Of weenie_properties_float.
inline constexpr std::array kRealFields{
    TemplateField<std::optional<double>>{12, &Template::shade},
    TemplateField<std::optional<double>>{39, &Template::scale},
    TemplateField<std::optional<double>>{76, &Template::translucency},
    TemplateField<std::optional<double>>{43, &Template::generatorRadius},
    TemplateField<std::optional<double>>{77, &Template::scriptIntensity},
};

/// Of weenie_properties_bool.
inline constexpr std::array kBoolFields{
    TemplateField<std::optional<bool>>{2, &Template::open},
    TemplateField<std::optional<bool>>{3, &Template::locked},
    TemplateField<std::optional<bool>>{13, &Template::ethereal},
    TemplateField<std::optional<bool>>{18, &Template::visibility},
    TemplateField<std::optional<bool>>{34, &Template::defaultOpen},
    TemplateField<std::optional<bool>>{35, &Template::defaultLocked},
    TemplateField<std::optional<bool>>{71, &Template::noDraw},
};

/// Sets the member of a property. Properties without a member are ignored.
template <class Fields, class Value>
void setField(const Fields& fields, Template& to, std::int64_t property, const Value& value) {
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [property](const auto& field) { return field.property == property; });
    if (found != fields.end())
        to.*(found->member) = value;
}

} // namespace limen::placements
