package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemNumber
import robotran.javacompiler.messages.JavaMessages
import robotran.javacompiler.messages.NewerJava

/** Explains Java features that are too new for a brick or that its virtual machine lacks. */
internal class BrickAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem): ProblemExplanation? {
        val newer =
            NEWER_JAVA[problem.number]
                ?: newerWord(problem.arguments.firstOrNull().orEmpty())?.takeIf { problem.isSyntax }
        return if (newer !=
            null
        ) {
            ProblemExplanation(messages.newerJava(newer), messages.insteadOf(newer))
        } else {
            brickAdvice(problem)
        }
    }

    private fun brickAdvice(problem: EcjProblem): ProblemExplanation? = when (problem.number) {
        ProblemNumber.SWITCH -> ProblemExplanation(messages.noSwitch(), messages.useIf())

        ProblemNumber.LONG_ARITHMETIC -> ProblemExplanation(messages.noLongArithmetic(), messages.useInt())

        ProblemNumber.FLOAT_REMAINDER -> ProblemExplanation(messages.noFloatRemainder(), messages.useIntRemainder())

        ProblemNumber.ARRAY_TYPE_TEST -> ProblemExplanation(messages.noArrayTypeTest(), messages.useArrayItself())

        ProblemNumber.CLASS_LITERAL -> ProblemExplanation(messages.noClassLiteral(), messages.useInstanceof())

        ProblemNumber.TEXT_JOINED_IN_LOOP -> ProblemExplanation(messages.textJoinedInLoop(), messages.makeTextOnce())

        ProblemNumber.DIVISOR_TOO_LARGE -> ProblemExplanation(
            messages.divisorTooLarge(problem.arguments[0], problem.arguments[1]),
        )

        ProblemNumber.ARRAY_TOO_LONG -> ProblemExplanation(
            messages.arrayTooLong(problem.arguments[0], problem.arguments[1]),
        )

        else -> null
    }

    companion object {
        private val NEWER_JAVA = mapOf(
            ProblemNumber.TYPE_PARAMETERS to NewerJava.GENERICS,
            ProblemNumber.TYPE_ARGUMENTS to NewerJava.GENERICS,
            ProblemNumber.STATIC_IMPORT to NewerJava.STATIC_IMPORT,
            ProblemNumber.FOR_EACH to NewerJava.FOR_EACH,
            ProblemNumber.ENUM to NewerJava.ENUM,
            ProblemNumber.VARARGS to NewerJava.VARARGS,
            ProblemNumber.ANNOTATION to NewerJava.ANNOTATION,
            ProblemNumber.DEFAULT_METHOD to NewerJava.INTERFACE_METHOD_BODY,
            ProblemNumber.STATIC_INTERFACE_METHOD to NewerJava.INTERFACE_METHOD_BODY,
            ProblemNumber.LAMBDA to NewerJava.LAMBDA,
            ProblemNumber.METHOD_REFERENCE to NewerJava.LAMBDA,
            ProblemNumber.RESOURCE_TOO_OLD to NewerJava.TRY_WITH_RESOURCES,
            ProblemNumber.MULTI_CATCH to NewerJava.MULTI_CATCH,
            ProblemNumber.ARROW_IN_CASE to NewerJava.SWITCH_EXPRESSION,
            ProblemNumber.SWITCH_EXPRESSION to NewerJava.SWITCH_EXPRESSION,
            ProblemNumber.PREVIEW_FEATURE to NewerJava.TEXT_BLOCK,
            ProblemNumber.UNDERSCORES_IN_NUMBER to NewerJava.NUMBER_STYLE,
            ProblemNumber.BINARY_NUMBER to NewerJava.NUMBER_STYLE,
        )

        /** Whether [problem] is only about newer Java. ECJ can still parse it, so its other problems are reliable. */
        fun isOnlyNewer(problem: EcjProblem) = problem.number in NEWER_JAVA
    }
}
