package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.SourceFix
import robotran.language.source.SourceSpan

/** Explains the syntax errors in statements that beginners often make. */
internal class StatementAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val word = source.words(problem.start, problem.end)
        val expected = problem.arguments.lastOrNull().orEmpty()
        return misspeltOperator(problem, source)
            ?: foreignWord(word, problem, source)
            ?: decimalComma(problem, source, expected)
            ?: condition(word, problem, source, expected)
            ?: noStatement(word, problem, source)
            ?: nameOrArray(word, problem, source, expected)
    }

    /** ECJ reports one of the signs only. */
    private fun misspeltOperator(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val before = source.lineBefore(problem.start).takeLastWhile { it in OPERATOR_SIGNS }
        val behind = source.codeBehind(problem.start).takeWhile { it in OPERATOR_SIGNS }
        if (behind.isEmpty()) return null
        val written = before + behind
        val right = javaEquivalent(written) ?: return null
        val span = SourceSpan(problem.start - before.length, problem.start + behind.length)
        return ProblemExplanation(
            messages.foreignWord(written, right),
            fix = SourceFix(source.range(span), right),
            at = span,
        )
    }

    /** ECJ takes `1,5` for two values. */
    private fun decimalComma(problem: EcjProblem, source: SourceText, expected: String): ProblemExplanation? {
        if (problem.number != ProblemId.INVALID_TOKEN || expected != "VariableDeclarator") return null
        val comma = decimalCommaIn(source, problem.start, problem.start) ?: return null
        val type = DECLARED_TYPE.find(source.lineBefore(comma.span.start))?.groupValues?.get(1)
        return ProblemExplanation(
            messages.decimalPoint(comma.pointed),
            fix = comma.fixFor(type.orEmpty(), source),
            at = comma.span,
        )
    }

    private fun foreignWord(word: String, problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val range = source.range(problem.start, problem.end)
        val foreign = javaEquivalent(word)
        val small = keywordInOtherCase(word)
        return when {
            foreign == "" -> ProblemExplanation(messages.noSuchWord(word), fix = SourceFix(range, ""))
            foreign != null -> ProblemExplanation(messages.foreignWord(word, foreign), fix = SourceFix(range, foreign))
            small != null -> ProblemExplanation(messages.wrongCase(small), fix = SourceFix(range, small))
            else -> null
        }
    }

    private fun condition(
        word: String,
        problem: EcjProblem,
        source: SourceText,
        expected: String,
    ): ProblemExplanation? = when {
        word in CONDITIONAL && expected == "(" -> ProblemExplanation(messages.conditionInBrackets(word))

        word == "else" && problem.number == ProblemId.PARSING_ERROR_DELETE -> {
            ProblemExplanation(messages.elseWithoutIf())
        }

        word == "," && IN_FOR.containsMatchIn(source.lineBefore(problem.start)) -> {
            ProblemExplanation(
                messages.semicolonsInFor(),
                fix = SourceFix(source.range(problem.start, problem.end), ";"),
            )
        }

        expected != "AssignmentOperator" || problem.number != ProblemId.INVALID_TOKEN -> null

        word == "==" -> {
            ProblemExplanation(
                messages.setWithOneSign(),
                fix = SourceFix(source.range(problem.start, problem.end), "="),
            )
        }

        else -> ProblemExplanation(messages.noStatement())
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

            missing.startsWith("AssignmentOperator") && endsHere -> ProblemExplanation(messages.noStatement())
            missing.startsWith("... VariableDeclaratorId") -> ProblemExplanation(messages.typeOfParameter())
            else -> null
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
        const val OPERATOR_SIGNS = "<>=!&|"

        /** The type of a variable that is declared and set in one statement. */
        val DECLARED_TYPE = Regex("""(\w+)\s+\w+\s*=\s*$""")
        val CONDITIONAL = setOf("if", "while", "for")
        val IN_FOR = Regex("""\bfor\s*\([^)]*$""")
    }
}
