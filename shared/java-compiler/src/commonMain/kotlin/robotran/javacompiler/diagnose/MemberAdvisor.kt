package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.othersOfSeries
import robotran.language.source.SourceFix

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

            ProblemId.PARAMETER_MISMATCH -> otherParameters(problem, source, name)
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

    /** Explains a method that the class has with other parameters, as far as the program should not use that. */
    private fun otherParameters(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation? {
        val method = problem.arguments[1]
        // It is the library's own.
        if (problem.members.isNotEmpty() && problem.members.none { it.startsWith("$method(") }) {
            return method(problem, source, name)
        }
        // The class may have got it from another one, such as toString() of Object.
        val owner = source.qualifier(problem.start) ?: return null
        return gaps.instead(method, owner)?.let {
            ProblemExplanation(messages.unknownMethod(shortened(method), shortened(owner)), it)
        }
    }

    private fun field(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val owner = source.qualifier(problem.start)
        val message = messages.unknownField(shortened(name), owner?.let(::shortened))
        if (name == LENGTH) return ProblemExplanation(message, messages.lengthOfTextOrArray())
        methodWithoutBrackets(problem, source, name)?.let { return it }
        val others = othersOfSeries(name, candidatesFor(problem)).take(MAX_NAMED)
        if (owner?.first()?.isUpperCase() == true && others.isNotEmpty()) {
            return ProblemExplanation(message, messages.useOneOf(others.joinToString { "$owner.$it" }))
        }
        val explanation = member(problem, source, name, owner, message)
        val parts = gaps.constants.filterValues { it == owner }.keys.joinToString { "$owner.$it" }
        val isExplained = explanation.hint != null || parts.isEmpty()
        return if (isExplained) explanation else ProblemExplanation(message, messages.useOneOf(parts))
    }

    private fun method(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation {
        val owner = problem.arguments.first().substringBefore('<')
        val isUnqualified = source.codeBefore(problem.start) != '.'
        val instead = if (isUnqualified) gaps.insteadOfCall(name) else null
        if (instead != null) return ProblemExplanation(messages.unknownMethodHere(name, shortened(owner)), instead)
        if (isUnqualified) command(problem, source, name)?.let { return it }
        val explanation =
            member(problem, source, name, owner, messages.unknownMethod(shortened(name), shortened(owner)))
        val isOwn = explanation.hint == null && owner !in library.simpleNames && isUnqualified
        if (!isOwn) return explanation
        val parameters = parametersOf(problem.arguments.getOrElse(2) { "" })
        return ProblemExplanation(explanation.message, messages.writeMethod(shortened(name), parameters))
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
                ProblemExplanation(message, fix = SourceFix(range, call))
            }

            "$name(0)" in problem.members -> {
                val compared = COMPARED.find(behind)
                val end = problem.end + (compared?.value?.length ?: 0)
                val call = if (compared == null) "$name()" else "$name() =="
                ProblemExplanation(
                    messages.callWithBrackets(shortened(name)),
                    fix = SourceFix(source.range(problem.start, end), call),
                )
            }

            problem.members.any { it.startsWith("$name(") } -> {
                ProblemExplanation(messages.callWithBrackets(shortened(name)))
            }

            else -> null
        }
    }

    /** A misspelled keyword with a condition, such as `elseif` or `While`, looks like a method call. */
    private fun command(problem: EcjProblem, source: SourceText, name: String): ProblemExplanation? {
        val range = source.range(problem.start, problem.end)
        val foreign = javaEquivalent(name)?.ifEmpty { null }
        val small = keywordInOtherCase(name)
        return when {
            foreign != null -> ProblemExplanation(messages.foreignWord(name, foreign), fix = SourceFix(range, foreign))
            small != null -> ProblemExplanation(messages.wrongCase(small), fix = SourceFix(range, small))
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
        val instead = owner?.let { gaps.instead(name, it) ?: gaps.instead(name.replaceFirstChar(Char::lowercase), it) }
        if (instead != null) return ProblemExplanation(message, instead)
        val candidates = candidatesFor(problem).ifEmpty { suggestions.namesIn(source) }
        // A name that differs only in its capital letters comes before one with a word before it: isForward.
        val likely = (listOf("") + PREFIXES).firstNotNullOfOrNull { prefix ->
            candidates.find { it != name && it.equals(prefix + name, ignoreCase = true) }
        }
        val near = likely?.let(::listOf) ?: nearest(name, candidates)
        val longer = withMoreWords(name, candidates).takeIf { near.isEmpty() }
            ?: return suggestions.suggested(problem, source, message, near)
        return ProblemExplanation(message, messages.didYouMean(longer))
    }

    /** The shortest of [candidates] that has all words of [name] and more, such as `getLightValue` for `getValue`. */
    private fun withMoreWords(name: String, candidates: List<String>): String? {
        if (name.none { it.isUpperCase() } || !name.all { it.isLetterOrDigit() }) return null
        val pattern = name.drop(1).fold(name.take(1)) { all, next ->
            if (next.isUpperCase()) "$all.*$next" else "$all$next"
        }
        return candidates.filter { Regex(pattern).matches(it) }.minByOrNull { it.length }
    }

    /** The names of the members that may be meant; methods have the number of their parameters behind them. */
    private fun candidatesFor(problem: EcjProblem): List<String> {
        val isCall = problem.number in PROBLEMS_OF_CALLS
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
        val fix = words.takeIf { it.endsWith("()") }?.let { SourceFix(source.range(problem.end - 2, problem.end), "") }
        return ProblemExplanation(messages.lengthOfArrayValue(), fix = fix)
    }

    private companion object {
        const val LENGTH = "length"
        const val MAX_NAMED = 6
        val PROBLEMS_OF_CALLS =
            setOf(ProblemId.UNDEFINED_METHOD, ProblemId.METHOD_NOT_VISIBLE, ProblemId.PARAMETER_MISMATCH)

        /** How the names of methods begin that pupils leave away. */
        val PREFIXES = listOf("get", "is", "set")

        /** A value that is set, up to its semicolon. */
        val SET = Regex("""^\s*=[^=;][^;]*;""")

        /** A single `=` before a value that is compared. */
        val COMPARED = Regex("""^\s*=(?=\s*(?:true|false|\d+)\s*\))""")
    }
}
