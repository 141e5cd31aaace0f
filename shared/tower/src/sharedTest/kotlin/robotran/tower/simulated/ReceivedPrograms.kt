package robotran.tower.simulated

import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.legofirmware.FirmwareProgram
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages

/** What was sent to [slot], as the firmware's virtual machine runs it. */
fun SimulatedLegoFirmware.programIn(slot: Int): FirmwareProgram {
    val chunks = parts.filterKeys { it.startsWith("$slot ") }.map { (name, code) ->
        val (_, kind, number) = name.split(' ')
        Chunk(ChunkId(if (kind == "task") ChunkKind.TASK else ChunkKind.SUB, number.toInt()), CodeBytes(code))
    }
    return FirmwareProgram("received", RcxImage(FirmwareTarget.RCX2, chunks), language = Language.ENGLISH)
}

/** A virtual brick on which [program] has run for [milliseconds]. */
fun brickAfter(program: FirmwareProgram, milliseconds: Int): RcxBrick =
    RcxBrick(listOf(program), messages = BrickMessages.of(Language.ENGLISH)).also { brick ->
        brick.press(BrickButton.RUN)
        brick.release(BrickButton.RUN)
        repeat(milliseconds) { brick.tick() }
    }
