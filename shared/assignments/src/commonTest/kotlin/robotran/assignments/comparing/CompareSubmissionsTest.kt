package robotran.assignments.comparing

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.collecting.Submission
import robotran.assignments.java
import robotran.assignments.robolang
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.seconds
import kotlin.time.measureTime

class CompareSubmissionsTest {
    private val maze = """
        power left 5
        power right 1
        var steps = 0
        repeat forever
          start forward
          wait until left bumper or right bumper
          if left bumper
            backward 4
            turn left 90
          else
            backward 2
            turn left 25
          end
          steps = steps + 1
        end
    """.trimIndent()

    private val go = """
        class Go {
          static int steps;
          public static void main(String[] args) throws Exception {
            while (true) {
              Motor.A.forward();
              Motor.C.forward();
              while (Sensor.S1.readValue() == 0) { Thread.sleep(10); }
              steps = steps + 1;
              turn(90);
            }
          }
        }
    """.trimIndent()

    private fun submission(vararg programs: ProjectProgram) =
        Submission.Usable("x", "x", ProjectRobot("robot", programs.toList()))

    private fun pairs(vararg submissions: Submission, assignment: Project = ASSIGNMENT) =
        compareSubmissions(submissions.toList(), assignment)

    @Test
    fun `comments and blanks and names make no difference`() {
        val same = maze.replace("steps", "n").replace("\n", "  // so\n\n").replace("Power", "POWER")
        val javaSame = "/* mine */\n" + go.replace("steps", "n").replace("Go", "Walk").replace("turn(", "rotate(")
            .replace(" = ", "=").replace("  ", "\t")
        assertEquals(listOf(SimilarPair(0, 1, 1.0)), pairs(submission(robolang(maze)), submission(robolang(same))))
        assertEquals(listOf(SimilarPair(0, 1, 1.0)), pairs(submission(java(go)), submission(java(javaSame))))
        assertEquals(emptyList(), pairs(submission(robolang(maze)), submission(java(go))))
    }

    @Test
    fun `programs in NQC are compared without comments, blanks and names`() {
        val turn = (1..12).joinToString("\n", "int steps;\ntask main()\n{\n", "\n}\n") {
            "    OnFwd(OUT_A); Wait($it * 10); steps += $it; if (SENSOR_1 == $it) Off(OUT_C);"
        }
        val same = "/* mine\n */" + turn.replace("steps", "n").replace(" += ", "+=").replace("    ", "\t")
        val nqc = { text: String -> ProjectProgram(Program("a.nqc", ProgramLanguage.NQC, text)) }
        assertEquals(listOf(SimilarPair(0, 1, 1.0)), pairs(submission(nqc(turn)), submission(nqc(same))))
    }

    @Test
    fun `small changes leave much in common`() {
        val changed = maze.replace("turn left 25", "turn left 30")
        val moved = maze.replace("var steps = 0\n", "") + "\nvar steps = 0"
        val own = "repeat 4\n  forward 20\n  turn right 90\n  pen up\n  wait 2 seconds\n  pen down\nend\nbeep\nbuzz\n"
        val found = pairs(submission(robolang(maze)), submission(robolang(changed)), submission(robolang(own)))
        assertEquals(listOf(0 to 1), found.map { it.first to it.second })
        assertTrue(found.single().share in 0.85..0.99 && found.single().isMarked && !found.single().isEqual, "$found")
        assertTrue(pairs(submission(robolang(maze)), submission(robolang(moved))).single().isMarked)
    }

    @Test
    fun `what was given does not count`() {
        val robot = ASSIGNMENT.world.robots.first().name
        val given = ASSIGNMENT.copy(robots = listOf(ProjectRobot(robot, listOf(robolang(maze)))))
        val one = submission(robolang("$maze\npen down\nforward 7\nbeep\nwait 3 seconds\nbuzz\nforward 8\nbeep\n"))
        val other = submission(robolang("repeat 9\n turn left 8\nend\nwait 1 seconds\nbuzz\nbeep\nbeep\n$maze"))
        assertEquals(1, pairs(one, other).size)
        assertEquals(emptyList(), pairs(one, other, assignment = given))
        assertEquals(1.0, pairs(one, one, assignment = given).single().share)
        assertEquals(emptyList(), pairs(submission(robolang(maze)), submission(robolang(maze)), assignment = given))
    }

    @Test
    fun `five hundred long programs take seconds at most`() = runTest {
        val random = Random(1)
        val submissions = List(500) {
            submission(robolang(List(300) { "forward ${random.nextInt(100)}" }.joinToString("\n")))
        }
        val time = measureTime { compareSubmissions(submissions, ASSIGNMENT) }
        assertTrue(time < 20.seconds, "$time")
    }
}
