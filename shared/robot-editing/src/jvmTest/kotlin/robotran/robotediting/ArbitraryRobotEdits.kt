package robotran.robotediting

import robotran.world.PenMount
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.geometry.Point
import kotlin.random.Random

/** An edit that fits a state. */
internal class ArbitraryRobotEdits(private val seed: Long) {
    fun of(editing: RobotEditing): RobotEdit = with(Random(seed)) {
        val robot = editing.robot
        val element = (robot.elements() + robot.chassis.outline.indices.map { RobotElement.Corner(it) }).random(this)
        when (nextInt(20)) {
            0, 1 -> RobotEdit.Choose(element)
            2 -> RobotEdit.ChooseNext(nextBoolean())
            3, 4 -> RobotEdit.StartDrag(handle(editing, element), point())
            5, 6, 7 -> RobotEdit.DragTo(point())
            8 -> if (nextBoolean()) RobotEdit.Drop else RobotEdit.CancelDrag
            9 -> RobotEdit.Nudge(nextInt(-3, 4) * 0.5, nextInt(-3, 4) * 0.5)
            10 -> RobotEdit.TurnBy(nextInt(-3, 4) * 15.0)
            11 -> RobotEdit.Remove
            12 -> RobotEdit.SetPort(nextInt(0, robot.brick.inputPorts + 1).takeIf { it > 0 })
            13 -> RobotEdit.AddCorner
            14, 15 -> RobotEdit.Add(RobotItem.of(robot.brick).random(this), point().takeIf { nextBoolean() })
            16 -> RobotEdit.Change(changed(robot), "figure".takeIf { nextBoolean() })
            17 -> RobotEdit.Replace(ReadyRobots.all.values.random(this))
            18 -> RobotEdit.Undo
            else -> RobotEdit.Redo
        }
    }

    private fun Random.handle(editing: RobotEditing, element: RobotElement): RobotHandle =
        editing.handles().map { it.handle }.plus(RobotHandle.Body(element)).random(this)

    private fun Random.point() = Point(nextDouble(-50.0, 50.0), nextDouble(-50.0, 50.0)).let {
        if (nextBoolean()) Point(it.x / 5, it.y / 5) else it
    }

    private fun Random.changed(robot: RobotDescription): RobotDescription = when (nextInt(6)) {
        0 -> robot.copy(title = listOf("", "A", "Long ".repeat(12), "Ä\nB").random(this))
        1 -> robot.copy(chassis = robot.chassis.copy(mass = nextDouble(-1.0, 9.0), height = nextDouble(0.0, 50.0)))
        2 -> robot.copy(
            drive = robot.drive.copy(gear = nextDouble(0.0, 20.0), right = robot.brick.motorPorts.random(this)),
        )
        3 -> robot.copy(pen = PenMount(robot.brick.motorPorts.random(this)))
        4 -> robot.copy(drive = robot.drive.copy(tyreFriction = nextDouble(0.0, 3.0), reversed = nextBoolean()))
        else -> robot.copy(brickAt = robot.brickAt.copy(at = point()))
    }
}
