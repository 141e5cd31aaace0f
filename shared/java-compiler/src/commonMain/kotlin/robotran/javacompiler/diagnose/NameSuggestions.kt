package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.SourceFix

/**
 * Suggests the names that misspelled names may mean.
 *
 * @param undeclared the undeclared names, which are never suggested.
 */
internal class NameSuggestions(private val undeclared: Set<String>, private val messages: JavaMessages) {
    /**
     * Returns [message] with the hint to use the first of [likely], which are equally likely, or [message] alone if
     * there is none. A fix is certain only of a single one.
     */
    fun suggested(problem: EcjProblem, source: SourceText, message: String, likely: List<String>): ProblemExplanation {
        val suggestion = likely.firstOrNull() ?: return ProblemExplanation(message)
        val written = source.words(problem.start, problem.end)
        val sameLetters = suggestion.equals(written, ignoreCase = true)
        val hint = if (sameLetters) messages.wrongCase(suggestion) else messages.didYouMean(suggestion)
        val fix = SourceFix(source.range(problem.start, problem.end), suggestion)
        return ProblemExplanation(message, hint, fix.takeIf { likely.size == 1 })
    }

    /** The names in the source that may be declared. */
    fun namesIn(source: SourceText): List<String> = source.names.filterNot { it in KEYWORDS || it in undeclared }

    fun classesIn(source: SourceText): List<String> = namesIn(source).filter { it.first().isUpperCase() }
}
