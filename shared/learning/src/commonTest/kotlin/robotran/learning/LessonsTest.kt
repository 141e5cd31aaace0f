package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

class LessonsTest {
    @Test
    fun `every lesson has a name and a world of its own`() {
        assertEquals(Lessons.all.size, Lessons.all.map { it.name }.toSet().size)
        for (lesson in Lessons.all) assertEquals(lesson, Lessons.lessonIn(lesson.world(Language.GERMAN)), lesson.name)
        assertTrue(Lessons.all.none { lesson -> WorldGallery.find(lesson.world(Language.ENGLISH)) != null })
    }

    @Test
    fun `lessons are found by the names that an older version saved`() {
        assertEquals("repeat", Lessons.named("03-repeat")?.name)
        assertEquals("repeat", Lessons.named("repeat")?.name)
        assertEquals(null, Lessons.named("nothing"))
    }

    @Test
    fun `every strand has a title and a sentence in every language`() {
        for (strand in Lessons.strands) {
            val titles = Language.entries.map { strand.title(it) }
            assertTrue(titles.all { it.isNotBlank() } && (strand.name == "java" || titles.toSet().size == titles.size))
            assertEquals(Language.entries.size, Language.entries.map { strand.about(it) }.toSet().size, strand.name)
        }
    }

    @Test
    fun `every lesson and every task of a world says as much in every language, each in its own words`() {
        for (lesson in Lessons.all + worldTasks) {
            for (inBlocks in listOf(false, true)) saysAsMuch(lesson, inBlocks)
        }
    }

    private fun saysAsMuch(lesson: Lesson, inBlocks: Boolean) {
        val said = Language.entries.map { lesson.text(it, inBlocks) }
        assertEquals(1, said.map { it.paragraphs.size }.toSet().size, lesson.name)
        val paragraphs = if (lesson in worldTasks) 0..0 else 2..4
        assertTrue(said.all { it.paragraphs.size in paragraphs }, lesson.name)
        assertTrue(said.all { text -> partsOf(text).all { it.isNotBlank() } }, lesson.name)
        assertEquals(1, said.map { text -> text.whens.map { it.condition.phrase } }.toSet().size, lesson.name)
        for (part in partsOf(said.first()).indices.drop(1)) {
            assertEquals(
                said.size,
                said.map {
                    partsOf(it)[part]
                }.toSet().size,
                "${lesson.name}: ${partsOf(said[0])[part]}",
            )
        }
        assertTrue(said.none { text -> partsOf(text).any { '!' in it.replace(CODE, "") } }, lesson.name)
    }

    @Test
    fun `every lesson says in a few words what one can do after it, and goes on after You can`() {
        for (lesson in Lessons.all) {
            val skills = Language.entries.map { assertNotNull(lesson.text(it).skill, lesson.name) }
            assertEquals(skills.size, skills.toSet().size, lesson.name)
            for (skill in skills) assertTrue(skill.length in 8..MOST_OF_SKILL && !skill.endsWith("."), skill)
            assertTrue(skills.first().first().isLowerCase(), skills.first())
        }
        assertEquals(Lessons.all.size, Lessons.all.map { it.text(Language.ENGLISH).skill }.toSet().size)
        assertTrue(worldTasks.all { it.text(Language.ENGLISH).skill == null })
    }

    @Test
    fun `program text in the lessons is the same in every language`() {
        for (lesson in Lessons.all + worldTasks) {
            for (inBlocks in listOf(false, true)) {
                val quoted = Language.entries.map { language ->
                    partsOf(lesson.text(language, inBlocks)).map { quoted(it).sorted() }
                }
                assertEquals(1, quoted.toSet().size, "${lesson.name}: $quoted")
            }
        }
    }

    @Test
    fun `nobody sees the marks of the file`() {
        for (lesson in Lessons.all + worldTasks) {
            for (language in Language.entries) {
                val text = lesson.text(language)
                val blocks = lesson.text(language, inBlocks = true)
                assertEquals(text.title to text.task, blocks.title to blocks.task, lesson.name)
                val all = partsOf(text) + partsOf(blocks)
                assertTrue(all.none { "(text)" in it || "(blocks)" in it || "\n" in it || it != it.trim() }, "$all")
            }
        }
    }

    @Test
    fun `what a lesson's program begins with is known to the help`() {
        val words = Lessons.all.filter { it.programLanguage == ProgramLanguage.ROBOLANG }.map { lesson ->
            lesson.program.text.lines().first { it.isNotBlank() && !it.startsWith("//") }
        }
        for (line in words) {
            assertTrue(helpOn(Language.SPANISH, ProgramLanguage.ROBOLANG, line, 0, brick = BrickKind.RCX) != null, line)
        }
    }

    @Test
    fun `the world of a lesson carries its title and task in the pupil's language`() {
        val lesson = Lessons.all.first()
        assertEquals(lesson.text(Language.GERMAN).title, lesson.world(Language.GERMAN).title)
        assertNotEquals(lesson.world(Language.ENGLISH).task, lesson.world(Language.GERMAN).task)
        assertTrue(Lessons.all.none { '`' in it.world(Language.ENGLISH).task })
    }

    @Test
    fun `the pupil's own version of a program takes the place of the one given`() {
        val own = SourceFile("mine.robo", "beep\n")
        val project = Lessons.all.first().project(Language.ENGLISH, listOf(own))
        assertEquals(listOf(own), project.robots.single().programs.single().files)
    }

    @Test
    fun `the written tutorial has lessons of the same names`() {
        val page = robolangPages.getValue("robolang.md").substringAfter("## Tutorial").substringBefore("## Reference")
        val headings = Regex("### [0-9]+\\. (.+)").findAll(page).map { it.groupValues[1] }.toList()
        val titles = Lessons.all.map { it.text(Language.ENGLISH).title }
        assertTrue(headings.isNotEmpty() && titles.containsAll(headings), "${headings - titles.toSet()}")
    }

    private fun partsOf(text: LessonText): List<String> =
        listOf(text.title) + text.paragraphs + text.task + text.nudge + text.part + text.solution +
            text.whens.map { it.text } + listOfNotNull(text.again)

    private companion object {
        /** So that it fits into two or three lines of a card. */
        const val MOST_OF_SKILL = 56
        val CODE = Regex("`[^`]*`")
    }

    private fun quoted(text: String): List<String> = text.split('`').filterIndexed { place, _ -> place % 2 == 1 }
}
