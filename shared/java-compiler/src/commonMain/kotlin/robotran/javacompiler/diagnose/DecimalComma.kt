package robotran.javacompiler.diagnose

import robotran.language.source.SourceFix
import robotran.language.source.SourceSpan

/**
 * A number with a comma, such as `1,5`, in a source.
 *
 * @property pointed the number with a point.
 */
internal class DecimalComma(val span: SourceSpan, val pointed: String) {
    /** A fix where a value of the [type] is needed; null where a number with a point does not fit. */
    fun fixFor(type: String, source: SourceText): SourceFix? = when (type) {
        "float" -> SourceFix(source.range(span), pointed + "f")
        "double" -> SourceFix(source.range(span), pointed)
        else -> null
    }
}

private val COMMA = Regex("""(?<![\w.,])(\d+),(\d+)(?![\w.,])""")

/** The first number with a comma that ends behind [start] in its line, and begins at [last] or before; or null. */
internal fun decimalCommaIn(source: SourceText, start: Int, last: Int): DecimalComma? {
    val before = source.lineBefore(start)
    val lineStart = start - before.length
    val found = COMMA.findAll(before + source.codeBehind(start)).firstOrNull { lineStart + it.range.last >= start }
        ?: return null
    val span = SourceSpan(lineStart + found.range.first, lineStart + found.range.last + 1)
    return DecimalComma(span, "${found.groupValues[1]}.${found.groupValues[2]}").takeIf { span.start <= last }
}
