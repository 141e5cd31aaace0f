package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemNumber
import robotran.javacompiler.messages.JavaMessages

/** Explains problems with classes and methods as a whole. */
internal class ClassAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val word = shortened(source.words(problem.start, problem.end))

        fun argument(place: Int) = shortened(problem.arguments[place])
        return when (problem.number) {
            ProblemNumber.PUBLIC_CLASS_MUST_MATCH_FILE_NAME -> {
                ProblemExplanation(messages.wrongFileName(argument(1)))
            }

            ProblemNumber.MISSING_RETURN_TYPE -> {
                ProblemExplanation(
                    messages.missingReturnType(),
                    messages.writeVoid(),
                    source.insertion(problem.start, "void "),
                )
            }

            ProblemNumber.CLASS_IS_ABSTRACT -> {
                cannotBeMade(argument(0))
            }

            ProblemNumber.METHOD_NOT_WRITTEN -> {
                val method = shortened("${problem.arguments[0]}(${problem.arguments[1]})")
                ProblemExplanation(
                    messages.mustHaveMethod(argument(3), method, argument(2)),
                    messages.writePublicMethod(method),
                )
            }

            ProblemNumber.REDUCED_VISIBILITY -> {
                ProblemExplanation(messages.mustBePublic(word))
            }

            ProblemNumber.DUPLICATE_TYPE, ProblemNumber.DUPLICATE_FIELD -> {
                ProblemExplanation(messages.declaredTwice(argument(1)))
            }

            ProblemNumber.DUPLICATE_METHOD -> {
                ProblemExplanation(messages.declaredTwice(word))
            }

            else -> {
                null
            }
        }
    }

    private fun cannotBeMade(name: String) = ProblemExplanation(
        messages.cannotBeMade(name),
        if (name ==
            "Thread"
        ) {
            messages.extendThread()
        } else {
            messages.extendIt(name)
        },
    )
}
