package robotran.robotediting

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import robotran.language.Language
import robotran.world.Paper
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.file.RobotFileResult
import robotran.world.file.WorldFileResult
import robotran.world.file.readRobot
import robotran.world.file.readWorld
import robotran.world.file.writeRobot
import robotran.world.file.writeWorld
import robotran.world.geometry.Pose
import robotran.world.robot.RobotError
import robotran.world.robot.robotErrors
import robotran.world.robot.things

class RobotEditingProperties :
    StringSpec({
        val robots = Arb.element(ReadyRobots.all.values.toList())
        val edits = Arb.list(arbitrary { ArbitraryRobotEdits(it.random.nextLong()) }, 0..60)

        fun edited(robot: RobotDescription, list: List<ArbitraryRobotEdits>) =
            list.fold(RobotEditing.of(robot)) { now, edit -> now.after(edit.of(now)) }

        "undoing everything gives the robot as it was, and redoing everything what it became" {
            checkAll(400, robots, edits) { robot, list ->
                val last = edited(robot, list).after(RobotEdit.Drop)
                val undone = generateSequence(last) { it.after(RobotEdit.Undo) }.first { !it.history.canUndo }
                undone.robot shouldBe robot
                val redone = generateSequence(undone) { it.after(RobotEdit.Redo) }.first { !it.history.canRedo }
                if (!last.history.canRedo) redone.robot shouldBe last.robot
            }
        }

        "figures stay in their ranges, and what is impossible is always told" {
            checkAll(400, robots, edits) { robot, list ->
                val editing = edited(robot, list)
                editing.errors shouldBe robotErrors(editing.robot)
                editing.errors.filter { it is RobotError.OutOfRange || it == RobotError.NoWheels }.shouldBeEmpty()
            }
        }

        "a possible robot is read as it was written, and an impossible one stays a draft of its world" {
            checkAll(400, robots, edits) { robot, list ->
                val editing = edited(robot, list).after(RobotEdit.Drop)
                val result = readRobot(writeRobot(editing.robot), Language.ENGLISH)
                if (editing.isPossible) {
                    result shouldBe RobotFileResult.Success(editing.robot)
                } else {
                    (result is RobotFileResult.Failure) shouldBe true
                }
                val place = RobotPlacement(Pose(60.0, 45.0, 0.0), draft = editing.robot)
                val world = World("World", Paper(120.0, 90.0), listOf(place))
                readWorld(writeWorld(world), Language.ENGLISH) shouldBe WorldFileResult.Success(world)
            }
        }

        "what is chosen is always there, and dragging makes no thing disappear" {
            checkAll(400, robots, edits) { robot, list ->
                list.fold(RobotEditing.of(robot)) { now, arbitrary ->
                    val edit = arbitrary.of(now)
                    val next = now.after(edit)
                    next.chosen?.let { next.robot.has(it) shouldBe true }
                    if (edit is RobotEdit.DragTo || edit is RobotEdit.Nudge || edit is RobotEdit.TurnBy) {
                        next.robot.things.size shouldBe now.robot.things.size
                    }
                    next
                }
            }
        }
    })
