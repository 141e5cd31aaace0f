package robotran.build.texts

/**
 * The blocks of a Markdown [document] that start with three backticks and [mark]. The key is [path] and the number of
 * the block's first line, such as `docs/worlds.md:12`.
 */
fun fencedBlocks(path: String, document: String, mark: String): Map<String, String> {
    val blocks = mutableMapOf<String, String>()
    var block: StringBuilder? = null
    var firstLine = 0
    document.lines().forEachIndexed { index, line ->
        val open = block
        when {
            open == null && line == FENCE + mark -> {
                block = StringBuilder()
                firstLine = index + 2
            }

            open != null && line == FENCE -> {
                blocks["$path:$firstLine"] = open.toString()
                block = null
            }

            open != null -> open.append(line).append('\n')
        }
    }
    require(block == null) { "$path: the block that begins at line $firstLine has no end" }
    return blocks
}

private const val FENCE = "```"
