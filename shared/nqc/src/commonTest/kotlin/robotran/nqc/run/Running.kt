package robotran.nqc.run

import robotran.brick.controls.BrickButton
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.SymbolKind
import robotran.legofirmware.run.FirmwareState
import robotran.nqc.NqcOptions
import robotran.nqc.programOf
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.messages.BrickMessages
import kotlin.test.assertIs

/** Runs [source] on a brick until it ends and returns its global variables by name. */
internal fun variablesAfter(source: String, target: FirmwareTarget): Map<String, Int> {
    val program = programOf(source, NqcOptions(target))
    val brick =
        RcxBrick(
            listOf(program.forBrick(language = Language.ENGLISH)),
            InfraredAir(),
            messages = BrickMessages.of(Language.ENGLISH),
        )
    brick.press(BrickButton.RUN)
    brick.release(BrickButton.RUN)
    var milliseconds = 0
    while (milliseconds++ < LONGEST_RUN && (milliseconds < 10 || brick.state.run is RunState.Running)) brick.tick()
    assertIs<RunState.Ended>(brick.state.run, "The program does not end: $source")
    val values = (brick.firmwareState as FirmwareState).variables
    return program.image.symbols.filter { it.kind == SymbolKind.VARIABLE && it.number < values.size }
        .associate { it.name to values[it.number] }
}

/** In milliseconds. */
private const val LONGEST_RUN = 60_000
