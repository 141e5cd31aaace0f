package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.ecj.EcjCompilation
import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.language.source.SourceSpan
import robotran.languagesupport.SourceFile

/** The max number of characters that a message quotes from the source. */
private const val MAX_QUOTED_CHARACTERS = 40

/** The max number of reported problems, errors first. It bounds the time for a source full of errors. */
private const val MAX_PROBLEMS = 300

internal fun shortened(text: String) = if (text.length <= MAX_QUOTED_CHARACTERS) {
    text
} else {
    text.take(MAX_QUOTED_CHARACTERS - 2) + ".."
}

/** Turns ECJ's problems in [sources] into diagnostics for pupils: at most one per line, and no follow-up errors. */
internal class Diagnosis(
    sources: List<SourceFile>,
    library: Map<String, ByteArray>,
    private val compilation: EcjCompilation,
    private val messages: JavaMessages,
    missing: MissingMembers,
    target: BrickTarget,
) {
    private val sources = sources.map(::SourceText)
    private val byPath = compilation.problems.sortedByDescending { it.isError }.take(MAX_PROBLEMS).groupBy { it.path }
        .mapValues { (path, problems) -> cleared(problems, this.sources.first { it.path == path }) }
    private val suggestions = NameSuggestions(undeclaredNames(), messages)
    private val libraryNames = LibraryNames(library)
    private val lejos = LejosAdvisor(missing, messages)
    private val brick = BrickAdvisor(messages)
    private val gaps = BrickGaps.of(target, messages)
    private val names = NameAdvisor(libraryNames, suggestions, gaps, messages)
    private val members = MemberAdvisor(libraryNames, suggestions, gaps, messages)
    private val meaning = SemanticAdvisor(messages, libraryNames, boxes = target == BrickTarget.LEJOS_NXJ)
    private val structure = StructureAdvisor(messages)
    private val syntax = SyntaxAdvisor(messages)
    private val limits = LimitAdvisor(messages)

    /** The diagnostics in the order of the sources. They contain at least one error if the compilation failed. */
    fun diagnostics(): List<Diagnostic> {
        val causes = sources.flatMap { source -> diagnosticsOf(source, causes(source, byPath[source.path].orEmpty())) }
        val found = if (hasErrors(causes)) causes else sources.flatMap { diagnosticsOf(it, byPath[it.path].orEmpty()) }
        val succeeded = compilation.completed && compilation.problems.none { it.isError }
        return if (succeeded || hasErrors(found)) found else found + compilerFailed()
    }

    /** The diagnostic for a missing main method; null if there is one. */
    fun missingMain(): Diagnostic? =
        if (compilation.mainClasses.isEmpty()) MissingMainMethod(messages).missing(sources) else null

    /** [problems] of [source] without some that ECJ only guesses, and with what it does not see. */
    private fun cleared(problems: List<EcjProblem>, source: SourceText): List<EcjProblem> {
        // ECJ takes a call such as `stop();` in a class for a method whose type is missing, not for a syntax error.
        val isSuspect = problems.any {
            (it.isSyntax && !BrickAdvisor.isOnlyNewer(it)) || it.number == ProblemId.MISSING_RETURN_TYPE
        }
        val structure = if (isSuspect) StructureErrors(source).problems() else emptyList()
        return structure + withoutLostLoopVariables(source, withoutMethodReferences(problems))
    }

    private fun undeclaredNames(): Set<String> = sources.flatMap { source ->
        byPath[source.path].orEmpty().filter { it.number in NameAdvisor.NUMBERS }.map { source.words(it.start, it.end) }
    }.toSet()

    private fun diagnosticsOf(source: SourceText, problems: List<EcjProblem>): List<Diagnostic> {
        val all = problems.map { diagnostic(it, source) }
        val order = compareBy<Diagnostic> { it.range?.line }.thenBy { it.severity }.thenBy { it.range?.column }
        return all.sortedWith(order).distinctBy { it.range?.line }
    }

    private fun hasErrors(diagnostics: List<Diagnostic>) = diagnostics.any { it.severity == Severity.ERROR }

    private fun diagnostic(problem: EcjProblem, source: SourceText): Diagnostic {
        val advice = structure.advice(problem, source)
            ?: lejos.advice(problem, source)
            ?: brick.advice(problem)
            ?: names.advice(problem, source)
            ?: members.advice(problem, source)
            ?: meaning.advice(problem, source)
            ?: syntax.advice(problem, source)
            ?: limits.advice(problem)
            ?: ProblemExplanation(messages.compilerSays(problem.message.trim().removeSuffix(".") + "."))
        val span = advice.at ?: SourceSpan(problem.start, problem.end)
        return Diagnostic(
            file = source.path,
            severity = if (problem.isError) Severity.ERROR else Severity.WARNING,
            range = source.range(span),
            text = source.words(span.start, span.end),
            message = advice.sentences,
            fix = advice.fix,
        )
    }

    private fun compilerFailed() = Diagnostic(
        file = sources.firstOrNull()?.path.orEmpty(),
        severity = Severity.ERROR,
        range = SourceRange(1, 1, 1),
        message = messages.compilerFailed(),
    )
}
