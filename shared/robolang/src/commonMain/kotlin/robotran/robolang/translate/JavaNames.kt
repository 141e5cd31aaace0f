package robotran.robolang.translate

import robotran.robolang.check.Symbol
import robotran.robolang.check.SymbolKind

/**
 * What the names of a program are called in Java: the same, unless Java, leJOS or the translation itself needs the word
 * or two names would meet, which get an underscore. Java tells a method from a variable of the same name, so each only
 * minds its own.
 *
 * @param className the class that all of them are in.
 */
internal class JavaNames(className: String) {
    private val names = mutableMapOf<Symbol, String>()
    private val shared = mutableSetOf(className)
    private val scopes = ArrayDeque<MutableSet<String>>()

    /** Keeps [name] for the translation itself. */
    fun reserve(name: String) {
        shared += name
    }

    /** Names what the whole class knows: a routine or a global. */
    fun declareShared(symbol: Symbol): String {
        val isRoutine = symbol.kind == SymbolKind.PROCEDURE || symbol.kind == SymbolKind.FUNCTION
        val name = unused(legal(symbol.name), if (isRoutine) JavaWords.NO_METHODS else JavaWords.NO_VARIABLES)
        shared += name
        names[symbol] = name
        return name
    }

    /** A name that the whole class knows for something that the program does not name, such as a text. */
    fun shared(wanted: String): String = unused(wanted, JavaWords.NO_VARIABLES).also { shared += it }

    /** Names something that only the innermost open scope knows. */
    fun declareLocal(symbol: Symbol): String = local(legal(symbol.name)).also { names[symbol] = it }

    /** A name for something that the program does not name, such as the count of a `repeat`. */
    fun local(wanted: String): String = unused(wanted, JavaWords.NO_VARIABLES).also { scopes.last() += it }

    fun of(symbol: Symbol): String = names.getValue(symbol)

    /** What the reader should know of [symbol]'s name; null if it is the pupil's own. */
    fun noteOn(symbol: Symbol): String? = of(symbol).takeIf { it != symbol.name }?.let { "in Robolang: ${symbol.name}" }

    fun <T> inScope(action: () -> T): T {
        scopes.addLast(mutableSetOf())
        try {
            return action()
        } finally {
            scopes.removeLast()
        }
    }

    private fun unused(wanted: String, reserved: Set<String>): String {
        var name = wanted
        while (name in reserved || name in shared || scopes.any { name in it }) name += "_"
        return name
    }
}

/**
 * [name] with an underscore for each character that not every Java takes for a letter, and before a digit at its start.
 */
internal fun legal(name: String): String {
    val letters = name.map { if (isJavaLetter(it) || it in '0'..'9') it else '_' }.joinToString("")
    return if (letters.isEmpty() || letters.first() in '0'..'9') "_$letters" else letters
}

/** The letters that Java has had since Unicode 2, of the alphabets that Robolang takes. */
private fun isJavaLetter(character: Char): Boolean =
    character == '_' || character in 'a'..'z' || character in 'A'..'Z' ||
        (character in '\u00C0'..'\u01F5' && character != '\u00D7' && character != '\u00F7') ||
        (character in '\u0391'..'\u03CE' && character != '\u03A2') || character in '\u0401'..'\u0481'
