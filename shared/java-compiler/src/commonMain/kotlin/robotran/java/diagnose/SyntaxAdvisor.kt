package robotran.java.diagnose

import robotran.java.EcjProblem
import robotran.java.JavaFix
import robotran.java.JavaMessages
import robotran.java.ProblemNumber

/** What to tell about sources that cannot be read. ECJ's arguments are words of the source and of its grammar. */
internal class SyntaxAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): Advice? {
        val word = source.words(problem.start, problem.end)
        return when (problem.number) {
            ProblemNumber.PARSING_ERROR_INSERT_TO_COMPLETE -> {
                missing(problem.arguments.first(), problem, source, word)
            }

            ProblemNumber.PARSING_ERROR_INSERT_AFTER -> {
                insertAfter(problem, source, word)
            }

            ProblemNumber.PARSING_ERROR_DELETE, ProblemNumber.UNMATCHED_BRACKET -> {
                Advice(if (word in BRACKETS) messages.extraBracket(word) else messages.notUnderstood(word))
            }

            ProblemNumber.PARSING_ERROR, ProblemNumber.PARSING_ERROR_INSERT_BEFORE -> {
                expected(problem, word)
            }

            ProblemNumber.UNTERMINATED_STRING -> {
                Advice(messages.unclosedText())
            }

            ProblemNumber.INVALID_CHARACTER_CONSTANT -> {
                Advice(messages.wrongCharacter())
            }

            ProblemNumber.SOURCE_TOO_LONG -> {
                Advice(messages.sourceTooLong(problem.arguments.first()))
            }

            ProblemNumber.NESTED_TOO_DEEPLY -> {
                Advice(messages.nestedTooDeeply())
            }

            else -> {
                if (problem.isSyntax && word.isNotBlank()) Advice(messages.notUnderstood(shortened(word))) else null
            }
        }
    }

    private fun missing(expected: String, problem: EcjProblem, source: SourceText, word: String): Advice {
        val symbol = expected.substringBefore(' ')
        val insertion = JavaFix(source.range(problem.end, problem.end), symbol)
        return when (symbol) {
            ";" -> Advice(messages.missingSemicolon(), fix = insertion, atEnd = true)
            ")", "]" -> Advice(messages.missingBracket(symbol), fix = insertion, atEnd = true)
            "}" -> Advice(messages.missingBracket(symbol), atEnd = true)
            else -> Advice(messages.somethingMissing(shortened(word)))
        }
    }

    private fun insertAfter(problem: EcjProblem, source: SourceText, word: String): Advice {
        val symbol = problem.arguments.last()
        return when {
            symbol == ";" || symbol in BRACKETS -> missing(symbol, problem, source, word)
            isReadable(symbol) -> Advice(messages.expectedAfter(shortened(word), symbol))
            else -> Advice(messages.somethingMissing(shortened(word)))
        }
    }

    private fun expected(problem: EcjProblem, word: String): Advice {
        val expected = problem.arguments.last()
        return Advice(
            if (isReadable(expected)) messages.expectedInstead(shortened(word), expected) else messages.notUnderstood(shortened(word)),
        )
    }

    /** The grammar's names for groups of words, such as `ReferenceType`, tell a pupil nothing. */
    private fun isReadable(expected: String) = ' ' !in expected && expected.none { it.isUpperCase() }

    private companion object {
        val BRACKETS = setOf("(", ")", "[", "]", "{", "}")
    }
}
