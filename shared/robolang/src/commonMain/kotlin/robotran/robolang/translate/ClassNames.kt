package robotran.robolang.translate

/**
 * The class for a program called [programName], usually the name of a file: `my square.robo` becomes `MySquare`. It has plain letters
 * only, since it is the name of files, too, which the console of a real robot's computer has to read.
 */
internal fun classNameOf(programName: String): String {
    val file = programName.substringAfterLast('/').substringAfterLast('\\').removeSuffix(".robo")
    val words = plain(file).split(' ').filter { it.isNotEmpty() }
    val name = legal(words.joinToString("") { word -> word.replaceFirstChar { if (it in 'a'..'z') it - ('a' - 'A') else it } })
    return when {
        name.all { it == '_' } -> "Program"
        name.startsWith("_") -> "Program" + name.trimStart('_')
        name in JavaWords.NO_CLASSES || name.startsWith(WHENEVER) -> "Program$name"
        else -> name
    }
}

/** [text] with each foreign letter by the plain ones it is often written with, and a space for all that is neither letter nor digit. */
private fun plain(text: String): String = text.map { character ->
    when (character) {
        '_', in 'a'..'z', in 'A'..'Z', in '0'..'9' -> character.toString()
        else -> SPELLINGS[character] ?: " "
    }
}.joinToString("")

private val SPELLINGS: Map<Char, String> = mapOf('ß' to "ss", 'ä' to "ae", 'ö' to "oe", 'ü' to "ue", 'Ä' to "Ae", 'Ö' to "Oe", 'Ü' to "Ue") +
    mapOf('æ' to "ae", 'ø' to "oe", 'å' to "aa", 'Æ' to "Ae", 'Ø' to "Oe", 'Å' to "Aa", 'ç' to "c", 'ñ' to "n", 'Ç' to "C", 'Ñ' to "N") +
    "àáâã".associateWith { "a" } + "èéêë".associateWith { "e" } + "ìíîï".associateWith { "i" } + "òóôõ".associateWith { "o" } +
    "ùúû".associateWith { "u" } + "ÀÁÂÃ".associateWith { "A" } + "ÈÉÊË".associateWith { "E" } + "ÌÍÎÏ".associateWith { "I" } +
    "ÒÓÔÕ".associateWith { "O" } + "ÙÚÛ".associateWith { "U" }

/** What the class of a behaviour is called, its number left aside. */
internal const val WHENEVER = "Whenever"
