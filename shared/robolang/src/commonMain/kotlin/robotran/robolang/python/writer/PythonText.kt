package robotran.robolang.python.writer

import robotran.robolang.robot.roundAsPython

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

/** [figure] with at most three digits behind its point, and none that says nothing. */
internal fun decimalFigure(figure: Double): String {
    val thousandths = roundAsPython(figure * THOUSAND)
    val whole = thousandths / THOUSAND
    val rest = "${thousandths % THOUSAND}".padStart(DIGITS, '0').trimEnd('0')
    return if (rest.isEmpty()) "$whole" else "$whole.$rest"
}

private const val THOUSAND = 1000
private const val DIGITS = 3
