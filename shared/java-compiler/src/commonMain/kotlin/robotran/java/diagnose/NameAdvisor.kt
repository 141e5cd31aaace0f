package robotran.java.diagnose

import robotran.java.EcjProblem
import robotran.java.JavaFix
import robotran.java.JavaMessages
import robotran.java.ProblemNumber

/**
 * What to tell about names that nothing declares: what the brick has instead, a missing import, or the name that was probably meant.
 *
 * @param undeclared all such names, since none of them can be meant by another.
 */
internal class NameAdvisor(
    private val library: LibraryNames,
    private val undeclared: Set<String>,
    private val messages: JavaMessages,
) {
    fun advice(problem: EcjProblem, source: SourceText): Advice? {
        val written = source.words(problem.start, problem.end)
        val name = shortened(written)
        return when (problem.number) {
            ProblemNumber.IMPORT_NOT_FOUND -> {
                Advice(messages.unknownImport(name), absent(written)?.let(messages::absent))
            }

            ProblemNumber.UNDEFINED_TYPE -> {
                classAdvice(problem, source, written)
            }

            ProblemNumber.UNDEFINED_NAME, ProblemNumber.UNRESOLVED_VARIABLE -> {
                if (written.firstOrNull()?.isUpperCase() ==
                    true
                ) {
                    classAdvice(problem, source, written)
                } else {
                    variableAdvice(problem, source, written)
                }
            }

            ProblemNumber.UNDEFINED_FIELD -> {
                val owner = source.qualifier(problem.start)
                memberAdvice(problem, source, written, owner, messages.unknownField(name, owner?.let(::shortened)))
            }

            ProblemNumber.UNDEFINED_METHOD, ProblemNumber.METHOD_NOT_VISIBLE -> {
                val owner = problem.arguments.first()
                memberAdvice(problem, source, written, owner, messages.unknownMethod(name, shortened(owner)))
            }

            else -> {
                null
            }
        }
    }

    private fun classAdvice(problem: EcjProblem, source: SourceText, name: String): Advice {
        val newer = newerWord(name)
        val absent = absent(name)
        val home = library.packageOf(name)
        val message = messages.unknownClass(shortened(name))
        return when {
            newer != null -> Advice(messages.newerJava(newer), messages.insteadOf(newer))
            absent != null -> Advice(message, messages.absent(absent))
            home != null -> "import $home.*;".let { Advice(message, messages.importIt(it), source.addLineAtTop(it)) }
            else -> suggested(problem, source, message, nearest(name, library.simpleNames + classesIn(source)))
        }
    }

    private fun variableAdvice(problem: EcjProblem, source: SourceText, name: String): Advice {
        val message = messages.unknownVariable(shortened(name))
        val near = nearest(name, namesIn(source) + library.simpleNames)
        return if (near == null) Advice(message, messages.declareIt(shortened(name))) else suggested(problem, source, message, near)
    }

    private fun memberAdvice(problem: EcjProblem, source: SourceText, name: String, owner: String?, message: String): Advice {
        val absent = owner?.let { absent(name, it) }
        if (absent != null) return Advice(message, messages.absent(absent))
        // A class of the program itself has no members that are known here, but their names are in the source.
        return suggested(problem, source, message, nearest(name, problem.members.ifEmpty { namesIn(source) }))
    }

    private fun suggested(problem: EcjProblem, source: SourceText, message: String, suggestion: String?) = Advice(
        message,
        suggestion?.let(messages::didYouMean),
        suggestion?.let { JavaFix(source.range(problem.start, problem.end), it) },
    )

    /** The names of the source that may be declared. */
    private fun namesIn(source: SourceText) = source.names.filterNot { it in KEYWORDS || it in undeclared }

    private fun classesIn(source: SourceText) = namesIn(source).filter { it.first().isUpperCase() }

    companion object {
        /** The problems that this is about. */
        val NUMBERS = setOf(
            ProblemNumber.IMPORT_NOT_FOUND,
            ProblemNumber.UNDEFINED_TYPE,
            ProblemNumber.UNDEFINED_NAME,
            ProblemNumber.UNRESOLVED_VARIABLE,
            ProblemNumber.UNDEFINED_FIELD,
            ProblemNumber.UNDEFINED_METHOD,
        )

        /** Words of Java that a name can be a slip of but never means. */
        private val KEYWORDS = (
            "abstract boolean break byte case catch char class continue default do double else extends final finally float for if " +
                "implements import instanceof int interface long new package private protected public return short static super switch " +
                "synchronized throw throws try void while"
        ).split(' ').toSet()
    }
}
