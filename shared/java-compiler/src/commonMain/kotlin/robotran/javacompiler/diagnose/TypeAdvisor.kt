package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.javacompiler.messages.NewerJava
import robotran.language.source.SourceFix

/** Explains problems with the types of values. */
internal class TypeAdvisor(private val messages: JavaMessages, private val boxes: Boolean) {
    private val numbers = NumberAdvisor(messages, decimals = if (boxes) "double" else "float")

    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? = when (problem.number) {
        ProblemId.TYPE_MISMATCH -> mismatch(problem, source)
        ProblemId.INVALID_OPERATOR -> operator(problem)
        ProblemId.PARAMETER_MISMATCH -> arguments(problem, source)
        ProblemId.NUMERIC_VALUE_OUT_OF_RANGE -> numbers.outOfRange(problem, source)
        ProblemId.NOT_ITERABLE -> notIterable()
        else -> null
    }

    private fun notIterable() =
        ProblemExplanation(messages.onlyArraysAndLists(), messages.writeInNxj(listOf(EACH_ELEMENT)))

    private fun mismatch(problem: EcjProblem, source: SourceText): ProblemExplanation {
        val given = problem.arguments[0]
        val needed = problem.arguments[1]
        val message = messages.doesNotFit(shortened(given), shortened(needed))
        val text = source.words(problem.start, problem.end)
        val range = source.range(problem.start, problem.end)
        numbers.written(problem, source, needed)?.let { return it }
        return when {
            needed == "boolean" && SINGLE_EQUALS_SIGN.containsMatchIn(text) -> {
                ProblemExplanation(
                    messages.compareWithTwoSigns(),
                    fix = SourceFix(range, SINGLE_EQUALS_SIGN.replaceFirst(text, "==")),
                )
            }

            given == "void" -> ProblemExplanation(messages.givesNothing())

            given == "double" && needed == "float" && DECIMAL_NUMBER.matches(text) -> {
                ProblemExplanation(message, messages.writeFloat(text), SourceFix(range, "${text}f"))
            }

            given in NUMBERS && needed in NUMBERS -> {
                ProblemExplanation(message, messages.castNumber(needed), SourceFix(range, cast(text, needed)))
            }

            given in NUMBERS && needed == "boolean" -> ProblemExplanation(message, messages.compareWithZero())

            isBoxing(given, needed) -> {
                ProblemExplanation(message, messages.insteadOf(NewerJava.AUTOBOXING).takeUnless { boxes })
            }

            given == "Object" && needed !in SINGLE_VALUES -> {
                ProblemExplanation(
                    message,
                    messages.castObject(shortened(needed)),
                    SourceFix(range, cast(text, needed)),
                )
            }

            needed == "String" -> ProblemExplanation(message, messages.makeText())
            else -> ProblemExplanation(message)
        }
    }

    private fun operator(problem: EcjProblem): ProblemExplanation {
        val types = problem.arguments[1]
        val message = messages.wrongOperator(problem.arguments[0], shortened(types))
        return ProblemExplanation(
            message,
            if (!boxes && types.split(", ").any { it in BOXES }) {
                messages.insteadOf(NewerJava.AUTOBOXING)
            } else {
                null
            },
        )
    }

    /** ECJ's arguments are the class, the method, the parameter types and the argument types. */
    private fun arguments(problem: EcjProblem, source: SourceText): ProblemExplanation {
        val (_, method, needed, given) = problem.arguments.map(::shortened)
        val message = messages.wrongArguments(method, needed, given)
        val call = problem.end + source.codeBehind(problem.end).substringBefore(')').length
        val comma = decimalCommaIn(source, problem.end, call)
            ?.takeIf { needed.isNotEmpty() && commasIn(given) == commasIn(needed) + 1 }
        if (comma == null && method !in PAUSES) numbers.argument(problem, source, message, needed)?.let { return it }
        return when {
            comma != null -> {
                val type = if (',' in needed) "" else needed
                ProblemExplanation(message, messages.decimalPoint(comma.pointed), comma.fixFor(type, source))
            }

            method in PAUSES && given in setOf("float", "double") -> {
                ProblemExplanation(message, messages.countsMilliseconds(), milliseconds(problem, source))
            }

            given in NUMBERS && needed in NUMBERS -> ProblemExplanation(message, messages.castNumber(needed))

            isBoxing(given, needed) -> {
                ProblemExplanation(
                    message,
                    messages.insteadOf(NewerJava.AUTOBOXING).takeUnless {
                        boxes
                    },
                )
            }

            needed == "String" && given in NUMBERS -> ProblemExplanation(message, messages.makeText())
            else -> ProblemExplanation(message)
        }
    }

    private fun commasIn(types: String) = types.count { it == ',' }

    /** Seconds with a part behind the point, as whole milliseconds. */
    private fun milliseconds(problem: EcjProblem, source: SourceText): SourceFix? {
        val found = SECONDS.find(source.codeBehind(problem.end)) ?: return null
        val (whole, part) = found.destructured
        val number = (whole + part.padEnd(MILLISECOND_DIGITS, '0')).trimStart('0').ifEmpty { "0" }
        val start = problem.end + found.value.indexOf(whole + "." + part)
        return SourceFix(source.range(start, start + whole.length + 1 + part.length), number)
            .takeIf { part.length <= MILLISECOND_DIGITS && whole.length <= MILLISECOND_DIGITS }
    }

    private fun isBoxing(given: String, needed: String) =
        (given in SINGLE_VALUES && (needed == "Object" || needed in BOXES)) ||
            (given in BOXES && needed in SINGLE_VALUES)

    private fun cast(text: String, type: String) = if (ONE_VALUE.matches(text)) "($type) $text" else "($type) ($text)"

    private companion object {
        val NUMBERS = setOf("byte", "short", "char", "int", "long", "float", "double")
        val SINGLE_VALUES = NUMBERS + "boolean"
        val BOXES = setOf("Integer", "Float", "Boolean", "Long", "Double", "Byte", "Short", "Character")

        /** Methods that wait for a number of milliseconds. */
        val PAUSES = setOf("sleep", "msDelay")
        const val MILLISECOND_DIGITS = 3
        val SECONDS = Regex("""^\s*\(\s*(\d*)\.(\d+)\s*\)""")
        val DECIMAL_NUMBER = Regex("[0-9]*[.][0-9]+")

        val SINGLE_EQUALS_SIGN = Regex("(?<![=!<>+*/%&|^-])=(?!=)")

        /** A number, a variable, or a call whose arguments contain no parentheses. */
        val ONE_VALUE = Regex("""[\w.]+(\([^()]*\))?""")
    }
}
