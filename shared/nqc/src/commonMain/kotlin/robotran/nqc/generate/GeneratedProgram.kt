package robotran.nqc.generate

import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.RcxImage

/**
 * @property lines of each task and subroutine.
 * @property isOutOfVariables whether a variable found no place, so that the program has mistakes.
 */
internal class GeneratedProgram(
    val image: RcxImage,
    val lines: Map<ChunkId, List<NqcCodeLine>>,
    val isOutOfVariables: Boolean,
)
