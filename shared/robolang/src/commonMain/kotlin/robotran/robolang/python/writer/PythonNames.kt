package robotran.robolang.python.writer

import robotran.robolang.check.Symbol

/**
 * The Python names of a program's symbols: the same, constants of the whole program in capitals, with an underscore if
 * Python or the translation needs the word, or if two names collide.
 *
 * @param reserved the names that the translation itself uses.
 */
internal class PythonNames(reserved: Set<String>) {
    private val names = HashMap<Symbol, String>()
    private val shared = (WORDS + BUILT_IN + reserved).toHashSet()
    private val scopes = ArrayDeque<MutableSet<String>>()

    /** Names a routine or a variable of the whole program. */
    fun declareShared(symbol: Symbol, isCapital: Boolean): String =
        free(if (isCapital) capitals(legal(symbol.name)) else legal(symbol.name)).also {
            shared += it
            names[symbol] = it
        }

    /** A name for a function that has none in the program. */
    fun shared(wanted: String): String = free(wanted).also { shared += it }

    /** Names a variable of the innermost scope. */
    fun declareLocal(symbol: Symbol): String = local(legal(symbol.name)).also { names[symbol] = it }

    /** A name for something that has none in the program. */
    fun local(wanted: String): String = free(wanted).also { scopes.last() += it }

    fun of(symbol: Symbol): String = names[symbol] ?: legal(symbol.name)

    /** A note about a name that is not the pupil's own; null if it is, apart from capitals. */
    fun noteOn(symbol: Symbol): String? =
        "in Robolang: ${symbol.name}".takeIf { of(symbol).endsWith("_") && of(symbol) != symbol.name }

    fun <T> inScope(action: () -> T): T {
        scopes.addLast(HashSet())
        try {
            return action()
        } finally {
            scopes.removeLast()
        }
    }

    private fun free(wanted: String): String {
        var name = wanted
        while (name in shared || scopes.any { name in it }) name += "_"
        return name
    }

    private fun legal(name: String): String = if (name.first() in '0'..'9') "_$name" else name

    /** `STEP_WIDTH` for `stepWidth`. */
    private fun capitals(name: String): String = buildString {
        for ((place, letter) in name.withIndex()) {
            val isNewWord = place > 0 && letter in 'A'..'Z' && name[place - 1] in 'a'..'z'
            if (isNewWord) append('_')
            append(if (letter in 'a'..'z') letter.uppercaseChar() else letter)
        }
    }

    private companion object {
        val WORDS = (
            "False None True and as assert async await break class continue def del elif else except finally for " +
                "from global if import in is lambda nonlocal not or pass raise return try while with yield"
        ).split(' ')

        /** What the translation may use of Python itself. */
        val BUILT_IN = (
            "abs bool dict float id input int len list max min next object print range round set str sum SystemExit " +
                "type"
        ).split(' ')
    }
}
