package robotran.build.texts

/**
 * Generates Kotlin code for texts. The JVM limits string constants and methods to 65,535 bytes. So each file holds a
 * few texts, each in a function of its own and in pieces that compilers do not join. A text is put together when it is
 * first read, so that the web page can leave those to its later part that the first minute does not read.
 *
 * @param qualifiedName the package and name of the constant, a `Map<String, String>` from path to text.
 */
class TextSources(qualifiedName: String) {
    private val packageName = qualifiedName.substringBeforeLast('.')
    private val name = qualifiedName.substringAfterLast('.')

    /** The names and contents of the files that declare the constant, with [texts] by path. */
    fun files(texts: Map<String, String>): Map<String, String> {
        val parts = texts.entries.sortedBy { it.key }.chunked(TEXTS_IN_A_FILE)
        val files = parts.mapIndexed { index, part -> "$name$index.kt" to partFile("$name$index", part) }.toMap()
        val all = parts.indices.joinToString(" + ") { "$name$it()" }.ifEmpty { "emptyMap()" }
        return files + ("$name.kt" to mapFile(all))
    }

    private fun mapFile(readers: String): String = """
        |$HEADER
        |package $packageName
        |
        |private class ${name}Entry(override val key: String, read: () -> String) : Map.Entry<String, String> {
        |    override val value: String by lazy(LazyThreadSafetyMode.PUBLICATION, read)
        |}
        |
        |internal val $name: Map<String, String> = object : AbstractMap<String, String>() {
        |    private val readers: Map<String, () -> String> = $readers
        |    private val all = readers.mapValues { ${name}Entry(it.key, it.value) }
        |    override val entries: Set<Map.Entry<String, String>> = all.values.toSet()
        |    override val keys: Set<String> get() = all.keys
        |    override fun containsKey(key: String): Boolean = key in all
        |    override fun get(key: String): String? = all[key]?.value
        |}
        |
        """.trimMargin()

    private fun partFile(function: String, texts: List<Map.Entry<String, String>>): String = buildString {
        append("$HEADER\npackage $packageName\n\ninternal fun $function(): Map<String, () -> String> = mapOf(\n")
        texts.forEachIndexed { index, (path, _) -> append("    ${literal(path)} to { ${function}Text$index() },\n") }
        append(")\n")
        texts.forEachIndexed { index, (_, text) ->
            append("\nprivate fun ${function}Text$index() = listOf(\n")
            // An empty text is one empty piece: Kotlin could not tell what a list of nothing holds.
            text.chunked(CHARACTERS_IN_A_PIECE).ifEmpty { listOf("") }.forEach { append("    ${literal(it)},\n") }
            append(").joinToString(\"\")\n")
        }
    }

    private companion object {
        const val TEXTS_IN_A_FILE = 40
    }
}

/** [text] as Kotlin writes it in a program. */
internal fun literal(text: String): String = buildString {
    append('"')
    for (character in text) {
        when (character) {
            '"', '\\', '$' -> append('\\').append(character)
            in ' '..'~' -> append(character)
            else -> append("\\u").append("%04x".format(character.code))
        }
    }
    append('"')
}

internal const val HEADER = "// Generated from text files of the tree.\n"

/** Class files hold no longer constants than 65,535 bytes, of which a character may take three. */
internal const val CHARACTERS_IN_A_PIECE = 4000
