package robotran.blockediting.palette

import robotran.robolang.outline.LineForm

/** Whether a pupil sees or hears what this block does if it runs alone. */
val PaletteBlock.canBeTried: Boolean get() = !isValue && id in TRIED_IDS

private val TRIED_IDS = setOf(
    LineForm.MOVE,
    LineForm.MOVE_FOR_TIME,
    LineForm.TURN,
    LineForm.TURN_FOR_TIME,
    LineForm.START_MOVING,
    LineForm.START_TURNING,
    LineForm.STOP,
    LineForm.MOTOR,
    LineForm.MOTOR_TURN,
    LineForm.START_MOTOR_TURN,
    LineForm.PEN,
    LineForm.BEEP,
    LineForm.BUZZ,
    LineForm.PLAY,
    LineForm.SHOW,
    LineForm.SHOW_TEXT,
    LineForm.CLEAR_SCREEN,
    LineForm.CALL,
).mapTo(mutableSetOf()) { idOf(it) }
