package robotran.cli.run

import robotran.cli.CommandTest
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals

/** Tests `robotran run` with robots that are built otherwise. */
class RobotFileRunTest : CommandTest() {
    private fun robot(name: String, fields: String): String = folder.resolve("$name.robot.json").also {
        it.writeText("""{ "format": "robotran-robot", "version": 1, "title": "$name", $fields }""")
    }.toString()

    private val racer = robot("racer", """"wheels": { "diameter": 8, "track": 14 }, "mass": 0.9""")
    private val straight = program("forward 20\n", "straight.robo")

    private fun refused(vararg arguments: String): String {
        console.complaints.clear()
        assertEquals(2, commandLine.execute(listOf("run", straight) + arguments))
        return console.complaints.single()
    }

    @Test
    fun `a robot with other wheels drives as far as it is told`() {
        val arguments = listOf("run", straight, "--robot-file", racer, "--report", "-")
        assertEquals(0, commandLine.execute(arguments), console.complaints.joinToString())
        val report = console.said.single()
        assertEquals(60.0, report.substringAfter("\"x\": ").substringBefore(',').toDouble(), 0.3)
    }

    @Test
    fun `a robot of that name gets it`() {
        val arguments = listOf("run", straight, "--robot-file", "yellow=$racer", "--report", "-")
        assertEquals(0, commandLine.execute(arguments), console.complaints.joinToString())
        assertEquals(
            "No robot in this world is called red. There is only one, called yellow.",
            refused("--robot-file", "red=$racer"),
        )
    }

    @Test
    fun `an impossible robot is refused`() {
        val impossible = robot("impossible", """"wheels": { "left": "C" }""")
        assertContains(
            refused("--robot-file", impossible),
            "wheels: Two motors are needed to drive, but left and right are both motor C.",
        )
        val huge = robot("huge", """"outline": [[-29, -29], [29, -29], [29, 29], [-29, 29]], "parts": []""")
        val world = folder.resolve("narrow.world.json").also {
            it.writeText(
                """{"format": "robotran-world", "version": 2, "title": "Narrow", "paper": {"width": 50, "height": 50},
                "robots": [{"start": {"x": 25, "y": 25, "heading": 0}}], "walls": [{"from": [0, 0], "to": [50, 0], "thickness": 1}]}""",
            )
        }.toString()
        assertContains(refused("--world", world, "--robot-file", huge), "has no room where it starts in this world.")
    }
}
