package robotran.robolang.python

/** An expression of Python with the precedence of its outermost operator. */
internal class PythonText(val text: String, val strength: Int) {
    /** It, in brackets unless it binds at least as tightly as [wanted]. */
    fun atLeast(wanted: Int): String = if (strength < wanted) "($text)" else text
}

internal fun primary(text: String) = PythonText(text, PythonStrength.PRIMARY)

/**
 * How tightly the operators of Python bind; those of two values bind as in Robolang.
 *
 * Comparisons form chains in Python: `a < b == c` is `a < b and b == c`.
 */
internal object PythonStrength {
    const val LOOSEST = 0
    const val NOT = 3
    const val COMPARISON = 4
    const val SUM = 5
    const val PRODUCT = 6
    const val UNARY = 7
    const val AWAIT = 8
    const val PRIMARY = 9
}

/** [text] as a text of Python. */
internal fun pythonString(text: String): String = "\"" + text.replace("\\", "\\\\").replace("\"", "\\\"") + "\""

/** The whole number next to [value], the even one of two, as Python's `round` has it. */
internal fun roundAsPython(value: Double): Long {
    val below = kotlin.math.floor(value)
    val rest = value - below
    val isUp = rest > HALF || (rest == HALF && below % 2 != 0.0)
    return below.toLong() + if (isUp) 1 else 0
}

private const val HALF = 0.5
