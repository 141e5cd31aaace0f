package robotran.rcxrom.controls

import robotran.brick.controls.MotorPort

/** The ROM's code for this output port. */
val MotorPort.romCode: Int get() = FIRST_CODE + ordinal

private const val FIRST_CODE = 0x2000
