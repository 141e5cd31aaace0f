package robotran.workshop.documents

import kotlinx.coroutines.withContext
import robotran.documents.FilePlace
import robotran.documents.FileStamp
import robotran.documents.GivenFile
import robotran.documents.KeptWork
import robotran.documents.OpenedProject
import robotran.documents.Opening
import robotran.documents.OpeningTrouble
import robotran.documents.SavingCheck
import robotran.documents.WorkFile
import robotran.documents.checkBeforeSaving
import robotran.documents.fileNameFor
import robotran.documents.newWorkName
import robotran.documents.openFiles
import robotran.documents.openLinkText
import robotran.documents.projectFile
import robotran.documents.workName
import robotran.documents.workNameOfFile
import robotran.projects.Project
import robotran.rcxrom.Brick
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.Saving
import robotran.workshop.programs.fileNameFor
import robotran.workshop.service.Bench
import robotran.workshop.state.DocumentAnswer
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.ProgramFile
import robotran.workshop.state.PupilProgram

/**
 * Opens files and links, and saves to files.
 *
 * @param show shows a dialog, or none.
 * @param replaceWork does what puts another work in place of the open one, if nothing is lost by it, see [DocumentHolder].
 * @param sayKept says that the work before is kept, and offers the way back to it.
 */
internal class DocumentFiles(
    private val bench: Bench,
    private val keeper: DocumentKeeper,
    private val show: (DocumentDialog?) -> Unit,
    private val replaceWork: suspend (suspend (before: String?) -> Unit) -> Unit,
    private val sayKept: (before: String?) -> Unit,
) {
    suspend fun choose() {
        val files = bench.platform.files.open(KINDS)
        if (files.isNotEmpty()) open(files)
    }

    suspend fun open(files: List<OpenedFile>) {
        val given = files.map { file -> GivenFile(file.name, file.bytes, file.place?.let { FilePlace(it, file.name) }) }
        when (val opening = withContext(bench.platform.background) { openFiles(given, bench.language) }) {
            is Opening.Opened -> take(opening)
            is Opening.Refused -> show(DocumentDialog.Refused(opening.trouble))
        }
    }

    suspend fun openLink(link: String) {
        when (val opening = openLinkText(link, bench.language)) {
            is Opening.Opened -> {
                show(null)
                take(opening)
            }

            is Opening.Refused -> {
                show(DocumentDialog.PastingLink((opening.trouble as? OpeningTrouble.InLink)?.message))
            }
        }
    }

    /** Writes to the work's file; whether it is saved. */
    suspend fun save(overOthers: Boolean = false): Boolean {
        val file = keeper.file ?: return saveAs()
        val project = bench.project
        val bytes = bytesOf(project) ?: return false
        val now = if (overOthers) null else bench.platform.files.read(file.place.address)
        if (checkBeforeSaving(file, now, bytes) == SavingCheck.CHANGED_MEANWHILE) {
            show(DocumentDialog.ChangedMeanwhile(file.place.name))
            return false
        }
        return tell(bench.platform.files.write(file.place.address, file.place.name, bytes), project, bytes)
    }

    /** Lets a file be chosen and writes to that; whether it is saved. */
    suspend fun saveAs(): Boolean {
        val project = bench.project
        val bytes = bytesOf(project) ?: return false
        val name = fileNameFor(keeper.name.ifEmpty { project.world.title }, FileKind.PROJECT)
        return tell(bench.platform.files.save(name, FileKind.PROJECT, bytes), project, bytes)
    }

    /** What is to be done about a file that somebody else has changed. */
    suspend fun answer(answer: DocumentAnswer) {
        when (answer) {
            DocumentAnswer.GO_ON -> save(overOthers = true)
            DocumentAnswer.SAVE_AS -> saveAs()
            DocumentAnswer.TAKE_THEIRS -> takeTheirs()
        }
    }

    private suspend fun takeTheirs() {
        val place = keeper.file?.place ?: return
        val bytes = bench.platform.files.read(place.address) ?: return
        open(listOf(OpenedFile(place.name, bytes, place.address)))
    }

    private suspend fun take(opened: Opening.Opened) {
        val first = opened.projects.firstOrNull() ?: return takeParts(opened)
        val others = keepOthers(opened.projects.drop(1))
        replaceWork { before ->
            bench.openProject(first.project)
            keeper.opened(first.name, first.file, before)
            show(null)
            opened.world?.let { bench.changeWorld(it) }
            sayKept(before)
            addPrograms(opened)
        }
        if (!keeper.claimFile()) {
            bench.say(Notice.FileOpenElsewhere(keeper.file?.place?.name.orEmpty()))
        } else if (others) {
            bench.say(Notice.MoreProjectsOpened(opened.projects.size - 1))
        }
    }

    /** A world is a new work, with the programs that are there; programs come to the others. */
    private suspend fun takeParts(opened: Opening.Opened) {
        val world = opened.world ?: return addPrograms(opened)
        replaceWork { before ->
            bench.changeWorld(world, isAnother = true)
            keeper.opened(workName(world.title) ?: newWorkName(bench.language), null, before)
            show(null)
            sayKept(before)
            addPrograms(opened)
        }
    }

    private fun addPrograms(opened: Opening.Opened) {
        opened.programs.forEach { program ->
            bench.addProgram(PupilProgram(program.files.map { ProgramFile(it.name, it.text) }), replacing = true)
        }
        val names = bench.project.robots.firstOrNull()?.programs.orEmpty().map { it.name }
        val missing = opened.programs.filterNot { it.name in names }
        if (missing.isNotEmpty()) {
            bench.say(Notice.NoSlotForProgram(missing.first().name, Brick.MOST_PROGRAMS))
        }
        if (opened.world != null && opened.programs.isEmpty()) bench.show(Pane.WORLD)
    }

    /** Projects beyond the first are kept without being shown; whether there are any. */
    private suspend fun keepOthers(projects: List<OpenedProject>): Boolean {
        val now = bench.platform.clock.now
        projects.forEachIndexed { number, opened ->
            val id = "o${(now + number).toString(radix = 36)}"
            keeper.shelf.keep(KeptWork(id, opened.name, now - 1 - number, opened.project, opened.file, saved = opened.file != null))
        }
        return projects.isNotEmpty()
    }

    private suspend fun bytesOf(project: Project): ByteArray? {
        val bytes = withContext(bench.platform.background) { projectFile(project) }
        if (bytes == null) bench.say(Notice.ProjectTooLong)
        return bytes
    }

    private suspend fun tell(saving: Saving, project: Project, bytes: ByteArray): Boolean {
        when (saving) {
            is Saving.Saved -> {
                keeper.saved(project, saving.place?.let { WorkFile(FilePlace(it, saving.name), FileStamp.of(bytes)) })
                keeper.name = workNameOfFile(saving.name)
                show(null)
                if (keeper.claimFile()) {
                    bench.say(Notice.FileSaved(saving.name))
                } else {
                    bench.say(Notice.FileOpenElsewhere(saving.name))
                }
            }

            Saving.GivenUp -> {}

            is Saving.Failed -> {
                bench.sayNotSaved(saving)
            }
        }
        return saving is Saving.Saved
    }

    private companion object {
        val KINDS = listOf(FileKind.PROJECT, FileKind.WORLD, FileKind.ROBOLANG, FileKind.JAVA)
    }
}

/** Says that a file could not be saved. */
internal fun Bench.sayNotSaved(saving: Saving.Failed) =
    say(Notice.FileNotSaved(saving.reason, saving.isFull))
