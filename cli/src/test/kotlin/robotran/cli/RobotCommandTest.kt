package robotran.cli

import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals

class RobotCommandTest : CommandTest() {
    private fun check(vararg files: String) = commandLine.execute(listOf("robot") + files)

    @Test
    fun `the robots that come with Robotran have no mistakes`() {
        val files = tree.resolve("worlds").listFiles { file -> file.name.endsWith(".robot.json") }.orEmpty().sorted()
        assertEquals(19, files.size)
        assertEquals(0, check(*files.map { it.path }.toTypedArray()))
        assertEquals(19, console.said.size)
        assertContains(console.said.toString(), "It is the robot \"Sumo robot\" with an NXT.")
    }

    @Test
    fun `an impossible robot is told in a sentence with its place`() {
        val file = program(
            """
            { "format": "robotran-robot", "version": 1, "title": "Odd", "like": "nxt-penbot",
              "wheels": { "diameter": 5.6, "width": 2.6, "track": 11.4, "gear": 1, "left": "A", "right": "A" } }
            """.trimIndent(),
            "odd.robot.json",
        )
        assertEquals(1, check(file))
        assertContains(console.complaints.single(), "left and right are both motor A")
        assertContains(console.complaints.single(), "$file:")
    }

    @Test
    fun `a file that is not there is told`() {
        assertEquals(2, check("$folder/none.robot.json"))
        assertContains(console.complaints.single(), "none.robot.json")
    }
}
