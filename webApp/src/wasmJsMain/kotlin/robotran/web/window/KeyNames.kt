package robotran.web.window

import androidx.compose.ui.input.key.Key

/**
 * The key for [key], or, if that is unknown, such as on a Cyrillic keyboard, the key at the position [code].
 *
 * Both are values of the browser's keyboard events (UI Events KeyboardEvent key and code Values).
 */
internal fun keyOf(key: String, code: String): Key = NUMBER_PAD[code]?.takeIf { key.length == 1 || key == "Enter" }
    ?: RIGHT[code]
    ?: NAMED[key]
    ?: key.singleOrNull()?.let { signKey(it) }
    ?: code.removePrefix("Key").singleOrNull()?.let { signKey(it) }
    ?: Key.Unknown

private fun signKey(sign: Char): Key? = when (sign) {
    in 'a'..'z' -> Key(sign.uppercaseChar().code.toLong())
    in 'A'..'Z', in '0'..'9' -> Key(sign.code.toLong())
    else -> SIGNS[sign]
}

private val SIGNS = mapOf(
    ' ' to Key.Spacebar,
    '/' to Key.Slash,
    '\\' to Key.Backslash,
    '+' to Key.Plus,
    '-' to Key.Minus,
    '=' to Key.Equals,
    '.' to Key.Period,
    ',' to Key.Comma,
    ';' to Key.Semicolon,
    '[' to Key.LeftBracket,
    ']' to Key.RightBracket,
    '`' to Key.Grave,
)

private val NAMED = mapOf(
    "ArrowLeft" to Key.DirectionLeft,
    "ArrowRight" to Key.DirectionRight,
    "ArrowUp" to Key.DirectionUp,
    "ArrowDown" to Key.DirectionDown,
    "Home" to Key.MoveHome,
    "End" to Key.MoveEnd,
    "PageUp" to Key.PageUp,
    "PageDown" to Key.PageDown,
    "Enter" to Key.Enter,
    "Tab" to Key.Tab,
    "Backspace" to Key.Backspace,
    "Delete" to Key.Delete,
    "Insert" to Key.Insert,
    "Escape" to Key.Escape,
    "Shift" to Key.ShiftLeft,
    "Control" to Key.CtrlLeft,
    "Alt" to Key.AltLeft,
    "Meta" to Key.MetaLeft,
    "CapsLock" to Key.CapsLock,
    "F1" to Key.F1,
    "F2" to Key.F2,
    "F3" to Key.F3,
    "F4" to Key.F4,
    "F5" to Key.F5,
    "F6" to Key.F6,
    "F7" to Key.F7,
    "F8" to Key.F8,
    "F9" to Key.F9,
    "F10" to Key.F10,
    "F11" to Key.F11,
    "F12" to Key.F12,
)

private val RIGHT = mapOf(
    "ShiftRight" to Key.ShiftRight,
    "ControlRight" to Key.CtrlRight,
    "MetaRight" to Key.MetaRight,
)

private val NUMBER_PAD = mapOf(
    "Numpad0" to Key.NumPad0,
    "Numpad1" to Key.NumPad1,
    "Numpad2" to Key.NumPad2,
    "Numpad3" to Key.NumPad3,
    "Numpad4" to Key.NumPad4,
    "Numpad5" to Key.NumPad5,
    "Numpad6" to Key.NumPad6,
    "Numpad7" to Key.NumPad7,
    "Numpad8" to Key.NumPad8,
    "Numpad9" to Key.NumPad9,
    "NumpadAdd" to Key.NumPadAdd,
    "NumpadSubtract" to Key.NumPadSubtract,
    "NumpadMultiply" to Key.NumPadMultiply,
    "NumpadDivide" to Key.NumPadDivide,
    "NumpadDecimal" to Key.NumPadDot,
    "NumpadEnter" to Key.NumPadEnter,
)
