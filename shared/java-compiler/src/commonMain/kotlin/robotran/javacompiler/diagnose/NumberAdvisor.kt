package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.SourceFix

/**
 * Explains numbers that are written where they do not fit. None is cut by a fix: 5.5 is not 5.
 *
 * @param decimals the type of a variable for numbers with a point: an RCX computes with `float`.
 */
internal class NumberAdvisor(private val messages: JavaMessages, private val decimals: String) {
    fun outOfRange(problem: EcjProblem, source: SourceText): ProblemExplanation {
        val number = source.words(problem.start, problem.end)
        val decimal = number.trimStart('0').ifEmpty { "0" }
        val isOctal = number.length > 1 && number.startsWith('0') && number.all { it.isDigit() }
        return if (isOctal && decimal.length < MAX_INT_DIGITS) {
            ProblemExplanation(
                messages.noLeadingZero(decimal),
                fix = SourceFix(source.range(problem.start, problem.end), decimal),
            )
        } else {
            ProblemExplanation(messages.numberTooLarge(shortened(number)))
        }
    }

    /** Explains a number that is given where [needed] is the type; null if there is something else. */
    fun written(problem: EcjProblem, source: SourceText, needed: String): ProblemExplanation? {
        val text = source.words(problem.start, problem.end)
        return when {
            needed in WHOLE_NUMBERS && DECIMAL.matches(text) -> notWhole(problem, source, text, needed)

            needed in SMALL_NUMBERS && WHOLE.matches(text) -> ProblemExplanation(
                messages.tooLargeFor(text, needed),
                messages.declareAsInt(),
            )

            else -> null
        }
    }

    /** Explains by [message] a number that is the only argument of a method, for a parameter [needed]; or null. */
    fun argument(problem: EcjProblem, source: SourceText, message: String, needed: String): ProblemExplanation? {
        val argument = ONLY_ARGUMENT.find(source.codeBehind(problem.end))
        if (needed !in WHOLE_NUMBERS || argument == null) return null
        val number = argument.groupValues[1]
        val start = problem.end + argument.value.indexOf(number)
        val fix = SourceFix(source.range(start, start + number.length), wholePart(number))
        return ProblemExplanation(message, messages.writeWhole(wholePart(number)), fix.takeIf { isWhole(number) })
    }

    private fun notWhole(problem: EcjProblem, source: SourceText, number: String, needed: String): ProblemExplanation {
        val whole = wholePart(number)
        val variable = SET_VARIABLE.find(source.lineBefore(problem.start))?.groupValues?.get(1)
        val declaration = if (decimals == "float") "float $variable = ${number}f;" else "$decimals $variable = $number;"
        return ProblemExplanation(
            messages.notWhole(number, needed),
            if (variable == null) messages.writeWhole(whole) else messages.writeWholeOrDeclare(whole, declaration),
            SourceFix(source.range(problem.start, problem.end), whole).takeIf { isWhole(number) },
        )
    }

    /** [number] without its point and what is behind that. */
    private fun wholePart(number: String) =
        number.substringBefore('.').let { if (it.isEmpty() || it == "-") "0" else it }

    private fun isWhole(number: String) = number.substringAfter('.').all { it == '0' }

    private companion object {
        val WHOLE_NUMBERS = setOf("byte", "short", "char", "int", "long")
        val SMALL_NUMBERS = setOf("byte", "short", "char")
        val WHOLE = Regex("""-?\d+""")
        val DECIMAL = Regex("""-?(?:\d+\.\d*|\.\d+)""")
        val ONLY_ARGUMENT = Regex("""^\s*\(\s*(-?(?:\d+\.\d*|\.\d+))\s*\)""")

        /** A variable that is set, and maybe declared, by what comes next. */
        val SET_VARIABLE = Regex("""(\w+)\s*=\s*$""")

        /** A number with fewer digits is no larger than an `int` may be. */
        const val MAX_INT_DIGITS = 10
    }
}
