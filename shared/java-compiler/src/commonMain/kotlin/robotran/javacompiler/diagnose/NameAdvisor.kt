package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemNumber
import robotran.javacompiler.messages.JavaMessages

/**
 * Explains undeclared classes, imports and variables: names the brick's alternative, the missing import, or the likely
 * intended name.
 */
internal class NameAdvisor(
    private val library: LibraryNames,
    private val nearNames: NameSuggestions,
    private val messages: JavaMessages,
) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val written = source.words(problem.start, problem.end)
        return when (problem.number) {
            ProblemNumber.IMPORT_NOT_FOUND -> importAdvice(problem, source, written)
            ProblemNumber.UNDEFINED_TYPE -> classAdvice(problem, source, written)
            ProblemNumber.UNDEFINED_NAME, ProblemNumber.UNRESOLVED_VARIABLE -> name(problem, source, written)
            else -> null
        }
    }

    private fun name(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val isClass = name.firstOrNull()?.isUpperCase() == true
        val isLiteral = smallWord(name) in LITERALS
        return if (isClass && !isLiteral) classAdvice(problem, source, name) else variableAdvice(problem, source, name)
    }

    private fun importAdvice(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val message = messages.unknownImport(shortened(name))
        // ECJ reports only the missing part: for lejos.nxt.Motor, only lejos.
        val absent = absent(source.wordsUntil(problem.start, ';'))
        val home = library.packageOf(name)?.let { "$it.$name" }
        return when {
            absent != null -> ProblemExplanation(message, messages.absent(absent))

            else -> nearNames.suggested(
                problem,
                source,
                message,
                home ?: nearest(name, library.packages + library.qualifiedNames, FORGIVEN_IN_IMPORT),
            )
        }
    }

    private fun otherWord(problem: EcjProblem, source: SourceText, name: String, message: String): ProblemExplanation? {
        val range = source.range(problem.start, problem.end)
        val foreign = javaFor(name)?.ifEmpty { null }
        val small = smallWord(name)
        return when {
            small != null -> ProblemExplanation(message, messages.lettersOf(small), JavaFix(range, small))
            foreign != null -> ProblemExplanation(messages.otherWord(name, foreign), fix = JavaFix(range, foreign))
            else -> null
        }
    }

    private fun classAdvice(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val newer = newerWord(name)
        val absent = absent(name)
        val home = library.packageOf(name)
        val message = messages.unknownClass(shortened(name))
        return when {
            newer != null -> {
                ProblemExplanation(messages.newerJava(newer), messages.insteadOf(newer))
            }

            absent != null -> {
                ProblemExplanation(message, messages.absent(absent))
            }

            home != null -> {
                "import $home.*;".let { ProblemExplanation(message, messages.importIt(it), source.addLineAtTop(it)) }
            }

            else -> {
                otherWord(problem, source, name, message)
                    ?: nearNames.suggested(
                        problem,
                        source,
                        message,
                        nearest(
                            name,
                            library.simpleNames + nearNames.classesIn(source),
                        ),
                    )
            }
        }
    }

    private fun variableAdvice(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val message = messages.unknownVariable(shortened(name))
        otherWord(problem, source, name, message)?.let { return it }
        val near = nearest(name, nearNames.namesIn(source) + library.simpleNames)
        return if (near == null) {
            ProblemExplanation(message, messages.declareIt(shortened(name)))
        } else {
            nearNames.suggested(problem, source, message, near)
        }
    }

    companion object {
        private val LITERALS = setOf("true", "false", "null", "this")

        /** Imports are long, so one typing error per three letters would allow too many. */
        private const val FORGIVEN_IN_IMPORT = 2

        /** The problems with undeclared names. */
        val NUMBERS = setOf(
            ProblemNumber.IMPORT_NOT_FOUND,
            ProblemNumber.UNDEFINED_TYPE,
            ProblemNumber.UNDEFINED_NAME,
            ProblemNumber.UNRESOLVED_VARIABLE,
            ProblemNumber.UNDEFINED_FIELD,
            ProblemNumber.UNDEFINED_METHOD,
        )
    }
}
