package robotran.javacompiler.diagnose

/** What is directly around a declaration or statement. */
internal enum class CodeContext {
    FILE,
    CLASS,

    /** The constants of an enum, before the first semicolon. */
    CONSTANTS,
    CODE,
    ARRAY,
}

/**
 * A declaration or a statement, up to its semicolon or the brace that opens its body.
 *
 * @property tokens its words and signs, without the one that ends it; at least one.
 * @property end `;`, `{` or `}`; empty at the end of the source.
 */
internal class CodeItem(val context: CodeContext, val tokens: List<CodeToken>, val end: String) {
    /** The word [index], or a sign; empty behind the last one. */
    operator fun get(index: Int): String = tokens.getOrNull(index)?.text.orEmpty()

    fun has(words: Set<String>): Boolean = tokens.any { it.text in words }
}

/** Divides a source into declarations and statements by its braces and semicolons, whatever else is wrong in it. */
internal class CodeItems(tokens: List<CodeToken>) {
    private val found = mutableListOf<CodeItem>()
    private val contexts = mutableListOf(CodeContext.FILE)
    private val header = mutableListOf<CodeToken>()
    private var openBrackets = 0

    /** The items in the order of the source. */
    val items: List<CodeItem> get() = found

    init {
        tokens.forEach(::read)
        finish("")
    }

    private fun read(token: CodeToken) {
        when (token.text) {
            "{" -> {
                val body = bodyContext()
                finish(token.text)
                contexts += body
            }

            "}" -> {
                finish(token.text)
                if (contexts.size > 1) contexts.removeLast()
            }

            ";" -> {
                if (openBrackets > 0) {
                    header += token
                } else {
                    finish(token.text)
                    if (contexts.last() == CodeContext.CONSTANTS) contexts[contexts.lastIndex] = CodeContext.CLASS
                }
            }

            else -> {
                if (token.text == "(") openBrackets++
                if (token.text == ")") openBrackets--
                header += token
            }
        }
    }

    private fun finish(end: String) {
        if (header.isNotEmpty()) found += CodeItem(contexts.last(), header.toList(), end)
        header.clear()
        openBrackets = 0
    }

    private fun bodyContext(): CodeContext {
        val last = header.lastOrNull()?.text
        val kind = header.indices.map(::typeWord).firstOrNull { it.isNotEmpty() }
        return when {
            kind != null -> if (kind == "enum") CodeContext.CONSTANTS else CodeContext.CLASS
            contexts.last() == CodeContext.CONSTANTS -> CodeContext.CLASS
            last in BEFORE_ARRAY || contexts.last() == CodeContext.ARRAY -> CodeContext.ARRAY
            last == ")" && isNewObject() -> CodeContext.CLASS
            else -> CodeContext.CODE
        }
    }

    /** The word of the header at [offset], if it begins a class; in a file also with capital letters. */
    private fun typeWord(offset: Int): String {
        val written = header[offset].text
        val word = if (contexts.last() == CodeContext.FILE) written.lowercase() else written
        return if (word in TYPE_WORDS && header.getOrNull(offset - 1)?.text != ".") word else ""
    }

    /** Whether the header ends with `new Name(...)`, so that its body is one of a class without a name. */
    private fun isNewObject(): Boolean {
        var open = 0
        var place = header.lastIndex
        while (place >= 0) {
            if (header[place].text == ")") open++
            if (header[place].text == "(" && --open == 0) break
            place--
        }
        while (place > 0 && (header[place - 1].isWord || header[place - 1].text == ".")) {
            place--
            if (header[place].text == "new") return true
        }
        return false
    }

    companion object {
        val TYPE_WORDS = setOf("class", "interface", "enum")
        private val BEFORE_ARRAY = setOf("=", "]", ",")
    }
}
