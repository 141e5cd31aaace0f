package robotran.legofirmware.model

import robotran.legofirmware.image.FirmwareTarget

/**
 * How a firmware runs programs.
 *
 * @property opcodeMilliseconds virtual time of one instruction of any task. Source: Dick Swan's measurements on LUGNET
 * (robotics, 17666 and 22994): 2.6 to 3.2 ms for firmware 2.0, and 1.5 times as fast for 1.0.
 * @property version as a program reads it.
 */
internal class FirmwareModel private constructor(
    val target: FirmwareTarget,
    val opcodeMilliseconds: Long,
    val version: Int,
) {
    val isSecond: Boolean get() = target == FirmwareTarget.RCX2

    companion object {
        private val FIRST = FirmwareModel(FirmwareTarget.RCX, 2, 309)
        private val SECOND = FirmwareModel(FirmwareTarget.RCX2, 3, 328)

        fun of(target: FirmwareTarget): FirmwareModel = if (target == FirmwareTarget.RCX) FIRST else SECOND
    }
}
