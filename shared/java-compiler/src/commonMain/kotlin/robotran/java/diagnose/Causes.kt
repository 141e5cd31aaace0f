package robotran.java.diagnose

import robotran.java.EcjProblem
import robotran.java.ProblemNumber

/** The [problems] of [source] without those that only follow from others. */
internal fun causes(source: SourceText, problems: List<EcjProblem>): List<EcjProblem> {
    val unread = unread(source, problems)
    val firstUnread = unread.minOfOrNull { it.start } ?: Int.MAX_VALUE
    val unknown = mutableSetOf<String>()
    return problems.filter { problem ->
        val written = source.words(problem.start, problem.end)
        when {
            problem in unread || BrickAdvisor.isOnlyNewer(problem) -> true

            problem.isSyntax -> false

            problem.number == ProblemNumber.UNDEFINED_TYPE && newerWord(written) != null -> true

            // What stands behind a place that could not be read may have been read wrongly.
            problem.start >= firstUnread -> false

            problem.number == ProblemNumber.UNDEFINED_TYPE -> unknown.add(written)

            problem.number == ProblemNumber.CLASS_MUST_BE_ABSTRACT -> problems.none { it.number == ProblemNumber.ABSTRACT_METHOD }

            else -> true
        }
    }
}

/** A text that does not end takes brackets and semicolons away from the rest, so nothing else of what could not be read counts then. */
private fun unread(source: SourceText, problems: List<EcjProblem>): Set<EcjProblem> {
    val all = problems.filter { it.isSyntax && !BrickAdvisor.isOnlyNewer(it) }
    return all.filter { source.unclosedText(it.start) != null }.ifEmpty { all }.toSet()
}
