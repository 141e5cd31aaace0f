package robotran.build.texts

import java.util.zip.Deflater

/**
 * Generates Kotlin code for texts that are deflated together, those of each language of people apart from the others. A
 * package is unpacked when a text in it is first read. A web page holds a third of what it would hold otherwise.
 *
 * @param qualifiedName the package and name of the constant, a `Map<String, String>` from path to text.
 */
class PackedTextSources(qualifiedName: String) {
    private val packageName = qualifiedName.substringBeforeLast('.')
    private val name = qualifiedName.substringAfterLast('.')

    /** The names and contents of the files that declare the constant, with [texts] by path. */
    fun files(texts: Map<String, String>): Map<String, String> {
        val packages = texts.entries.sortedBy { it.key }.groupBy { languageOf(it.key) }.toSortedMap()
        val files = packages.map { (language, part) -> fileName(language) to packageFile(language, part) }
        return files.toMap() + ("$name.kt" to mapFile(packages))
    }

    private fun mapFile(packages: Map<String, List<Map.Entry<String, String>>>): String = buildString {
        append("$HEADER\npackage $packageName\n\nimport robotran.language.packed.unpack\n\n")
        append("internal val $name: Map<String, String> = object : AbstractMap<String, String>() {\n")
        for (language in packages.keys) {
            append("    private val ${wholeName(language)} by lazy { unpack(${piecesName(language)}()) }\n")
        }
        append("    private val all: Map<String, Entry> = buildMap {\n")
        for (language in packages.keys) {
            append("        var start = 0\n".replace("start", "start$language"))
            append("        for ((path, length) in ${placesName(language)}()) {\n")
            append("            val from = start$language\n")
            append("            put(path, Entry(path) { ${wholeName(language)}.substring(from, from + length) })\n")
            append("            start$language += length\n        }\n")
        }
        append("    }\n")
        append("    override val entries: Set<Map.Entry<String, String>> = all.values.toSet()\n")
        append("    override val keys: Set<String> get() = all.keys\n")
        append("    override fun containsKey(key: String): Boolean = key in all\n")
        append("    override fun get(key: String): String? = all[key]?.value\n}\n\n")
        append("private class Entry(override val key: String, read: () -> String) : Map.Entry<String, String> {\n")
        append("    override val value: String by lazy(LazyThreadSafetyMode.PUBLICATION, read)\n}\n")
    }.replace("Entry(", "${name}Entry(").replace(", Entry>", ", ${name}Entry>")

    private fun packageFile(language: String, texts: List<Map.Entry<String, String>>): String = buildString {
        append("$HEADER\npackage $packageName\n\ninternal fun ${placesName(language)}() = listOf(\n")
        for ((path, text) in texts) append("    ${literal(path)} to ${text.length},\n")
        append(")\n\ninternal fun ${piecesName(language)}() = listOf(\n")
        packed(texts.joinToString("") { it.value }).chunked(CHARACTERS_IN_A_PIECE).forEach {
            append("    ${literal(it)},\n")
        }
        append(")\n")
    }

    private fun fileName(language: String) = "$name${suffix(language)}.kt"

    private fun wholeName(language: String) = "whole${suffix(language)}"

    private fun piecesName(language: String) = "$name${suffix(language)}Pieces"

    private fun placesName(language: String) = "$name${suffix(language)}Places"

    private fun suffix(language: String) =
        if (language.isEmpty()) "Other" else language.replaceFirstChar(Char::uppercase)

    private fun languageOf(path: String): String = TAGGED.find(path)?.groupValues?.get(1).orEmpty()

    private companion object {
        val TAGGED = Regex("\\.([a-z]{2})\\.md$")
    }
}

/** The UTF-8 of [text], deflated (RFC 1951), a byte in each character. */
internal fun packed(text: String): String {
    val deflater = Deflater(Deflater.BEST_COMPRESSION, true)
    val bytes = text.encodeToByteArray()
    deflater.setInput(bytes)
    deflater.finish()
    val room = ByteArray(bytes.size + bytes.size / 8 + 64)
    var count = 0
    while (!deflater.finished()) count += deflater.deflate(room, count, room.size - count)
    deflater.end()
    return buildString(count) { for (index in 0..<count) append((room[index].toInt() and 0xff).toChar()) }
}
