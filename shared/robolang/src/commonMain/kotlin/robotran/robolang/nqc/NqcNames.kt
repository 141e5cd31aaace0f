package robotran.robolang.nqc

import robotran.robolang.check.Symbol

/**
 * The NQC names of a program's symbols: the same, in the letters of NQC. NQC's own functions and constants begin with a
 * capital letter, so that a name that does gets an underscore; so do words of NQC.
 */
internal class NqcNames {
    private val names = HashMap<Symbol, String>()
    private val shared = HashSet(HELPERS)
    private val scopes = ArrayDeque<MutableSet<String>>()

    /** Names a routine or a global variable. */
    fun declareShared(symbol: Symbol): String = free(legal(symbol.name)).also {
        shared += it
        names[symbol] = it
    }

    /** Names a variable of the innermost scope. */
    fun declareLocal(symbol: Symbol): String = local(symbol.name).also { names[symbol] = it }

    /** A name for something that has none in the program. */
    fun local(wanted: String): String = free(legal(wanted)).also { scopes.last() += it }

    fun of(symbol: Symbol): String = names[symbol] ?: legal(symbol.name)

    fun <T> inScope(action: () -> T): T {
        scopes.addLast(HashSet())
        try {
            return action()
        } finally {
            scopes.removeAt(scopes.lastIndex)
        }
    }

    private fun free(wanted: String): String {
        var name = wanted
        while (name in WORDS || name in shared || scopes.any { name in it }) name += "_"
        return name
    }

    private fun legal(name: String): String {
        val letters = name.map { LETTERS[it] ?: if (isLetter(it) || it in '0'..'9') "$it" else "_" }.joinToString("")
        return when {
            letters.first() in 'a'..'z' -> letters
            letters.first() in '0'..'9' -> "_$letters"
            else -> letters + "_"
        }
    }

    private fun isLetter(character: Char) = character in 'a'..'z' || character in 'A'..'Z' || character == '_'

    private companion object {
        val WORDS = (
            "abs acquire asm break case catch const continue default do else false for goto if int main monitor " +
                "repeat return sign start stop sub switch task true until void while"
        ).split(' ').toSet()

        /** The names of what the translation itself defines. */
        val HELPERS = NqcHelper.entries.map { it.called }

        /** Letters of German and Spanish. */
        val LETTERS = mapOf(
            'ä' to "ae",
            'ö' to "oe",
            'ü' to "ue",
            'ß' to "ss",
            'Ä' to "Ae",
            'Ö' to "Oe",
            'Ü' to "Ue",
            'á' to "a",
            'é' to "e",
            'í' to "i",
            'ó' to "o",
            'ú' to "u",
            'ñ' to "n",
        )
    }
}
