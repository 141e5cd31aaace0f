package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.messages.JavaMessages

/**
 * Suggests the names that misspelled names may mean.
 *
 * @param undeclared the undeclared names, which are never suggested.
 */
internal class NameSuggestions(private val undeclared: Set<String>, private val messages: JavaMessages) {
    /** Returns [message] with the hint and fix to use [suggestion], or [message] alone if there is no suggestion. */
    fun suggested(problem: EcjProblem, source: SourceText, message: String, suggestion: String?): ProblemExplanation {
        if (suggestion == null) return ProblemExplanation(message)
        val written = source.words(problem.start, problem.end)
        val sameLetters = suggestion.equals(written, ignoreCase = true)
        val hint = if (sameLetters) messages.wrongCase(suggestion) else messages.didYouMean(suggestion)
        return ProblemExplanation(message, hint, JavaFix(source.range(problem.start, problem.end), suggestion))
    }

    /** The names in the source that may be declared. */
    fun namesIn(source: SourceText): List<String> = source.names.filterNot { it in KEYWORDS || it in undeclared }

    fun classesIn(source: SourceText): List<String> = namesIn(source).filter { it.first().isUpperCase() }
}
