package robotran.legofirmware.image

/**
 * A part of a program.
 *
 * @property code its number in an image.
 * @property limit max number of such chunks; their numbers are below it.
 */
enum class ChunkKind(val code: Int, val limit: Int) {
    TASK(0, FirmwareLimits.TASKS),
    SUB(1, FirmwareLimits.SUBROUTINES),
    ;

    companion object {
        fun of(code: Int): ChunkKind? = entries.find { it.code == code }
    }
}

/**
 * Which task or subroutine of a program.
 *
 * @property number from 0; task 0 is the main task.
 */
data class ChunkId(val kind: ChunkKind, val number: Int) : Comparable<ChunkId> {
    /** Tasks before subroutines, then by number, as in a listing. */
    override fun compareTo(other: ChunkId): Int = compareValuesBy(this, other, { it.kind }, { it.number })

    companion object {
        val MAIN = ChunkId(ChunkKind.TASK, 0)
    }
}

/** The code of a task or subroutine. The firmware adds the return at its end. */
data class Chunk(val id: ChunkId, val code: CodeBytes)
