package robotran.nqc

import robotran.legofirmware.image.FirmwareTarget

/**
 * How to compile a program.
 *
 * @property target the firmware that the program is for.
 * @property isOld whether the program was written for NQC 1.3, from before 2000: it has another API, and nothing is set
 * up before its first command.
 * @property files other files of the program by the names that `#include` gives them.
 */
data class NqcOptions(
    val target: FirmwareTarget = FirmwareTarget.RCX2,
    val isOld: Boolean = false,
    val files: Map<String, String> = emptyMap(),
)
