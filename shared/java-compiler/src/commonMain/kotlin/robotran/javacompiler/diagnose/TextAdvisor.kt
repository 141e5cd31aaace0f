package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.SourceFix

/** Explains what goes wrong with texts: that they are compared as objects, not by their letters. */
internal class TextAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        if (problem.number != ProblemId.TEXTS_COMPARED) return null
        val operator = problem.arguments[0]
        val comparison = comparison(problem, source)
        val hint = messages.compareLetters(comparison?.let(::shortened) ?: "${not(operator)}a.equals(b)")
        val fix = comparison?.let { SourceFix(source.range(problem.start, problem.end), it) }
        return ProblemExplanation(messages.textsCompared(operator), hint, fix)
    }

    /** The same comparison with `equals`; null if no call can stand behind the left text, or it has several lines. */
    private fun comparison(problem: EcjProblem, source: SourceText): String? {
        val (operator, leftEnd, rightStart) = problem.arguments
        val left = source.words(problem.start, leftEnd.toInt()).trim()
        val right = source.words(rightStart.toInt(), problem.end).trim()
        val isWhole = source.words(problem.start, problem.end).length == problem.end - problem.start
        return if (leftEnd.toInt() < 0 || !isWhole) null else "${not(operator)}$left.equals($right)"
    }

    private fun not(operator: String) = if (operator == "!=") "!" else ""
}
