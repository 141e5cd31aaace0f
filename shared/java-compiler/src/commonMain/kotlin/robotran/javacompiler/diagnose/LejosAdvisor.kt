package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.SourceFix
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
            val fix = SourceFix(source.range(problem.start, problem.end), EXCEPTION).takeIf { isType }
            ProblemExplanation(messages.checkedInLejos(it), messages.catchException(), fix)
        }

        ProblemId.UNLOCKED_METHOD -> unlockedMethod(problem)

        ProblemId.UNLOCKED_SUPER_CALL -> ProblemExplanation(
            messages.unlockedSuperCall(shortened(problem.arguments[0])),
            messages.lockThis(),
        )

        ProblemId.TEXT_AND_NUMBER -> ProblemExplanation(messages.textAndNumber(), messages.makeRoomForNumber())
        ProblemId.LARGE_STEP -> largeStep(problem, source)
        else -> null
    }

    private fun largeStep(problem: EcjProblem, source: SourceText): ProblemExplanation {
        val written = source.words(problem.start, problem.end)
        val (name, operator, step) = STEP.matchEntire(written)?.destructured
            ?: return ProblemExplanation(messages.largeStep(), messages.insteadOfStep("i = i + 200"))
        val sum = "$name = $name $operator ${if (WORD.matches(step)) step else "($step)"}"
        return ProblemExplanation(
            messages.largeStep(),
            messages.insteadOfStep(sum),
            SourceFix(source.range(problem.start, problem.end), sum),
        )
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

        /** An assignment on one line, without a comment. */
        val STEP = Regex("([\\w$]+)\\s*([+-])=\\s*([^/]+)")
        val WORD = Regex("\\w+")
    }
}
