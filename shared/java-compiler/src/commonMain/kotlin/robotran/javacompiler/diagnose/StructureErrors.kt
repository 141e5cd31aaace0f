package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId

/**
 * Finds declarations and statements that are where Java has none, in a source with syntax errors. ECJ guesses something
 * else there, often in other lines.
 */
internal class StructureErrors(private val source: SourceText) {
    private val items = CodeItems(tokensOf(source.code.text)).items
    private val isPaired = source.bracesBefore(Int.MAX_VALUE) == 0
    private val className = items.firstOrNull { it.has(CodeItems.TYPE_WORDS) }?.let { item ->
        item[item.tokens.indexOfFirst { it.text in CodeItems.TYPE_WORDS } + 1]
    }.orEmpty()

    /** The mistakes as problems, in the order of the source, with the numbers in [NUMBERS]. */
    fun problems(): List<EcjProblem> {
        val all = items.mapNotNull { item ->
            when (item.context) {
                CodeContext.FILE -> inFile(item)
                CodeContext.CLASS -> inClass(item)
                CodeContext.CODE -> inCode(item)
                else -> null
            }
        }
        // One of a kind is enough: the others are most often beside it.
        return all.distinctBy { if (it.number in ONCE) it.number else it.start }
    }

    private fun inFile(item: CodeItem): EcjProblem? {
        val first = item.tokens.first()
        val miscased = item.tokens.filter { keywordInOtherCase(it.text) != null }
        return when {
            !first.isWord || first.text in FILE_WORDS -> null

            miscased.isNotEmpty() && isTypeHeader(item) -> {
                val last = miscased.last()
                val written = source.words(miscased.first().start, last.end)
                val corrected = written.split(' ').joinToString(" ") { keywordInOtherCase(it) ?: it }
                problem(ProblemId.WORD_IN_OTHER_CASE, miscased.first().start, last.end, corrected)
            }

            item.has(CodeItems.TYPE_WORDS) -> nameOfSeveralWords(item)

            // Most likely a misspelt word before the name of the class.
            item.end == "{" && item.tokens.all { it.isWord } -> null

            isPaired || className.isEmpty() -> {
                val kind = METHOD.takeIf { item.end == "{" && item.has(setOf("(")) }
                problem(ProblemId.OUTSIDE_CLASS, first.start, item.tokens.last().end, className, kind)
            }

            else -> null
        }
    }

    private fun isTypeHeader(item: CodeItem) =
        item.tokens.any { (keywordInOtherCase(it.text) ?: it.text) in CodeItems.TYPE_WORDS }

    private fun nameOfSeveralWords(item: CodeItem): EcjProblem? {
        val place = item.tokens.indexOfFirst { it.text in CodeItems.TYPE_WORDS } + 1
        val name = item.tokens.drop(place).takeWhile { it.isWord && it.text !in KEYWORDS }
        if (name.size < 2 || item.end != "{") return null
        return problem(
            ProblemId.NAME_OF_SEVERAL_WORDS,
            name.first().start,
            name.last().end,
            name.joinToString("") { it.text },
        )
    }

    private fun inClass(item: CodeItem): EcjProblem? {
        val name = item.tokens.takeWhile { it.isWord || it.text == "." }
        val next = item[name.size]
        val isAssigned = next == "=" || (next in STEPS && item[name.size + 1] in STEPS + "=")
        val isCalled = next == "(" && (name.size > 1 || item.end == ";")
        val isName = name.size % 2 == 1 && name.indices.all { name[it].isWord == (it % 2 == 0) }
        val isStatement = item[0] in STATEMENT_WORDS || (isName && (isAssigned || isCalled))
        if (!isStatement) return null
        return problem(ProblemId.OUTSIDE_METHOD, item.tokens.first().start, item.tokens.last().end)
    }

    private fun inCode(item: CodeItem): EcjProblem? = nestedMethod(item) ?: condition(item) ?: reservedName(item)

    private fun nestedMethod(item: CodeItem): EcjProblem? {
        if (item.end != "{" || !isPaired) return null
        val open = item.tokens.indexOfFirst { it.text == "(" }
        if (open < 2) return null
        val name = item.tokens[open - 1]
        val before = item.tokens.take(open - 1)
        val isTyped = before.first().isWord && before.all { it.isWord || it.text in TYPE_SIGNS } &&
            before.none { it.text in NO_TYPES } && before.last().text != "."
        if (!isTyped || !name.isWord || name.text in KEYWORDS) return null
        val parameters = item.tokens.drop(open + 1).takeWhile { it.text != ")" }
        val isDeclared = parameters.isEmpty() || (parameters.first().isWord && parameters.size > 1)
        if (!isDeclared) return null
        return problem(ProblemId.METHOD_IN_METHOD, before.first().start, name.end, name.text)
    }

    private fun condition(item: CodeItem): EcjProblem? {
        val place = item.tokens.indexOfFirst { it.text != "else" }
        if (item[place] !in CONDITIONAL || item[place + 1] == "(") return null
        val word = item.tokens[place]
        val hasBody = item.end == "{" && item.tokens.size > place + 1 && word.text != "for"
        val end = item.tokens.last().end.toString().takeIf { hasBody }
        return problem(ProblemId.CONDITION_WITHOUT_BRACKETS, word.start, word.end, word.text, end)
    }

    private fun reservedName(item: CodeItem): EcjProblem? {
        val place = item.tokens.indices.firstOrNull {
            item[it] in VALUE_TYPES && item[it + 1] in KEYWORDS && item[it + 2] in AFTER_NAME
        } ?: return null
        val word = item.tokens[place + 1]
        return problem(ProblemId.RESERVED_NAME, word.start, word.end, word.text)
    }

    private fun problem(number: Int, start: Int, end: Int, vararg arguments: String?) = EcjProblem(
        source.path,
        number,
        isError = true,
        isSyntax = true,
        start = start,
        end = end,
        message = "",
        arguments = arguments.filterNotNull(),
        members = emptyList(),
    )

    companion object {
        /** The mistakes after which ECJ guesses wrongly to the end of the source. */
        val DERAILING = setOf(
            ProblemId.OUTSIDE_CLASS,
            ProblemId.OUTSIDE_METHOD,
            ProblemId.METHOD_IN_METHOD,
            ProblemId.WORD_IN_OTHER_CASE,
            ProblemId.NAME_OF_SEVERAL_WORDS,
        )

        /** What is [ProblemId.OUTSIDE_CLASS]: a method. */
        const val METHOD = "method"

        val NUMBERS = DERAILING + ProblemId.CONDITION_WITHOUT_BRACKETS + ProblemId.RESERVED_NAME

        private val ONCE = setOf(ProblemId.OUTSIDE_CLASS, ProblemId.OUTSIDE_METHOD)
        private val FILE_WORDS = setOf("import", "package")
        private val CONDITIONAL = setOf("if", "while", "for", "switch")
        private val STATEMENT_WORDS = CONDITIONAL + setOf("do", "try", "return", "break", "continue", "throw", "else")
        private val STEPS = setOf("+", "-", "*", "/")
        private val TYPE_SIGNS = setOf(".", "[", "]", "<", ">", ",")
        private val NO_TYPES = STATEMENT_WORDS + setOf("new", "case", "class", "interface", "catch", "synchronized")
        private val VALUE_TYPES =
            setOf("int", "boolean", "float", "double", "char", "long", "byte", "short", "String")
        private val AFTER_NAME = setOf("=", "", ",")
    }
}
