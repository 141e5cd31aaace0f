package robotran.legofirmware.task

import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.instructions.PlacedInstruction
import robotran.legofirmware.instructions.instructionAt

/** The code of a task or subroutine; each instruction is decoded once. */
internal class LoadedChunk(chunk: Chunk) {
    val id: ChunkId = chunk.id
    val code: CodeBytes = chunk.code
    private val decoded = arrayOfNulls<PlacedInstruction>(code.size)

    /** The instruction at [address]; null if there is none. */
    fun instruction(address: Int): PlacedInstruction? {
        if (address !in decoded.indices) return null
        return decoded[address] ?: code.instructionAt(address)?.also { decoded[address] = it }
    }

    /** Whether the code is over at [address]: a jump may lead out of it. */
    fun isEnd(address: Int): Boolean = address !in decoded.indices
}

/** A place in the code. */
internal data class Location(val chunk: LoadedChunk, val address: Int)
