package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.javacompiler.messages.NewerJava

/** Explains Java features that are too new for a brick or that its virtual machine lacks. */
internal class BrickAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem): ProblemExplanation? {
        val newer =
            NEWER_JAVA[problem.number]
                ?: newerFeature(problem.arguments.firstOrNull().orEmpty())?.takeIf { problem.isSyntax }
        return if (newer != null) {
            ProblemExplanation(messages.newerJava(newer), messages.insteadOf(newer))
        } else {
            brickAdvice(problem)
        }
    }

    private fun brickAdvice(problem: EcjProblem): ProblemExplanation? = when (problem.number) {
        ProblemId.SWITCH -> ProblemExplanation(messages.noSwitch(), messages.useIf())
        ProblemId.LONG_ARITHMETIC -> ProblemExplanation(messages.noLongArithmetic(), messages.useInt())
        ProblemId.FLOAT_REMAINDER -> ProblemExplanation(messages.noFloatRemainder(), messages.useIntRemainder())
        ProblemId.ARRAY_TYPE_TEST -> ProblemExplanation(messages.noArrayTypeTest(), messages.useArrayItself())
        ProblemId.CLASS_LITERAL -> ProblemExplanation(messages.noClassLiteral(), messages.useInstanceof())
        ProblemId.TEXT_JOINED_IN_LOOP -> ProblemExplanation(messages.textJoinedInLoop(), messages.makeTextOnce())

        ProblemId.DIVISOR_TOO_LARGE -> ProblemExplanation(
            messages.divisorTooLarge(problem.arguments[0], problem.arguments[1]),
        )

        ProblemId.ARRAY_TOO_LONG -> ProblemExplanation(
            messages.arrayTooLong(problem.arguments[0], problem.arguments[1]),
        )

        else -> null
    }

    companion object {
        private val NEWER_JAVA = mapOf(
            ProblemId.TYPE_PARAMETERS to NewerJava.GENERICS,
            ProblemId.TYPE_ARGUMENTS to NewerJava.GENERICS,
            ProblemId.STATIC_IMPORT to NewerJava.STATIC_IMPORT,
            ProblemId.FOR_EACH to NewerJava.FOR_EACH,
            ProblemId.ENUM to NewerJava.ENUM,
            ProblemId.VARARGS to NewerJava.VARARGS,
            ProblemId.ANNOTATION to NewerJava.ANNOTATION,
            ProblemId.DEFAULT_METHOD to NewerJava.INTERFACE_METHOD_BODY,
            ProblemId.STATIC_INTERFACE_METHOD to NewerJava.INTERFACE_METHOD_BODY,
            ProblemId.DIAMOND to NewerJava.DIAMOND,
            ProblemId.TEXT_IN_SWITCH to NewerJava.TEXT_IN_SWITCH,
            ProblemId.LAMBDA to NewerJava.LAMBDA,
            ProblemId.METHOD_REFERENCE to NewerJava.LAMBDA,
            ProblemId.RESOURCE_TOO_OLD to NewerJava.TRY_WITH_RESOURCES,
            ProblemId.MULTI_CATCH to NewerJava.MULTI_CATCH,
            ProblemId.ARROW_IN_CASE to NewerJava.SWITCH_EXPRESSION,
            ProblemId.SWITCH_EXPRESSION to NewerJava.SWITCH_EXPRESSION,
            ProblemId.PREVIEW_FEATURE to NewerJava.TEXT_BLOCK,
            ProblemId.UNDERSCORES_IN_NUMBER to NewerJava.NUMBER_STYLE,
            ProblemId.BINARY_NUMBER to NewerJava.NUMBER_STYLE,
        )

        /** Whether [problem] is only about newer Java. ECJ can still parse it, so its other problems are reliable. */
        fun isOnlyNewer(problem: EcjProblem) = problem.number in NEWER_JAVA
    }
}
