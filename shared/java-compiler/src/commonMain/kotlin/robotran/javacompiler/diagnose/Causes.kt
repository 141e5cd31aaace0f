package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId

/** The [problems] of [source] without follow-up errors. */
internal fun causes(source: SourceText, problems: List<EcjProblem>): List<EcjProblem> {
    val syntaxErrors = syntaxErrors(source, problems)
    val firstSyntaxError = syntaxErrors.minOfOrNull { it.start } ?: Int.MAX_VALUE
    val unknown = mutableSetOf<String>()
    return problems.filter { problem ->
        val written = source.words(problem.start, problem.end)
        when {
            problem in syntaxErrors || BrickAdvisor.isOnlyNewer(problem) -> true

            problem.isSyntax -> false

            problem.number == ProblemId.UNDEFINED_TYPE && newerFeature(written) != null -> true

            // Code that contains or follows a syntax error may have been parsed wrongly.
            problem.end > firstSyntaxError -> false

            problem.number == ProblemId.UNDEFINED_TYPE -> unknown.add(written)

            problem.number == ProblemId.CLASS_MUST_BE_ABSTRACT -> problems.none {
                it.number == ProblemId.ABSTRACT_METHOD
            }

            else -> true
        }
    }
}

/** The syntax errors without their follow-up errors. */
private fun syntaxErrors(source: SourceText, problems: List<EcjProblem>): Set<EcjProblem> {
    val all = problems.filter { it.isSyntax && !BrickAdvisor.isOnlyNewer(it) }
    // An unclosed string hides brackets and semicolons from the parser.
    val unclosed = all.filter { source.unclosedString(it.start) != null }
    if (unclosed.isNotEmpty()) return unclosed.toSet()
    // An unclosed brace is reported where it should be closed. If the braces match in number, none is reported.
    val paired = source.bracesBefore(Int.MAX_VALUE) == 0
    return all.filterNot {
        if (paired) isAboutBrace(it, source) else isOpeningBrace(it, source)
    }.ifEmpty { all }.toSet()
}

private fun isAboutBrace(problem: EcjProblem, source: SourceText) =
    isOpeningBrace(problem, source) || problem.arguments.firstOrNull() == "}"

private fun isOpeningBrace(problem: EcjProblem, source: SourceText) = source.words(problem.start, problem.end) == "{"

/**
 * Drops each proposal to insert `::`, which Java 1.3 does not have, if ECJ also reports another missing token at the
 * same place, such as the semicolon after a name that ends a statement.
 */
internal fun withoutMethodReferences(problems: List<EcjProblem>): List<EcjProblem> {
    val (references, others) = problems.partition {
        it.isSyntax && it.arguments.firstOrNull()?.startsWith("::") == true
    }
    if (references.isEmpty()) return problems
    val places = others.filter { it.isSyntax }.mapTo(mutableSetOf()) { it.start to it.end }
    return problems.filter { it !in references || (it.start to it.end) !in places }
}
