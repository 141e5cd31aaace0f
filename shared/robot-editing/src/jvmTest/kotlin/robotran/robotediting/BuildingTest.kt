package robotran.robotediting

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.robot.RobotError
import robotran.world.robot.things

class BuildingTest :
    StringSpec({
        "a new sensor is on the first free port and chosen" {
            val editing = on(ReadyRobots.SUMO, RobotEdit.Add(RobotItem.COLOUR))
            val part = editing.robot.things.last() as SensorPart
            part.sensor shouldBe SensorKind.COLOUR
            part.port shouldBe 2
            editing.chosen shouldBe RobotElement.Part(3)
            editing.isPossible shouldBe true
        }

        "a new bumper is on the first side without one" {
            val editing = on(ReadyRobots.NXT_PENBOT, RobotEdit.Add(RobotItem.BUMPER))
            val bumper = editing.robot.things.last() as BumperPart
            bumper.direction shouldBe 180.0
            bumper.at shouldBe Point(-9.4, 0.0)
            bumper.port.shouldBeNull()
        }

        "a second thing of a kind is beside the first" {
            val editing = on(ReadyRobots.SUMO, RobotEdit.Add(RobotItem.SOUND), RobotEdit.Add(RobotItem.SOUND))
            editing.robot.things.takeLast(2).map { (it as SensorPart).at } shouldContainExactly
                listOf(Point(0.0, 0.0), Point(0.0, 3.0))
        }

        "a new light sensor lies where the sonar does not cover it" {
            val editing = on(ReadyRobots.NXT_PENBOT, RobotEdit.Add(RobotItem.LIGHT))
            val sonar = editing.robot.things.filterIsInstance<SensorPart>().first { it.sensor == SensorKind.ULTRASONIC }
            val light = editing.robot.things.last() as SensorPart
            editing.robot.portsOf(editing.robot.things.lastIndex) shouldBe emptyList()
            val half = SensorBody.of(SensorKind.ULTRASONIC, BrickKind.NXT).half
            (kotlin.math.abs(light.at.y - sonar.at.y) >= half) shouldBe true
        }

        "each eye of a sonar is the sonar, also over another sensor, and after a turn" {
            val robot = ReadyRobots.NXT_PENBOT
            val number = robot.things.indexOfFirst { it.kind == SensorKind.ULTRASONIC }
            val sonar = robot.things[number] as SensorPart
            for (side in listOf(-1.15, 1.15)) {
                val eye = Point(sonar.at.x - 0.85, sonar.at.y + side)
                robot.elementsAt(eye, 0.5).first() shouldBe RobotElement.Part(number)
            }
            val turned = robot.withThing(number) { (it as SensorPart).copy(facing = Facing.Ahead(90.0)) }!!
            val behind = Point(sonar.at.x + 2.0, sonar.at.y - 1.7)
            turned.elementsAt(behind, 0.0).first() shouldBe RobotElement.Part(number)
            (RobotElement.Part(number) in robot.elementsAt(behind, 0.0)) shouldBe false
        }

        "the palette has what the brick can read" {
            (RobotItem.ROTATION in RobotItem.of(BrickKind.RCX)) shouldBe true
            (RobotItem.ROTATION in RobotItem.of(BrickKind.NXT)) shouldBe true
            (RobotItem.RCX_LIGHT in RobotItem.of(BrickKind.RCX)) shouldBe false
            (RobotItem.ULTRASONIC in RobotItem.of(BrickKind.RCX)) shouldBe false
        }

        "a pen gets the motor that is free" {
            val editing = on(ReadyRobots.SUMO, RobotEdit.Add(RobotItem.PEN))
            editing.robot.pen?.motor shouldBe MotorPort.B
            editing.after(RobotEdit.Add(RobotItem.PEN)).error shouldBe RobotEditError.SAME_THING
        }

        "two things on a port of an NXT are told, and undone" {
            val taken = on(
                ReadyRobots.SUMO,
                RobotEdit.Choose(RobotElement.Part(1)),
                RobotEdit.SetPort(4),
            )
            taken.errors shouldContain RobotError.PortTaken(2, 4)
            taken.after(RobotEdit.Undo).errors shouldBe emptyList()
        }

        "a thing with two cables keeps one when it is plugged in elsewhere" {
            val penbot = ReadyRobots.RCX_PENBOT.let { it.copy(parts = it.parts + it.parts[0].on(2)) }
            penbot.portsOf(0) shouldBe listOf(1, 2)
            val editing = on(penbot, RobotEdit.Choose(RobotElement.Part(0)), RobotEdit.SetPort(3))
            editing.robot.portsOf(0) shouldBe listOf(3)
        }

        "everything can be removed but what a robot needs" {
            val first = RobotEditing.of(ReadyRobots.NXT_PENBOT)
            val bare = List(4) { RobotElement.Part(0) }.plus(listOf(RobotElement.Caster(0), RobotElement.Pen))
                .fold(first) { now, element -> now.after(RobotEdit.Choose(element)).after(RobotEdit.Remove) }
            bare.robot.parts shouldBe emptyList()
            bare.robot.pen.shouldBeNull()
            bare.errors shouldBe listOf(RobotError.TipsOver(backwards = false))
            val wheels = bare.after(RobotEdit.Choose(RobotElement.Wheels)).after(RobotEdit.Remove)
            wheels.error shouldBe RobotEditError.NEEDED
            wheels.robot shouldBe bare.robot
        }

        "a sensor turns in steps, and one that looks down does not" {
            val sonar = on(ReadyRobots.SUMO, RobotEdit.Choose(RobotElement.Part(2)), RobotEdit.TurnBy(-15.0))
            (sonar.robot.things[2] as SensorPart).facing shouldBe Facing.Ahead(-15.0)
            val light = on(ReadyRobots.SUMO, RobotEdit.Choose(RobotElement.Part(1)), RobotEdit.TurnBy(15.0))
            light.robot shouldBe ReadyRobots.SUMO
            light.history.canUndo shouldBe false
        }

        "a corner is added, moved and removed" {
            val added = on(ReadyRobots.SUMO, RobotEdit.Choose(RobotElement.Corner(1)), RobotEdit.AddCorner)
            added.chosen shouldBe RobotElement.Corner(2)
            added.robot.chassis.outline[2] shouldBe Point(9.0, 0.0)
            val moved = added.after(RobotEdit.Nudge(3.0, 0.0))
            moved.robot.chassis.outline[2] shouldBe Point(12.0, 0.0)
            moved.after(RobotEdit.Remove).robot.chassis.outline shouldBe ReadyRobots.SUMO.chassis.outline
        }

        "a triangle keeps its corners" {
            val triangle = ReadyRobots.SUMO.let { it.copy(chassis = it.chassis.copy(it.chassis.outline.take(3))) }
            on(triangle, RobotEdit.Choose(RobotElement.Corner(0)), RobotEdit.Remove).error shouldBe
                RobotEditError.TOO_FEW_CORNERS
        }

        "figures stay in their ranges, and those of a ready robot as they are" {
            val penbot = ReadyRobots.RCX_PENBOT
            val heavy = on(penbot, RobotEdit.Change(penbot.copy(chassis = penbot.chassis.copy(mass = 99.0))))
            heavy.robot.chassis.mass shouldBe 5.0
            heavy.robot.drive shouldBe penbot.drive
            on(penbot, RobotEdit.Change(penbot.copy(title = " "))).robot.title shouldBe penbot.title
        }

        "typing is one step" {
            val typed = "Racer".indices.fold(RobotEditing.of(ReadyRobots.SUMO)) { now, end ->
                now.after(RobotEdit.Change(now.robot.copy(title = "Racer".take(end + 1)), "title"))
            }
            typed.robot.title shouldBe "Racer"
            typed.after(RobotEdit.Undo).robot shouldBe ReadyRobots.SUMO
            val more = typed.after(RobotEdit.FinishChange).after(
                RobotEdit.Change(typed.robot.copy(title = "Racers"), "title"),
            )
            more.after(RobotEdit.Undo).robot.title shouldBe "Racer"
        }

        "keys go through all elements" {
            val first = RobotEditing.of(ReadyRobots.SUMO)
            val all = ReadyRobots.SUMO.elements()
            val seen = generateSequence(first.after(RobotEdit.ChooseNext())) { it.after(RobotEdit.ChooseNext()) }
                .take(all.size).map { it.chosen }.toList()
            seen shouldBe all
            first.after(RobotEdit.ChooseNext(backwards = true)).chosen shouldBe all.last()
        }

        "another robot is built, and the old one comes back" {
            val editing = on(ReadyRobots.SUMO, RobotEdit.Replace(ReadyRobots.RCX_PENBOT))
            editing.robot shouldBe ReadyRobots.RCX_PENBOT
            editing.after(RobotEdit.Undo).robot shouldBe ReadyRobots.SUMO
            editing.after(RobotEdit.Undo).after(RobotEdit.Redo).robot shouldNotBe ReadyRobots.SUMO
        }
    })

internal fun on(robot: RobotDescription, vararg edits: RobotEdit): RobotEditing =
    edits.fold(RobotEditing.of(robot)) { now, edit -> now.after(edit) }
