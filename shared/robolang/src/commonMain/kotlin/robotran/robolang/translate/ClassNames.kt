package robotran.robolang.translate

/**
 * The class name for a program [programName], usually a file name: `my square.robo` becomes `MySquare`. Plain ASCII
 * letters only, since it is also a file name that a console must be able to read.
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

/** Replaces each letter beyond ASCII by its usual transcription, and anything but letters and digits by a space. */
private fun plain(text: String): String = text.map { character ->
    when (character) {
        '_', in 'a'..'z', in 'A'..'Z', in '0'..'9' -> character.toString()
        else -> SPELLINGS[character] ?: " "
    }
}.joinToString("")

/** The transcriptions of letters beyond ASCII. */
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

/** The class name of a behaviour, without its number. */
internal const val WHENEVER = "Whenever"
