package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.SourceFix

/**
 * Explains semantic errors.
 *
 * @param boxes whether Java makes objects of numbers by itself.
 */
internal class SemanticAdvisor(private val messages: JavaMessages, private val library: LibraryNames, boxes: Boolean) {
    private val types = TypeAdvisor(messages, boxes)
    private val classes = ClassAdvisor(messages)
    private val constructors = ConstructorAdvisor(messages)
    private val texts = TextAdvisor(messages)

    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? =
        types.advice(problem, source) ?: classes.advice(problem, source) ?: constructors.advice(problem, source)
            ?: texts.advice(problem, source) ?: variable(problem) ?: way(problem, source)

    private fun variable(problem: EcjProblem): ProblemExplanation? {
        fun argument(index: Int) = shortened(problem.arguments[index])
        return when (problem.number) {
            ProblemId.UNINITIALIZED_LOCAL_VARIABLE -> ProblemExplanation(messages.notInitialized(argument(0)))

            ProblemId.REDEFINED_LOCAL, ProblemId.REDEFINED_ARGUMENT -> ProblemExplanation(
                messages.declaredTwice(argument(0)),
            )

            ProblemId.FINAL_LOCAL_ASSIGNED -> ProblemExplanation(messages.neverChanges(argument(0)))
            ProblemId.FINAL_FIELD_ASSIGNED -> ProblemExplanation(messages.neverChanges(argument(1)))

            ProblemId.NON_STATIC_FIELD -> ProblemExplanation(
                messages.staticNeeded(argument(0)),
                messages.makeItStatic(),
            )

            ProblemId.THIS_IN_STATIC -> ProblemExplanation(messages.staticNeeded("this"))
            ProblemId.ASSIGNMENT_HAS_NO_EFFECT -> ProblemExplanation(messages.noEffect())
            ProblemId.POSSIBLE_ACCIDENTAL_BOOLEAN_ASSIGNMENT -> ProblemExplanation(messages.compareWithTwoSigns())
            else -> null
        }
    }

    /** Explains problems with control flow, exceptions and instance methods in static code. */
    private fun way(problem: EcjProblem, source: SourceText): ProblemExplanation? = when (problem.number) {
        ProblemId.NON_STATIC_METHOD -> nonStatic(problem, source)
        ProblemId.VOID_METHOD_RETURNS_VALUE -> ProblemExplanation(messages.returnsNothing())
        ProblemId.SHOULD_RETURN_VALUE -> ProblemExplanation(messages.mustReturn(), messages.returnValue())
        ProblemId.CODE_CANNOT_BE_REACHED -> ProblemExplanation(messages.neverReached())
        ProblemId.UNHANDLED_EXCEPTION -> unhandled(problem, source)

        ProblemId.EXCEPTION_NEVER_THROWN, ProblemId.UNREACHABLE_CATCH -> {
            ProblemExplanation(messages.neverThrown(shortened(problem.arguments[0])), messages.removeCatch())
        }

        ProblemId.THROWS_MORE_THAN_OVERRIDDEN -> {
            val exception = shortened(problem.arguments[0])
            ProblemExplanation(
                messages.announcesMore(exception, shortened(problem.arguments[1])),
                messages.catchInside(exception),
            )
        }

        ProblemId.EMPTY_STATEMENT -> {
            val isBeforeBlock = source.codeAt(source.codeFrom(problem.end)) == '{'
            val fix = SourceFix(source.range(problem.start, problem.end), "")
            ProblemExplanation(messages.emptyStatement(), fix = fix.takeIf { isBeforeBlock })
        }

        else -> null
    }

    private fun nonStatic(problem: EcjProblem, source: SourceText): ProblemExplanation {
        val owner = shortened(problem.arguments[0])
        val name = shortened(problem.arguments[1])
        val onClass = source.words(problem.start, problem.end).startsWith("$owner.")
        val message = messages.staticNeeded(name)
        return when {
            onClass -> ProblemExplanation(messages.objectNeeded(name, owner))
            owner == OBJECT -> ofObject(problem, source, name, message)

            // It is inherited from the library.
            owner in library.simpleNames && owner != source.className -> {
                ProblemExplanation(message, messages.callOnNew(shortened(source.className), name))
            }

            else -> ProblemExplanation(message, messages.makeItStatic())
        }
    }

    private fun ofObject(problem: EcjProblem, source: SourceText, name: String, message: String): ProblemExplanation {
        val isPause = name == "wait" && problem.arguments.getOrElse(2) { "" }.isNotEmpty()
        if (!isPause) return ProblemExplanation(message, messages.callOnObject(name))
        val isWord = source.words(problem.start, problem.end) == name
        val fix = SourceFix(source.range(problem.start, problem.end), SLEEP).takeIf { isWord }
        return ProblemExplanation(message, messages.sleepInstead(), fix)
    }

    private fun unhandled(problem: EcjProblem, source: SourceText): ProblemExplanation {
        val exception = problem.arguments[0]
        val name = shortened(exception)
        val end = source.codeFrom(problem.end)
        val statement = source.words(problem.start, end + 1)
        val isWhole = source.codeBefore(problem.start) in STATEMENT_STARTS && statement.endsWith(';')
        val fix = SourceFix(source.range(problem.start, end + 1), "try { $statement } catch ($exception e) { }")
        return ProblemExplanation(messages.unhandledException(name), messages.handleIt(name), fix.takeIf { isWhole })
    }

    private companion object {
        const val OBJECT = "Object"
        const val SLEEP = "Thread.sleep"
        val STATEMENT_STARTS = setOf('{', '}', ';')
    }
}
