package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages

/** Explains problems with methods and fields that a class does not have or that are private. */
internal class MemberAdvisor(
    private val library: LibraryNames,
    private val suggestions: NameSuggestions,
    private val gaps: BrickGaps,
    private val messages: JavaMessages,
) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? {
        val name = source.words(problem.start, problem.end)
        return when (problem.number) {
            ProblemId.UNDEFINED_FIELD -> field(problem, source, name)

            ProblemId.UNDEFINED_METHOD -> method(problem, source, name)

            ProblemId.METHOD_NOT_VISIBLE -> hidden(problem, source, name, owner = problem.arguments[0])
                ?: method(problem, source, name)

            ProblemId.FIELD_NOT_VISIBLE -> hidden(problem, source, name, owner = problem.arguments[1])
                ?: field(problem, source, name)

            // The class may have the method with other parameters, such as toString() of Object.
            ProblemId.PARAMETER_MISMATCH -> source.qualifier(problem.start)?.let { owner ->
                gaps.instead(problem.arguments[1], owner)?.let {
                    ProblemExplanation(messages.unknownMethod(shortened(problem.arguments[1]), shortened(owner)), it)
                }
            }

            ProblemId.NO_MESSAGE_SEND_ON_ARRAY -> onArray(problem, source, name)

            ProblemId.NO_MESSAGE_SEND_ON_BASE_TYPE -> ProblemExplanation(
                messages.noMembers(shortened(problem.arguments[0])),
            )

            ProblemId.ARRAY_NEEDED -> if (problem.arguments[0] == "String") {
                ProblemExplanation(messages.noArray("String"), messages.charAt())
            } else {
                null
            }

            else -> null
        }
    }

    private fun field(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val owner = source.qualifier(problem.start)
        val message = messages.unknownField(shortened(name), owner?.let(::shortened))
        if (name == LENGTH) return ProblemExplanation(message, messages.lengthOfTextOrArray())
        methodWithoutBrackets(problem, source, name)?.let { return it }
        return member(problem, source, name, owner, message)
    }

    private fun method(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val owner = problem.arguments.first().substringBefore('<')
        val isUnqualified = source.codeBefore(problem.start) != '.'
        val instead = if (isUnqualified) gaps.insteadOfCall(name) else null
        if (instead != null) return ProblemExplanation(messages.unknownMethodHere(name, shortened(owner)), instead)
        if (isUnqualified) command(problem, source, name)?.let { return it }
        val told = member(problem, source, name, owner, messages.unknownMethod(shortened(name), shortened(owner)))
        val isOwn = told.hint == null && owner !in library.simpleNames && isUnqualified
        if (!isOwn) return told
        val parameters = parametersOf(problem.arguments.getOrElse(2) { "" })
        return ProblemExplanation(told.message, messages.writeMethod(shortened(name), parameters))
    }

    /** Parameters of the types of a call, as they are declared. */
    private fun parametersOf(types: String): String = types.split(", ").filter { it.isNotEmpty() && it != "null" }
        .mapIndexed { index, type -> "${shortened(type)} ${'a' + index}" }.joinToString()

    /** A method that is used like a field. */
    private fun methodWithoutBrackets(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation? {
        val behind = source.codeBehind(problem.end)
        val set = SET.find(behind)
        return when {
            "$name(1)" in problem.members && set != null -> {
                val end = problem.end + set.value.length - 1
                val value = source.words(problem.end, end).substringAfter('=').trim()
                val call = "$name($value)"
                val range = source.range(problem.start, end)
                val message = messages.valueInBrackets(shortened(name), shortened(call))
                ProblemExplanation(message, fix = JavaFix(range, call))
            }

            "$name(0)" in problem.members -> {
                val compared = COMPARED.find(behind)
                val end = problem.end + (compared?.value?.length ?: 0)
                val call = if (compared == null) "$name()" else "$name() =="
                ProblemExplanation(
                    messages.callWithBrackets(shortened(name)),
                    fix = JavaFix(source.range(problem.start, end), call),
                )
            }

            problem.members.any { it.startsWith("$name(") } -> {
                ProblemExplanation(messages.callWithBrackets(shortened(name)))
            }

            else -> {
                null
            }
        }
    }

    /** A misspelled keyword with a condition, such as `elseif` or `While`, looks like a method call. */
    private fun command(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation? {
        val range = source.range(problem.start, problem.end)
        val foreign = javaEquivalent(name)?.ifEmpty { null }
        val small = keywordInOtherCase(name)
        return when {
            foreign != null -> ProblemExplanation(messages.foreignWord(name, foreign), fix = JavaFix(range, foreign))
            small != null -> ProblemExplanation(messages.wrongCase(small), fix = JavaFix(range, small))
            else -> null
        }
    }

    private fun member(
        problem: EcjProblem,
        source: SourceText,
        name: String,
        owner: String?,
        message: String,
    ): ProblemExplanation {
        val instead = owner?.let { gaps.instead(name, it) }
        if (instead != null) return ProblemExplanation(message, instead)
        val candidates = candidatesFor(problem).ifEmpty { suggestions.namesIn(source) }
        // A name that differs only in its capital letters comes before one with a word before it: isForward.
        val likely = (listOf("") + PREFIXES).firstNotNullOfOrNull { prefix ->
            candidates.find { it != name && it.equals(prefix + name, ignoreCase = true) }
        }
        return suggestions.suggested(problem, source, message, likely ?: nearest(name, candidates))
    }

    /** The names of the members that may be meant; methods have the number of their parameters behind them. */
    private fun candidatesFor(problem: EcjProblem): List<String> {
        val isCall = problem.number == ProblemId.UNDEFINED_METHOD || problem.number == ProblemId.METHOD_NOT_VISIBLE
        val isKnown = problem.members.any { it.endsWith(')') }
        return problem.members.filter { !isKnown || it.endsWith(')') == isCall }.map { it.substringBefore('(') }
    }

    /** Explains the program's own private members. A private member of the library counts as missing: returns null. */
    private fun hidden(problem: EcjProblem, source: SourceText, name: String, owner: String): ProblemExplanation? {
        val simpleName = owner.substringAfterLast('.')
        val isOwn = simpleName in source.names && simpleName !in library.simpleNames
        return if (isOwn) {
            ProblemExplanation(
                messages.isPrivate(shortened(name), shortened(owner)),
                messages.usePublic(),
            )
        } else {
            null
        }
    }

    private fun onArray(problem: EcjProblem, source: SourceText, words: String): ProblemExplanation {
        if (problem.arguments.getOrNull(1) != LENGTH) {
            return ProblemExplanation(messages.noMembers(shortened(problem.arguments[0])))
        }
        val fix = words.takeIf { it.endsWith("()") }?.let { JavaFix(source.range(problem.end - 2, problem.end), "") }
        return ProblemExplanation(messages.lengthOfArrayValue(), fix = fix)
    }

    private companion object {
        const val LENGTH = "length"

        /** How the names of methods begin that pupils leave away. */
        val PREFIXES = listOf("get", "is", "set")

        /** A value that is set, up to its semicolon. */
        val SET = Regex("""^\s*=[^=;][^;]*;""")

        /** A single `=` before a value that is compared. */
        val COMPARED = Regex("""^\s*=(?=\s*(?:true|false|\d+)\s*\))""")
    }
}
