package robotran.nqc

import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.RcxImage
import robotran.nqc.generate.CodeLine

/**
 * A compiled program.
 *
 * @property name usually that of its file.
 * @property image what a brick runs; its symbols are in the order of the original compiler.
 * @property lines where the code of each task and subroutine comes from, in the order of addresses.
 */
class NqcProgram internal constructor(val name: String, val image: RcxImage, val lines: Map<ChunkId, List<CodeLine>>) {
    /** The statement whose code is at [address] of a task or subroutine; null if there is none. */
    fun lineAt(chunk: ChunkId, address: Int): CodeLine? = lines[chunk]?.lastOrNull { it.address <= address }
}
