package robotran.assignments.collecting

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.DRAWS
import robotran.assignments.file
import robotran.assignments.handIn
import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.language.Language
import robotran.projects.Course
import robotran.projects.ProjectProgram
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** Whose hand-ins are, where they are for several assignments. */
class CollectCourseTest {
    private val around = ASSIGNMENT.copy(
        world = ASSIGNMENT.world.copy(title = "Around the wall"),
        assignment = ASSIGNMENT.assignment?.copy(id = "around-1"),
    )
    private val course = Course("Both", assignments = listOf(ASSIGNMENT, around))
    private val byAna = listOf(
        file("Ana Gil/Draw/loesung.robo", DRAWS),
        file("Ana Gil/Around the wall - Íñigo, 7.º B.robotran", handIn("Íñigo, 7.º B", assignment = around)),
    )
    private val byClass = byAna + listOf(
        file("Eva Sol/Around the wall.robo", DRAWS),
        file("Bob Rey/nothing.robo", DRAWS),
    )
    private val remark = SubmissionRemark.OtherName("Íñigo, 7.º B")

    private suspend fun collect(files: List<CollectedFile>) = collectCourse(files, course, Language.ENGLISH)

    private suspend fun inFolder(files: List<CollectedFile>) =
        collect(files.map { CollectedFile("all/class/${it.path}", it.bytes) })

    private suspend fun inZip(files: List<CollectedFile>) =
        collect(listOf(CollectedFile("class.zip", zipOf(files.map { ZipEntry(it.path, it.bytes) }))))

    private fun names(found: CourseHandIns) = found.tasks.map { task -> task.map { it.name } }

    @Test
    fun `a pupil's folder is one pupil's in all assignments`() = runTest {
        for (found in listOf(collect(byClass), inFolder(byClass), inZip(byClass))) {
            assertEquals(listOf(listOf("Ana Gil"), listOf("Ana Gil", "Eva Sol")), names(found))
            assertEquals(listOf("Bob Rey"), found.unsorted.map { it.name })
            assertEquals(emptyList(), found.tasks[0].single().remarks)
            assertEquals(listOf<SubmissionRemark>(remark), found.tasks[1].first().remarks)
        }
    }

    @Test
    fun `the only folder with a work for each assignment is one pupil's`() = runTest {
        for (found in listOf(inFolder(byAna), inZip(byAna))) {
            assertEquals(listOf(listOf("Ana Gil"), listOf("Ana Gil")), names(found))
            assertEquals(listOf<SubmissionRemark>(remark), found.tasks[1].single().remarks)
        }
    }

    @Test
    fun `a folder with the hand-ins of a class is nobody's`() = runTest {
        val files = listOf("Ida", "Jan").flatMap { pupil ->
            course.assignments.map { task ->
                file("all/class/${task.world.title} - $pupil.robotran", handIn(pupil, assignment = task))
            }
        }
        assertEquals(List(2) { listOf("Ida", "Jan") }, names(collect(files)))
    }

    @Test
    fun `a program that is for no assignment is told, also of a pupil who has handed in others`() = runTest {
        val found = collect(byClass + file("Eva Sol/old.robo", DRAWS))
        assertEquals(listOf("Eva Sol", "Bob Rey"), found.unsorted.map { it.name })
    }

    @Test
    fun `the Java files for each assignment are one program`() = runTest {
        val files = course.assignments.flatMap { task ->
            listOf(
                file("class/${task.world.title}/Go.java", "class Go { static void main(String[] a) { } }"),
                file("class/${task.world.title}/Arm.java", "class Arm { }"),
            )
        }
        val found = collect(files).tasks.map { task -> assertIs<Submission.Usable>(task.single()) }
        assertEquals(List(2) { listOf("Go.java", "Arm.java") }, found.map { it.robot.programs.single().fileNames })
    }

    private val ProjectProgram.fileNames get() = files.map { it.name }
}
