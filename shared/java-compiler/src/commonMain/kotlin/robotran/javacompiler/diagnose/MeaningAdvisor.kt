package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemNumber
import robotran.javacompiler.messages.JavaMessages

/** Explains semantic errors. */
internal class MeaningAdvisor(private val messages: JavaMessages) {
    private val types = TypeAdvisor(messages)
    private val classes = ClassAdvisor(messages)

    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? =
        types.advice(problem, source) ?: classes.advice(problem, source) ?: variable(problem) ?: way(problem, source)

    private fun variable(problem: EcjProblem): ProblemExplanation? {
        fun argument(place: Int) = shortened(problem.arguments[place])
        return when (problem.number) {
            ProblemNumber.UNINITIALIZED_LOCAL_VARIABLE -> ProblemExplanation(messages.notInitialized(argument(0)))

            ProblemNumber.REDEFINED_LOCAL, ProblemNumber.REDEFINED_ARGUMENT -> ProblemExplanation(
                messages.declaredTwice(argument(0)),
            )

            ProblemNumber.FINAL_LOCAL_ASSIGNED -> ProblemExplanation(messages.neverChanges(argument(0)))

            ProblemNumber.FINAL_FIELD_ASSIGNED -> ProblemExplanation(messages.neverChanges(argument(1)))

            ProblemNumber.NON_STATIC_FIELD -> ProblemExplanation(
                messages.staticNeeded(argument(0)),
                messages.makeItStatic(),
            )

            ProblemNumber.THIS_IN_STATIC -> ProblemExplanation(messages.staticNeeded("this"))

            ProblemNumber.ASSIGNMENT_HAS_NO_EFFECT -> ProblemExplanation(messages.noEffect())

            ProblemNumber.POSSIBLE_ACCIDENTAL_BOOLEAN_ASSIGNMENT -> ProblemExplanation(messages.compareWithTwoSigns())

            else -> null
        }
    }

    /** Explains problems with control flow, exceptions and instance methods in static code. */
    private fun way(problem: EcjProblem, source: SourceText): ProblemExplanation? = when (problem.number) {
        ProblemNumber.NON_STATIC_METHOD -> {
            nonStatic(problem, source)
        }

        ProblemNumber.VOID_METHOD_RETURNS_VALUE -> {
            ProblemExplanation(messages.returnsNothing())
        }

        ProblemNumber.SHOULD_RETURN_VALUE -> {
            ProblemExplanation(messages.mustReturn(), messages.returnValue())
        }

        ProblemNumber.CODE_CANNOT_BE_REACHED -> {
            ProblemExplanation(messages.neverReached())
        }

        ProblemNumber.UNHANDLED_EXCEPTION -> {
            unhandled(problem, source)
        }

        ProblemNumber.EXCEPTION_NEVER_THROWN, ProblemNumber.UNREACHABLE_CATCH -> {
            ProblemExplanation(messages.neverThrown(shortened(problem.arguments[0])), messages.takeCatchAway())
        }

        ProblemNumber.EMPTY_STATEMENT -> {
            ProblemExplanation(messages.emptyStatement())
        }

        else -> {
            null
        }
    }

    private fun nonStatic(problem: EcjProblem, source: SourceText): ProblemExplanation {
        val owner = shortened(problem.arguments[0])
        val name = shortened(problem.arguments[1])
        val onClass = source.words(problem.start, problem.end).startsWith("$owner.")
        return if (onClass) {
            ProblemExplanation(
                messages.objectNeeded(name, owner),
            )
        } else {
            ProblemExplanation(messages.staticNeeded(name), messages.makeItStatic())
        }
    }

    private fun unhandled(problem: EcjProblem, source: SourceText): ProblemExplanation {
        val exception = problem.arguments[0]
        val name = shortened(exception)
        val end = source.codeFrom(problem.end)
        val statement = source.words(problem.start, end + 1)
        val isWhole = source.codeBefore(problem.start) in STATEMENT_STARTS && statement.endsWith(';')
        val fix = JavaFix(source.range(problem.start, end + 1), "try { $statement } catch ($exception e) { }")
        return ProblemExplanation(messages.unhandledException(name), messages.handleIt(name), fix.takeIf { isWhole })
    }

    private companion object {
        val STATEMENT_STARTS = setOf('{', '}', ';')
    }
}
