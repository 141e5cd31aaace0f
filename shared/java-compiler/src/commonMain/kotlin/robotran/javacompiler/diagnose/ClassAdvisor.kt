package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages

/** Explains problems with classes and methods as a whole. */
internal class ClassAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val word = shortened(source.words(problem.start, problem.end))

        fun argument(index: Int) = shortened(problem.arguments[index])
        return when (problem.number) {
            ProblemId.PUBLIC_CLASS_MUST_MATCH_FILE_NAME -> ProblemExplanation(messages.wrongFileName(argument(1)))

            ProblemId.MISSING_RETURN_TYPE -> {
                ProblemExplanation(
                    messages.missingReturnType(),
                    messages.writeVoid(),
                    source.insertion(problem.start, "void "),
                )
            }

            ProblemId.CLASS_IS_ABSTRACT -> cannotInstantiate(argument(0))

            ProblemId.METHOD_NOT_WRITTEN -> {
                val method = shortened("${problem.arguments[0]}(${problem.arguments[1]})")
                ProblemExplanation(
                    messages.mustHaveMethod(argument(3), method, argument(2)),
                    messages.writePublicMethod(method),
                )
            }

            ProblemId.REDUCED_VISIBILITY -> ProblemExplanation(messages.mustBePublic(word))

            ProblemId.DUPLICATE_TYPE, ProblemId.DUPLICATE_FIELD -> {
                ProblemExplanation(messages.declaredTwice(argument(1)))
            }

            ProblemId.DUPLICATE_METHOD -> ProblemExplanation(messages.declaredTwice(word))
            else -> null
        }
    }

    private fun cannotInstantiate(name: String) = ProblemExplanation(
        messages.cannotInstantiate(name),
        if (name == "Thread") {
            messages.extendThread()
        } else {
            messages.extendIt(name)
        },
    )
}
