package robotran.legofirmware

import robotran.language.Language
import robotran.legofirmware.image.LineTable
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.VariableTable
import robotran.legofirmware.messages.FirmwareRunMessages
import robotran.legofirmware.run.FirmwareMachine
import robotran.legofirmware.run.FirmwareRun
import robotran.legofirmware.run.LegoFirmwareRun
import robotran.legofirmware.run.ProgramCode
import robotran.rcxrom.program.RcxFirmware
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom

/**
 * A program for LEGO's firmware, ready to load into a brick. Immutable.
 *
 * @property lines where its code comes from, for the log and the debugger.
 * @property variables who knows which variable, for the debugger; null if every task knows all that the image names.
 * @property language of the warnings about a run.
 */
class FirmwareProgram(
    override val name: String,
    val image: RcxImage,
    val lines: LineTable = LineTable.NONE,
    private val language: Language,
    val variables: VariableTable? = null,
) : RcxProgram {
    override val firmware: RcxFirmware get() = LegoFirmware(language)

    internal val code = ProgramCode(name, image, lines, variables)

    /** Starts a new run on a firmware of its own, which knows nothing of earlier runs. */
    override fun start(rom: Rom): LegoFirmwareRun {
        val machine = FirmwareMachine(rom, FirmwareRunMessages.of(language))
        machine.begin()
        return FirmwareRun(machine, code)
    }
}
