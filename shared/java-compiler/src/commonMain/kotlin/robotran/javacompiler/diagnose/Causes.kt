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
    // The rest of the source is in the comment.
    all.find { it.number == ProblemId.UNTERMINATED_COMMENT }?.let { return setOf(it) }
    // An unclosed string hides brackets and semicolons from the parser.
    val unclosed = all.filter { source.unclosedString(it.start) != null }
    if (unclosed.isNotEmpty()) return unclosed.toSet()
    if (all.any { it.number in StructureErrors.NUMBERS }) return withStructure(source, all)
    // An unclosed brace is reported where it should be closed. If the braces match in number, none is reported.
    val paired = source.bracesBefore(Int.MAX_VALUE) == 0
    return all.filterNot {
        if (paired) isAboutBrace(it, source) else isOpeningBrace(it, source)
    }.ifEmpty { all }.toSet()
}

/** The mistakes of structure among [all], and the others that do not only follow from them. */
private fun withStructure(source: SourceText, all: List<EcjProblem>): Set<EcjProblem> {
    val (structure, others) = all.partition { it.number in StructureErrors.NUMBERS }
    val derailing = structure.filter { it.number in StructureErrors.DERAILING }
    val derailed = derailing.minOfOrNull { it.start } ?: Int.MAX_VALUE
    val starts = structure.mapTo(mutableSetOf()) { it.start }
    val lines = structure.mapTo(mutableSetOf()) { source.range(it.start, it.start).line }
    val kept = others.filterNot {
        // ECJ may report the last word before them.
        it.end > derailed || source.codeFrom(it.end) in starts || isAboutBrace(it, source) ||
            source.range(it.start, it.start).line in lines
    }
    return (structure + kept).toSet()
}

private fun isAboutBrace(problem: EcjProblem, source: SourceText) =
    isOpeningBrace(problem, source) || problem.arguments.firstOrNull() == "}"

private fun isOpeningBrace(problem: EcjProblem, source: SourceText) = source.words(problem.start, problem.end) == "{"

/**
 * [problems] without those that only follow from a `for` that ends with a semicolon, so that its variable is unknown in
 * the block behind; the semicolon is the mistake.
 */
internal fun withoutLostLoopVariables(source: SourceText, problems: List<EcjProblem>): List<EcjProblem> {
    val unknown = problems.filter { it.number in UNKNOWN_VARIABLES }
    if (unknown.isEmpty()) return problems
    val loops = problems.filter { it.number == ProblemId.EMPTY_STATEMENT && !it.isError }.mapNotNull { empty ->
        val name = LOOP_VARIABLE.find(source.lineBefore(empty.start))?.groupValues?.get(1)
        val lost = unknown.filter { it.start > empty.start && source.words(it.start, it.end) == name }
        if (lost.isEmpty()) null else empty to lost
    }
    val semicolons = loops.map { it.first }.toSet()
    val lost = loops.flatMap { it.second }.toSet()
    return problems.filter { it !in lost }.map { if (it in semicolons) it.asError() else it }
}

private val UNKNOWN_VARIABLES = setOf(ProblemId.UNRESOLVED_VARIABLE, ProblemId.UNDEFINED_NAME)

/** The variable that a `for` before the end of this line declares. */
private val LOOP_VARIABLE = Regex("""\bfor\s*\(\s*(?:final\s+)?\w+\s+(\w+)\s*=[^{}]*$""")

private fun EcjProblem.asError() =
    EcjProblem(path, number, isError = true, isSyntax, start, end, message, arguments, members)

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
