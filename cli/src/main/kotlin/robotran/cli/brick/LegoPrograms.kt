package robotran.cli.brick

import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.RcxImage
import robotran.tower.LegoPartKind
import robotran.tower.LegoProgram
import robotran.tower.LegoProgramPart

/** What a brick gets of the image; it knows no names. */
internal fun RcxImage.toLegoProgram(): LegoProgram = LegoProgram(
    chunks.map { chunk ->
        val kind = when (chunk.id.kind) {
            ChunkKind.TASK -> LegoPartKind.TASK
            ChunkKind.SUB -> LegoPartKind.SUBROUTINE
        }
        LegoProgramPart(kind, chunk.id.number, chunk.code.toByteArray())
    },
)
