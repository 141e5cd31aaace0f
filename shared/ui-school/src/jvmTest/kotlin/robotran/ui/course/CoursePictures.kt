package robotran.ui.course

import robotran.assignments.course.OwnCourses
import robotran.assignments.course.pupilCopy
import robotran.language.Language
import robotran.projects.Course
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.assignment.AnyCourse
import robotran.workshop.documents.Machine
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.CoursePage
import robotran.workshop.state.LearningPage
import kotlin.test.Test

/** Writes pictures of the pages of courses to build/pictures for review. */
class CoursePictures {
    @Test
    fun `the pages of courses can be photographed`() {
        for ((name, width, height) in SCREENS) {
            photographAll(name, width, height, dark = false, Language.ENGLISH, scale = 1f)
        }
        photographAll("phone", 411, 891, dark = true, Language.GERMAN, scale = 1f)
        photographAll("tablet", 1280, 800, dark = true, Language.SPANISH, scale = 1f)
        photographAll("phone", 411, 891, dark = false, Language.GERMAN, scale = 2f)
        photographAll("tablet", 1280, 800, dark = false, Language.GERMAN, scale = 2f)
    }

    private fun photographAll(name: String, width: Int, height: Int, dark: Boolean, language: Language, scale: Float) {
        val machine = Machine()
        val workshop = machine.window()
        val settings = workshop.state.settings
        workshop.handle(SettingsEvent.SettingsChanged(settings.copy(language = language, textScale = scale)))
        val prefix = "courses/$name-${language.tag}-${if (dark) "dark" else "light"}-${(scale * 100).toInt()}"
        val picture = { what: String -> photograph(workshop, width, height, dark).keepAs("$prefix-$what") }
        workshop.handle(CourseEvent.ListRequested)
        picture("none")
        workshop.open(AnyCourse.teachers)
        workshop.open(pupilCopy(OwnCourses.worlds(language)))
        workshop.open(pupilCopy(AnyCourse.teachers))
        workshop.handle(CourseEvent.TaskChosen(0))
        workshop.attempt(AnyAssignment.SOLUTION)
        picture("outcome")
        workshop.handle(CourseEvent.NextTaskChosen)
        workshop.attempt("pen down\nforward 6\n")
        workshop.handle(CourseEvent.OpenCourseRequested)
        picture("course")
        workshop.handle(CourseEvent.ListRequested)
        picture("list")
        val list = workshop.state.course.page as CoursePage.MyCourses
        workshop.handle(CourseEvent.RemovalRequested(list.courses.first { it.isForTeachers }.key))
        picture("removal")
        workshop.handle(CourseEvent.RemovalRequested(null))
        workshop.handle(CourseEvent.CourseChosen(list.courses.first { it.count > 3 }.key))
        picture("worlds")
        workshop.handle(CourseEvent.ListRequested)
        workshop.handle(CourseEvent.MakingRequested(list.courses.first { it.isForTeachers }.key))
        workshop.handle(CourseEvent.WorksShown(true))
        picture("making")
        workshop.handle(CourseEvent.PageClosed)
        workshop.handle(CourseEvent.PageClosed)
        workshop.handle(CourseEvent.PageClosed)
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        picture("map")
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        picture("gallery")
        // The language is one of the process.
        workshop.handle(SettingsEvent.SettingsChanged(settings))
        picture("usual-again")
        workshop.close()
    }

    private fun Workshop.open(course: Course) = handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(course))))

    private fun Workshop.attempt(text: String) {
        handle(ProgramEvent.ProgramEdited(text))
        handle(RunEvent.RunPressed)
        advance(20_000)
    }

    private companion object {
        val SCREENS = listOf(
            Triple("phone", 411, 891),
            Triple("tablet", 1280, 800),
            Triple("tablet-upright", 800, 1280),
            Triple("laptop", 1440, 900),
        )
    }
}
