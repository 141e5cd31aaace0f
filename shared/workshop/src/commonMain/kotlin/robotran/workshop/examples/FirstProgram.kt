package robotran.workshop.examples

import robotran.workshop.state.PupilProgram

/** The square program, the initial program of a new project. */
fun firstProgram(): PupilProgram = PupilProgram(NAME, exampleTexts.getValue(NAME))

private const val NAME = "square.robo"
