package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemNumber

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

            // What holds or stands behind a place that could not be read may have been read wrongly.
            problem.end > firstUnread -> false

            problem.number == ProblemNumber.UNDEFINED_TYPE -> unknown.add(written)

            problem.number == ProblemNumber.CLASS_MUST_BE_ABSTRACT -> problems.none {
                it.number ==
                    ProblemNumber.ABSTRACT_METHOD
            }

            else -> true
        }
    }
}

/** What could not be read, without what only follows from that. */
private fun unread(source: SourceText, problems: List<EcjProblem>): Set<EcjProblem> {
    val all = problems.filter { it.isSyntax && !BrickAdvisor.isOnlyNewer(it) }
    // A text that does not end takes brackets and semicolons away from the rest.
    val unclosed = all.filter { source.unclosedText(it.start) != null }
    if (unclosed.isNotEmpty()) return unclosed.toSet()
    // A brace that stays open is told where it should be closed, and no brace is wrong if there are as many of both.
    val paired = source.bracesBefore(Int.MAX_VALUE) == 0
    return all.filterNot {
        if (paired) isAboutBrace(it, source) else isOpeningBrace(it, source)
    }.ifEmpty { all }.toSet()
}

private fun isAboutBrace(problem: EcjProblem, source: SourceText) =
    isOpeningBrace(problem, source) || problem.arguments.firstOrNull() == "}"

private fun isOpeningBrace(problem: EcjProblem, source: SourceText) = source.words(problem.start, problem.end) == "{"

/**
 * [problems] without the proposals to go on with `::`, which Java of a brick's time does not have, where ECJ also says
 * what else is missing there: behind a name that a statement ends with, that is its semicolon.
 */
internal fun withoutMethodReferences(problems: List<EcjProblem>): List<EcjProblem> {
    val (references, others) = problems.partition {
        it.isSyntax && it.arguments.firstOrNull()?.startsWith("::") == true
    }
    if (references.isEmpty()) return problems
    val places = others.filter { it.isSyntax }.mapTo(mutableSetOf()) { it.start to it.end }
    return problems.filter { it !in references || (it.start to it.end) !in places }
}
