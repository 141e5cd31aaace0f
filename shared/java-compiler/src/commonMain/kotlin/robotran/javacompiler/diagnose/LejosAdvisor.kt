package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.lejoslibrary.LejosDifference

/** Explains where leJOS on a real brick compiles less than Robotran, or does something else at run time. */
internal class LejosAdvisor(private val missing: MissingMembers, private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? = when (problem.number) {
        ProblemId.LIBRARY_GAP -> missing.find(problem.arguments[0])?.let { gap(it, problem, source) }

        ProblemId.UNHANDLED_EXCEPTION -> checkedName(problem)?.let {
            ProblemExplanation(messages.checkedInLejos(it), messages.handleIt(it))
        }

        ProblemId.EXCEPTION_NEVER_THROWN -> checkedName(problem)?.let {
            val isType = source.words(problem.start, problem.end) == it
            val fix = JavaFix(source.range(problem.start, problem.end), EXCEPTION).takeIf { isType }
            ProblemExplanation(messages.checkedInLejos(it), messages.catchException(), fix)
        }

        ProblemId.UNLOCKED_METHOD -> unlockedMethod(problem)

        ProblemId.UNLOCKED_SUPER_CALL -> ProblemExplanation(
            messages.unlockedSuperCall(shortened(problem.arguments[0])),
            messages.lockThis(),
        )

        ProblemId.TEXT_AND_NUMBER -> ProblemExplanation(messages.textAndNumber(), messages.makeRoomForNumber())

        else -> null
    }

    private fun checkedName(problem: EcjProblem): String? = problem.arguments[0].takeIf(missing::isCheckedOnlyThere)

    private fun gap(difference: LejosDifference, problem: EcjProblem, source: SourceText): ProblemExplanation {
        val owner = difference.owner.substringAfterLast('/')
        val member = difference.member.substringBefore('(').substringBefore(':')
        return ProblemExplanation(
            messages.missingInLejos(difference.instead, owner, member),
            messages.insteadInLejos(difference.instead, owner, member),
            lejosFix(difference.instead, member, problem.start, problem.end, source),
        )
    }

    private fun unlockedMethod(problem: EcjProblem): ProblemExplanation {
        val (name, modifier, monitorCall) = problem.arguments
        val message = messages.unlockedMethod(shortened(name), modifier)
        val effect = if (monitorCall.isEmpty()) null else messages.monitorCallFails(monitorCall)
        return ProblemExplanation(
            listOfNotNull(message, effect).joinToString(" "),
            if (modifier == STATIC) messages.lockAnObject() else messages.lockWithoutPrivate(),
        )
    }

    private companion object {
        const val EXCEPTION = "Exception"
        const val STATIC = "static"
    }
}
