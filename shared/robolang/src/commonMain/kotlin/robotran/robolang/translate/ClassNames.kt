package robotran.robolang.translate

/**
 * The class for a program called [programName], usually the name of a file: `my square.robo` becomes `MySquare`. It has
 * plain letters only, since it is the name of files, too, which the console of a real robot's computer has to read.
 */
internal fun classNameOf(programName: String): String {
    val file = programName.substringAfterLast('/').substringAfterLast('\\').removeSuffix(".robo")
    val words = plain(file).split(' ').filter { it.isNotEmpty() }
    val name = legal(
        words.joinToString("") { word ->
            word.replaceFirstChar {
                if (it in
                    'a'..'z'
                ) {
                    it - ('a' - 'A')
                } else {
                    it
                }
            }
        },
    )
    return when {
        name.all { it == '_' } -> "Program"
        name.startsWith("_") -> "Program" + name.trimStart('_')
        name in JavaWords.NO_CLASSES || name.startsWith(WHENEVER) -> "Program$name"
        else -> name
    }
}

/**
 * [text] with each foreign letter by the plain ones it is often written with, and a space for all that is neither
 * letter nor digit.
 */
private fun plain(text: String): String = text.map { character ->
    when (character) {
        '_', in 'a'..'z', in 'A'..'Z', in '0'..'9' -> character.toString()
        else -> SPELLINGS[character] ?: " "
    }
}.joinToString("")

/** What letters beyond the alphabet are written as. */
private val SPELLINGS: Map<Char, String> = mapOf(
    "a" to "àáâã",
    "aa" to "å",
    "ae" to "äæ",
    "c" to "ç",
    "e" to "èéêë",
    "i" to "ìíîï",
    "n" to "ñ",
    "o" to "òóôõ",
    "oe" to "öø",
    "ss" to "ß",
    "u" to "ùúû",
    "ue" to "ü",
    "A" to "ÀÁÂÃ",
    "Aa" to "Å",
    "Ae" to "ÄÆ",
    "C" to "Ç",
    "E" to "ÈÉÊË",
    "I" to "ÌÍÎÏ",
    "N" to "Ñ",
    "O" to "ÒÓÔÕ",
    "Oe" to "ÖØ",
    "U" to "ÙÚÛ",
    "Ue" to "Ü",
).flatMap { (plain, others) -> others.map { it to plain } }.toMap()

/** What the class of a behaviour is called, its number left aside. */
internal const val WHENEVER = "Whenever"
