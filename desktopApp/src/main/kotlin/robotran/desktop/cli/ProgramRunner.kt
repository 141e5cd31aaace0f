package robotran.desktop.cli

import kotlinx.coroutines.runBlocking
import robotran.desktop.ExitCode
import robotran.desktop.TextFile
import robotran.desktop.readTextFile
import robotran.rom.RcxProgram
import robotran.rom.RunState
import robotran.world.BuiltInWorlds
import robotran.world.Session
import robotran.world.World
import robotran.world.WorldFileResult
import robotran.world.physics.loadPhysicsEngine
import robotran.world.readWorld
import robotran.world.runUnattended

/** Runs one program in one world as `robotran run` does: reads both, presses Run, lets virtual time pass, writes the results. */
internal class ProgramRunner(
    private val console: Console,
) {
    /**
     * @param worldName the world's file; the plain sheet if null.
     * @param milliseconds how much virtual time may pass at most.
     * @param presses what is done to the buttons; if empty, Run is pressed.
     */
    fun run(
        programName: String,
        worldName: String?,
        milliseconds: Int,
        presses: List<ButtonPress>,
        outputs: RunOutputs,
    ): ExitCode {
        val program = readProgram(programName)
        val world = readWorldFile(worldName)
        if (program == null || world == null) return ExitCode.BAD_INPUT

        val session = runBlocking { Session(world, listOf(program), loadPhysicsEngine()) }
        try {
            if (presses.isEmpty()) session.runUnattended(milliseconds) else session.runWithPresses(presses, milliseconds)
            val problems = RunResults(session, console).write(outputs)
            problems.forEach(console::complain)
            val run = session.state.brick.run
            return when {
                problems.isNotEmpty() -> ExitCode.BAD_INPUT
                run is RunState.Failed -> ExitCode.PROGRAM_FAILED
                else -> ExitCode.DONE
            }
        } finally {
            session.close()
        }
    }

    private fun readProgram(name: String): RcxProgram? =
        when (val file = readRobolangFile(name)) {
            is RobolangFile.Ready -> {
                file.program
            }

            is RobolangFile.Mistaken -> {
                file.diagnostics.forEach { console.complain(lineOf(name, it)) }
                null
            }

            is RobolangFile.Unreadable -> {
                console.complain(file.reason)
                null
            }
        }

    private fun readWorldFile(name: String?): World? {
        if (name == null) return BuiltInWorlds.plain
        val text = textOf(name) ?: return null
        return when (val result = readWorld(text)) {
            is WorldFileResult.Loaded -> {
                result.world
            }

            is WorldFileResult.Refused -> {
                console.complain("$name: ${result.message}")
                null
            }
        }
    }

    private fun textOf(name: String): String? =
        when (val file = readTextFile(name)) {
            is TextFile.Read -> {
                file.text
            }

            is TextFile.Refused -> {
                console.complain(file.reason)
                null
            }
        }
}
