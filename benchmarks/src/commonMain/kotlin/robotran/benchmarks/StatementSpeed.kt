package robotran.benchmarks

import robotran.brick.program.ProgramStatus
import robotran.robolang.RobolangRcxProgram

/** The statements per second of the interpreter, in a counting loop. */
internal suspend fun statementSpeed(): Measurement {
    val program = programOf("var count = 0\nrepeat 2000000 times\n  count = count + 1\nend\n") as RobolangRcxProgram
    var statements = 0L
    val seconds =
        seconds {
            val run = program.start(SilentRom())
            while (run.resume(STEPS) == ProgramStatus.Running) Unit
            statements = run.statementsBegun
        }
    return Measurement(statements / seconds / 1e6, "million statements/s", "$statements in ${rounded(seconds)} s")
}

private const val STEPS = 100_000
