package robotran.workshop.examples

import robotran.workshop.state.PupilProgram

/** The square: what is there before a pupil has written anything. */
fun firstProgram(): PupilProgram = PupilProgram(NAME, exampleTexts.getValue(NAME))

private const val NAME = "square.robo"
