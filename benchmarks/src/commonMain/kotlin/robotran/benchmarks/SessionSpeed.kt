package robotran.benchmarks

import robotran.robolang.Calibration
import robotran.rom.BrickButton
import robotran.world.BuiltInWorlds
import robotran.world.Penbot
import robotran.world.Session
import robotran.world.SessionInput
import robotran.world.World
import robotran.world.physics.loadPhysicsEngine
import kotlin.time.Duration.Companion.minutes
import kotlin.time.DurationUnit

/** How many times as fast as real time a session runs that drives and draws all the time on a sheet with nothing on it. */
internal suspend fun openSheetSpeed(): Figure = sessionSpeed(BuiltInWorlds.plain.copy(walls = emptyList()))

/** The same among walls, which the robot runs into all the time. */
internal suspend fun wallsSpeed(): Figure = sessionSpeed(BuiltInWorlds.plain)

private suspend fun sessionSpeed(world: World): Figure {
    val physics = loadPhysicsEngine()
    val program = programOf(PROGRAM, Calibration(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE))
    val time =
        median {
            val session = Session(world, listOf(program), physics)
            session.apply(SessionInput.Press(BrickButton.RUN))
            session.apply(SessionInput.Release(BrickButton.RUN))
            session.advance(VIRTUAL_TIME.inWholeMilliseconds.toInt())
            session.close()
        }
    return Figure(VIRTUAL_TIME / time, "times real time", "a minute in ${rounded(time.toDouble(DurationUnit.SECONDS))} s")
}

private const val PROGRAM = "pen down\nrepeat 40 times\nforward 30\nturn right 97\nbackward 20\nend\n"
private val VIRTUAL_TIME = 1.minutes
