package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.messages.JavaMessages

/**
 * Finds the names that are meant by slips.
 *
 * @param undeclared all names that nothing declares, since none of them can be meant by another.
 */
internal class NameSuggestions(private val undeclared: Set<String>, private val messages: JavaMessages) {
    /** [message] with the advice to write [suggestion] in the place of the problem, if there is one. */
    fun suggested(problem: EcjProblem, source: SourceText, message: String, suggestion: String?): ProblemExplanation {
        if (suggestion == null) return ProblemExplanation(message)
        val written = source.words(problem.start, problem.end)
        val sameLetters = suggestion.equals(written, ignoreCase = true)
        val hint = if (sameLetters) messages.lettersOf(suggestion) else messages.didYouMean(suggestion)
        return ProblemExplanation(message, hint, JavaFix(source.range(problem.start, problem.end), suggestion))
    }

    /** The names of the source that may be declared. */
    fun namesIn(source: SourceText): List<String> = source.names.filterNot { it in KEYWORDS || it in undeclared }

    fun classesIn(source: SourceText): List<String> = namesIn(source).filter { it.first().isUpperCase() }
}
