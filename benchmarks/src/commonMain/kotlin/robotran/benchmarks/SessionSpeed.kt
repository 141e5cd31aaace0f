package robotran.benchmarks

import robotran.robolang.Calibration
import robotran.rom.BrickButton
import robotran.rom.RcxProgram
import robotran.world.BuiltInWorlds
import robotran.world.Penbot
import robotran.world.Session
import robotran.world.SessionInput
import robotran.world.World
import robotran.world.physics.PhysicsEngine
import robotran.world.physics.loadPhysicsEngine
import kotlin.time.Duration
import kotlin.time.Duration.Companion.minutes
import kotlin.time.DurationUnit

/** How many times as fast as real time a session runs that drives and draws all the time on a sheet with nothing on it. */
internal suspend fun openSheetSpeed(): Figure = realTime(BuiltInWorlds.plain.copy(walls = emptyList()))

/** The same among walls, which the robot runs into all the time. */
internal suspend fun wallsSpeed(): Figure = realTime(BuiltInWorlds.plain)

/** How much longer the session among walls takes than dyn4j alone with as many bodies. */
internal suspend fun sessionAgainstDyn4j(): Figure {
    val physics = loadPhysicsEngine()
    val session = driving(BuiltInWorlds.plain, physics)
    val alone = median { pushABoxAbout(physics) }
    return Figure(session / alone, "times as long as dyn4j alone", "a minute of dyn4j in ${seconds(alone)} s")
}

/** How many times as fast as real time a session runs in which a Java program follows a line, at a brick's speed. */
internal suspend fun lineFollowerSpeed(): Figure {
    val program = javaProgramOf(LINE_FOLLOWER, javaPrograms.getValue(LINE_FOLLOWER))
    return realTime(running(program, BuiltInWorlds.plain, loadPhysicsEngine()))
}

private suspend fun realTime(world: World): Figure = realTime(driving(world, loadPhysicsEngine()))

private fun realTime(time: Duration): Figure =
    Figure(VIRTUAL_TIME / time, "times real time", "a minute in ${seconds(time)} s")

/** How long it takes to drive about in [world] for [VIRTUAL_TIME]. */
private fun driving(
    world: World,
    physics: PhysicsEngine,
): Duration = running(programOf(PROGRAM, Calibration(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)), world, physics)

/** How long [program] takes for [VIRTUAL_TIME] of its run in [world]. */
private fun running(
    program: RcxProgram,
    world: World,
    physics: PhysicsEngine,
): Duration =
    median {
        val session = Session(world, listOf(program), physics)
        session.apply(SessionInput.Press(BrickButton.RUN))
        session.apply(SessionInput.Release(BrickButton.RUN))
        session.advance(VIRTUAL_TIME.inWholeMilliseconds.toInt())
        session.close()
    }

private fun seconds(time: Duration): String = rounded(time.toDouble(DurationUnit.SECONDS))

private const val PROGRAM = "pen down\nrepeat 40 times\nforward 30\nturn right 97\nbackward 20\nend\n"

private const val LINE_FOLLOWER = "LineFollower.java"

/** How much virtual time is measured. */
internal val VIRTUAL_TIME = 1.minutes
