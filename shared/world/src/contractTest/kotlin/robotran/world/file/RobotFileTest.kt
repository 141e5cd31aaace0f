package robotran.world.file

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.brick.kind.PlainDrive
import robotran.brick.kind.WheelTrim
import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.world.BrickMount
import robotran.world.BuggyMount
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.Chassis
import robotran.world.Drive
import robotran.world.Facing
import robotran.world.FingerTouchPart
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.robot.RobotParameters
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertSame
import kotlin.test.assertTrue

class RobotFileTest {
    @Test
    fun `a robot is read with all it has`() {
        val expected = RobotDescription(
            title = "Sees all",
            brick = BrickKind.NXT,
            chassis = Chassis(
                listOf(Point(-9.0, -5.0), Point(8.0, -5.0), Point(10.0, 0.0), Point(8.0, 5.0), Point(-9.0, 5.0)),
                height = 11.0,
                mass = 1.1,
                massAt = Point(0.6, 0.0),
            ),
            drive = Drive(4.32, 2.2, 15.0, 1.667, MotorPort.B, MotorPort.A, reversed = true, tyreFriction = 0.9),
            casters = listOf(Point(7.0, 2.0), Point(7.0, -2.0)),
            pen = null,
            brickAt = BrickMount(Point(-1.0, 0.0), turned = true),
            parts = listOf(
                BumperPart(1, Point(-9.5, 1.0), 9.0, 1.5, 180.0, BumperSide.LEFT),
                SensorPart(
                    4,
                    SensorKind.ULTRASONIC,
                    Point(9.0, 0.0),
                    12.0,
                    Facing.Ahead(45.0),
                    turret = MotorPort.C,
                ),
                SensorPart(3, SensorKind.LIGHT, Point(8.5, 1.0), 2.0, Facing.Down),
                RotationPart(null, BumperSide.RIGHT),
                FingerTouchPart(null),
            ),
            base = "sumo",
        )
        assertEquals(expected, loadedRobot(FULL_ROBOT))
        assertEquals(expected, loadedRobot(writeRobot(expected)))
    }

    @Test
    fun `what a file leaves out is like the robot that it names`() {
        assertEquals(
            ReadyRobots.SUMO.copy(title = "S"),
            loadedRobot("""{"format": "robotran-robot", "version": 1, "title": "S", "like": "sumo"}"""),
        )
        val own = loadedRobot("""{"format": "robotran-robot", "version": 1, "title": "P", "pen": null}""")
        assertEquals(ReadyRobots.RCX_PENBOT.copy(title = "P", pen = null, base = null), own)
        val nxt = loadedRobot("""{"format": "robotran-robot", "version": 1, "title": "P", "brick": "nxt"}""")
        assertEquals(ReadyRobots.NXT_PENBOT.copy(title = "P", base = null), nxt)
    }

    @Test
    fun `only what differs is written`() {
        val robot = ReadyRobots.NXT_PENBOT.copy(
            title = "Mine",
            drive = ReadyRobots.NXT_PENBOT.drive.copy(track = 12.25),
            pen = null,
        )
        assertEquals(
            """
            {
              "format": "robotran-robot",
              "version": 1,
              "title": "Mine",
              "like": "nxt-penbot",
              "wheels": { "track": 12.25 },
              "pen": null
            }

            """.trimIndent(),
            writeRobot(robot),
        )
    }

    @Test
    fun `a penbot with other sensors keeps its exact bumpers and wheels`() {
        val sensor = SensorPart(2, SensorKind.LIGHT, Point(7.0, 1.0), 1.0, Facing.Down)
        val robot = ReadyRobots.RCX_PENBOT.copy(parts = ReadyRobots.RCX_PENBOT.parts + sensor.copy(port = null))
        val read = loadedRobot(writeRobot(robot))
        assertEquals(robot, read)
        assertSame(RobotParameters.PENBOT, RobotParameters.of(read))
    }

    @Test
    fun `every ready robot and its file are the same`() {
        assertEquals(ReadyRobots.all.keys.map { "$it.robot.json" }.toSet(), robotTexts.keys)
        for ((name, robot) in ReadyRobots.all) {
            val read = loadedRobot(robotTexts.getValue("$name.robot.json"))
            assertEquals(robot.copy(base = null), read, name)
        }
    }

    @Test
    fun `a buggy is read and written with all it has, and only a micro-bit has one`() {
        val named = """{"format": "robotran-robot", "version": 1, "title": "B", "brick": "microbit", """ +
            """"buggy": {"kind": "maqueen"}}"""
        assertEquals(BuggyMount(BuggyKind.MAQUEEN), loadedRobot(named).buggy)
        assertEquals(null, loadedRobot(named.replace("\"microbit\"", "\"nxt\"")).buggy)
        assertEquals(
            BuggyPins.BRIDGE,
            loadedRobot(named.replace("\"maqueen\"", "\"plain\", \"pins\": {\"drive\": \"bridge\"}")).buggy?.pins,
        )
        val pins = BuggyPins(
            PlainDrive.BRIDGE,
            left = listOf(12, 8),
            right = listOf(16, 14),
            lines = listOf(0, 1),
            isDarkOne = false,
            trigger = 15,
            echo = 13,
            pen = 2,
        )
        val full = ReadyRobots.CUTEBOT.copy(
            title = "Own",
            buggy = BuggyMount(BuggyKind.PLAIN, WheelTrim(1.0, 0.98), pins),
        )
        assertEquals(full, loadedRobot(writeRobot(full)))
        val likeAnRcx = """{"format": "robotran-robot", "version": 1, "title": "L", "like": "sumo", """ +
            """"brick": "microbit", "parts": []}"""
        val onUsualBuggy = loadedRobot(likeAnRcx)
        assertEquals(ReadyRobots.CUTEBOT.buggy, onUsualBuggy.buggy)
        assertEquals(onUsualBuggy, loadedRobot(writeRobot(onUsualBuggy)))
        assertEquals("Line 27: buggy.pins: Pin 12 of the buggy is used twice.", robotFileError("[0, 1]", "[0, 12]"))
        assertTrue("belongs to the micro:bit itself" in robotFileError("[0, 1]", "[0, 5]"))
    }

    @Test
    fun `every robot of the page can be read`() {
        assertTrue(documentedRobots.isNotEmpty())
        documentedRobots.values.forEach(::loadedRobot)
    }

    @Test
    fun `impossible robots are told where they are in the file`() {
        assertEquals(
            "Line 20: parts[1]: Two things are plugged into port 1.",
            robotFileError("\"port\": 4", "\"port\": 1"),
        )
        assertEquals(
            "Line 11: wheels: Two motors are needed to drive, but left and right are both motor A.",
            robotFileError("\"left\": \"B\"", "\"left\": \"A\""),
        )
        assertEquals(
            "Line 12: wheels.diameter: A robot needs two wheels: give them a diameter from 2 to 10 cm.",
            robotFileError("\"diameter\": 4.32", "\"diameter\": 0"),
        )
        assertEquals("Line 9: mass must be from 0.1 to 5.", robotFileError("\"mass\": 1.1", "\"mass\": 9"))
        assertEquals(
            "Line 5: like: There is no ready robot called \"judo\", only \"rcx-penbot\", \"nxt-penbot\", " +
                "\"line-follower\", \"sumo\", \"both-sides\", \"spike-penbot\", \"spike-scout\", " +
                "\"essential-rover\", \"technic-penbot\", \"ev3-penbot\", \"nxt-pybricks-penbot\", \"cutebot\", " +
                "\"cutebot-pro\", \"maqueen\", \"maqueen-plus\", \"tiny-bit\", \"kitronik-penbot\", " +
                "\"plain-buggy\" and \"cutebot-v1\".",
            robotFileError("\"sumo\"", "\"judo\""),
        )
        val german = assertIs<RobotFileResult.Failure>(
            readRobot(FULL_ROBOT.replace("\"massAt\": [0.6, 0]", "\"massAt\": [0.6, 1]"), Language.GERMAN),
        )
        assertEquals("Zeile 10: massAt: Der Schwerpunkt muss auf der Mittellinie liegen, bei y 0.", german.message)
    }

    @Test
    fun `files that are no robots of this version are refused`() {
        assertEquals(
            "Line 2: This is not a Robotran robot: a robot file says \"format\": \"robotran-robot\".",
            robotFileError("robotran-robot", "robotran-world"),
        )
        assertEquals(
            "Line 3: This robot was made by a newer Robotran (it has version 2, this Robotran reads up to 1).",
            robotFileError("\"version\": 1", "\"version\": 2"),
        )
        assertEquals("Line 3: version must be from 1 to 1.", robotFileError("\"version\": 1", "\"version\": 0"))
    }

    @Test
    fun `unknown fields are kept`() {
        val text = FULL_ROBOT.replace("\"brickTurned\"", "\"wings\": { \"span\": 3 }, \"brickTurned\"")
            .replace("\"diameter\"", "\"spokes\": 6, \"diameter\"")
            .replace("\"kind\": \"touch\"", "\"kind\": \"touch\", \"red\": true")
        val robot = loadedRobot(text)
        val written = writeRobot(robot)
        assertEquals(robot, loadedRobot(written))
        val kept = listOf("\"wings\": { \"span\": 3 }", "\"spokes\": 6", "\"red\": true")
        for (field in kept) assertTrue(field in written, written)
    }

    @Test
    fun `a robot in a world is a name, a description or a penbot with sensors`() {
        fun world(robot: String) = """{"format": "robotran-world", "version": 2, "title": "W",
            "paper": {"width": 100, "height": 80}, "robots": [{ "start": {"x": 50, "y": 40, "heading": 0}$robot }]}"""

        fun robotOf(robot: String) = loaded(world(robot)).also {
            assertEquals(it, loaded(writeWorld(it)))
        }.robots.single().description
        assertEquals(ReadyRobots.SUMO, robotOf(", \"robot\": \"sumo\""))
        assertEquals(ReadyRobots.RCX_PENBOT, robotOf(", \"robot\": \"rcx-penbot\""))
        assertEquals("Big", robotOf(", \"robot\": { \"title\": \"Big\", \"like\": \"sumo\", \"mass\": 2 }").title)
        assertTrue("\"robot\": \"sumo\"" in writeWorld(loaded(world(", \"robot\": \"sumo\""))))
        assertTrue("robot\":" !in writeWorld(loaded(world(", \"robot\": \"rcx-penbot\""))).replace("\"robots\"", ""))
        assertEquals(
            "Line 2: robots[0].ports: A robot has either \"robot\" or \"ports\": what is plugged into a robot is in " +
                "its own parts.",
            refusal(world(", \"robot\": \"sumo\", \"ports\": {}")).message,
        )
        val wide =
            refusal(world(", \"robot\": { \"title\": \"W\", \"outline\": [[-5, -9], [8, -9], [8, 9]], \"mass\": 7 }"))
        assertEquals("robots[0].robot.mass", wide.path)
    }

    @Test
    fun `a robot must have room for its own outline`() {
        fun world(robot: String) = """{"format": "robotran-world", "version": 2, "title": "W",
            "paper": {"width": 100, "height": 80}, "walls": [{ "from": [62, 0], "to": [62, 80], "thickness": 1 }],
            "robots": [{ "start": {"x": 50, "y": 40, "heading": 0}$robot }]}"""
        assertNotNull(loaded(world("")))
        val outline = "\"outline\": [[-5, -4], [13, -4], [13, 4], [-5, 4]]"
        val long = ", \"robot\": { \"title\": \"Long\", $outline, \"parts\": [] }"
        assertEquals("Line 3: robots[0].start puts the robot into walls[0].", refusal(world(long)).message)
    }
}
