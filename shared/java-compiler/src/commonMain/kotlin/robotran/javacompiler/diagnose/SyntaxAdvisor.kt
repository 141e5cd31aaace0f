package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.SourceFix
import robotran.language.source.SourceSpan

/** Explains syntax errors. The arguments of ECJ's problems are words of the source and symbols of its grammar. */
internal class SyntaxAdvisor(private val messages: JavaMessages) {
    private val statements = StatementAdvisor(messages)

    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        if (problem.isSyntax) {
            source.unclosedString(problem.start)?.let {
                return ProblemExplanation(
                    messages.unclosedString(),
                    messages.closeString(),
                    at = SourceSpan(
                        it,
                        it + 1,
                    ),
                )
            }
            statements.advice(problem, source)?.let { return it }
        }
        val word = source.words(problem.start, problem.end)
        return when (problem.number) {
            ProblemId.PARSING_ERROR_INSERT_TO_COMPLETE -> missing(problem.arguments.first(), problem, source, word)
            ProblemId.PARSING_ERROR_INSERT_AFTER -> insertAfter(problem, source, word)
            ProblemId.PARSING_ERROR_DELETE, ProblemId.UNMATCHED_BRACKET -> extra(word)
            ProblemId.PARSING_ERROR, ProblemId.PARSING_ERROR_INSERT_BEFORE -> expected(problem, word)

            ProblemId.UNTERMINATED_COMMENT -> ProblemExplanation(
                messages.unclosedComment(),
                at = SourceSpan(problem.start, problem.start + 2),
            )

            ProblemId.UNTERMINATED_STRING -> ProblemExplanation(messages.unclosedString(), messages.closeString())
            ProblemId.INVALID_CHARACTER_CONSTANT -> wrongCharacter(problem, source, word)

            ProblemId.ARRAY_CONSTANT_OUTSIDE_INITIALIZER -> ProblemExplanation(
                messages.notUnderstood(shortened(word)),
                messages.arrayOfValues(),
            )

            else -> if (problem.isSyntax && word.isNotBlank()) {
                ProblemExplanation(messages.notUnderstood(shortened(word)))
            } else {
                null
            }
        }
    }

    private fun extra(word: String) = ProblemExplanation(
        if (word in
            BRACKETS
        ) {
            messages.extraBracket(word)
        } else {
            messages.notUnderstood(shortened(word))
        },
    )

    private fun missing(expected: String, problem: EcjProblem, source: SourceText, word: String): ProblemExplanation {
        val symbol = expected.substringBefore(' ')
        val behind = SourceSpan(problem.end, problem.end)
        val insertion = source.insertion(problem.end, symbol)
        return when (symbol) {
            ";" -> ProblemExplanation(messages.missingSemicolon(), fix = insertion, at = behind)
            ")", "]" -> ProblemExplanation(messages.missingBracket(symbol), fix = insertion, at = behind)
            "}" -> missingBrace(problem, source, word)
            "Finally" -> ProblemExplanation(messages.tryAlone(), messages.addCatch())
            else -> ProblemExplanation(messages.somethingMissing(shortened(word)))
        }
    }

    /** ECJ reports either the unclosed brace or the last word before the place where it should be closed. */
    private fun missingBrace(problem: EcjProblem, source: SourceText, word: String): ProblemExplanation {
        val message = messages.missingBracket("}")
        return if (word == "{") {
            ProblemExplanation(message)
        } else {
            ProblemExplanation(
                message,
                fix = source.insertion(problem.end, "\n}"),
                at = SourceSpan(problem.end, problem.end),
            )
        }
    }

    private fun insertAfter(problem: EcjProblem, source: SourceText, word: String): ProblemExplanation {
        val symbol = problem.arguments.last()
        return when {
            symbol == ";" || symbol in BRACKETS -> missing(symbol, problem, source, word)
            isReadable(symbol) -> ProblemExplanation(messages.expectedAfter(shortened(word), symbol))
            else -> ProblemExplanation(messages.somethingMissing(shortened(word)))
        }
    }

    private fun expected(problem: EcjProblem, word: String): ProblemExplanation {
        val expected = problem.arguments.last()
        val readable = isReadable(expected) && word.isNotBlank()
        return ProblemExplanation(
            if (readable) {
                messages.expectedInstead(
                    shortened(word),
                    expected,
                )
            } else {
                messages.notUnderstood(shortened(word))
            },
        )
    }

    private fun wrongCharacter(problem: EcjProblem, source: SourceText, word: String): ProblemExplanation {
        val text = word.removeSurrounding("'")
        val isText = word.length > 2 && text.length == word.length - 2 && '"' !in text
        return ProblemExplanation(
            messages.wrongCharacter(),
            fix = if (isText) SourceFix(source.range(problem.start, problem.end), "\"$text\"") else null,
        )
    }

    /** Whether [expected] makes sense to a pupil; names of grammar symbols, such as `ReferenceType`, do not. */
    private fun isReadable(expected: String) = ' ' !in expected && expected.none { it.isUpperCase() }

    private companion object {
        val BRACKETS = setOf("(", ")", "[", "]", "{", "}")
    }
}
