package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import kotlin.test.Test
import kotlin.time.Duration.Companion.minutes

class ZzTryTest {
    @Test
    fun `try mine`() = runTest(timeout = 10.minutes) {
        val mine = Lessons.all.filter { it.strand == "board" } + worldTasks.filter { "buggy-" in it.name }
        val out = StringBuilder()
        for (lesson in mine) {
            out.appendLine("=== ${lesson.name}")
            try {
                val bad = (1..20).mapNotNull { seed ->
                    val a = runInAllPlaces(lesson, lesson.solution.text, seed)
                    if (a.isSolved) null else "seed $seed ${a.run.goals} ${a.run.robot.pose} ${a.run.milliseconds}"
                }
                out.appendLine("unsolved ${bad.size} ${bad.take(2)}")
                val a = runIn(lesson, lesson.solution.text)
                out.appendLine("first: ${a.run.goals} ${a.run.robot.pose} ${a.run.milliseconds} ms")
                if (lesson.places.size > 1) {
                    val b = runIn(lesson, lesson.solution.text, place = LessonPlace.AGAIN)
                    out.appendLine("again: ${b.run.goals} ${b.run.robot.pose} ${b.run.milliseconds} ms")
                }
                val g = runIn(lesson, lesson.program.text)
                out.appendLine("given: ${g.isSolved} ${g.run.robot.pose} ${g.run.milliseconds}")
                if ("harder" in lesson.name) {
                    val base = worldTasks.single { it.name == lesson.name.substringBeforeLast('/') }
                    val s = runIn(lesson, base.solution.text)
                    out.appendLine("base solution solves: ${s.isSolved} ${s.run.robot.pose}")
                }
                for ((name, text) in if ("harder" in lesson.name) emptyMap() else wrongTriesAt(lesson)) {
                    val w = runInAllPlaces(lesson, text)
                    val f = runIn(lesson, text)
                    val h = chooseHint(lesson, w, Language.ENGLISH)
                    val wanted = text.lines().first().removePrefix("// hint: ")
                    val got = if (h == null) "SOLVED" else h.condition?.phrase ?: "nudge"
                    out.appendLine("${if (got == wanted) "ok " else "BAD"} $name: want $wanted got $got, first ${f.isSolved} pose ${f.run.robot.pose}")
                }
            } catch (e: Throwable) {
                out.appendLine("FAILED ${e.message?.take(600)}")
            }
        }
        java.io.File("/tmp/w/l-draft/try.txt").writeText(out.toString())
    }

    @Test
    fun `hubs`() = runTest(timeout = 30.minutes) {
        val out = StringBuilder()
        for (brick in listOf(robotran.brick.kind.BrickKind.MICROBIT, robotran.brick.kind.BrickKind.MICROBIT_V1)) {
            val names = Lessons.allOn(brick).filter { lesson ->
                (1..3).all { seed ->
                    try {
                        runInAllPlaces(lesson, lesson.solution.text, seed).isSolved
                    } catch (_: AssertionError) {
                        false
                    }
                }
            }.map { it.name }
            out.appendLine("$brick ${names.size}: " + names.joinToString())
            java.io.File("/tmp/w/l-draft/hubs.txt").writeText(out.toString())
        }
    }
}
