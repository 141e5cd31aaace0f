package robotran.build

import java.io.Serializable

/** How programs of one language are recognised: by the end of a file's name, and by the mark of a fenced block. */
data class ProgramLanguage(
    val extension: String,
    val fence: String,
) : Serializable

/** A program and where it was found, with the line its fenced block begins at if it comes from a document. */
data class ProgramText(
    val path: String,
    val text: String,
)

/** The programs in the blocks of a Markdown [document] that begin with three backticks and [mark]. */
fun fencedPrograms(document: ProgramText, mark: String): List<ProgramText> {
    val programs = mutableListOf<ProgramText>()
    var block: StringBuilder? = null
    var firstLine = 0
    document.text.lines().forEachIndexed { index, line ->
        val open = block
        when {
            open == null && line == FENCE + mark -> {
                block = StringBuilder()
                firstLine = index + 2
            }

            open != null && line == FENCE -> {
                programs += ProgramText("${document.path}:$firstLine", open.toString())
                block = null
            }

            open != null -> {
                open.append(line).append('\n')
            }
        }
    }
    require(block == null) { "${document.path}: the block that begins at line $firstLine has no end" }
    return programs
}

private const val FENCE = "```"
