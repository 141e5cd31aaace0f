package robotran.nqc.api

/**
 * The API as it is written: headers in NQC (`src/api`), whose doc comments are its help.
 *
 * @param isOld whether it is that of NQC 1.3.
 */
internal class ApiHeader(isOld: Boolean) {
    private val files = TOPICS.mapNotNull { topic -> apiTexts[if (isOld) "old/$topic" else topic] }

    /** All of it. */
    val text: String = files.joinToString("\n")

    /** What is left without the lines of `#define`: the functions. */
    val functions: String = text.lines().filterNot { it.startsWith(DEFINE) }.joinToString("\n")

    /** The comment on each name, in the order in which a list of them makes sense. */
    val docs: Map<String, ApiDoc> = text.split(ApiDoc.END).filter { it.startsWith(ApiDoc.BEGINNING) }
        .flatMap { paragraph -> ApiDoc(paragraph).let { doc -> namesIn(paragraph).map { it to doc } } }
        .toMap()

    private fun namesIn(paragraph: String) = paragraph.lines().mapNotNull { line ->
        DECLARING.firstOrNull { line.startsWith(it) }?.let { line.removePrefix(it).takeWhile(::isInName) }
    }

    private fun isInName(character: Char) = character.isLetterOrDigit() || character == '_'

    private companion object {
        /** The headers in the order in which a list of their names makes sense. */
        val TOPICS = "outputs sensors sound display datalog time events messages tasks serial other".split(' ')
            .map { "$it.nqh" }

        const val DEFINE = "#define "
        val DECLARING = listOf(DEFINE, "void ")
    }
}
