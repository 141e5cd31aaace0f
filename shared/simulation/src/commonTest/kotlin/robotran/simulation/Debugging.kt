package robotran.simulation

import robotran.brick.controls.BrickButton
import robotran.brick.program.StepKind
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.Penbot
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** A session that has just started the Robolang program [source], named `test`. */
internal suspend fun startedForDebugging(source: String, world: World = BuiltInWorlds.plain): Session {
    val target = RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
    val program = assertIs<RobolangResult.Success>(
        compileRobolang("test", source, target, messages = RobolangMessages.of(Language.ENGLISH)),
    ).program
    return Session(world, listOf(program), loadPhysicsEngine(), Language.ENGLISH).apply {
        apply(SessionInput.Press(BrickButton.RUN))
        apply(SessionInput.Release(BrickButton.RUN))
    }
}

/** The program's current line. */
internal fun Session.line(): Int = assertIs<RunState.Running>(state.brick.run).sourceLine

/** The lines before which successive [steps] stop. */
internal fun Session.lines(vararg steps: StepKind): List<Int> = steps.map { step ->
    assertEquals(StopReason.StepDone, stepStatement(step))
    line()
}

/** Continues to a breakpoint on [line]. */
internal fun Session.runTo(line: Int) {
    breakpoints = setOf(Breakpoint(line))
    assertEquals(StopReason.Breakpoint(line), runUntilStop(10_000))
}
