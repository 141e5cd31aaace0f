package robotran.runcontrol

import robotran.brick.controls.BrickButton
import robotran.brick.program.BrickProgram
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.Penbot
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import kotlin.test.assertIs

internal fun robolang(source: String): BrickProgram {
    val target = RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
    return assertIs<RobolangResult.Success>(
        compileRobolang("test", source, target, messages = RobolangMessages.of(Language.ENGLISH)),
    ).program
}

internal suspend fun setupOf(source: String, world: World = BuiltInWorlds.plain): RunSetup = RunSetup(
    world,
    world.robots.map {
        RobotProgramSet(listOf(robolang(source)))
    },
    loadPhysicsEngine(),
    Language.ENGLISH,
)

/** A run of [source] in which Run was pressed on all robots at the start. */
internal suspend fun started(source: String, world: World = BuiltInWorlds.plain): RunPlayer =
    RunPlayer(setupOf(source, world)).apply { pressRun(world) }

internal fun RunPlayer.pressRun(world: World = BuiltInWorlds.plain) {
    for (robot in world.robots.indices) {
        apply(SessionInput.Press(BrickButton.RUN, robot))
        apply(SessionInput.Release(BrickButton.RUN, robot))
    }
}

/** The run of [player] at [time], computed separately from the start. */
internal suspend fun RunPlayer.again(source: String, time: Long, world: World = BuiltInWorlds.plain): Session {
    val setup = setupOf(source, world)
    return Session.replay(setup.world, setup.loads, setup.physics, inputs, time, Language.ENGLISH)
}

/** The program's current line; 0 if none runs. */
internal val RunPlayer.line: Int get() = (session.state.brick.run as? RunState.Running)?.sourceLine ?: 0

/** Advances time until the run stops, at most a minute. */
internal fun RunPlayer.untilStill() {
    repeat(6_000) { if (playback != PlaybackState.Paused) pass(10) }
}

/** Draws [count] frames every [milliseconds], the first at [from]; returns the time of the next frame. */
internal fun RunPlayer.frames(count: Int, milliseconds: Long = 16, from: Long = 0): Long {
    repeat(count) { frame((from + it * milliseconds) * 1_000_000) }
    return from + count * milliseconds
}

/** A program that drives, beeps, draws and calls a procedure. */
internal const val BUSY = """procedure dash(n)
  pen down
  forward n
  pen up
end
var round = 0
repeat 4 times
  round = round + 1
  dash(10)
  beep
  turn left 90
end
show round"""
