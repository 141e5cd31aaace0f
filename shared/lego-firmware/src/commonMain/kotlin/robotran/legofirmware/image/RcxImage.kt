package robotran.legofirmware.image

/**
 * A program for LEGO's firmware: the contents of an `.rcx` file (RCXI).
 *
 * @property chunks in the order of the file, in which they are sent to a brick; no two with one [Chunk.id].
 * @property symbols in the order of the file.
 */
data class RcxImage(val target: FirmwareTarget, val chunks: List<Chunk>, val symbols: List<Symbol> = emptyList()) {
    /** The sum of the chunks' code in bytes. */
    val codeSize: Int get() = chunks.sumOf { it.code.size }

    /** The chunk with this [id]; null if the program has none. */
    fun chunk(id: ChunkId): Chunk? = chunks.find { it.id == id }

    /** The name of a task or subroutine; null if the image does not say it. */
    fun nameOf(id: ChunkId): String? = symbols.find { it.kind.code == id.kind.code && it.number == id.number }?.name

    /** The first name of a variable; null if the image does not say it. */
    fun nameOfVariable(number: Int): String? =
        symbols.find { it.kind == SymbolKind.VARIABLE && it.number == number }?.name
}
