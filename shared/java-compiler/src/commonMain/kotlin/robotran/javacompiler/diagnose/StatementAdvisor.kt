package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemNumber
import robotran.javacompiler.messages.JavaMessages

/** What to tell about statements that cannot be read for a reason that beginners often have. */
internal class StatementAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): Advice? {
        val word = source.words(problem.start, problem.end)
        val expected = problem.arguments.lastOrNull().orEmpty()
        return otherWord(word, problem, source)
            ?: misplaced(problem, source, expected)
            ?: condition(word, problem, source, expected)
            ?: noStatement(word, problem, source)
            ?: nameOrArray(word, problem, source, expected)
    }

    private fun otherWord(word: String, problem: EcjProblem, source: SourceText): Advice? {
        val range = source.range(problem.start, problem.end)
        val foreign = javaFor(word)
        val small = smallWord(word)
        return when {
            foreign == "" -> Advice(messages.noSuchWord(word), fix = JavaFix(range, ""))
            foreign != null -> Advice(messages.otherWord(word, foreign), fix = JavaFix(range, foreign))
            small != null -> Advice(messages.lettersOf(small), fix = JavaFix(range, small))
            else -> null
        }
    }

    private fun misplaced(problem: EcjProblem, source: SourceText, expected: String): Advice? {
        val isWhole =
            problem.number == ProblemNumber.PARSING_ERROR_INSERT_BEFORE || problem.number == ProblemNumber.PARSING_ERROR_DELETE_SEVERAL
        val isStatement = expected == "Identifier" || problem.arguments == listOf(";", ",")
        return when (source.bracesBefore(problem.start)) {
            0 -> if (isWhole) Advice(messages.outsideClass(), messages.beginWithClass(className(source))) else null
            1 -> if (isStatement) Advice(messages.outsideMethod(), messages.moveIntoMethod()) else null
            else -> null
        }
    }

    private fun className(source: SourceText) = source.path.substringAfterLast('/').removeSuffix(".java")

    private fun condition(word: String, problem: EcjProblem, source: SourceText, expected: String): Advice? = when {
        word in CONDITIONAL && expected == "(" -> {
            Advice(messages.conditionInBrackets(word))
        }

        word == "else" && problem.number == ProblemNumber.PARSING_ERROR_DELETE -> {
            Advice(messages.elseWithoutIf())
        }

        word == "," && IN_FOR.containsMatchIn(source.lineBefore(problem.start)) -> {
            Advice(messages.semicolonsInFor(), fix = JavaFix(source.range(problem.start, problem.end), ";"))
        }

        expected != "AssignmentOperator" || problem.number != ProblemNumber.INVALID_TOKEN -> {
            null
        }

        word == "==" -> {
            Advice(messages.setWithOneSign(), fix = JavaFix(source.range(problem.start, problem.end), "="))
        }

        else -> {
            Advice(messages.noStatement())
        }
    }

    private fun noStatement(word: String, problem: EcjProblem, source: SourceText): Advice? {
        if (problem.number != ProblemNumber.PARSING_ERROR_INSERT_TO_COMPLETE) return null
        val isName = word.firstOrNull()?.isJavaLetter() == true
        val endsHere = source.codeAt(source.codeFrom(problem.end)) == ';'
        val missing = problem.arguments.first()
        return when {
            missing == "VariableDeclarators" && isName && endsHere -> {
                Advice(messages.callWithBrackets(shortened(word)), fix = source.insertion(problem.end, "()"))
            }

            missing.startsWith("AssignmentOperator") && endsHere -> {
                Advice(messages.noStatement())
            }

            missing.startsWith("... VariableDeclaratorId") -> {
                Advice(messages.typeOfParameter())
            }

            else -> {
                null
            }
        }
    }

    private fun nameOrArray(word: String, problem: EcjProblem, source: SourceText, expected: String): Advice? {
        val isNumber = word.isNotEmpty() && word.all { it.isDigit() }
        val after = source.codeAt(problem.end)
        return when {
            isNumber && source.codeBefore(problem.start) == '[' && after == ']' -> Advice(messages.lengthOfArray())
            isNumber && after?.isJavaLetter() == true -> Advice(messages.nameBeginsWithLetter())
            word in KEYWORDS && expected == "VariableDeclaratorId" -> Advice(messages.wordOfJava(word))
            else -> null
        }
    }

    private fun Char.isJavaLetter() = isLetter() || this == '_'

    private companion object {
        val CONDITIONAL = setOf("if", "while", "for")
        val IN_FOR = Regex("""\bfor\s*\([^)]*$""")
    }
}
