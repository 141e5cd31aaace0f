package robotran.editing

/**
 * The format of a number.
 *
 * @property isPercent whether to display it multiplied by a hundred.
 * @property step step of the displayed value for buttons.
 * @property slider the usual range of the displayed value; null for no slider.
 */
class NumberSpec(
    val range: ClosedRange<Double>,
    val isWhole: Boolean = false,
    val isPercent: Boolean = false,
    val step: Double = 1.0,
    val unit: String = "",
    val slider: ClosedRange<Double>? = null,
) {
    constructor(range: IntRange, step: Double = 1.0, unit: String = "", slider: ClosedRange<Double>? = null) :
        this(range.first.toDouble()..range.last.toDouble(), isWhole = true, step = step, unit = unit, slider = slider)
}

/**
 * The format of a text.
 *
 * @property maximum max number of characters.
 */
class TextSpec(val maximum: Int, val kind: TextKind = TextKind.LINE, val mayBeBlank: Boolean = false) {
    fun accepts(text: String): Boolean =
        kind == TextKind.PROGRAM || isValidText(text, maximum, mayBeBlank, severalLines = kind == TextKind.PROSE)
}

enum class TextKind {
    LINE,

    /** Several lines. */
    PROSE,

    /** Several lines of anything; whoever takes it checks it. */
    PROGRAM,
}

/** Whether a file can hold [text] in one line, or in several if [severalLines]. */
fun isValidText(text: String, maximum: Int, mayBeBlank: Boolean = false, severalLines: Boolean = false): Boolean =
    (mayBeBlank || text.isNotBlank()) && text.length <= maximum && hasNoUnpairedSurrogate(text) &&
        text.none { it.isISOControl() && !(severalLines && it == '\n') }

/** Whether there is no unpaired surrogate, which UTF-8 cannot encode. */
fun hasNoUnpairedSurrogate(text: String): Boolean {
    var place = 0
    while (place < text.length) {
        val isPair = text[place].isHighSurrogate() && place + 1 < text.length && text[place + 1].isLowSurrogate()
        if (text[place].isSurrogate() && !isPair) return false
        place += if (isPair) 2 else 1
    }
    return true
}
