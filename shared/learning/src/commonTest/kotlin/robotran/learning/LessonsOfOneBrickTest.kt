package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertSame
import kotlin.test.assertTrue

/** The lessons about one brick, whose worlds name a robot with it. */
class LessonsOfOneBrickTest {
    private val lessons = Lessons.all - lessonsForAllBricks.toSet()

    @Test
    fun `they are a strand of their own, about the micro-bit on a buggy`() {
        assertEquals(listOf("board"), lessons.map { it.strand }.distinct())
        assertEquals(lessons, Lessons.strands.single { it.name == "board" }.lessons)
        assertTrue(lessons.size >= 3)
        assertEquals(listOf(BrickKind.MICROBIT), lessons.map { it.brick }.distinct())
    }

    @Test
    fun `whatever robot a pupil has gets the same lesson, with its own robot`() {
        for (lesson in lessons) {
            for (brick in BrickKind.entries) assertSame(lesson, lesson.on(brick), "${lesson.name} on $brick")
            for (place in lesson.places) assertSame(lesson, Lessons.lessonIn(lesson.world(Language.SPANISH, place)))
            assertTrue(Lessons.allOn(BrickKind.MICROBIT).none { it.name == lesson.name })
        }
    }

    @Test
    fun `the other lessons say nothing of it`() {
        for (lesson in lessonsForAllBricks) {
            for (brick in BrickKind.entries) {
                val version = lesson.on(brick)
                assertTrue(version.brick == brick || version === lesson, "${lesson.name} on $brick")
            }
        }
    }
}
