package robotran.benchmarks

import robotran.brick.program.BrickProgram
import robotran.language.Language
import robotran.robolang.robot.RobotTarget
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.pressRun
import robotran.world.Penbot
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import kotlin.time.Duration
import kotlin.time.Duration.Companion.minutes
import kotlin.time.DurationUnit

/** The speed relative to real time of a session that drives and draws all the time on an empty sheet. */
internal suspend fun openSheetSpeed(): Measurement = realTime(BuiltInWorlds.plain.copy(walls = emptyList()))

/** The same with walls that the robot keeps hitting. */
internal suspend fun wallsSpeed(): Measurement = realTime(BuiltInWorlds.plain)

/** The same in a crowded world: 40 barriers, 10 blocks, three robots, lamps, a mark, noise. */
internal suspend fun heavyWorldSpeed(): Measurement = realTime(heavyWorld())

/** The ratio of a session's time to the time of its dyn4j steps alone. */
internal suspend fun tickAgainstStep(): Measurement = againstStep(BuiltInWorlds.plain)

/** The same in the crowded world. */
internal suspend fun heavyTickAgainstStep(): Measurement = againstStep(heavyWorld())

/** The speed relative to real time with a growing number of barriers. */
internal suspend fun growthWithBarriers(): Measurement = growth(listOf(1, 10, 100, 400)) {
    crowdedWorld(barriers = it, robots = 1)
}

/** The speed relative to real time with a growing number of robots, which all drive and draw. */
internal suspend fun growthWithRobots(): Measurement = growth(listOf(1, 2, 4, 8)) {
    crowdedWorld(barriers = 40, robots = it)
}

/** An example of the heaviest sessions of pupils. */
internal fun heavyWorld() = crowdedWorld(barriers = 40, robots = 3, blocks = 10, furnished = true)

private suspend fun growth(sizes: List<Int>, world: (Int) -> World): Measurement {
    val physics = loadPhysicsEngine()
    val speeds = sizes.map { VIRTUAL_TIME / driving(world(it), physics) }
    val all = sizes.zip(speeds).joinToString { (size, speed) -> "$size: ${rounded(speed)}" }
    val unit = "times as slow with ${sizes.last()} as with ${sizes.first()}"
    return Measurement(speeds.first() / speeds.last(), unit, "times real time with $all")
}

private suspend fun againstStep(world: World): Measurement {
    val physics = loadPhysicsEngine()
    val recorded = RecordedPhysics(physics)
    driveOnce(world, recorded)
    val bare = median { recorded.again() }
    val session = driving(world, physics)
    return Measurement(
        session / bare,
        "times as long as its steps of dyn4j alone",
        "a minute of those in ${seconds(bare)} s",
    )
}

/** The speed relative to real time of a session in which a Java program follows a line, at the brick's speed. */
internal suspend fun lineFollowerSpeed(): Measurement {
    val program = javaProgramOf(LINE_FOLLOWER, javaPrograms.getValue(LINE_FOLLOWER))
    return realTime(running(program, BuiltInWorlds.plain, loadPhysicsEngine()))
}

private suspend fun realTime(world: World): Measurement = realTime(driving(world, loadPhysicsEngine()))

internal fun realTime(time: Duration): Measurement =
    Measurement(VIRTUAL_TIME / time, "times real time", "a minute in ${seconds(time)} s")

/** The time for all robots to drive in [world] for [VIRTUAL_TIME]. */
private fun driving(world: World, physics: PhysicsEngine): Duration = running(drivingProgram(), world, physics)

/** The time to simulate [VIRTUAL_TIME] of [program], on all robots, in [world]. */
internal fun running(program: BrickProgram, world: World, physics: PhysicsEngine): Duration =
    median { runOnce(program, world, physics) }

private fun driveOnce(world: World, physics: PhysicsEngine) = runOnce(drivingProgram(), world, physics)

private fun runOnce(program: BrickProgram, world: World, physics: PhysicsEngine) {
    val session = Session(world, world.robots.map { RobotProgramSet(listOf(program)) }, physics, Language.ENGLISH)
    session.pressRun()
    session.advance(VIRTUAL_TIME.inWholeMilliseconds.toInt())
    session.close()
}

private fun drivingProgram() =
    programOf(PROGRAM, RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE))

private fun seconds(time: Duration): String = rounded(time.toDouble(DurationUnit.SECONDS))

/** Drives and draws for longer than the benchmark runs. */
internal const val PROGRAM = "pen down\nrepeat 40 times\nforward 30\nturn right 97\nbackward 20\nend\n"

private const val LINE_FOLLOWER = "LineFollower.java"

/** The measured virtual time. */
internal val VIRTUAL_TIME = 1.minutes
