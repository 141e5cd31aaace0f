package robotran.legofirmware

import robotran.language.Language
import robotran.legofirmware.messages.FirmwareRunMessages
import robotran.legofirmware.shell.LegoShell
import robotran.rcxrom.program.RcxFirmware
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.RcxShell
import robotran.rcxrom.program.ShellHardware

/**
 * LEGO's own firmware for a virtual RCX. It runs [FirmwareProgram]s; a slot with another program is empty for it.
 *
 * @property language of its warnings and explanations.
 */
internal data class LegoFirmware(private val language: Language) : RcxFirmware {
    override fun load(programs: List<RcxProgram?>, firstSlot: Int, hardware: ShellHardware): RcxShell = LegoShell(
        slots = programs.map { (it as? FirmwareProgram)?.code },
        codeOf = { (it as? FirmwareProgram)?.code },
        firstSlot,
        hardware,
        FirmwareRunMessages.of(language),
    )
}
