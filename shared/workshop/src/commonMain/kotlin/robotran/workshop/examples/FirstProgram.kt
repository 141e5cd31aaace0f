package robotran.workshop.examples

import robotran.programs.Program

/** The square program, the initial program of a new project. */
fun firstProgram(): Program = Program.of(NAME, exampleTexts.getValue(NAME))

private const val NAME = "square.robo"
