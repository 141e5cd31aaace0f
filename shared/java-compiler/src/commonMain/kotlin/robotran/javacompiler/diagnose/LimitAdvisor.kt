package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages

/** Explains what is too much for the compiler or for a class file. */
internal class LimitAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem): ProblemExplanation? = when (problem.number) {
        ProblemId.SOURCE_TOO_LONG -> ProblemExplanation(messages.sourceTooLong(problem.arguments.first()))
        ProblemId.NESTED_TOO_DEEPLY -> ProblemExplanation(messages.nestedTooDeeply())
        ProblemId.TOO_MANY_IMPORTS -> ProblemExplanation(messages.tooManyImports(problem.arguments.first()))
        ProblemId.TOO_MANY_CLASSES -> ProblemExplanation(messages.tooManyClasses(problem.arguments.first()))

        ProblemId.TOO_MUCH_WORK -> {
            ProblemExplanation(
                messages.tooMuchWork(shortened(problem.arguments.first())),
                messages.putLessInside(),
            )
        }

        ProblemId.FINALLY_COPIED_TOO_OFTEN -> {
            ProblemExplanation(
                messages.finallyCopiedTooOften(),
                messages.useMethodInFinally(),
            )
        }

        ProblemId.METHOD_TOO_LONG, ProblemId.STATIC_INITIALIZER_TOO_LONG, ProblemId.CONSTRUCTOR_TOO_LONG -> {
            ProblemExplanation(messages.methodTooLong())
        }

        else -> null
    }
}
