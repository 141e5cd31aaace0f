package robotran.legofirmware.assembly

import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.image.Symbol
import robotran.legofirmware.image.SymbolKind

/**
 * The names in the comments of an assembly listing, such as `; Var 0 = n` and `; Task 0 = main, size: 12 bytes`. A
 * listing has no other place for them.
 */
internal class Names {
    private val chunkNames = mutableMapOf<ChunkId, String>()
    private val variables = mutableListOf<Symbol>()

    fun read(line: String) {
        val comment = line.trim()
        if (!comment.startsWith("; ") || variables.size >= FirmwareLimits.SYMBOLS / 2) return
        val words = comment.drop(2).split(' ', limit = WORDS)
        if (words.size < WORDS || words[2] != "=") return
        val number = words[1].toIntOrNull()?.takeIf { it in 0..GREATEST_NUMBER } ?: return
        val isFit = { name: String -> name.length <= FirmwareLimits.NAME_CHARACTERS && name.all { it.code in NAME } }
        when (words[0]) {
            "Var" -> if (isFit(words.last())) variables += Symbol(SymbolKind.VARIABLE, number, words.last())

            "Task", "Sub" -> {
                val name = words.last().substringBefore(", size:")
                val kind = if (words[0] == "Task") ChunkKind.TASK else ChunkKind.SUB
                if (isFit(name)) chunkNames[ChunkId(kind, number)] = name
            }
        }
    }

    /** The symbols of [chunks], then of variables, as NQC's compiler orders them. */
    fun symbols(chunks: List<ChunkId>): List<Symbol> {
        val named = chunks.mapNotNull { id ->
            val kind = if (id.kind == ChunkKind.TASK) SymbolKind.TASK else SymbolKind.SUB
            chunkNames[id]?.takeIf { it.isNotEmpty() }?.let { Symbol(kind, id.number, it) }
        }
        return named + variables
    }

    private companion object {
        const val WORDS = 4
        const val GREATEST_NUMBER = 255

        /** Characters of a name in an image. */
        val NAME = 1..0xFF
    }
}
