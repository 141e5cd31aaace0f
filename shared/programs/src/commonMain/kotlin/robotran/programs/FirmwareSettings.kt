package robotran.programs

import robotran.legofirmware.image.FirmwareTarget

/**
 * How programs for LEGO's own firmware are compiled.
 *
 * @property target the firmware that they are for; what only a newer one knows is a mistake.
 * @property isOldNqc whether NQC has the API of version 1.3, from before 2000.
 */
data class FirmwareSettings(val target: FirmwareTarget = FirmwareTarget.RCX2, val isOldNqc: Boolean = false)
