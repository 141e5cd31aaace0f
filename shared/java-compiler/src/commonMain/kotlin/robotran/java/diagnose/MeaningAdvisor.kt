package robotran.java.diagnose

import robotran.java.EcjProblem
import robotran.java.JavaFix
import robotran.java.JavaMessages
import robotran.java.JavaRange
import robotran.java.NewerJava
import robotran.java.ProblemNumber

/** What to tell about programs that can be read but make no sense. */
internal class MeaningAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): Advice? {
        val word = shortened(source.words(problem.start, problem.end))

        fun argument(place: Int) = shortened(problem.arguments.getOrElse(place) { word })
        return when (problem.number) {
            ProblemNumber.TYPE_MISMATCH -> mismatch(problem, source, argument(0), argument(1))
            ProblemNumber.UNINITIALIZED_LOCAL_VARIABLE -> Advice(messages.notInitialized(argument(0)))
            ProblemNumber.REDEFINED_LOCAL, ProblemNumber.REDEFINED_ARGUMENT -> Advice(messages.declaredTwice(argument(0)))
            ProblemNumber.VOID_METHOD_RETURNS_VALUE -> Advice(messages.returnsNothing())
            ProblemNumber.SHOULD_RETURN_VALUE -> Advice(messages.mustReturn())
            ProblemNumber.CODE_CANNOT_BE_REACHED -> Advice(messages.neverReached())
            ProblemNumber.UNHANDLED_EXCEPTION -> Advice(messages.unhandledException(argument(0)), messages.passItOn(argument(0)))
            ProblemNumber.PARAMETER_MISMATCH -> Advice(messages.wrongArguments(argument(1), argument(2), argument(3)))
            ProblemNumber.NON_STATIC_FIELD -> Advice(messages.staticNeeded(argument(0)), messages.makeItStatic())
            ProblemNumber.NON_STATIC_METHOD -> Advice(messages.staticNeeded(argument(1)), messages.makeItStatic())
            ProblemNumber.PUBLIC_CLASS_MUST_MATCH_FILE_NAME -> Advice(messages.wrongFileName(argument(1)))
            ProblemNumber.NUMERIC_VALUE_OUT_OF_RANGE -> Advice(messages.numberTooLarge(word))
            ProblemNumber.ASSIGNMENT_HAS_NO_EFFECT -> Advice(messages.noEffect())
            ProblemNumber.POSSIBLE_ACCIDENTAL_BOOLEAN_ASSIGNMENT -> Advice(messages.compareWithTwoSigns())
            ProblemNumber.EMPTY_STATEMENT -> Advice(messages.emptyStatement())
            ProblemNumber.INVALID_OPERATOR -> Advice(messages.wrongOperator(argument(0)))
            else -> null
        }
    }

    private fun mismatch(problem: EcjProblem, source: SourceText, given: String, needed: String): Advice {
        val message = messages.doesNotFit(given, needed)
        val text = source.words(problem.start, problem.end)
        val range = source.range(problem.start, problem.end)
        return when {
            needed == "boolean" && SINGLE_EQUALS_SIGN.containsMatchIn(text) -> {
                Advice(messages.compareWithTwoSigns(), fix = twoSigns(text, range))
            }

            given == "double" && needed == "float" && DECIMAL_NUMBER.matches(text) -> {
                Advice(message, messages.writeFloat(text), JavaFix(range, "${text}f"))
            }

            given in WIDTHS && needed in WIDTHS -> {
                Advice(message, messages.castIt(needed))
            }

            (given in WIDTHS && needed == "Object") || setOf(given, needed) == setOf("int", "Integer") -> {
                Advice(message, messages.insteadOf(NewerJava.AUTOBOXING))
            }

            needed == "String" -> {
                Advice(message, messages.makeText())
            }

            else -> {
                Advice(message)
            }
        }
    }

    private fun twoSigns(text: String, range: JavaRange) = JavaFix(range, SINGLE_EQUALS_SIGN.replaceFirst(text, "=="))

    private companion object {
        val WIDTHS = setOf("byte", "short", "char", "int", "long", "float", "double")
        val DECIMAL_NUMBER = Regex("[0-9]*[.][0-9]+")
        val SINGLE_EQUALS_SIGN = Regex("(?<![=!<>+*/%&|^-])=(?!=)")
    }
}
