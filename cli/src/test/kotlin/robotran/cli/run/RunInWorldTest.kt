package robotran.cli.run

import robotran.cli.CommandTest
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals

/** Tests `robotran run` with the seed, the realism, the goals and the other robots of a world. */
class RunInWorldTest : CommandTest() {
    private val world = folder.resolve("two.world.json").also {
        it.writeText(
            """{"format": "robotran-world", "version": 2, "title": "Two", "paper": {"width": 100, "height": 80}, "realism": 0.5, "timeLimit": 5,
               "robots": [{"start": {"x": 50, "y": 40, "heading": 0}}, {"name": "red", "start": {"x": 10, "y": 10, "heading": 0}, "program": ["forward 10"]}],
               "goals": [{"kind": "all", "goals": [{"kind": "reach", "region": {"circle": {"x": 80, "y": 40, "radius": 6}}},
                 {"kind": "reach", "region": {"circle": {"x": 60, "y": 10, "radius": 6}}, "who": "red"}]}]}""",
        )
    }.toString()
    private val forward = program("forward 30\n", "forward.robo")

    private fun run(vararg arguments: String): String {
        console.said.clear()
        assertEquals(
            0,
            commandLine.execute(listOf("run", forward, "--world", world) + arguments),
            console.complaints.joinToString(),
        )
        return console.said.single()
    }

    private fun traceHash(vararg arguments: String) =
        run(*arguments, "--report", "-").substringAfter("\"traceHash\": \"").substringBefore('"')

    @Test
    fun `seed and realism of the world can be changed`() {
        assertEquals(traceHash(), traceHash("--seed", "1", "--realism", "0.5"))
        assertNotEquals(traceHash(), traceHash("--seed", "2"))
        assertNotEquals(traceHash(), traceHash("--realism", "1"))
        assertEquals(traceHash("--realism", "0", "--seed", "1"), traceHash("--realism", "0", "--seed", "2"))
    }

    @Test
    fun `a seed or a realism that makes no sense is refused`() {
        val seeds = listOf("--seed=-1", "--seed=x", "--seed=2147483648")
        for (option in seeds + listOf("--realism=1.5", "--realism=much", "--robot=red", "--robot==$forward")) {
            console.complaints.clear()
            assertEquals(2, commandLine.execute(listOf("run", forward, "--world", world, option)), option)
            assertContains(console.complaints.single(), option.substringAfter('='))
        }
    }

    @Test
    fun `the goals are told at the end, part by part`() {
        val lines = run("--realism", "0").lines().drop(1)
        assertEquals(
            listOf(
                "not met (60 %): Do all of these.",
                "  met: Drive your robot to the marked area on the right.",
                "  not met (20 %): Drive the robot \"red\" to the marked area at the bottom.",
                "    34 cm short of the marked area. (at 1 s, at x 20 cm, y 10 cm, in line 1)",
            ),
            lines.map { it.replace(Regex("\\(\\d+ %\\)")) { found -> if (it.startsWith(" ")) "(20 %)" else "(60 %)" } },
        )
        val other = program("forward 50\n", "other.robo")
        assertEquals("met: Do all of these.", run("--realism", "0", "--robot", "red=$other", "--for", "10").lines()[1])
    }

    @Test
    fun `goals are told after presses as well`() {
        assertContains(
            run("--realism", "0", "--press", "run@1"),
            "\n  met: Drive your robot to the marked area on the right.",
        )
    }
}
