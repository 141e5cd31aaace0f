package robotran.legofirmware.assembly

import robotran.legofirmware.image.ChunkKind

/** The lines around a task or subroutine. */
internal enum class BlockDirective(val word: String, val end: String, val kind: ChunkKind) {
    TASK("task", "endt", ChunkKind.TASK),
    SUB("sub", "ends", ChunkKind.SUB),
}
