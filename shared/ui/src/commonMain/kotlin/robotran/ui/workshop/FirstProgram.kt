package robotran.ui.workshop

import robotran.ui.exampleTexts

/** The square: what is there before a pupil has written anything. */
internal fun firstProgram(): PupilProgram = PupilProgram(NAME, exampleTexts.getValue(NAME))

private const val NAME = "square.robo"
