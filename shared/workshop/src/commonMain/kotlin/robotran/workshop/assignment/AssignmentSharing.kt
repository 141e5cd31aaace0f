package robotran.workshop.assignment

import kotlinx.coroutines.withContext
import robotran.assignments.doing.pupilCopy
import robotran.assignments.doing.teacherCopy
import robotran.assignments.packaging.PackageResult
import robotran.assignments.packaging.ScormVersion
import robotran.assignments.packaging.learningPackage
import robotran.assignments.reporting.packageFileName
import robotran.documents.fileNameFor
import robotran.documents.projectFile
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.linkOf
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Preferences
import robotran.workshop.state.AssignmentEditorState
import robotran.workshop.state.LinkError
import robotran.workshop.state.PupilLink

/** Files and links of an assignment, for its author and for pupils. Each function returns the state of the page then. */
internal class AssignmentSharing(
    private val platform: Platform,
    private val current: CurrentProject,
    private val preferences: Preferences,
) {
    private val title: String get() = current.project.world.title

    suspend fun saveForTeacher(page: AssignmentEditorState): AssignmentEditorState =
        save(page, teacherCopy(current.project), title + preferences.language.teacherSuffix)

    suspend fun saveForPupils(page: AssignmentEditorState): AssignmentEditorState =
        save(page, pupilCopy(current.project), title)

    suspend fun makeLink(page: AssignmentEditorState): AssignmentEditorState {
        val address = platform.pageAddress.ifEmpty { preferences.settings.site }
        if (address.isEmpty()) return page.copy(link = PupilLink(problem = LinkError.NoSite))
        val copy = pupilCopy(current.project)
        return when (val link = withContext(platform.background) { linkOf(copy, preferences.language) }) {
            is LinkCreation.Made -> page.copy(link = PupilLink(address + link.fragment))
            is LinkCreation.TooLong -> page.copy(link = PupilLink(problem = LinkError.TooLong(link.message)))
        }
    }

    suspend fun copyLink(page: AssignmentEditorState): AssignmentEditorState {
        val shown = page.link ?: return page
        return page.copy(link = shown.copy(isCopied = shown.link?.let { platform.sharing.copy(it) } == true))
    }

    suspend fun shareLink(page: AssignmentEditorState): AssignmentEditorState {
        page.link?.link?.let { platform.sharing.share(it) }
        return page
    }

    /** Shows and copies the HTML that shows the assignment in a frame, or says why there is none. */
    suspend fun copyEmbedCode(page: AssignmentEditorState): AssignmentEditorState {
        val made = makeLink(page)
        val link = made.link?.link ?: return page.copy(embedCode = null, embedError = made.link?.problem)
        val code = "<iframe src=\"${link.replaceFirst("#", "?embed=assignment#")}\" title=\"${escaped(title)}\" " +
            "width=\"100%\" height=\"600\" allow=\"clipboard-write\"></iframe>"
        return page.copy(embedCode = code, embedCodeCopied = platform.sharing.copy(code))
    }

    suspend fun savePackage(page: AssignmentEditorState, version: ScormVersion): AssignmentEditorState {
        val site = platform.webSite?.files() ?: return page.copy(saveError = "")
        val copy = pupilCopy(current.project)
        val made = withContext(platform.background) {
            learningPackage(title, listOf(copy), version, site, preferences.language)
        }
        return when (made) {
            is PackageResult.TooLong -> page.copy(saveError = made.message)
            is PackageResult.Made -> save(page, packageFileName(title, version), FileKind.ZIP, made.bytes)
        }
    }

    private fun escaped(text: String) = text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;")

    private suspend fun save(page: AssignmentEditorState, project: Project, name: String): AssignmentEditorState {
        val bytes = withContext(platform.background) { projectFile(project) } ?: return page.copy(saveError = "")
        return save(page, name, FileKind.PROJECT, bytes)
    }

    private suspend fun save(
        page: AssignmentEditorState,
        name: String,
        kind: FileKind,
        bytes: ByteArray,
    ): AssignmentEditorState = when (val saving = platform.files.save(fileNameFor(name, kind), kind, bytes)) {
        is Saving.Saved -> page.copy(savedAs = saving.name)
        is Saving.Failed -> page.copy(saveError = saving.reason)
        Saving.Cancelled -> page
    }
}
