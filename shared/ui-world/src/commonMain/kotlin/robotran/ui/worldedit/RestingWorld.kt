package robotran.ui.worldedit

import robotran.simulation.state.Ink
import robotran.simulation.state.LampState
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.geometry.Pose

/** [world] in its initial state, for drawing; [like] is any session, which provides the displays of the bricks. */
internal fun initialStateOf(world: World, like: SessionState): SessionState = like.copy(
    milliseconds = 0,
    robots = world.robots.map { place ->
        val still =
            RobotState(place.start, 0.0, 0.0, penDown = false, leftBumperPressed = false, rightBumperPressed = false)
        like.robots.first().copy(robot = still, bumps = 0, bumpedAt = null, warnings = emptyList(), romCalls = 0)
    },
    blocks = world.blocks.map { Pose(0.0, 0.0, 0.0) },
    lamps = world.lamps.map { LampState(it.place, it.on) },
    ink = Ink.NONE,
    goals = emptyList(),
)
