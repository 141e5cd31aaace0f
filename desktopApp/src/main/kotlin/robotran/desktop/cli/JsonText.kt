package robotran.desktop.cli

/** [text] as a string in JSON. */
internal fun quoted(text: String): String =
    buildString {
        append('"')
        for (character in text) {
            when {
                character == '"' || character == '\\' -> append('\\').append(character)
                character < ' ' || character.isSurrogate() -> append("\\u%04x".format(character.code))
                else -> append(character)
            }
        }
        append('"')
    }
