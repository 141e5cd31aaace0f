package robotran.ui.program.blocks.dialogs

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.key.utf16CodePoint

/**
 * A number while it is typed.
 *
 * @property text what was typed; null before the first key, which begins a new number.
 */
internal data class TypedNumber(val text: String?) {
    /** The number as Robolang writes it; null while it is incomplete. */
    val number: String? get() = text?.takeIf { COMPLETE.matches(it) }

    /**
     * This number after the key [sign]: a digit, `.`, `-`, or [ERASE].
     *
     * @param now what the program has, which `-` and [ERASE] change if nothing was typed yet.
     */
    fun with(sign: Char, now: String): TypedNumber {
        val before = text ?: now
        return when (sign) {
            ERASE -> TypedNumber(before.dropLast(1))
            '-' -> TypedNumber(if (before.startsWith("-")) before.drop(1) else "-$before")
            '.' -> if (text?.contains('.') == true) this else TypedNumber((text ?: "0").ifEmpty { "0" } + ".")
            else -> if (text.orEmpty().length < MAX_LENGTH) TypedNumber(joined(text.orEmpty(), sign)) else this
        }
    }

    private fun joined(digits: String, digit: Char): String = when (digits) {
        "0" -> "$digit"
        "-0" -> "-$digit"
        else -> digits + digit
    }

    companion object {
        /** Deletes the last sign. */
        const val ERASE = '⌫'
        private val COMPLETE = Regex("-?\\d+(\\.\\d+)?")
        private const val MAX_LENGTH = 8
    }
}

/** The keys of a keyboard while a number is edited. */
internal class NumberKeys(
    private val typed: TypedNumber,
    private val now: String,
    private val onTyped: (TypedNumber) -> Unit,
    private val onStep: (Int) -> Unit,
    private val onClose: () -> Unit,
) {
    /** Whether [event] was a key for the number. */
    fun handle(event: KeyEvent): Boolean {
        if (event.type != KeyEventType.KeyDown) return false
        if (event.isCtrlPressed || event.isAltPressed || event.isMetaPressed) return false
        when (event.key) {
            Key.DirectionUp -> onStep(1)
            Key.DirectionDown -> onStep(-1)
            Key.Enter, Key.NumPadEnter, Key.Escape -> onClose()
            Key.Backspace, Key.Delete -> onTyped(typed.with(TypedNumber.ERASE, now))
            else -> onTyped(typed.with(signOf(event) ?: return false, now))
        }
        return true
    }

    private fun signOf(event: KeyEvent): Char? = when (val sign = event.utf16CodePoint.toChar()) {
        in '0'..'9', '-', '.' -> sign
        ',' -> '.'
        else -> DIGITS[event.key]
    }

    private companion object {
        /** For keyboards whose keys say no character. */
        val DIGITS: Map<Key, Char> = listOf(
            Key.Zero,
            Key.One,
            Key.Two,
            Key.Three,
            Key.Four,
            Key.Five,
            Key.Six,
            Key.Seven,
            Key.Eight,
            Key.Nine,
        ).withIndex().associate { (digit, key) -> key to '0' + digit }
    }
}
