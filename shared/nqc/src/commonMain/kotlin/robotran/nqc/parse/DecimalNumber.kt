package robotran.nqc.parse

import robotran.language.source.SourceRange
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/**
 * A number with a point, which NQC does not have.
 *
 * @property text as typed.
 * @property isTime whether it is an argument that is a time in hundredths of a second.
 */
internal class DecimalNumber private constructor(val text: String, val range: SourceRange, val isTime: Boolean) {
    /** A hundred times its value; null if it is 0 then, or too large for the brick. */
    val hundredths: Int?
        get() {
            val digits = text.substringAfter('.').padEnd(DECIMALS, '0')
            val number = text.substringBefore('.').ifEmpty { "0" } + digits.take(DECIMALS)
            return number.toIntOrNull()?.takeIf { it in 1..Short.MAX_VALUE }
        }

    companion object {
        private const val DECIMALS = 2

        /** The numbers of the arguments, from 0, that are times. */
        private val TIMES = mapOf("Wait" to 0, "Sleep" to 0, "OnFor" to 1, "PlayTone" to 1)

        /** The farthest that an argument is looked for before its number. */
        private const val LONGEST_CALL = 30

        /** The number whose point is here; null if there is none. [tokenAt] gives a token by its distance from here. */
        fun at(tokenAt: (Int) -> Token): DecimalNumber? {
            val point = tokenAt(0).takeIf { it.text == "." } ?: return null
            val before = tokenAt(-1).takeIf { it.kind == TokenKind.NUMBER && it.range.line == point.range.line }
            val after = tokenAt(1).takeIf { it.kind == TokenKind.NUMBER && it.range.line == point.range.line }
            val text = before?.text.orEmpty() + point.text + after?.text.orEmpty()
            val range = (before?.range ?: point.range).to(after?.range ?: point.range)
            val isTime = isTime(tokenAt, if (before == null) -1 else -2)
            return if (before == null && after == null) null else DecimalNumber(text, range, isTime)
        }

        /** Whether the token at [last] ends what comes before a time in the brackets of a call. */
        private fun isTime(tokenAt: (Int) -> Token, last: Int): Boolean {
            var argument = 0
            for (distance in last downTo last - LONGEST_CALL) {
                val token = tokenAt(distance)
                when {
                    token.isSign("(") -> return TIMES[tokenAt(distance - 1).text] == argument
                    token.isSign(",") -> argument++
                    token.kind != TokenKind.NAME && token.kind != TokenKind.NUMBER && !token.isSign("+") -> return false
                }
            }
            return false
        }
    }
}
