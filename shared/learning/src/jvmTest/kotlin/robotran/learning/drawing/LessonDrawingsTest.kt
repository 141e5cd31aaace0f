package robotran.learning.drawing

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.learning.DRAWING
import robotran.learning.Lesson
import robotran.learning.Lessons
import robotran.learning.lessonTexts
import robotran.learning.runIn
import java.io.File
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

class LessonDrawingsTest {
    @Test
    fun `the drawing of each lesson is what its solution leaves on the sheet`() = runTest(timeout = 5.minutes) {
        val fresh = Lessons.all.flatMap { lesson ->
            BrickKind.entries.map { lesson.on(it) }.distinct().filter { it.hasOwnDrawing(lesson) }.map { it to lesson }
        }.associate { (version, lesson) ->
            fileOf(lesson, version) to RunDrawing.of(runIn(version, version.solution.text).run)
        }
        val stale = fresh.filter { (file, drawing) -> kept(file) != drawing }
        for ((file, drawing) in stale) {
            File("build/lesson-drawings/$file").apply { parentFile.mkdirs() }.writeText(drawing.text + "\n")
        }
        assertEquals(emptySet(), stale.keys, "Record them again: shared/learning/record-drawings.sh")
    }

    @Test
    fun `the drawings of all lessons take little room`() {
        val sizes = Lessons.all.mapNotNull { it.drawing?.text?.length }
        assertEquals(Lessons.all.size, sizes.size)
        assertTrue(sizes.sum() < MOST, "${sizes.sum()} characters")
    }

    private fun kept(file: String): RunDrawing? = if (file in
        lessonTexts
    ) {
        readRunDrawing(lessonTexts.getValue(file).trim())
    } else {
        null
    }

    /** A lesson on another brick has one if it has a world of its own there; hubs have that of the brick they are like. */
    private fun Lesson.hasOwnDrawing(plain: Lesson) = this === plain || (brick.java != null && drawing != plain.drawing)

    private fun fileOf(lesson: Lesson, version: Lesson): String {
        val folder = lessonTexts.keys.map { it.substringBeforeLast('/') }
            .first { it.startsWith("${lesson.strand}/") && it.substringAfter('-') == lesson.name }
        val prefix = if (version === lesson) "" else "${version.brick.name.lowercase()}-"
        return "$folder/$prefix$DRAWING"
    }

    private companion object {
        const val MOST = 30_000
    }
}
