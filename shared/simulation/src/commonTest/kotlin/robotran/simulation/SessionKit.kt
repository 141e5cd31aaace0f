package robotran.simulation

import robotran.brick.program.BrickProgram
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.World
import robotran.world.file.BuiltInWorlds

/**
 * Presses Run on a robot in [world] with [program], and lets it run until half a second after its end, at most a
 * minute.
 */
suspend fun runToEnd(program: BrickProgram, world: World = BuiltInWorlds.plain): Session {
    val session = startRun(program, world)
    while (session.state.brick.run is RunState.Running && session.state.milliseconds < 60_000) session.advance(10)
    session.advance(500)
    return session
}

/** A session in which Run has just been pressed and released. */
suspend fun startRun(program: BrickProgram, world: World = BuiltInWorlds.plain): Session {
    val session = Session(world, listOf(program), loadPhysicsEngine(), Language.ENGLISH)
    val button = session.state.brick.kind.startButton
    session.apply(SessionInput.Press(button))
    session.advance(100)
    session.apply(SessionInput.Release(button))
    session.advance(1)
    return session
}
