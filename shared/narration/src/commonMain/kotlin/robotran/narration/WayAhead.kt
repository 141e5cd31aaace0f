package robotran.narration

import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.robot.box

/**
 * How far the robot with the index [robot] could go straight on until it meets a thing, in centimetres from its front
 * edge; null if nothing is in its way. The edge of the sheet is no thing.
 */
fun wayAhead(robot: Int, world: World, session: SessionState): Double? {
    val sweep = Sweep(session.robots[robot].robot.pose, RobotSide.AHEAD, world.robots[robot].description.box)
    return bodiesOf(world, session).filter { it.robot != robot }.mapNotNull { sweep.distanceTo(it.outline) }.minOrNull()
}
