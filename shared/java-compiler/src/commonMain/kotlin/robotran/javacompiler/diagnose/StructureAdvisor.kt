package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.SourceFix

/** Explains the [StructureErrors] of a source. */
internal class StructureAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val range = source.range(problem.start, problem.end)
        val word = problem.arguments.firstOrNull().orEmpty()
        return when (problem.number) {
            ProblemId.OUTSIDE_CLASS -> ProblemExplanation(
                messages.outsideClass(),
                when {
                    word.isNotEmpty() -> messages.moveIntoClass(word)
                    StructureErrors.METHOD in problem.arguments -> messages.putIntoClass(source.className)
                    else -> messages.beginWithClass(source.className)
                },
            )

            ProblemId.OUTSIDE_METHOD -> ProblemExplanation(messages.outsideMethod(), messages.moveIntoMethod())

            ProblemId.METHOD_IN_METHOD -> ProblemExplanation(
                messages.methodInMethod(shortened(word)),
                messages.moveOutOfMethod(),
            )

            ProblemId.WORD_IN_OTHER_CASE -> ProblemExplanation(messages.wrongCase(word), fix = SourceFix(range, word))

            ProblemId.NAME_OF_SEVERAL_WORDS -> ProblemExplanation(
                messages.nameIsOneWord(shortened(word)),
                // The file has to have the name of the class.
                fix = SourceFix(range, word).takeIf { word == source.className },
            )

            ProblemId.CONDITION_WITHOUT_BRACKETS -> condition(problem, source, word)
            ProblemId.RESERVED_NAME -> ProblemExplanation(messages.reservedWord(word))
            else -> null
        }
    }

    private fun condition(problem: EcjProblem, source: SourceText, word: String): ProblemExplanation {
        val end = problem.arguments.getOrNull(1)?.toIntOrNull()
        val start = source.codeFrom(problem.end)
        val range = end?.let { source.range(start, it) }
        val written = end?.let { source.words(start, it) }.orEmpty()
        val isInLine = end != null && written.length == end - start
        return ProblemExplanation(
            messages.conditionInBrackets(word),
            fix = range?.takeIf { isInLine }?.let { SourceFix(it, "($written)") },
        )
    }
}
