package robotran.cli.microbit

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.options.option
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.cli.hub.isBoard
import robotran.cli.hub.pythonBrickOf
import robotran.language.Language

/** `--micropython`: the file into which a program for a micro:bit goes. */
internal fun ParameterHolder.microPythonOption() = option(
    "--micropython",
    metavar = "FILE",
    help = "for a micro:bit: a .hex with MicroPython, such as one that was saved in the Python editor of the micro:bit",
)

/**
 * The micro:bit that the only one of [programs] is for: [brick] or, if that is not given, the one that its header names; null
 * if it is for none. Refuses a [buggy] without one.
 */
internal fun boardOf(programs: List<String>, brick: BrickKind?, buggy: BuggyKind?, language: Language): BrickKind? {
    val board = pythonBrickOf(programs, brick, language)?.takeIf { it.isBoard }
    if (buggy != null && board == null) throw UsageError("--buggy goes with --brick microbit or microbit-v1")
    return board
}
