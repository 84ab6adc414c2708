#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace limen::viewer {

/// A key, by its position on the keyboard. The numbers are GLFW's; Window.cpp checks them against GLFW's
/// header.
enum class KeyCode : std::uint16_t {};

struct KeyName {
    KeyCode code{};
    std::string_view name; ///< its label on a US keyboard
};

inline constexpr std::array kKeyNames = [] {
    constexpr auto key = [](int code, std::string_view name) {
        return KeyName{static_cast<KeyCode>(code), name};
    };
    return std::array{key(32, "Space"),
                      key(39, "'"),
                      key(44, ","),
                      key(45, "-"),
                      key(46, "."),
                      key(47, "/"),
                      key(48, "0"),
                      key(49, "1"),
                      key(50, "2"),
                      key(51, "3"),
                      key(52, "4"),
                      key(53, "5"),
                      key(54, "6"),
                      key(55, "7"),
                      key(56, "8"),
                      key(57, "9"),
                      key(59, ";"),
                      key(61, "="),
                      key(65, "A"),
                      key(66, "B"),
                      key(67, "C"),
                      key(68, "D"),
                      key(69, "E"),
                      key(70, "F"),
                      key(71, "G"),
                      key(72, "H"),
                      key(73, "I"),
                      key(74, "J"),
                      key(75, "K"),
                      key(76, "L"),
                      key(77, "M"),
                      key(78, "N"),
                      key(79, "O"),
                      key(80, "P"),
                      key(81, "Q"),
                      key(82, "R"),
                      key(83, "S"),
                      key(84, "T"),
                      key(85, "U"),
                      key(86, "V"),
                      key(87, "W"),
                      key(88, "X"),
                      key(89, "Y"),
                      key(90, "Z"),
                      key(91, "["),
                      key(92, "\\"),
                      key(93, "]"),
                      key(96, "`"),
                      key(256, "Escape"),
                      key(257, "Enter"),
                      key(258, "Tab"),
                      key(259, "Backspace"),
                      key(260, "Insert"),
                      key(261, "Delete"),
                      key(262, "Right"),
                      key(263, "Left"),
                      key(264, "Down"),
                      key(265, "Up"),
                      key(266, "PageUp"),
                      key(267, "PageDown"),
                      key(268, "Home"),
                      key(269, "End"),
                      key(280, "CapsLock"),
                      key(281, "ScrollLock"),
                      key(282, "NumLock"),
                      key(283, "PrintScreen"),
                      key(284, "Pause"),
                      key(290, "F1"),
                      key(291, "F2"),
                      key(292, "F3"),
                      key(293, "F4"),
                      key(294, "F5"),
                      key(295, "F6"),
                      key(296, "F7"),
                      key(297, "F8"),
                      key(298, "F9"),
                      key(299, "F10"),
                      key(300, "F11"),
                      key(301, "F12"),
                      key(320, "Keypad0"),
                      key(321, "Keypad1"),
                      key(322, "Keypad2"),
                      key(323, "Keypad3"),
                      key(324, "Keypad4"),
                      key(325, "Keypad5"),
                      key(326, "Keypad6"),
                      key(327, "Keypad7"),
                      key(328, "Keypad8"),
                      key(329, "Keypad9"),
                      key(330, "KeypadDecimal"),
                      key(331, "KeypadDivide"),
                      key(332, "KeypadMultiply"),
                      key(333, "KeypadMinus"),
                      key(334, "KeypadPlus"),
                      key(335, "KeypadEnter"),
                      key(336, "KeypadEqual"),
                      key(340, "LeftShift"),
                      key(341, "LeftControl"),
                      key(342, "LeftAlt"),
                      key(343, "LeftSuper"),
                      key(344, "RightShift"),
                      key(345, "RightControl"),
                      key(346, "RightAlt"),
                      key(347, "RightSuper"),
                      key(348, "Menu")};
}();

/// Ignores case. nullopt: no key has this name.
[[nodiscard]] constexpr std::optional<KeyCode> keyNamed(std::string_view name) {
    const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; };
    for (const KeyName& key : kKeyNames) {
        bool same = key.name.size() == name.size();
        for (std::size_t i = 0; same && i < name.size(); ++i)
            same = upper(key.name[i]) == upper(name[i]);
        if (same)
            return key.code;
    }
    return std::nullopt;
}

/// The name of a key; empty if it has none and cannot be bound.
[[nodiscard]] constexpr std::string_view nameOf(KeyCode code) {
    for (const KeyName& key : kKeyNames)
        if (key.code == code)
            return key.name;
    return {};
}

} // namespace limen::viewer
