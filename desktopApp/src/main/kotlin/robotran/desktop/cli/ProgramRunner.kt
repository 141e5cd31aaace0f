package robotran.desktop.cli

import kotlinx.coroutines.runBlocking
import robotran.desktop.ExitCode
import robotran.desktop.files.NamedProgram
import robotran.desktop.files.ProgramFiles
import robotran.desktop.files.TextFile
import robotran.desktop.files.readProgramFiles
import robotran.desktop.files.readTextFile
import robotran.programs.JavaSettings
import robotran.programs.ProgramReader
import robotran.programs.ProgramResult
import robotran.rom.RcxProgram
import robotran.rom.RunState
import robotran.ui.workshop.PENBOT_CALIBRATION
import robotran.world.BuiltInWorlds
import robotran.world.Session
import robotran.world.World
import robotran.world.WorldFileResult
import robotran.world.physics.loadPhysicsEngine
import robotran.world.readWorld
import robotran.world.runUnattended

/** Runs programs in one world as `robotran run` does: reads all, presses Run, lets virtual time pass, writes the results. */
internal class ProgramRunner(
    private val console: Console,
) {
    /**
     * @param programNames the programs' files, see [readProgramFiles].
     * @param java how Java programs are to run.
     * @param worldName the world's file; the plain sheet if null.
     * @param milliseconds how much virtual time may pass at most.
     * @param presses what is done to the buttons; if empty, Run is pressed.
     */
    fun run(
        programNames: List<String>,
        java: JavaSettings,
        worldName: String?,
        milliseconds: Int,
        presses: List<ButtonPress>,
        outputs: RunOutputs,
    ): ExitCode {
        val programs = readPrograms(programNames, java)
        val world = readWorldFile(worldName)
        if (programs == null || world == null) return ExitCode.BAD_INPUT

        val session = runBlocking { Session(world, programs, loadPhysicsEngine()) }
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

    /** Null if any of them cannot run; why is told. */
    private fun readPrograms(
        names: List<String>,
        java: JavaSettings,
    ): List<RcxProgram>? =
        when (val files = readProgramFiles(names)) {
            is ProgramFiles.Read -> {
                val reader = ProgramReader(PENBOT_CALIBRATION, java)
                files.programs.map { readProgram(it, reader) }.takeIf { null !in it }?.filterNotNull()
            }

            is ProgramFiles.Refused -> {
                console.complain(files.reason)
                null
            }
        }

    private fun readProgram(
        program: NamedProgram,
        reader: ProgramReader,
    ): RcxProgram? =
        when (val result = runBlocking { reader.read(program.source) }) {
            is ProgramResult.Ready -> {
                result.program
            }

            is ProgramResult.Mistaken -> {
                result.mistakes.forEach { console.complain(lineOf(program, it)) }
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
