package robotran.workshop.course

import kotlinx.coroutines.withContext
import robotran.assignments.course.courseFile
import robotran.assignments.course.pupilCopy
import robotran.assignments.course.teacherCopy
import robotran.documents.fileNameFor
import robotran.projects.Course
import robotran.projects.LinkCreation
import robotran.projects.linkOf
import robotran.workshop.assignment.teacherSuffix
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.service.Preferences
import robotran.workshop.state.CourseError
import robotran.workshop.state.CoursePage
import robotran.workshop.state.LinkError
import robotran.workshop.state.PupilLink

/** Files and links of a course. Each function returns the state of the author's page then. */
internal class CourseSharing(private val platform: Platform, private val preferences: Preferences) {
    suspend fun saveForTeacher(page: CoursePage.Making): CoursePage.Making =
        save(page, teacherCopy(page.course), page.course.title + preferences.language.teacherSuffix)

    suspend fun saveForPupils(page: CoursePage.Making): CoursePage.Making =
        save(page, pupilCopy(page.course), page.course.title)

    suspend fun makeLink(page: CoursePage.Making): CoursePage.Making {
        val address = platform.pageAddress.ifEmpty { preferences.settings.site }
        if (address.isEmpty()) return page.copy(link = PupilLink(problem = LinkError.NoSite))
        val copy = pupilCopy(page.course)
        return when (val link = withContext(platform.background) { linkOf(copy, preferences.language) }) {
            is LinkCreation.Made -> page.copy(link = PupilLink(address + link.fragment))
            is LinkCreation.TooLong -> page.copy(link = PupilLink(problem = LinkError.TooLong(link.message)))
        }
    }

    suspend fun copyLink(page: CoursePage.Making): CoursePage.Making {
        val shown = page.link ?: return page
        return page.copy(link = shown.copy(isCopied = shown.link?.let { platform.sharing.copy(it) } == true))
    }

    suspend fun shareLink(page: CoursePage.Making): CoursePage.Making {
        page.link?.link?.let { platform.sharing.share(it) }
        return page
    }

    private suspend fun save(page: CoursePage.Making, course: Course, name: String): CoursePage.Making {
        val bytes = withContext(platform.background) { courseFile(course) }
            ?: return page.copy(problem = CourseError.TooLong)
        return when (val saving = platform.files.save(fileNameFor(name, FileKind.COURSE), FileKind.COURSE, bytes)) {
            is Saving.Saved -> page.copy(savedAs = saving.name)
            is Saving.Failed -> page.copy(problem = CourseError.NotSaved(saving.reason))
            Saving.Cancelled -> page
        }
    }
}
