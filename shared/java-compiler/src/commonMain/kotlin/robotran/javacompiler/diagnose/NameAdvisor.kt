package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.othersOfSeries
import robotran.language.source.SourceFix

/**
 * Explains undeclared classes, imports and variables: names the brick's alternative, the missing import, or the likely
 * intended name.
 */
internal class NameAdvisor(
    private val library: LibraryNames,
    private val suggestions: NameSuggestions,
    private val gaps: BrickGaps,
    private val messages: JavaMessages,
) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val written = source.words(problem.start, problem.end)
        return when (problem.number) {
            ProblemId.IMPORT_NOT_FOUND -> importAdvice(problem, source, written)
            ProblemId.UNDEFINED_TYPE -> classAdvice(problem, source, written)
            ProblemId.AMBIGUOUS_TYPE -> choiceAdvice(problem, source, written)
            ProblemId.UNDEFINED_NAME, ProblemId.UNRESOLVED_VARIABLE -> name(problem, source, written)
            else -> null
        }
    }

    private fun name(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        constant(problem, source, name)?.let { return it }
        val isClass = name.firstOrNull()?.isUpperCase() == true
        val isLiteral = keywordInOtherCase(name) in LITERALS
        return if (isClass && !isLiteral) classAdvice(problem, source, name) else variableAdvice(problem, source, name)
    }

    /** A constant of the brick's classes without its class. A single letter may be anything, unless a dot follows. */
    private fun constant(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation? {
        if (name.length == 1 && source.codeAt(source.codeFrom(problem.end)) != '.') return null
        val others = othersOfSeries(name, gaps.constants.keys).map { "${gaps.constants[it]}.$it" }
        val owner = gaps.constants[name]
            ?: return ProblemExplanation(
                messages.unknownVariable(name),
                messages.useOneOf(others.joinToString()),
            ).takeIf { others.isNotEmpty() }
        val full = "$owner.$name"
        val isImported = library.homesOf(owner).any { source.imports(owner, it) }
        val fix = SourceFix(source.range(problem.start, problem.end), full).takeIf { isImported }
        return ProblemExplanation(messages.unknownVariable(name), messages.didYouMean(full), fix)
    }

    private fun importAdvice(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val message = messages.unknownImport(shortened(name))
        // ECJ reports only the missing part: for lejos.nxt.Motor, only lejos.
        val instead = gaps.instead(source.snippetUntil(problem.start, ';'))
        val home = library.packageOf(name)?.let { "$it.$name" }
        return when {
            instead != null -> ProblemExplanation(message, instead)

            else -> suggestions.suggested(
                problem,
                source,
                message,
                home?.let(::listOf) ?: nearest(name, library.packages + library.qualifiedNames, MAX_ERRORS_IN_IMPORT),
            )
        }
    }

    private fun foreignWord(
        problem: EcjProblem,
        source: SourceText,
        name: String,
        message: String,
    ): ProblemExplanation? {
        val range = source.range(problem.start, problem.end)
        val foreign = javaEquivalent(name)?.ifEmpty { null }
        val small = keywordInOtherCase(name)
        return when {
            small != null -> ProblemExplanation(message, messages.wrongCase(small), SourceFix(range, small))
            foreign != null -> ProblemExplanation(messages.foreignWord(name, foreign), fix = SourceFix(range, foreign))
            else -> null
        }
    }

    private fun classAdvice(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val newer = newerFeature(name)
        val instead = gaps.instead(name)
        val home = library.packageOf(name)
        val message = messages.unknownClass(shortened(name))
        return when {
            newer != null -> ProblemExplanation(messages.newerJava(newer), messages.insteadOf(newer))
            instead != null -> ProblemExplanation(message, instead)

            home != null && source.imports(name, home) -> {
                val constants = gaps.constants.filterValues { it == name }.keys.joinToString { "$name.$it" }
                ProblemExplanation(
                    messages.classIsNoValue(shortened(name)),
                    messages.useOneOf(constants).takeIf { constants.isNotEmpty() },
                )
            }

            home != null -> {
                "import $home.*;".let { ProblemExplanation(message, messages.importIt(it), source.addLineAtTop(it)) }
            }

            else -> {
                foreignWord(problem, source, name, message)
                    ?: suggestions.suggested(
                        problem,
                        source,
                        message,
                        nearest(
                            name,
                            library.simpleNames + suggestions.classesIn(source),
                        ),
                    )
            }
        }
    }

    /**
     * Several of the imported packages have the class; a program most likely means that of the brick, but with types in
     * angle brackets that of Java.
     */
    private fun choiceAdvice(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val message = messages.severalClasses(shortened(name))
        val candidates = library.qualifiedNames.filter { it.substringAfterLast('.') == name }
        val isGeneric = source.codeAt(source.codeFrom(problem.end)) == '<'
        val home = candidates.firstOrNull { it.startsWith("java.") == isGeneric } ?: candidates.firstOrNull()
        return home?.let { "import $it;" }
            ?.let { ProblemExplanation(message, messages.importIt(it), source.addLineAtTop(it)) }
            ?: ProblemExplanation(message)
    }

    private fun variableAdvice(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val message = messages.unknownVariable(shortened(name))
        foreignWord(problem, source, name, message)?.let { return it }
        val near = nearest(name, suggestions.namesIn(source) + library.simpleNames)
        return if (near.isEmpty()) {
            ProblemExplanation(message, messages.declareIt(shortened(name)))
        } else {
            suggestions.suggested(problem, source, message, near)
        }
    }

    companion object {
        private val LITERALS = setOf("true", "false", "null", "this")

        /** Imports are long, so one typing error per three letters would allow too many. */
        private const val MAX_ERRORS_IN_IMPORT = 2

        /** The problems with undeclared names. */
        val NUMBERS = setOf(
            ProblemId.IMPORT_NOT_FOUND,
            ProblemId.UNDEFINED_TYPE,
            ProblemId.UNDEFINED_NAME,
            ProblemId.UNRESOLVED_VARIABLE,
            ProblemId.UNDEFINED_FIELD,
            ProblemId.UNDEFINED_METHOD,
        )
    }
}
