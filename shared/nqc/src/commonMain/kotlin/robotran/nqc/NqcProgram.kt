package robotran.nqc

import robotran.language.Language
import robotran.legofirmware.FirmwareProgram
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.CodeLine
import robotran.legofirmware.image.LineTable
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.VariableTable
import robotran.nqc.generate.NqcCodeLine

/**
 * A compiled program.
 *
 * @property name usually that of its file.
 * @property image what a brick runs; its symbols are in the order of the original compiler.
 * @property variables who knows which variable.
 * @property lines where the code of each task and subroutine comes from, in the order of addresses.
 */
class NqcProgram internal constructor(
    val name: String,
    val image: RcxImage,
    val lines: Map<ChunkId, List<NqcCodeLine>>,
    val variables: VariableTable,
) {
    /** The statement whose code is at [address] of a task or subroutine; null if there is none. */
    fun lineAt(chunk: ChunkId, address: Int): NqcCodeLine? = lines[chunk]?.lastOrNull { it.address <= address }

    /** [lines] for the log and the debugger of the firmware; lines of the main file have no file there. */
    val lineTable: LineTable
        get() = LineTable(
            lines.mapValues { (_, ofChunk) ->
                ofChunk.map { CodeLine(it.address, it.range.line, it.range.file.takeIf { file -> file != name }) }
            },
        )

    /**
     * The program for the brick.
     *
     * @param language of the warnings about a run.
     */
    fun forBrick(language: Language): FirmwareProgram = FirmwareProgram(name, image, lineTable, language, variables)
}
