package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages

/** Explains the syntax errors in statements that beginners often make. */
internal class StatementAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val word = source.words(problem.start, problem.end)
        val expected = problem.arguments.lastOrNull().orEmpty()
        return unequal(word, problem, source)
            ?: foreignWord(word, problem, source)
            ?: misplaced(problem, source, expected)
            ?: condition(word, problem, source, expected)
            ?: noStatement(word, problem, source)
            ?: nameOrArray(word, problem, source, expected)
    }

    /** ECJ reports the second sign only. */
    private fun unequal(word: String, problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val both = SourceSpan(problem.start - 1, problem.end)
        if (word != ">" || source.words(both.start, both.end) != UNEQUAL) return null
        val right = javaEquivalent(UNEQUAL).orEmpty()
        return ProblemExplanation(
            messages.foreignWord(UNEQUAL, right),
            fix = JavaFix(source.range(both), right),
            at = both,
        )
    }

    private fun foreignWord(word: String, problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val range = source.range(problem.start, problem.end)
        val foreign = javaEquivalent(word)
        val small = keywordInOtherCase(word)
        return when {
            foreign == "" -> ProblemExplanation(messages.noSuchWord(word), fix = JavaFix(range, ""))
            foreign != null -> ProblemExplanation(messages.foreignWord(word, foreign), fix = JavaFix(range, foreign))
            small != null -> ProblemExplanation(messages.wrongCase(small), fix = JavaFix(range, small))
            else -> null
        }
    }

    private fun misplaced(problem: EcjProblem, source: SourceText, expected: String): ProblemExplanation? {
        val isWhole =
            problem.number == ProblemId.PARSING_ERROR_INSERT_BEFORE ||
                problem.number == ProblemId.PARSING_ERROR_DELETE_SEVERAL
        val isStatement = expected == "Identifier" || problem.arguments == listOf(";", ",")
        return when (source.bracesBefore(problem.start)) {
            0 -> if (isWhole) {
                ProblemExplanation(
                    messages.outsideClass(),
                    messages.beginWithClass(className(source)),
                )
            } else {
                null
            }

            1 -> if (isStatement) ProblemExplanation(messages.outsideMethod(), messages.moveIntoMethod()) else null

            else -> null
        }
    }

    private fun className(source: SourceText) = source.path.substringAfterLast('/').removeSuffix(".java")

    private fun condition(
        word: String,
        problem: EcjProblem,
        source: SourceText,
        expected: String,
    ): ProblemExplanation? = when {
        word in CONDITIONAL && expected == "(" -> {
            ProblemExplanation(messages.conditionInBrackets(word))
        }

        word == "else" && problem.number == ProblemId.PARSING_ERROR_DELETE -> {
            ProblemExplanation(messages.elseWithoutIf())
        }

        word == "," && IN_FOR.containsMatchIn(source.lineBefore(problem.start)) -> {
            ProblemExplanation(messages.semicolonsInFor(), fix = JavaFix(source.range(problem.start, problem.end), ";"))
        }

        expected != "AssignmentOperator" || problem.number != ProblemId.INVALID_TOKEN -> {
            null
        }

        word == "==" -> {
            ProblemExplanation(messages.setWithOneSign(), fix = JavaFix(source.range(problem.start, problem.end), "="))
        }

        else -> {
            ProblemExplanation(messages.noStatement())
        }
    }

    private fun noStatement(word: String, problem: EcjProblem, source: SourceText): ProblemExplanation? {
        if (problem.number != ProblemId.PARSING_ERROR_INSERT_TO_COMPLETE) return null
        val isName = word.firstOrNull()?.isJavaLetter() == true
        val endsHere = source.codeAt(source.codeFrom(problem.end)) == ';'
        val missing = problem.arguments.first()
        return when {
            missing == "VariableDeclarators" && isName && endsHere -> {
                ProblemExplanation(
                    messages.callWithBrackets(shortened(word)),
                    fix = source.insertion(problem.end, "()"),
                )
            }

            missing.startsWith("AssignmentOperator") && endsHere -> {
                ProblemExplanation(messages.noStatement())
            }

            missing.startsWith("... VariableDeclaratorId") -> {
                ProblemExplanation(messages.typeOfParameter())
            }

            else -> {
                null
            }
        }
    }

    private fun nameOrArray(
        word: String,
        problem: EcjProblem,
        source: SourceText,
        expected: String,
    ): ProblemExplanation? {
        val isNumber = word.isNotEmpty() && word.all { it.isDigit() }
        val after = source.codeAt(problem.end)
        return when {
            isNumber && source.codeBefore(
                problem.start,
            ) == '[' && after == ']' -> ProblemExplanation(messages.lengthOfArray())

            isNumber && after?.isJavaLetter() == true -> ProblemExplanation(messages.nameBeginsWithLetter())

            word in KEYWORDS && expected == "VariableDeclaratorId" -> ProblemExplanation(messages.reservedWord(word))

            else -> null
        }
    }

    private fun Char.isJavaLetter() = isLetter() || this == '_'

    private companion object {
        /** As other languages write it. */
        const val UNEQUAL = "<>"

        val CONDITIONAL = setOf("if", "while", "for")
        val IN_FOR = Regex("""\bfor\s*\([^)]*$""")
    }
}
