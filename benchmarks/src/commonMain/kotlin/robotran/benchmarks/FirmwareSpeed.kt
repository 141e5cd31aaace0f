package robotran.benchmarks

import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.rcxrom.program.RcxProgram
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.file.BuiltInWorlds
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld

/** The commands per second of the machine of LEGO's firmware, in a loop of arithmetic, comparisons and a second task. */
internal suspend fun firmwareCommandSpeed(): Measurement {
    val program = nqcProgramOf("mixed.nqc", MIXED_NQC)
    val seconds = seconds {
        val rom = SilentRom()
        val run = program.start(rom)
        repeat(COMMANDS) {
            check(run.resume(1) == ProgramStatus.Running) { "The loop came to an end." }
            rom.milliseconds += MILLISECONDS_OF_COMMAND
        }
    }
    val speed = COMMANDS / seconds
    return Measurement(
        speed / 1e6,
        "million commands/s, ${rounded(speed / COMMANDS_OF_BRICK)} times as many as a real brick",
        "$COMMANDS in ${rounded(seconds)} s",
    )
}

/** The speed relative to real time of a session in which a program in NQC follows a line. */
internal suspend fun nqcLineFollowerSpeed(): Measurement {
    val world = (
        readWorld(
            BuiltInWorlds.texts.getValue("line-loop.world.json"),
            Language.ENGLISH,
        ) as WorldFileResult.Success
    ).world
    val program = nqcProgramOf(LINE_FOLLOWER_NQC, nqcPrograms.getValue(LINE_FOLLOWER_NQC))
    return realTime(running(program, world, loadPhysicsEngine()))
}

/** The valid program [source] in NQC, compiled. */
private suspend fun nqcProgramOf(name: String, source: String): RcxProgram = when (
    val result = ProgramCompiler(
        ANY_TARGET,
        language = Language.ENGLISH,
    ).compileOrThrow(Program.of(name, source))
) {
    is ProgramResult.Success -> result.program as RcxProgram
    is ProgramResult.Failure -> error(result.diagnostics.first().message)
}

private val MIXED_NQC =
    """
    int sum;
    int past[4];

    task main()
    {
        int i;
        start other;
        while (true)
        {
            for (i = 0; i < 4; i++)
            {
                past[i] = past[i] * 31 + i;
                if (past[i] > sum) sum = past[i] / 3;
                else sum -= i;
            }
        }
    }

    task other()
    {
        int rounds;
        while (true) rounds = (rounds + 7) % 100;
    }
    """.trimIndent()

private const val LINE_FOLLOWER_NQC = "line-follower.nqc"
private const val COMMANDS = 1_000_000

/** What a command takes with firmware 2.0. */
private const val MILLISECONDS_OF_COMMAND = 3

/** A second's commands of a real RCX, as measured on LUGNET; see `docs/lego-firmware.md`. */
private const val COMMANDS_OF_BRICK = 330
