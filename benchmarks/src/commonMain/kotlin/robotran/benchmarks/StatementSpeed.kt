package robotran.benchmarks

import robotran.rom.ProgramStatus
import robotran.rom.RcxMemory
import robotran.rom.Rom
import robotran.rom.RomCall
import robotran.rom.SensorField
import robotran.rom.SensorRequest

/** How many statements a second the interpreter executes in a loop that counts. */
internal suspend fun statementSpeed(): Figure {
    val program = programOf("var count = 0\nrepeat 2000000 times\n  count = count + 1\nend\n")
    var statements = 0L
    val seconds =
        seconds {
            val run = program.start(SilentRom())
            while (run.resume(STEPS) == ProgramStatus.Running) Unit
            statements = run.statementsBegun
        }
    return Figure(statements / seconds / 1e6, "million statements/s", "$statements in ${rounded(seconds)} s")
}

/** A ROM behind which there is nothing. */
private class SilentRom : Rom {
    override val memory = RcxMemory()

    override val milliseconds = 0L

    override fun call(
        call: RomCall,
        sourceLine: Int,
        sourceFile: String?,
    ) = Unit

    override fun readSensor(
        port: Int,
        request: SensorRequest,
    ): Int = 0

    override fun setSensorTypeAndMode(
        port: Int,
        type: Int,
        mode: Int,
    ) = Unit

    override fun setSensorValue(
        port: Int,
        value: Int,
        field: SensorField,
    ) = Unit
}

private const val STEPS = 100_000
