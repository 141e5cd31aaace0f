package robotran.robolang.translate

import robotran.brick.kind.JavaPlatform
import robotran.robolang.check.Symbol
import robotran.robolang.check.SymbolKind

/**
 * The Java names of a program's symbols: the same, with an underscore if Java, leJOS or the translation needs the word,
 * or if two names collide. In Java, a method and a variable may have the same name, so each kind is checked separately.
 *
 * @param className the class that contains them.
 */
internal class JavaNames(className: String, private val platform: JavaPlatform) {
    private val names = mutableMapOf<Symbol, String>()
    private val shared = mutableSetOf(className)
    private val scopes = ArrayDeque<MutableSet<String>>()

    /** Reserves [name] for the translation. */
    fun reserve(name: String) {
        shared += name
    }

    /** Names a routine or a global. */
    fun declareShared(symbol: Symbol): String {
        val isRoutine = symbol.kind == SymbolKind.PROCEDURE || symbol.kind == SymbolKind.FUNCTION
        val name =
            unused(
                legal(symbol.name),
                if (isRoutine) JavaWords.noMethods(platform) else JavaWords.noVariables(platform),
            )
        shared += name
        names[symbol] = name
        return name
    }

    /** A class-level name for something unnamed in the program, such as a text. */
    fun shared(wanted: String): String = unused(wanted, JavaWords.noVariables(platform)).also { shared += it }

    /** Names a symbol of the innermost open scope. */
    fun declareLocal(symbol: Symbol): String = local(legal(symbol.name)).also { names[symbol] = it }

    /** A local name for something unnamed in the program, such as the counter of a `repeat`. */
    fun local(wanted: String): String = unused(wanted, JavaWords.noVariables(platform)).also { scopes.last() += it }

    fun of(symbol: Symbol): String = names.getValue(symbol)

    /** A note about a changed name of [symbol]; null if it is the pupil's own. */
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
 * [name] with an underscore for each character that is not a letter in every Java version, and before a leading digit.
 */
internal fun legal(name: String): String {
    val letters = name.map { if (isJavaLetter(it) || it in '0'..'9') it else '_' }.joinToString("")
    return if (letters.isEmpty() || letters.first() in '0'..'9') "_$letters" else letters
}

/** The letters of Robolang that are letters in Java since Unicode 2. */
private fun isJavaLetter(character: Char): Boolean =
    character == '_' || character in 'a'..'z' || character in 'A'..'Z' ||
        (character in '\u00C0'..'\u01F5' && character != '\u00D7' && character != '\u00F7') ||
        (character in '\u0391'..'\u03CE' && character != '\u03A2') || character in '\u0401'..'\u0481'
