package robotran.robotediting

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.ReadyRobots
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.robot.RobotError
import robotran.world.robot.things

class DraggingRobotTest :
    StringSpec({
        fun RobotEditing.drag(handle: RobotHandle, from: Point, to: Point) =
            after(RobotEdit.StartDrag(handle, from)).after(RobotEdit.DragTo(to)).after(RobotEdit.Drop)

        fun body(number: Int) = RobotHandle.Body(RobotElement.Part(number))

        "a sensor snaps to half centimetres, and is one step" {
            val editing = RobotEditing.of(ReadyRobots.SUMO).drag(body(2), Point(8.0, 0.0), Point(6.3, 2.1))
            (editing.robot.things[2] as SensorPart).at shouldBe Point(6.5, 2.0)
            editing.after(RobotEdit.Undo).robot shouldBe ReadyRobots.SUMO
        }

        "a drag that is cancelled changes nothing" {
            val first = RobotEditing.of(ReadyRobots.SUMO)
            val dragging = first.after(
                RobotEdit.StartDrag(body(2), Point(8.0, 0.0)),
            ).after(RobotEdit.DragTo(Point(0.0, 3.0)))
            dragging.after(RobotEdit.CancelDrag) shouldBe first
            dragging.after(RobotEdit.Undo) shouldBe first
        }

        "a thing does not become another one" {
            val follower = RobotEditing.of(ReadyRobots.LINE_FOLLOWER)
            val merged = follower.drag(body(0), Point(7.5, 1.5), Point(7.5, -1.5))
            merged.robot shouldBe ReadyRobots.LINE_FOLLOWER
        }

        "the direction snaps to 15 degrees" {
            val chosen = RobotEditing.of(ReadyRobots.SUMO).after(RobotEdit.Choose(RobotElement.Part(2)))
            val handle = chosen.handles().single()
            handle.at shouldBe Point(13.0, 0.0)
            val turned = chosen.drag(handle.handle, handle.at, Point(8.1, 5.0))
            (turned.robot.things[2] as SensorPart).facing shouldBe Facing.Ahead(90.0)
        }

        "a bumper grows at both ends" {
            val chosen = RobotEditing.of(ReadyRobots.SUMO).after(RobotEdit.Choose(RobotElement.Part(0)))
            val handle = chosen.handles().first { it.handle is RobotHandle.BumperEnd }
            val wide = chosen.drag(handle.handle, handle.at, Point(-9.0, -6.0))
            (wide.robot.things[0] as BumperPart).width shouldBe 12.0
        }

        "wheels become larger, wider and farther apart" {
            val wheels = RobotEditing.of(ReadyRobots.SUMO).after(RobotEdit.Choose(RobotElement.Wheels))
            wheels.handles().size shouldBe 3
            wheels.drag(RobotHandle.Track, Point(0.0, 7.0), Point(1.0, 8.1)).robot.drive.track shouldBe 16.0
            wheels.drag(RobotHandle.WheelDiameter, Point(2.8, 7.0), Point(3.4, 7.0)).robot.drive.wheelDiameter shouldBe
                7.0
            wheels.drag(RobotHandle.WheelWidth, Point(0.0, 8.3), Point(0.0, 8.0)).robot.drive.wheelWidth shouldBe 2.0
            val right = RobotHandle.Body(RobotElement.Wheels)
            wheels.drag(right, Point(0.0, -7.0), Point(0.0, -6.0)).robot.drive.track shouldBe 12.0
        }

        "the chassis moves by half centimetres, and not off the limits" {
            val whole = RobotHandle.Body(RobotElement.Chassis)
            val first = RobotEditing.of(ReadyRobots.NXT_PENBOT)
            first.drag(whole, Point(0.0, 0.0), Point(1.1, 0.0)).robot.chassis.outline.first() shouldBe Point(-7.2, -4.3)
            first.drag(whole, Point(0.0, 0.0), Point(39.0, 0.0)).robot shouldBe first.robot
        }

        "the mass stays on the middle line" {
            val mass = RobotHandle.Body(RobotElement.Mass)
            val behind = RobotEditing.of(ReadyRobots.SUMO).drag(mass, Point(0.5, 0.0), Point(-3.0, 4.0))
            behind.robot.chassis.massAt shouldBe Point(-3.0, 0.0)
            behind.errors shouldBe listOf(RobotError.TipsOver(backwards = true))
        }

        "a sensor that is dragged far away, into the robot or a bumper inside it is told" {
            val sumo = RobotEditing.of(ReadyRobots.SUMO)
            val far = sumo.drag(body(1), Point(8.5, 0.0), Point(39.0, 0.0))
            (far.errors.single() as RobotError.FarAway).part shouldBe 1
            sumo.drag(body(0), Point(-9.5, 0.0), Point(-4.0, 0.0)).errors shouldContain RobotError.BumperInside(0)
            val hidden = sumo.drag(body(2), Point(8.0, 0.0), Point(0.0, 0.0))
            (hidden.errors.single() is RobotError.LooksIntoRobot) shouldBe true
        }

        "views are where the sensors are, also on the paper" {
            val robot = ReadyRobots.BOTH_SIDES
            val cone = robot.views().first() as SensorView.Cone
            cone.direction shouldBe 90.0
            cone.rays.size shouldBe 17
            val onPaper = cone.on(Pose(30.0, 20.0, 90.0))
            onPaper.direction shouldBe 180.0
            onPaper.eye shouldBe Point(25.0, 22.0)
            (robot.views()[1] as SensorView.Spot).at shouldBe Point(7.2, 0.0)
            robot.views().map { it.number } shouldBe listOf(0, 2, 3)
        }

        "a finger finds the small things first" {
            val sumo = ReadyRobots.SUMO
            sumo.elementsAt(Point(7.8, 0.2), 0.5).take(2) shouldBe listOf(RobotElement.Part(2), RobotElement.Part(1))
            sumo.elementsAt(Point(0.5, -7.0), 0.2) shouldBe listOf(RobotElement.Wheels)
            sumo.elementsAt(Point(-8.5, 5.0), 0.2).last() shouldBe RobotElement.Chassis
            sumo.elementsAt(Point(30.0, 30.0), 1.0) shouldBe emptyList()
        }

        "an error is at its piece" {
            val taken = on(ReadyRobots.SUMO, RobotEdit.Choose(RobotElement.Part(1)), RobotEdit.SetPort(4))
            taken.robot.elementOf(taken.errors.single()) shouldBe RobotElement.Part(2)
        }
    })
