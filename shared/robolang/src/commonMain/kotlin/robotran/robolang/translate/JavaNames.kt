package robotran.robolang.translate

import robotran.robolang.check.Symbol

/**
 * What the names of a program are called in Java: the same, unless Java, leJOS or the translation itself needs the word or two
 * names would meet, which get an underscore.
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
    fun declareShared(symbol: Symbol): String = unused(legal(symbol.name)).also {
        shared += it
        names[symbol] = it
    }

    /** Names something that only the innermost open scope knows. */
    fun declareLocal(symbol: Symbol): String = local(legal(symbol.name)).also { names[symbol] = it }

    /** A name for something that the program does not name, such as the count of a `repeat`. */
    fun local(wanted: String): String = unused(wanted).also { scopes.last() += it }

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

    private fun unused(wanted: String): String {
        var name = wanted
        while (name in JavaWords.RESERVED || name in shared || scopes.any { name in it }) name += "_"
        return name
    }
}

/** [name] with an underscore for each letter that Java does not take. */
internal fun legal(name: String): String {
    val letters = name.map { if (it == '_' || it in '0'..'9' || it.isLetter()) it else '_' }.joinToString("")
    return if (letters.isEmpty() || letters.first() in '0'..'9') "_$letters" else letters
}

/** The class for a program called [programName], usually the name of a file: `my square.robo` becomes `MySquare`. */
internal fun classNameOf(programName: String): String {
    val file = programName.substringAfterLast('/').substringAfterLast('\\')
    val words = file.removeSuffix(".robo").split(' ', '-', '.', '(', ')').filter { it.isNotEmpty() }
    val name = legal(words.joinToString("") { word -> word.replaceFirstChar { if (it in 'a'..'z') it - ('a' - 'A') else it } })
    return if (name == "_" || name in JavaWords.RESERVED) "Program$name".trimEnd('_') else name
}
